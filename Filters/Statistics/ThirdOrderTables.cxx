// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ThirdOrderTables.h"

#include "PackData.h"
#include "ruc/Base/Text.h"
#include "ruc/Statistics/Results/Phases.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <cmath>
#include <string>

namespace
{
// A column of values and one of their errors, which a name may be without
class Figures
{
public:
  void Add(const ruc::ThirdOrderFigure& figure)
  {
    this->Values.push_back(figure.Value);
    this->Errors.push_back(figure.Error);
  }
  void Fill(vtkTable* table, const std::string& name) const
  {
    PackData::AddColumn(table, name, this->Values);
    PackData::AddColumn(table, name + "_error", this->Errors);
  }

private:
  std::vector<double> Values, Errors;
};

bool HasEta(const ruc::ThirdOrderOfSpheres& found)
{
  return !std::isnan(found.Spheres.Eta.Value);
}

// Where all spheres are one phase, it has the name of that
std::string NameOf(const ruc::ThirdOrderOfSpheres& found, int phase)
{
  return found.Sources == 1 && phase == 0 ? "spheres" : ruc::PhaseName(phase, found.Sources);
}
}

void ThirdOrderTables::FillParameters(const ruc::ThirdOrderOfSpheres& found, vtkTable* table)
{
  std::vector<std::string> phases = { "spheres" };
  std::vector<double> fractions = { 1.0 - found.Fractions.back() };
  Figures zeta, eta;
  zeta.Add(found.Spheres.Zeta);
  eta.Add(found.Spheres.Eta);
  // A single phase of spheres is there already
  for (int r = found.Sources == 1 ? 1 : 0; r <= found.Sources; ++r)
  {
    phases.push_back(NameOf(found, r));
    fractions.push_back(found.Fractions[r]);
    zeta.Add(found.OfPhases[r].Zeta);
    eta.Add(found.OfPhases[r].Eta);
  }
  PackData::AddColumn(table, "Phase", phases);
  PackData::AddColumn(table, "VolumeFraction", fractions);
  zeta.Fill(table, "zeta");
  if (HasEta(found))
  {
    eta.Fill(table, "eta");
  }
}

void ThirdOrderTables::FillIntegrals(const ruc::ThirdOrderOfSpheres& found, vtkTable* table)
{
  std::vector<std::string> names[3];
  Figures second, fourth;
  for (int q = 0; q <= found.Sources; ++q)
  {
    for (int r = 0; r <= found.Sources; ++r)
    {
      for (int s = r; s <= found.Sources; ++s)
      {
        names[0].push_back(NameOf(found, q));
        names[1].push_back(NameOf(found, r));
        names[2].push_back(NameOf(found, s));
        second.Add(found.Second[found.PlaceOf(q, r, s)]);
        fourth.Add(found.Fourth[found.PlaceOf(q, r, s)]);
      }
    }
  }
  PackData::AddColumn(table, "q", names[0]);
  PackData::AddColumn(table, "r", names[1]);
  PackData::AddColumn(table, "s", names[2]);
  second.Fill(table, "I");
  if (HasEta(found))
  {
    fourth.Fill(table, "J");
  }
}

void ThirdOrderTables::FillSpectrum(const ruc::ThirdOrderOfSpheres& found, vtkTable* table)
{
  // The rest of higher degrees has none of its own
  const std::size_t degrees = found.Spectrum.size() - 1;
  std::vector<long long> degree;
  Figures spectrum;
  for (std::size_t n = 0; n < degrees; ++n)
  {
    degree.push_back(static_cast<long long>(n) + 2);
    spectrum.Add(found.Spectrum[n]);
  }
  PackData::AddColumn(table, "l", degree);
  spectrum.Fill(table, "Z");
  std::size_t triple = 0;
  for (int q = 0; found.Sources > 1 && q < found.Sources; ++q)
  {
    for (int r = 0; r < found.Sources; ++r)
    {
      for (int s = r; s < found.Sources; ++s)
      {
        const std::vector<double>& values = found.SpectrumOf[triple++];
        PackData::AddColumn(table, ruc::Text("Z_", q + 1, "_", r + 1, "_", s + 1),
          std::vector<double>(values.begin(), values.begin() + degrees));
      }
    }
  }
}

void ThirdOrderTables::FillSlabs(const ruc::ThirdOrderOfSpheres& found, vtkTable* table)
{
  const char* const axes[] = { "x", "y", "z", "cylinder" };
  std::vector<std::string> axis;
  std::vector<double> from, to, fraction;
  std::vector<long long> centres;
  Figures zeta;
  for (const ruc::ThirdOrderOfSpheres::Slab& slab : found.Slabs)
  {
    axis.push_back(axes[slab.Axis]);
    from.push_back(slab.From);
    to.push_back(slab.To);
    centres.push_back(static_cast<long long>(slab.Centres));
    fraction.push_back(slab.Fraction);
    zeta.Add(slab.Zeta);
  }
  PackData::AddColumn(table, "Axis", axis);
  PackData::AddColumn(table, "From", from);
  PackData::AddColumn(table, "To", to);
  PackData::AddColumn(table, "NumberOfCentres", centres);
  PackData::AddColumn(table, "VolumeFraction", fraction);
  zeta.Fill(table, "zeta");
}

void ThirdOrderTables::FillPack(
  const ruc::SpherePack& own, const ruc::ThirdOrderOfSpheres& found, vtkPolyData* output)
{
  PackData::FillPolyData(own, output);
  // Their places in the share are no numbers of the spheres
  output->GetPointData()->RemoveArray("Id");
  vtkNew<vtkDoubleArray> energy;
  energy->SetName("FieldEnergy");
  for (double value : found.FieldEnergy)
  {
    energy->InsertNextValue(value);
  }
  output->GetPointData()->AddArray(energy);
  output->GetPointData()->SetActiveScalars("FieldEnergy"); // views colour by it
}

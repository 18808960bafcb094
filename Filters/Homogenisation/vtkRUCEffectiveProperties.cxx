// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCEffectiveProperties.h"

#include "EffectiveTables.h"
#include "OutputSummary.h"
#include "PackData.h"
#include "ProgressReport.h"
#include "RankCommunicator.h"
#include "VoxelOutput.h"
#include "ruc/Base/Require.h"
#include "ruc/Homogenisation/CellBox.h"
#include "ruc/Homogenisation/EffectiveResult.h"
#include "ruc/Particles/PackShare.h"
#include "ruc/Statistics/Results/OnePointProbability.h"
#include "ruc/Statistics/ThirdOrder/ThirdOrderOfSpheres.h"

#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkTable.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkRUCEffectiveProperties);

namespace
{
constexpr double LeastVoxels = 2.0; // of the smallest radius
const char* const PropertyNames[] = { "Conductivity", "Elasticity" };
const char* const RuleNames[] = { "Laminate", "Harmonic", "Arithmetic" };
const char* const EndNames[] = { "Tolerance", "MaximumIterations", "Stopped" };

void SetNumber(std::vector<double>& numbers, int i, double value)
{
  if (i >= 0)
  {
    numbers.resize(std::max<std::size_t>(numbers.size(), i + 1), 0.0);
    numbers[i] = value;
  }
}

void PrintNumbers(
  ostream& os, vtkIndent indent, const char* name, const std::vector<double>& numbers)
{
  os << indent << name << ":";
  for (double number : numbers)
  {
    os << " " << number;
  }
  os << "\n";
}

ruc::SolverEnd WorstEnd(const std::vector<ruc::CellRun>& runs)
{
  ruc::SolverEnd worst = ruc::SolverEnd::Tolerance;
  for (const ruc::CellRun& run : runs)
  {
    worst = std::max(worst, run.Cell.Tensor.EndedBy);
  }
  return worst;
}

// The rows of thermal expansion, from the stiffness of the finest run of the first rule
void AddExpansion(const std::vector<ruc::CellRun>& runs, const ruc::CellMaterials& materials,
  double ofMatrix, double ofSpheres, std::vector<ruc::CellQuantity>& quantities)
{
  constexpr const char* axes[] = { "xx", "yy", "zz", "yz", "xz", "xy" };
  const auto expansion = ruc::ExpansionOf(
    runs.front().Cell.Tensor, materials.Matrix, materials.Moduli.front(), ofMatrix, ofSpheres);
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  for (int a = 0; a < ruc::MostFluxes; ++a)
  {
    quantities.push_back({ std::string("alpha_") + axes[a], expansion[a], unknown, unknown });
  }
}
}

vtkRUCEffectiveProperties::vtkRUCEffectiveProperties()
{
  this->SetNumberOfOutputPorts(3);
}

int vtkRUCEffectiveProperties::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == FIELDS ? "vtkImageData" : "vtkTable");
  return 1;
}

void vtkRUCEffectiveProperties::ClearModeConductivities()
{
  this->ModeConductivities.clear();
  this->Modified();
}
void vtkRUCEffectiveProperties::SetModeConductivity(int i, double value)
{
  SetNumber(this->ModeConductivities, i, value);
  this->Modified();
}
void vtkRUCEffectiveProperties::ClearModeModuli()
{
  this->ModeModuli.clear();
  this->Modified();
}
void vtkRUCEffectiveProperties::SetModeModulus(int i, double value)
{
  SetNumber(this->ModeModuli, i, value);
  this->Modified();
}
void vtkRUCEffectiveProperties::ClearModePoissonRatios()
{
  this->ModePoissonRatios.clear();
  this->Modified();
}
void vtkRUCEffectiveProperties::SetModePoissonRatio(int i, double value)
{
  SetNumber(this->ModePoissonRatios, i, value);
  this->Modified();
}

void vtkRUCEffectiveProperties::ValidateProperties() const
{
  const auto choice = [](const char* name, int value, int last) {
    ruc::Require(value >= 0 && value <= last, name, ruc::Text("a value from 0 to ", last), value);
  };
  choice("Property", this->Property, ELASTICITY);
  choice("Method", this->Method, BOTH);
  choice("InterfaceRule", this->InterfaceRule, BOTH_RULES);
  choice("Boundary", this->Boundary, MIRRORED);
  choice("Fields", this->Fields, this->Property == CONDUCTIVITY ? 3 : 6);
  ruc::Require(this->SecondResolution == 0 ||
      (this->SecondResolution >= 2 && this->SecondResolution < this->Resolution),
    "SecondResolution",
    ruc::Text("0, or a number from 2 to less than Resolution, ", this->Resolution),
    this->SecondResolution);
  ruc::ValidateSolver(this->GetSettings());
}

ruc::SolverSettings vtkRUCEffectiveProperties::GetSettings() const
{
  return { this->Tolerance, this->MaximumIterations };
}

ruc::CellMaterials vtkRUCEffectiveProperties::MakeMaterials(int modes) const
{
  if (this->Property == CONDUCTIVITY)
  {
    return ruc::MakeConductors(this->MatrixConductivity, this->ModeConductivities, modes);
  }
  ruc::CellMaterials materials = ruc::MakeElastic(this->MatrixModulus, this->MatrixPoissonRatio,
    this->ModeModuli, this->ModePoissonRatios, modes);
  const bool expands = this->MatrixExpansion != 0.0 || this->SphereExpansion != 0.0;
  ruc::Require(!expands || materials.Moduli.size() == 1, "SphereExpansion",
    "spheres of one material", materials.Moduli.size());
  return materials;
}

ruc::CellBox vtkRUCEffectiveProperties::FindBox(
  const ruc::Window& observed, double largestRadius) const
{
  const auto vector = [](const double* v) { return ruc::Vector3{ v[0], v[1], v[2] }; };
  return ruc::FindCellBox(observed, largestRadius, static_cast<ruc::CellBoundary>(this->Boundary),
    vector(this->WindowOrigin), vector(this->WindowSize));
}

std::vector<ruc::InterfaceRule> vtkRUCEffectiveProperties::GetRules(
  const ruc::CellMaterials& materials) const
{
  switch (this->InterfaceRule)
  {
    case AUTOMATIC_RULE:
      return { materials.AutomaticRule() };
    case BOTH_RULES:
      return { ruc::InterfaceRule::Laminate, ruc::InterfaceRule::Harmonic };
    default:
      return { static_cast<ruc::InterfaceRule>(this->InterfaceRule - LAMINATE) };
  }
}

std::vector<int> vtkRUCEffectiveProperties::GetResolutions() const
{
  return this->SecondResolution > 0 ? std::vector<int>{ this->Resolution, this->SecondResolution }
                                    : std::vector<int>{ this->Resolution };
}

int vtkRUCEffectiveProperties::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  ruc::VoxelGrid grid;
  if (inputs[0]->GetNumberOfInformationObjects() == 1)
  {
    try
    {
      RankCommunicator ranks(this->GetController());
      const PackData::SharedPack pack = this->FindShareEarly(inputs, outputs, ranks);
      const ruc::CellBox box = this->FindBox(pack.Observed, pack.Share.LargestRadius);
      grid = ruc::MakeCellGrid(box.Box, this->Resolution, box.Mirrored).Source;
    }
    catch (const std::exception&)
    {
      // The run says what is wrong
    }
  }
  this->Announced = grid.Dimensions;
  VoxelOutput::Announce(grid, false, outputs->GetInformationObject(FIELDS));
  return this->Superclass::RequestInformation(request, inputs, outputs);
}

std::vector<ruc::PropertyBounds> vtkRUCEffectiveProperties::FindBounds(const ruc::PackShare& share,
  const ruc::CellMaterials& materials, ProgressReport& report, RankCommunicator& ranks)
{
  ruc::ThirdOrderSettings settings;
  settings.ByMode = std::max(materials.Conductivities.size(), materials.Moduli.size()) > 1;
  settings.WithEta = this->Property == ELASTICITY;
  const std::vector<double> fractions = ruc::OnePointProbability(share);
  try
  {
    const ruc::ThirdOrderOfSpheres third =
      ruc::MeasureThirdOrder(share, settings, ranks, report.ForPairs(ranks));
    return ruc::BoundPack(materials, fractions, &third);
  }
  catch (const std::invalid_argument& error)
  {
    if (ranks.Rank() == 0)
    {
      vtkWarningMacro(<< "there are no bounds of third order: " << error.what());
    }
  }
  return ruc::BoundPack(materials, fractions, nullptr);
}

std::vector<ruc::CellRun> vtkRUCEffectiveProperties::SolveAll(const ruc::SpherePack& piece,
  const ruc::Window& observed, const ruc::CellBox& box, const ruc::CellMaterials& materials,
  ruc::CellFields& fields, ProgressReport& report, RankCommunicator& ranks)
{
  const std::vector<ruc::InterfaceRule> rules = this->GetRules(materials);
  const std::vector<int> resolutions = this->GetResolutions();
  const int cases = this->Property == CONDUCTIVITY ? 3 : 6;
  const double steps = static_cast<double>(rules.size() * resolutions.size() * cases);
  constexpr double usualSteps = 30.0;
  std::vector<ruc::CellRun> runs;
  for (ruc::InterfaceRule rule : rules)
  {
    for (int resolution : resolutions)
    {
      const ruc::CellGrid cell = ruc::MakeCellGrid(box.Box, resolution, box.Mirrored);
      const auto progress = [&](const ruc::SolverStep& step)
      {
        const double part = std::min(step.Iteration / usualSteps, 1.0);
        return ranks.Rank() > 0 ||
          report.Update((static_cast<double>(runs.size() * cases + step.Case) + part) / steps,
            ruc::Text("case ", step.Case + 1, " of ", cases, " at ", resolution,
              " voxels, iteration ", step.Iteration, ", at most ", step.Energy));
      };
      ruc::CellRun run = { resolution, rule, cell.Source.Spacing[0], {} };
      run.Cell = ruc::SolveCell(piece, observed, cell, materials, rule, this->GetSettings(), ranks,
        progress, runs.empty() ? &fields : nullptr);
      runs.push_back(std::move(run));
      if (runs.back().Cell.Tensor.EndedBy == ruc::SolverEnd::Stopped)
      {
        // A coarser grid than that of what was found whole would not tell of it
        if (runs.size() > 1)
        {
          runs.pop_back();
          runs.front().Cell.Tensor.EndedBy = ruc::SolverEnd::Stopped;
        }
        return runs;
      }
    }
  }
  return runs;
}

void vtkRUCEffectiveProperties::Execute(
  vtkPointSet* input, vtkInformationVector* outputs, RankCommunicator& ranks)
{
  this->ValidateProperties();
  ProgressReport report(this, this->GetLabel());
  PackData::PackPiece pack = this->FindPiece(input, true, ranks);
  const ruc::SpherePack piece = pack.Piece.Spheres();
  const ruc::PackShare share = ruc::SharePack(std::move(pack.Piece), ranks);
  const ruc::CellMaterials materials = this->MakeMaterials(share.NumberOfModes());
  const ruc::CellBox box = this->FindBox(share.Observed, share.LargestRadius);
  const ruc::CellGrid cell = ruc::MakeCellGrid(box.Box, this->Resolution, box.Mirrored);
  ruc::Require(cell.Source.Dimensions == this->Announced, "Effective Properties",
    "a window that does not change with time", "another one than was announced");
  const double overlap = this->CheckOverlap(share, false, ranks);
  EffectiveTables::Properties found;
  if (this->Method != SOLVER)
  {
    found.Bounds = this->FindBounds(share, materials, report, ranks);
  }
  ruc::CellFields fields;
  fields.Case = this->Fields - 1;
  std::vector<ruc::CellRun> runs;
  double fraction = 0.0;
  if (this->Method != BOUNDS)
  {
    runs = this->SolveAll(piece, share.Observed, box, materials, fields, report, ranks);
    found.Quantities = ruc::CombineRuns(static_cast<ruc::CellProperty>(this->Property), runs);
    fraction = runs.front().Cell.Fraction;
    if (this->Property == ELASTICITY &&
      (this->MatrixExpansion != 0.0 || this->SphereExpansion != 0.0))
    {
      AddExpansion(runs, materials, this->MatrixExpansion, this->SphereExpansion, found.Quantities);
    }
  }
  else
  {
    fraction = ruc::FindFraction(piece, share.Observed, cell, materials, ranks, &fields);
  }
  double leastRadius = std::numeric_limits<double>::max();
  for (double radius : piece.Radius)
  {
    leastRadius = std::min(leastRadius, radius);
  }
  ranks.Minimum(&leastRadius, 1);
  vtkImageData* image = vtkImageData::GetData(outputs, FIELDS);
  VoxelOutput::SetPiece(image, cell.Source, false, ranks);
  EffectiveTables::FillFields(cell, std::move(fields), image, ranks);
  if (ranks.Rank() == 0)
  {
    const auto property = static_cast<ruc::CellProperty>(this->Property);
    EffectiveTables::FillProperties(property, found, vtkTable::GetData(outputs, PROPERTIES));
    EffectiveTables::FillConvergence(property, runs, vtkTable::GetData(outputs, CONVERGENCE));
    this->Warn(runs, cell, leastRadius);
  }
  OutputSummary::ForEachOutput(outputs,
    [&](vtkDataObject* data)
    {
      this->AddSummary(box, cell, fraction, runs, data);
      PackData::AddPackSummary(
        data, pack, share.NumberOfSpheres, ruc::OnePointProbability(share), overlap);
    });
}

void vtkRUCEffectiveProperties::AddSummary(const ruc::CellBox& box, const ruc::CellGrid& cell,
  double fraction, const std::vector<ruc::CellRun>& runs, vtkDataObject* data) const
{
  const auto list = [](const auto& v) { return std::vector<double>{ v.begin(), v.end() }; };
  PackData::AddField(data, "Property", std::string(PropertyNames[this->Property]));
  PackData::AddField(data, "Boundary", std::string(box.Mirrored ? "Mirrored" : "Periodic"));
  PackData::AddField(data, "WindowOrigin", list(box.Box.Origin));
  PackData::AddField(data, "WindowSize", list(box.Box.Size));
  const std::array<int, 3> n = cell.Source.Dimensions;
  PackData::AddField(data, "Voxels", std::vector<long long>{ n[0], n[1], n[2] });
  PackData::AddField(data, "SolvedFraction", std::vector<double>{ fraction });
  std::vector<std::string> rules;
  long long iterations = 0;
  for (const ruc::CellRun& run : runs)
  {
    const std::string rule = RuleNames[static_cast<int>(run.Rule)];
    if (rules.empty() || rules.back() != rule)
    {
      rules.push_back(rule);
    }
    iterations += static_cast<long long>(run.Cell.Tensor.Steps.size());
  }
  if (!runs.empty())
  {
    PackData::AddField(data, "InterfaceRule", rules);
    PackData::AddField(data, "Iterations", std::vector<long long>{ iterations });
    PackData::AddField(data, "EndedBy", std::string(EndNames[static_cast<int>(WorstEnd(runs))]));
  }
}

void vtkRUCEffectiveProperties::Warn(
  const std::vector<ruc::CellRun>& runs, const ruc::CellGrid& cell, double leastRadius)
{
  if (runs.empty())
  {
    return;
  }
  const auto& h = cell.Source.Spacing;
  const double voxels = leastRadius / *std::max_element(h.begin(), h.end());
  if (voxels < LeastVoxels)
  {
    vtkWarningMacro(<< "the smallest radius, " << leastRadius << ", has " << voxels
                    << " voxels; with fewer than " << LeastVoxels
                    << " the solution says little. Resolution makes them smaller.");
  }
  const ruc::SolverEnd end = WorstEnd(runs);
  if (end == ruc::SolverEnd::Stopped)
  {
    vtkWarningMacro(<< "stopped before all cases were solved; values of the solver lie above what "
                       "they would have been.");
  }
  else if (end == ruc::SolverEnd::MaximumIterations)
  {
    vtkWarningMacro(<< "a case was not solved to the Tolerance, " << this->Tolerance << ", in "
                    << this->MaximumIterations
                    << " iterations; values of the solver lie above what they would have been.");
  }
}

std::optional<ruc::Estimate> vtkRUCEffectiveProperties::MakeEstimate()
{
  this->ValidateProperties();
  const std::optional<ruc::PackFigures> pack = this->FindFigures();
  if (!pack)
  {
    return {};
  }
  const ruc::CellMaterials materials = this->MakeMaterials(pack->Modes);
  const ruc::CellBox box = this->FindBox(pack->Observed, pack->LargestRadius);
  ruc::Estimate estimate = ruc::EstimatePack(*pack);
  if (this->Method != SOLVER)
  {
    ruc::ThirdOrderSettings settings;
    settings.WithEta = this->Property == ELASTICITY;
    estimate += ruc::EstimateThirdOrder(*pack, settings);
  }
  ruc::Estimate largest;
  for (ruc::InterfaceRule rule : this->GetRules(materials))
  {
    for (int resolution : this->GetResolutions())
    {
      const ruc::Estimate one =
        ruc::EstimateCell(ruc::MakeCellGrid(box.Box, resolution, box.Mirrored), materials, rule,
          this->Fields > 0 && resolution == this->Resolution);
      largest.Seconds += this->Method == BOUNDS ? 0.0 : one.Seconds;
      largest.MegabytesOfAll = std::max(largest.MegabytesOfAll, one.MegabytesOfAll);
      largest.MegabytesOfRank = std::max(largest.MegabytesOfRank, one.MegabytesOfRank);
    }
  }
  if (this->Method != BOUNDS)
  {
    estimate += largest;
  }
  return estimate;
}

void vtkRUCEffectiveProperties::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Property: " << this->Property << "\n";
  os << indent << "MatrixConductivity: " << this->MatrixConductivity << "\n";
  PrintNumbers(os, indent, "ModeConductivities", this->ModeConductivities);
  os << indent << "MatrixModulus: " << this->MatrixModulus << "\n";
  os << indent << "MatrixPoissonRatio: " << this->MatrixPoissonRatio << "\n";
  PrintNumbers(os, indent, "ModeModuli", this->ModeModuli);
  PrintNumbers(os, indent, "ModePoissonRatios", this->ModePoissonRatios);
  os << indent << "MatrixExpansion: " << this->MatrixExpansion << "\n";
  os << indent << "SphereExpansion: " << this->SphereExpansion << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "SecondResolution: " << this->SecondResolution << "\n";
  os << indent << "InterfaceRule: " << this->InterfaceRule << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MaximumIterations: " << this->MaximumIterations << "\n";
  os << indent << "Boundary: " << this->Boundary << "\n";
  const auto print = [&](const char* name, const double* v)
  { os << indent << name << ": " << v[0] << " " << v[1] << " " << v[2] << "\n"; };
  print("WindowOrigin", this->WindowOrigin);
  print("WindowSize", this->WindowSize);
  os << indent << "Fields: " << this->Fields << "\n";
}

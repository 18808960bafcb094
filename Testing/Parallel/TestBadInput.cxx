// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bad input gives one error, on rank 0, that names the filter, the array or property, what is
 * required and what was got; every output is empty on every rank, no rank waits for another, and
 * the filter works again once the input is mended.
 */
#include "Packs.h"

#include "vtkRUCCompareProbabilities.h"
#include "vtkRUCChordLengths.h"
#include "vtkRUCDirectionalProbability.h"
#include "vtkRUCOnePointProbability.h"
#include "vtkRUCParticleModes.h"
#include "vtkRUCPeriodicReplicas.h"
#include "vtkRUCProbabilityMap.h"
#include "vtkRUCRadialDistribution.h"
#include "vtkRUCSpherePackReader.h"
#include "vtkRUCThreePointProbability.h"
#include "vtkRUCTwoPointProbability.h"
#include "vtkRUCUnitCellReconstruction.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkCommunicator.h"
#include "vtkMPIController.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

namespace
{
int Failures = 0;
constexpr double Edge = 12.0;

void Check(bool good, const std::string& what)
{
  if (!good)
  {
    ++Failures;
    std::cerr << "FAILED: " << what << std::endl;
  }
}

// Collects the errors of an algorithm instead of printing them
struct Errors
{
  explicit Errors(vtkObject* object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Texts.push_back(static_cast<const char*>(text)); });
    object->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  vtkNew<vtkCallbackCommand> Command;
  std::vector<std::string> Texts;
};

bool IsEmpty(vtkAlgorithm* filter)
{
  bool empty = true;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* data = filter->GetOutputDataObject(port);
    empty = empty && data->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
      data->GetNumberOfElements(vtkDataObject::ROW) == 0 &&
      data->GetFieldData()->GetNumberOfArrays() == 0;
  }
  return empty;
}

vtkMPIController* Controller;

void CheckRefusal(vtkAlgorithm* filter, const Errors& errors, const std::string& what,
  const std::vector<std::string>& parts)
{
  Check(IsEmpty(filter), what + ": outputs are empty");
  if (Controller->GetLocalProcessId() > 0)
  {
    Check(errors.Texts.empty(), what + ": rank 0 alone reports");
    return;
  }
  Check(errors.Texts.size() == 1, what + ": one error, got " + std::to_string(errors.Texts.size()));
  for (const std::string& part : parts)
  {
    for (const std::string& text : errors.Texts)
    {
      Check(
        text.find(part) != std::string::npos, what + ": '" + part + "' in the message: " + text);
    }
  }
}

// The part of a pack that this rank holds: round robin, so each rank but one of three has some
bool Mine(std::size_t i)
{
  return i % Controller->GetNumberOfProcesses() ==
    static_cast<std::size_t>(Controller->GetLocalProcessId());
}

// Runs a filter on a good pack, on a bad one made from it by `spoil`, and on the good one again
template <class Filter>
void Refuses(const std::string& what, const std::vector<std::string>& parts,
  const ruc::SpherePack& good, const std::function<void(ruc::SpherePack&)>& spoil,
  const std::function<void(vtkPolyData*)>& spoilData = {},
  const std::function<void(Filter*)>& spoilFilter = {}, bool periodic = true, double edge = Edge,
  const std::function<void(Filter*)>& configure = {})
{
  vtkNew<Filter> filter;
  const Errors errors(filter);
  if (configure)
  {
    configure(filter);
  }
  const auto goodData = MakePolyData(good, Edge, periodic, Mine);
  filter->SetInputData(goodData);
  filter->Update();
  Check(errors.Texts.empty(), what + ": the good pack is taken");
  if (Controller->GetLocalProcessId() == 0)
  {
    Check(!IsEmpty(filter), what + ": the good pack gives a result");
  }

  ruc::SpherePack bad = good;
  spoil(bad);
  const auto badData = MakePolyData(bad, edge, periodic, Mine);
  if (spoilData)
  {
    spoilData(badData);
  }
  if (spoilFilter)
  {
    spoilFilter(filter);
  }
  filter->SetInputData(badData);
  filter->Update();
  CheckRefusal(filter, errors, what, parts);
}

// A table of S_rs as Two-Point Probability gives it, on rank 0
vtkSmartPointer<vtkTable> MakeTable(int modes, int lags, double spacing)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  if (Controller->GetLocalProcessId() > 0)
  {
    return table;
  }
  const auto add = [&](const std::string& name, double scale)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name.c_str());
    for (int k = 0; k <= lags; ++k)
    {
      column->InsertNextValue(scale * k);
    }
    table->AddColumn(column);
  };
  const auto phase = [=](int p) { return p == modes ? std::string("m") : std::to_string(p + 1); };
  add("r", spacing);
  for (int r = 0; r <= modes; ++r)
  {
    for (int s = r; s <= modes; ++s)
    {
      add("S_" + phase(r) + "_" + phase(s), 0.01 * (r + s + 1));
    }
  }
  return table;
}

// An image as Three-Point Probability gives it; the slab of this rank
vtkSmartPointer<vtkImageData> MakeImage(int lags, double spacing, const std::string& name)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int rank = Controller->GetLocalProcessId(), ranks = Controller->GetNumberOfProcesses();
  image->SetExtent(0, lags, 0, lags, 4 * rank / ranks, 4 * (rank + 1) / ranks);
  image->SetSpacing(spacing, spacing, 45.0);
  vtkNew<vtkDoubleArray> values;
  values->SetName(name.c_str());
  values->SetNumberOfValues(image->GetNumberOfPoints());
  values->Fill(0.25);
  image->GetPointData()->AddArray(values);
  return image;
}

// Compares the input with the cells, in vain, and then with a good cell
void RefusesComparison(const std::string& what, const std::vector<std::string>& parts,
  vtkDataObject* input, const std::vector<vtkSmartPointer<vtkDataObject>>& cells,
  vtkDataObject* goodInput, vtkDataObject* goodCell)
{
  vtkNew<vtkRUCCompareProbabilities> filter;
  const Errors errors(filter);
  filter->SetInputDataObject(0, input);
  for (vtkDataObject* cell : cells)
  {
    filter->AddInputDataObject(1, cell);
  }
  filter->Update();
  std::vector<std::string> all = parts;
  all.push_back("Compare Probabilities");
  CheckRefusal(filter, errors, what, all);

  filter->RemoveAllCellConnections();
  filter->SetInputDataObject(0, goodInput);
  filter->AddInputDataObject(1, goodCell);
  filter->Update();
  if (Controller->GetLocalProcessId() == 0)
  {
    Check(errors.Texts.size() == 1, what + ": a good cell is taken");
    Check(!IsEmpty(filter), what + ": a good cell gives a result");
  }
}

void RefusesText(const std::string& what, const std::string& text,
  const std::vector<std::string>& parts,
  const std::function<void(vtkRUCSpherePackReader*)>& configure = {})
{
  const std::string fileName =
    "bad_input_np" + std::to_string(Controller->GetNumberOfProcesses()) + ".csv";
  if (Controller->GetLocalProcessId() == 0)
  {
    std::ofstream(fileName, std::ios::binary) << text;
  }
  vtkNew<vtkRUCSpherePackReader> reader;
  const Errors errors(reader);
  reader->SetFileName(fileName.c_str());
  if (configure)
  {
    configure(reader);
  }
  // What reads nothing on the other ranks is the rank 0 of a serial reader; then the chain behind
  // it on all ranks
  vtkNew<vtkPolyData> nothing;
  vtkNew<vtkRUCParticleModes> modes;
  const Errors following(modes);
  if (Controller->GetLocalProcessId() == 0)
  {
    reader->Update();
    modes->SetInputData(reader->GetOutput());
  }
  else
  {
    modes->SetInputData(nothing);
  }
  modes->Update();
  if (Controller->GetLocalProcessId() == 0)
  {
    std::vector<std::string> all = parts;
    all.push_back("Sphere Pack Reader");
    all.push_back(fileName);
    CheckRefusal(reader, errors, what, all);
    std::remove(fileName.c_str());
  }
  CheckRefusal(
    modes, following, what + ", the filter behind", { "Particle Modes", "at least one sphere" });
}
}

int main(int argc, char* argv[])
{
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  vtkMultiProcessController::SetGlobalController(controller);
  Controller = controller;

  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const ruc::SpherePack pack =
    MakePack(Edge, [](int i) { return std::make_pair(0.4 + 0.1 * (i % 3), 1 + i % 3); });
  const auto asIs = [](ruc::SpherePack&) {};

  // The pack
  using TwoPoint = vtkRUCTwoPointProbability;
  using Cell = vtkRUCUnitCellReconstruction;
  const std::string name = "Two-Point Probability";
  Refuses<TwoPoint>(
    "no points", { name, "at least one sphere", "no points" }, pack, [](auto& p) { p = {}; });
  Refuses<vtkRUCOnePointProbability>(
    "no points", { "One-Point Probability", "no points" }, pack, [](auto& p) { p = {}; });
  Refuses<vtkRUCParticleModes>(
    "no points", { "Particle Modes", "no points" }, pack, [](auto& p) { p = {}; });
  Refuses<vtkRUCPeriodicReplicas>(
    "no points", { "Periodic Replicas", "no points" }, pack, [](auto& p) { p = {}; });
  Refuses<TwoPoint>("no radius", { name, "'Radius' is required", "'Mode'" }, pack, asIs,
    [](vtkPolyData* d) { d->GetPointData()->RemoveArray("Radius"); });
  Refuses<TwoPoint>("no radius on one rank", { name, "'Radius' is required" }, pack, asIs,
    [](vtkPolyData* d)
    {
      if (Controller->GetLocalProcessId() == Controller->GetNumberOfProcesses() - 1)
      {
        d->GetPointData()->RemoveArray("Radius");
      }
    });
  Refuses<TwoPoint>("radius as text", { name, "'Radius' requires numbers", "string" }, pack, asIs,
    [](vtkPolyData* d)
    {
      vtkNew<vtkStringArray> text;
      text->SetName("Radius");
      text->SetNumberOfValues(d->GetNumberOfPoints());
      d->GetPointData()->RemoveArray("Radius");
      d->GetPointData()->AddArray(text);
    });
  Refuses<TwoPoint>("radius of three components",
    { name, "'Radius' requires numbers of one component", "3 component" }, pack, asIs,
    [](vtkPolyData* d)
    {
      vtkNew<vtkDoubleArray> vectors;
      vectors->SetName("Radius");
      vectors->SetNumberOfComponents(3);
      vectors->SetNumberOfTuples(d->GetNumberOfPoints());
      vectors->Fill(1.0);
      d->GetPointData()->AddArray(vectors);
    });
  for (double radius : { nan, infinity, 0.0, -1.0 })
  {
    Refuses<TwoPoint>("radius " + std::to_string(radius),
      { name, "'Radius' requires finite values > 0", "got" }, pack,
      [=](auto& p) { p.Radius[5] = radius; });
  }
  Refuses<TwoPoint>(
    "NaN coordinate", { name, "finite coordinates", "nan" }, pack, [=](auto& p) { p.Y[7] = nan; });
  Refuses<TwoPoint>("infinite coordinate", { name, "finite coordinates", "inf" }, pack,
    [=](auto& p) { p.Z[7] = infinity; });
  Refuses<TwoPoint>("no modes", { name, "'Mode' is required" }, pack, asIs,
    [](vtkPolyData* d) { d->GetPointData()->RemoveArray("Mode"); });
  Refuses<TwoPoint>("mode 0", { name, "'Mode' requires the values 1", "got 0" }, pack,
    [](auto& p) { p.Mode[3] = 0; });
  Refuses<TwoPoint>("huge mode", { name, "'Mode' requires the values 1", "got 2000000000" }, pack,
    [](auto& p) { p.Mode[3] = 2000000000; });
  Refuses<TwoPoint>("gap in the modes",
    { name, "'Mode' requires the values 1", "no sphere of mode 4" }, pack,
    [](auto& p) { p.Mode[3] = 5; });
  Refuses<TwoPoint>("coincident centres", { name, "distinct centres" }, pack,
    [](auto& p)
    {
      p.X[1] = p.X[0];
      p.Y[1] = p.Y[0];
      p.Z[1] = p.Z[0];
    });

  // The window
  Refuses<TwoPoint>("centre outside the box",
    { name, "requires every centre inside", "1 of 600 outside" }, pack,
    [](auto& p) { p.X[0] = 1.5 * Edge; });
  Refuses<TwoPoint>("box smaller than a sphere", { name, "BoxSize requires periodic edges longer" },
    pack, [](auto& p) { p.Radius[0] = 0.51 * Edge; });
  Refuses<TwoPoint>("box of no size",
    { name, "BoxSize requires three finite edges > 0", "got 0 0 0" }, pack, asIs, {}, {}, true,
    0.0);
  Refuses<TwoPoint>("box of negative size",
    { name, "BoxSize requires three finite edges > 0", "got -3 -3 -3" }, pack, asIs, {}, {}, true,
    -3.0);
  Refuses<TwoPoint>(
    "lag beyond the window", { name, "MaximumLag requires 0 < MaximumLag <= ", "got 12" }, pack,
    asIs, {}, [](TwoPoint* f) { f->SetMaximumLag(12.0); }, false);
  Refuses<TwoPoint>("lag beyond the periodic box", { name, "MaximumLag requires", "got 1e+09" },
    pack, asIs, {}, [](TwoPoint* f) { f->SetMaximumLag(1e9); });
  Refuses<TwoPoint>("negative lag", { name, "MaximumLag requires", "got -1" }, pack, asIs, {},
    [](TwoPoint* f) { f->SetMaximumLag(-1.0); });
  for (int lags : { 0, -5, 2000000000 })
  {
    Refuses<TwoPoint>("lags " + std::to_string(lags),
      { name, "NumberOfLags requires 1 <= NumberOfLags <= 100000", std::to_string(lags) }, pack,
      asIs, {}, [=](TwoPoint* f) { f->SetNumberOfLags(lags); });
  }
  Refuses<TwoPoint>("tolerance", { name, "SaturationTolerance requires", "got 0" }, pack, asIs, {},
    [](TwoPoint* f) { f->SetSaturationTolerance(0.0); });

  using Directional = vtkRUCDirectionalProbability;
  for (int directions : { 1, 0, -3 })
  {
    Refuses<Directional>("directions " + std::to_string(directions),
      { "Directional Probability", "NumberOfDirections requires a number >= 2",
        std::to_string(directions) },
      pack, asIs, {}, [=](Directional* f) { f->SetNumberOfDirections(directions); });
  }
  for (int method : { -1, 2 })
  {
    Refuses<Directional>("method " + std::to_string(method),
      { "Directional Probability", "Method requires a value from 0 to 1", std::to_string(method) },
      pack, asIs, {}, [=](Directional* f) { f->SetMethod(method); });
  }
  using Map = vtkRUCProbabilityMap;
  for (const char* pairs : { "", "1", "1 2 3", "0 1", "4 m", "m x", ";", "1,1" })
  {
    Refuses<Map>(std::string("phase pairs ") + pairs,
      { "Probability Map", "PhasePairs requires pairs of phases, 1 to 3 or m" }, pack, asIs, {},
      [=](Map* f) { f->SetPhasePairs(pairs); });
  }
  Refuses<Map>("spacing", { "Probability Map", "Spacing requires", "got -1" }, pack, asIs, {},
    [](Map* f) { f->SetSpacing(-1.0); });
  Refuses<Map>("resolution", { "Probability Map", "Resolution requires", "got 0" }, pack, asIs, {},
    [](Map* f) { f->SetResolution(0); });
  Refuses<Map>(
    "map beyond the window", { "Probability Map", "Spacing x Resolution requires a length" }, pack,
    asIs, {}, [](Map* f) { f->SetSpacing(1.0); }, false);
  using Radial = vtkRUCRadialDistribution;
  Refuses<Radial>(
    "lag beyond the window", { "Radial Distribution", "MaximumLag", "got 12" }, pack, asIs, {},
    [](Radial* f) { f->SetMaximumLag(12.0); }, false);
  Refuses<Radial>("no lags", { "Radial Distribution", "NumberOfLags requires", "got 0" }, pack,
    asIs, {}, [](Radial* f) { f->SetNumberOfLags(0); });
  using Chords = vtkRUCChordLengths;
  Refuses<Chords>("no lines", { "Chord Lengths", "NumberOfLines requires", "got 0" }, pack, asIs,
    {}, [](Chords* f) { f->SetNumberOfLines(0); });
  Refuses<Chords>(
    "lag beyond the region", { "Chord Lengths", "MaximumLag requires", "got 11.9" }, pack, asIs, {},
    [](Chords* f) { f->SetMaximumLag(11.9); }, false);

  // Sampling
  using OnePoint = vtkRUCOnePointProbability;
  for (int method : { TwoPoint::CHORD_SAMPLING, TwoPoint::TEMPLATE_SAMPLING })
  {
    const auto refuses = [&](const std::string& what, const std::vector<std::string>& parts,
                           const std::function<void(TwoPoint*)>& spoil, bool periodic = true)
    {
      Refuses<TwoPoint>(
        what, parts, pack, asIs, {},
        [=](TwoPoint* f)
        {
          f->SetMethod(method);
          spoil(f);
        },
        periodic);
    };
    const std::string samples =
      method == TwoPoint::CHORD_SAMPLING ? "NumberOfLines" : "NumberOfThrows";
    refuses("no samples", { name, samples + " requires", "got 0" },
      [](TwoPoint* f)
      {
        f->SetNumberOfLines(0);
        f->SetNumberOfThrows(0);
      });
    refuses("negative error", { name, "TargetError requires", "got -0.1" },
      [](TwoPoint* f) { f->SetTargetError(-0.1); });
    refuses("an error out of reach", { name, "TargetError requires", "got 1e-12" },
      [](TwoPoint* f) { f->SetTargetError(1e-12); });
    refuses("seed", { name, "Seed requires", "got -1" }, [](TwoPoint* f) { f->SetSeed(-1); });
    refuses("no lags", { name, "NumberOfLags requires", "got 0" },
      [](TwoPoint* f) { f->SetNumberOfLags(0); });
    refuses(
      "margin", { name, "WindowMargin requires", "got -2" },
      [](TwoPoint* f) { f->SetWindowMargin(-2.0); }, false);
    refuses(
      "margin as wide as the window", { name, "margin of 6" },
      [](TwoPoint* f) { f->SetWindowMargin(6.0); }, false);
    refuses(
      "lag beyond the region", { name, "MaximumLag requires", "got 11.9" },
      [](TwoPoint* f) { f->SetMaximumLag(11.9); }, false);
    const auto refusesMask = [&](const std::string& what, const std::vector<std::string>& parts,
                               const std::function<void(vtkImageData*)>& spoil,
                               bool periodic = false)
    {
      refuses(
        what, parts,
        [&](TwoPoint* f)
        {
          const auto mask =
            MakeMask(Edge, Controller->GetLocalProcessId(), Controller->GetNumberOfProcesses());
          spoil(mask);
          f->SetInputDataObject(1, mask);
        },
        periodic);
    };
    refusesMask("empty mask", { name, "ask requires at least one inside voxel" },
      [](vtkImageData* m) { m->GetPointData()->GetArray(0)->Fill(0.0); });
    refusesMask("mask that misses the pack",
      { name, "Mask requires at least one centre of the pack inside", "none of 600" },
      [](vtkImageData* m) { m->SetOrigin(100.0, 0.0, 0.0); });
    refusesMask("mask thinner than the margin", { name, "ask requires inside voxels" },
      [](vtkImageData* m) { m->SetSpacing(0.5, 0.5, 0.04); });
    refusesMask("mask without an array", { name, "Mask requires an image with an array" },
      [](vtkImageData* m) { m->GetPointData()->Initialize(); });
    refusesMask(
      "mask of a periodic pack", { name, "Mask requires a pack that is not periodic" },
      [](vtkImageData*) {}, true);
  }
  const auto addMask = [](vtkAlgorithm* f)
  {
    f->SetInputDataObject(
      1, MakeMask(Edge, Controller->GetLocalProcessId(), Controller->GetNumberOfProcesses()));
  };
  Refuses<TwoPoint>("mask and the exact sum", { name, "Mask requires Method", "Exact Pair Sum" },
    pack, asIs, {}, addMask, false);
  Refuses<Directional>("mask and the exact sum along directions",
    { "Directional Probability", "Mask requires Method Chord Sampling", "Exact Pair Sum" }, pack,
    asIs, {}, addMask, false);
  Refuses<OnePoint>("lines", { "One-Point Probability", "NumberOfLines requires", "got -4" }, pack,
    asIs, {},
    [](OnePoint* f)
    {
      f->SetMethod(OnePoint::CHORD_SAMPLING);
      f->SetNumberOfLines(-4);
    });

  // Three points
  using ThreePoint = vtkRUCThreePointProbability;
  const std::string three = "Three-Point Probability";
  const auto refusesThree = [&](const std::string& what, const std::vector<std::string>& parts,
                              const std::function<void(ThreePoint*)>& spoil, bool periodic = true)
  {
    std::vector<std::string> all = parts;
    all.push_back(three);
    // Few throws and lags, so that the good pack takes no time
    Refuses<ThreePoint>(
      what, all, pack, asIs, {}, [&](ThreePoint* f) { spoil(f); }, periodic, Edge,
      [](ThreePoint* f)
      {
        f->SetNumberOfThrows(20);
        f->SetNumberOfLags(8);
        f->SetNumberOfDirections(4);
      });
  };
  for (const char* phases : { "", "1", "1 2", "1 2 3 m", "0 1 1", "4 m m", "1 m x", "1,1,1", ";",
         "1 1 1;; m m m", "1 1 1; 1 2", "all m", "-1 1 1", "1.5 1 1" })
  {
    refusesThree(std::string("triples '") + phases + "'", { "Phases requires", "got" },
      [=](ThreePoint* f) { f->SetPhases(phases); });
  }
  refusesThree("no throws", { "NumberOfThrows requires a number from 1", "got 0" },
    [](ThreePoint* f) { f->SetNumberOfThrows(0); });
  for (int directions : { 1, 0, -4, 513 })
  {
    refusesThree("rays " + std::to_string(directions),
      { "NumberOfDirections requires a number from 2 to 512", "got " + std::to_string(directions) },
      [=](ThreePoint* f) { f->SetNumberOfDirections(directions); });
  }
  for (int lags : { 0, -5, 2000000000 })
  {
    refusesThree("lags " + std::to_string(lags),
      { "NumberOfLags requires", "got " + std::to_string(lags) },
      [=](ThreePoint* f) { f->SetNumberOfLags(lags); });
  }
  refusesThree("more lags than allowed", { "NumberOfLags requires a number from 1 to 20000" },
    [](ThreePoint* f) { f->SetNumberOfLags(20001); });
  refusesThree("negative lag", { "MaximumLag requires", "got -1" },
    [](ThreePoint* f) { f->SetMaximumLag(-1.0); });
  refusesThree(
    "lag beyond the window", { "MaximumLag requires 0 < MaximumLag <= 5.3", "got 5.5" },
    [](ThreePoint* f) { f->SetMaximumLag(5.5); }, false);
  refusesThree("lag beyond the periodic box",
    { "MaximumLag requires 0 < MaximumLag <= 48", "got 48.5" },
    [](ThreePoint* f) { f->SetMaximumLag(48.5); });
  refusesThree("seed", { "Seed requires", "got -1" }, [](ThreePoint* f) { f->SetSeed(-1); });
  refusesThree(
    "margin", { "WindowMargin requires", "got -2" },
    [](ThreePoint* f) { f->SetWindowMargin(-2.0); }, false);
  for (double limit : { 0.0, -1.0, nan, 0.01 })
  {
    refusesThree("memory " + std::to_string(limit),
      { "MemoryLimit requires at least", "MB on every rank for 40 triples of phases", "100 lags" },
      [=](ThreePoint* f)
      {
        f->SetPhases("all");
        f->SetNumberOfLags(100);
        f->SetMemoryLimit(limit);
      });
  }
  const auto giveMask = [](ThreePoint* f)
  {
    f->SetInputDataObject(
      1, MakeMask(Edge, Controller->GetLocalProcessId(), Controller->GetNumberOfProcesses()));
  };
  refusesThree(
    "mask of a periodic pack", { "Mask requires a pack that is not periodic" }, giveMask);
  refusesThree(
    "mask that misses the pack", { "Mask requires at least one centre of the pack inside" },
    [&](ThreePoint* f)
    {
      giveMask(f);
      vtkImageData::SafeDownCast(f->GetInputDataObject(1, 0))->SetOrigin(100.0, 0.0, 0.0);
    },
    false);

  // Comparisons
  using Data = vtkSmartPointer<vtkDataObject>;
  const auto table = MakeTable(2, 10, 0.5);
  const auto refusesTable = [&](const std::string& what, const std::vector<std::string>& parts,
                              const std::function<void(vtkTable*)>& spoil)
  {
    const auto bad = MakeTable(2, 10, 0.5);
    if (Controller->GetLocalProcessId() == 0)
    {
      spoil(bad);
    }
    std::vector<std::string> ofCell = parts, ofInput = parts;
    ofCell.push_back("Cell requires");
    ofInput.push_back("Input requires");
    RefusesComparison(what + " of the cell", ofCell, table, { Data(bad) }, table, table);
    RefusesComparison(
      what + " of the second cell", ofCell, table, { Data(table), Data(bad) }, table, table);
    RefusesComparison(what + " of the pack", ofInput, bad, { Data(table) }, table, table);
  };
  refusesTable("missing column", { "S_1_1, S_1_2, … S_m_m", "'S_2_m'" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_2_m");
      vtkNew<vtkDoubleArray> other; // as many columns
      other->SetName("other");
      other->SetNumberOfValues(t->GetNumberOfRows());
      other->Fill(0.0);
      t->AddColumn(other);
    });
  refusesTable("missing columns", { "6 unordered pairs", "got 5 columns" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_2_m");
      t->RemoveColumnByName("S_m_m");
    });
  refusesTable("no r", { "got none 'r'" }, [](vtkTable* t) { t->RemoveColumnByName("r"); });
  refusesTable("no rows", { "a table with rows, got none" }, [](vtkTable* t) { t->Initialize(); });
  refusesTable(
    "one row", { "at least two rows", "got 1" }, [](vtkTable* t) { t->SetNumberOfRows(1); });
  refusesTable("not a number", { "finite numbers, got nan in column S_1_2, row 3" },
    [=](vtkTable* t) { t->SetValueByName(3, "S_1_2", vtkVariant(nan)); });
  refusesTable("uneven lags", { "lags 0, dr, 2 dr", "in row 4, where 2 is due" },
    [](vtkTable* t) { t->SetValueByName(4, "r", vtkVariant(2.1)); });
  refusesTable("text", { "of numbers, got none 'S_m_m'" },
    [](vtkTable* t)
    {
      t->RemoveColumnByName("S_m_m");
      vtkNew<vtkStringArray> text;
      text->SetName("S_m_m");
      text->SetNumberOfValues(t->GetNumberOfRows());
      t->AddColumn(text);
    });
  const auto refusesCells = [&](const std::string& what, const std::vector<std::string>& parts,
                              const std::vector<Data>& cells)
  { RefusesComparison(what, parts, table, cells, table, table); };
  refusesCells("other number of lags", { "the lags of the input, 10 steps to 5", "got 11 to 5.5" },
    { Data(MakeTable(2, 11, 0.5)) });
  refusesCells("other lags", { "the lags of the input, 10 steps to 5", "got 10 to 6" },
    { Data(MakeTable(2, 10, 0.6)) });
  refusesCells("other modes", { "the modes of the input, 2, got 3" },
    { Data(table), Data(MakeTable(3, 10, 0.5)) });
  const auto image = MakeImage(6, 0.5, "S_1_1_1");
  refusesCells("image against table", { "a table, got an image" }, { Data(image) });
  const auto refusesImages = [&](const std::string& what, const std::vector<std::string>& parts,
                               const std::vector<Data>& cells)
  { RefusesComparison(what, parts, image, cells, image, image); };
  refusesImages("table against image", { "an image, got a table" }, { Data(table) });
  refusesImages("two images", { "one image, got 2" }, { Data(image), Data(image) });
  refusesImages("larger image", { "an image of the input's size", "NumberOfLags" },
    { Data(MakeImage(7, 0.5, "S_1_1_1")) });
  refusesImages("other spacing", { "the spacing of the input, 0.5, got 0.6", "MaximumLag" },
    { Data(MakeImage(6, 0.6, "S_1_1_1")) });
  refusesImages("other array", { "an array of the input's names, got none" },
    { Data(MakeImage(6, 0.5, "S_m_m_m")) });

  // The cell
  const std::string cell = "Unit Cell Reconstruction";
  Refuses<Cell>(
    "no sphere of a mode in the cell",
    { cell, "at least one sphere of every mode", "mode 1", "CellSize" }, pack,
    [](auto& p)
    {
      for (std::size_t i = 1; i < p.Size(); ++i)
      {
        p.Mode[i] = 2 + i % 2;
      }
      p.Mode[0] = 1;
    },
    {}, [](Cell* f) { f->SetNumberOfParticles(20); });
  Refuses<Cell>("lags 0", { cell, "NumberOfLags requires", "got 0" }, pack, asIs, {},
    [](Cell* f) { f->SetNumberOfLags(0); });
  Refuses<Cell>("negative cell", { cell, "CellSize requires", "got -2" }, pack, asIs, {},
    [](Cell* f) { f->SetCellSize(-2.0); });
  Refuses<Cell>(
    "lag beyond the pack", { cell, "MaximumLag requires", "got 11.9" }, pack, asIs, {},
    [](Cell* f) { f->SetMaximumLag(11.9); }, false);
  Refuses<Cell>("negative iterations", { cell, "MaximumIterations requires", "got -1" }, pack, asIs,
    {}, [](Cell* f) { f->SetMaximumIterations(-1); });

  // Modes and replicas
  using Modes = vtkRUCParticleModes;
  Refuses<Modes>("no modes wanted", { "Particle Modes", "NumberOfModes requires", "got 0" }, pack,
    asIs, {}, [](Modes* f) { f->SetNumberOfModes(0); });
  Refuses<Modes>("edges that leave spheres out",
    { "Particle Modes", "Edges requires every diameter" }, pack, asIs, {},
    [](Modes* f)
    {
      f->SetMethod(Modes::EXPLICIT_EDGES);
      f->SetEdge(0, 0.9);
      f->SetEdge(1, 2.0);
    });
  Refuses<Modes>("nothing left", { "Particle Modes", "MinimumDiameter requires", "got 50" }, pack,
    asIs, {}, [](Modes* f) { f->SetMinimumDiameter(50.0); });
  using Replicas = vtkRUCPeriodicReplicas;
  Refuses<Replicas>("no tiles", { "Periodic Replicas", "Tiles requires", "got 0 1 1" }, pack, asIs,
    {},
    [](Replicas* f)
    {
      f->SetMode(Replicas::TILING);
      f->SetTiles(0, 1, 1);
    });

  // The text
  RefusesText("missing column", "x,y,radius\n1,2,3\n", { "Line 1", "'z' is required" });
  RefusesText(
    "missing radius", "x,y,z,size\n1,2,3,4\n", { "Line 1", "'radius' or 'diameter' is required" });
  RefusesText("text in a number", "x,y,z,radius\n1,2,3,4\n1,2,3x,4\n", { "Line 3", "'z'", "'3x'" });
  RefusesText("short row", "x,y,z,radius\n1,2,3,4\n\n1,2,3\n",
    { "Line 4", "4 fields are required", "got 3" });
  RefusesText("empty file", "", { "At least one line with a sphere" });
  RefusesText("header alone", "x,y,z,radius\n", { "At least one line with a sphere" });
  RefusesText(
    "negative radius", "x,y,z,radius\n1,2,3,-4\n", { "Line 2", "'radius'", "> 0", "'-4'" });
  RefusesText("NaN radius", "1 2 3 nan\n", { "Line 1", "finite", "'nan'" });
  RefusesText("long line", "x,y,z,radius\n1,2,3,4\n" + std::string(10 * 1024 * 1024, '1') + "\n",
    { "Line 3", "65536", "10485760" });
  RefusesText("not UTF-8", "x,y,z,radius\n1,2,3,4\n1,2,\xb5,4\n", { "Line 3", "UTF-8", "181" });
  RefusesText("periodic box too small", "x,y,z,radius\n1,2,3,0.5\n", { "BoxSize", "Line 2" },
    [](vtkRUCSpherePackReader* r) { r->SetBoxSize(2.0, 2.0, 2.0); });

  int all = 0;
  controller->AllReduce(&Failures, &all, 1, vtkCommunicator::SUM_OP);
  vtkMultiProcessController::SetGlobalController(nullptr);
  controller->Finalize();
  return all == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

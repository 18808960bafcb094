// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/FoundWindow.h"

#include "ruc/Base/Require.h"
#include "ruc/Base/Text.h"
#include "ruc/Particles/FilledShare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace ruc
{
namespace
{
constexpr const char* CutFaces = "Cut faces";
constexpr const char* Eroded = "Eroded";
constexpr double NearlyEqualSizes = 0.9;
constexpr double ErosionOfEqualSizes = 3.5;
// A box of a simulation that is longer than the pack by this is worth a word
constexpr double LongBox = 1.1;

// WindowChoices::Faces, taken apart
struct FaceChoices
{
  std::array<std::optional<FaceKind>, NumberOfFaces> Kinds;
  std::array<bool, NumberOfFaces> Named{}; // by their own names
  bool HasMantle = false;
  std::optional<int> MantleAxis;

  explicit FaceChoices(std::string text)
  {
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ';' || c == ','; }, ' ');
    std::istringstream entries(text);
    for (std::string entry; entries >> entry;)
    {
      const std::size_t sign = std::min(entry.find('='), entry.size());
      const std::string name = entry.substr(0, sign);
      const std::string value = sign < entry.size() ? entry.substr(sign + 1) : "";
      Require(name == "mantle" ? this->SetMantle(value) : this->SetKind(name, value), "FaceKinds",
        "faces, each once, and what they are, such as z-=wall; z+=loose; y-=cut; mantle=none",
        entry);
    }
    Require(!this->MantleAxis || !this->NameFaceBeside(*this->MantleAxis), "FaceKinds",
      "of a cylinder only the faces that close it", text);
  }
  // Whether a face is named that a mantle along the axis would leave no room for
  bool NameFaceBeside(int axis) const
  {
    bool any = false;
    for (int f = 0; f < NumberOfFaces; ++f)
    {
      any = any || (this->Named[f] && f / 2 != axis);
    }
    return any;
  }

private:
  bool SetMantle(const std::string& value)
  {
    const std::size_t axis = std::string("xyz").find(value);
    const bool first = !this->HasMantle;
    this->HasMantle = true;
    this->MantleAxis =
      value.size() == 1 && axis < 3 ? std::optional<int>(static_cast<int>(axis)) : std::nullopt;
    return first && (this->MantleAxis || value == "none");
  }
  bool SetKind(const std::string& name, const std::string& value)
  {
    bool known = false;
    for (FaceKind kind : { FaceKind::Cut, FaceKind::Wall, FaceKind::Loose })
    {
      for (int f = 0; f < NumberOfFaces; ++f)
      {
        const bool named = name == NameOfFace(f);
        if (value == NameOf(kind) && (named ? !this->Named[f] : name == "all"))
        {
          this->Kinds[f] = named || !this->Named[f] ? kind : this->Kinds[f];
          this->Named[f] = this->Named[f] || named;
          known = true;
        }
      }
    }
    return known;
  }
};

bool IsEroded(FaceKind kind)
{
  return kind == FaceKind::Wall || kind == FaceKind::Loose;
}

// The faces of a pack as they were found or chosen
struct Enclosure
{
  PackFaces Faces;
  std::optional<Mantle> Around;
  std::array<bool, NumberOfFaces> IsChosen{};
  bool MantleIsChosen = false;

  bool Counts(int face) const
  {
    return this->Faces.Kinds[face] != FaceKind::Periodic &&
      (!this->Around || this->Around->Axis == face / 2);
  }
  bool IsAny(FaceKind kind) const { return !this->FacesOf(kind).empty(); }
  std::vector<int> FacesOf(FaceKind kind) const
  {
    std::vector<int> faces;
    for (int f = 0; f < NumberOfFaces; ++f)
    {
      if (this->Counts(f) && this->Faces.Kinds[f] == kind)
      {
        faces.push_back(f);
      }
    }
    return faces;
  }
  std::string Describe() const
  {
    std::string text = this->Around ? Text("mantle=", "xyz"[this->Around->Axis]) : "";
    for (int f = 0; f < NumberOfFaces; ++f)
    {
      if (this->Counts(f) || (!this->Around && this->Faces.Kinds[f] == FaceKind::Periodic))
      {
        text += Text(text.empty() ? "" : "; ", NameOfFace(f), "=", NameOf(this->Faces.Kinds[f]));
      }
    }
    return text;
  }
};

std::string ListOf(const std::vector<int>& faces)
{
  std::string text = faces.size() == 1 ? "face " : "faces ";
  for (std::size_t n = 0; n < faces.size(); ++n)
  {
    text += Text(n > 0 ? ", " : "", NameOfFace(faces[n]));
  }
  return text;
}

std::string InPercent(double share)
{
  return Text(std::lround(100.0 * share), " %");
}

std::optional<Mantle> ChooseMantle(const SpherePack& piece, const PackBounds& bounds,
  const FaceChoices& choices, Communicator& ranks)
{
  if (!choices.HasMantle)
  {
    const std::optional<Mantle> mantle = FindMantle(piece, bounds, ranks);
    return mantle && !choices.NameFaceBeside(mantle->Axis) ? mantle : std::nullopt;
  }
  if (!choices.MantleAxis)
  {
    return std::nullopt;
  }
  const int axis = *choices.MantleAxis;
  Require(!bounds.Periodic[(axis + 1) % 3] && !bounds.Periodic[(axis + 2) % 3], "FaceKinds",
    "a mantle along an axis across which the pack is not periodic", Text("mantle=", "xyz"[axis]));
  const std::optional<Mantle> mantle = FitMantle(piece, bounds, axis, ranks);
  Require(mantle.has_value(), "FaceKinds", "spheres all around the axis of a mantle",
    Text("mantle=", "xyz"[axis]));
  return mantle;
}

Enclosure FindEnclosure(const SpherePack& piece, const PackBounds& bounds,
  const WindowChoices& choices, Communicator& ranks)
{
  const FaceChoices chosen(choices.Faces);
  Enclosure enclosure;
  if (bounds.Spheres < LeastSpheresOfWindow && choices.AreAutomatic())
  {
    for (int f = 0; f < NumberOfFaces; ++f)
    {
      enclosure.Faces.Kinds[f] = bounds.Periodic[f / 2] ? FaceKind::Periodic : FaceKind::Unknown;
    }
    return enclosure;
  }
  enclosure.Around = ChooseMantle(piece, bounds, chosen, ranks);
  enclosure.MantleIsChosen = chosen.HasMantle;
  enclosure.Faces = FindFaces(piece, bounds, enclosure.Around, ranks);
  for (int f = 0; f < NumberOfFaces; ++f)
  {
    Require(!chosen.Named[f] || enclosure.Faces.Kinds[f] != FaceKind::Periodic, "FaceKinds",
      "faces along axes that are not periodic", NameOfFace(f));
    if (chosen.Kinds[f] && enclosure.Faces.Kinds[f] != FaceKind::Periodic)
    {
      enclosure.Faces.Kinds[f] = *chosen.Kinds[f];
      enclosure.IsChosen[f] = true;
    }
  }
  return enclosure;
}

double ChooseErosion(const WindowChoices& choices, const PackBounds& bounds)
{
  if (choices.Erosion >= 0.0)
  {
    return choices.Erosion;
  }
  return bounds.VolumeMean > NearlyEqualSizes ? ErosionOfEqualSizes
                                              : std::max(1.0, 2.0 * bounds.VolumeMean);
}

// The interval of the window along an axis; the second number is its length
std::array<double, 2> FindInterval(
  const PackBounds& bounds, const Enclosure& enclosure, int axis, double away)
{
  if (bounds.Periodic[axis])
  {
    return { bounds.Least[axis], bounds.Extent(axis) };
  }
  const auto& kinds = enclosure.Faces.Kinds;
  const double low =
    IsEroded(kinds[2 * axis]) ? bounds.Least[axis] + away : bounds.LeastCentre[axis];
  const double high =
    IsEroded(kinds[2 * axis + 1]) ? bounds.Greatest[axis] - away : bounds.GreatestCentre[axis];
  double length = high - low;
  while (length > 0.0 && low + length < high) // rounding would leave the last centre outside
  {
    length = std::nextafter(length, std::numeric_limits<double>::infinity());
  }
  return { low, length };
}

// Nothing if no length is left along an axis
std::optional<Window> MakeWindow(const PackBounds& bounds, const std::optional<Window>& box,
  const Enclosure& enclosure, double away)
{
  Vector3 origin, size;
  for (int q = 0; q < 3; ++q)
  {
    const std::array<double, 2> interval = FindInterval(bounds, enclosure, q, away);
    origin[q] = interval[0];
    size[q] = box && box->Periodic[q] ? box->Size[q] : interval[1];
  }
  if (enclosure.Around)
  {
    const int axis = enclosure.Around->Axis;
    Vector3 base = enclosure.Around->Centre, along{};
    base[axis] = origin[axis];
    along[axis] = 1.0;
    const double radius = enclosure.Around->Radius - away;
    return radius >= LeastLength && size[axis] >= LeastLength
      ? std::optional<Window>(Window::MakeCylinder(base, along, radius, size[axis]))
      : std::nullopt;
  }
  return *std::min_element(size.begin(), size.end()) >= LeastLength
    ? std::optional<Window>(Window::MakeBox(origin, size, bounds.Periodic))
    : std::nullopt;
}

std::int64_t CountInside(
  const SpherePack& piece, const std::optional<Window>& window, Communicator& ranks)
{
  std::int64_t inside = 0;
  for (std::size_t i = 0; i < piece.Size() && window; ++i)
  {
    inside += window->Contains(piece.Centre(i)) ? 1 : 0;
  }
  ranks.Sum(&inside, 1);
  return inside;
}

// Says what is too little, or nothing
std::string FindShortage(
  std::int64_t inside, const std::optional<Window>& window, const PackBounds& bounds)
{
  if (!window)
  {
    return "no room";
  }
  const double edge = window->ShortestEdge() / bounds.LargestDiameter();
  return edge < LeastEdgeOfWindow   ? Text("an edge of ", edge, " largest diameters")
    : inside < LeastSpheresOfWindow ? Text(inside, inside == 1 ? " sphere" : " spheres")
                                    : "";
}

// Of what was found; what was chosen is known
void WarnOfFaces(const Enclosure& enclosure, double erosion, FoundWindow& found)
{
  const std::string kept = Text(": window kept ", erosion, " largest diameters away.");
  const auto foundFaces = [&](FaceKind kind)
  {
    std::vector<int> faces = enclosure.FacesOf(kind);
    faces.erase(
      std::remove_if(faces.begin(), faces.end(), [&](int f) { return enclosure.IsChosen[f]; }),
      faces.end());
    return faces;
  };
  if (enclosure.Around && !enclosure.MantleIsChosen)
  {
    found.Warnings.push_back(Text("a cylinder along ", "xyz"[enclosure.Around->Axis], " of radius ",
      enclosure.Around->Radius, " holds the pack (", InPercent(enclosure.Around->Covered),
      " covered)", kept));
  }
  if (const std::vector<int> walls = foundFaces(FaceKind::Wall); !walls.empty())
  {
    const auto [least, most] = std::minmax_element(walls.begin(), walls.end(),
      [&](int f, int g) { return enclosure.Faces.Covered[f] < enclosure.Faces.Covered[g]; });
    const std::string from = InPercent(enclosure.Faces.Covered[*least]);
    const std::string to = InPercent(enclosure.Faces.Covered[*most]);
    found.Warnings.push_back(Text(ListOf(walls), walls.size() == 1 ? " looks" : " look",
      " like a wall (", from == to ? to : from + " to " + to, " covered)", kept));
  }
  if (const std::vector<int> loose = foundFaces(FaceKind::Loose); !loose.empty())
  {
    found.Warnings.push_back(
      Text(ListOf(loose), loose.size() == 1 ? " looks" : " look", " loose", kept));
  }
  if (const std::vector<int> unknown = foundFaces(FaceKind::Unknown); !unknown.empty())
  {
    found.Warnings.push_back(Text(
      "no window given: ", ListOf(unknown), " taken as cut; the spheres are too few to tell."));
  }
}

void WarnOfLongBox(const PackBounds& bounds, const Window& box, FoundWindow& found)
{
  for (int q = 0; q < 3; ++q)
  {
    const double times = box.Size[q] / bounds.Extent(q);
    if (!box.Periodic[q] && times > LongBox)
    {
      found.Warnings.push_back(Text("the box of the file is ", 0.1 * std::round(10.0 * times),
        " times the pack along ", "xyz"[q], ": not the window."));
    }
  }
}

// Says whether the spheres fill their bounds, as far as these are faces of the window
bool FillTheirBounds(const SpherePack& piece, const std::optional<Window>& box,
  const PackBounds& bounds, const Enclosure& enclosure, Communicator& ranks, FoundWindow& found)
{
  const std::optional<Window> whole = MakeWindow(bounds, box, enclosure, 0.0);
  const double share = whole ? FindFilledShare(piece, *whole, ranks) : 1.0;
  if (share < 1.0)
  {
    found.Warnings.push_back(Text("no window is taken: the spheres fill only about ",
      InPercent(share), " of the ", whole->Describe(),
      " that holds them. Is the container neither a box nor a cylinder along an axis, or are some "
      "spheres far away from the others? Set the window."));
  }
  return share == 1.0;
}

void TakeWindow(const SpherePack& piece, const std::optional<Window>& box, const PackBounds& bounds,
  const Enclosure& enclosure, const WindowChoices& choices, Communicator& ranks, FoundWindow& found)
{
  if (choices.AreAutomatic() && !FillTheirBounds(piece, box, bounds, enclosure, ranks, found))
  {
    return;
  }
  const bool eroded =
    enclosure.Around || enclosure.IsAny(FaceKind::Wall) || enclosure.IsAny(FaceKind::Loose);
  const double erosion = eroded ? ChooseErosion(choices, bounds) : 0.0;
  const std::optional<Window> window =
    MakeWindow(bounds, box, enclosure, erosion * bounds.LargestDiameter());
  WarnOfFaces(enclosure, erosion, found);
  const std::int64_t inside = CountInside(piece, window, ranks);
  const std::string shortage = eroded || !window ? FindShortage(inside, window, bounds) : "";
  if (!shortage.empty())
  {
    const std::string required = Text(
      LeastSpheresOfWindow, " spheres and an edge of ", LeastEdgeOfWindow, " largest diameters");
    Require(choices.Erosion < 0.0, "WindowErosion", "that it leaves " + required, shortage);
    found.Warnings.push_back(Text("no window is taken: ", required, " are required, ", shortage,
      " would be left. Set the window, or WindowErosion and FaceKinds."));
    return;
  }
  found.Observed = window;
  found.Source = eroded ? Eroded : CutFaces;
  found.Erosion = erosion;
  found.Outside = bounds.Spheres - inside;
}

bool CanBeMeasured(const SpherePack& piece, Communicator& ranks)
{
  bool good = true, any = false;
  for (std::size_t i = 0; i < piece.Size(); ++i)
  {
    const Vector3 centre = piece.Centre(i);
    good = good && piece.Radius[i] >= 0.0 && piece.Radius[i] <= GreatestLength;
    any = any || piece.Radius[i] >= LeastLength;
    for (double c : centre)
    {
      good = good && std::abs(c) <= GreatestLength;
    }
  }
  return ranks.All(good) && !ranks.All(!any);
}
}

void CheckChoices(const WindowChoices& choices)
{
  Require(std::isfinite(choices.Erosion), "WindowErosion", "a finite number", choices.Erosion);
  static_cast<void>(FaceChoices(choices.Faces));
}

std::string TellUnused(const WindowChoices& choices, bool known)
{
  return choices.AreAutomatic() ? ""
                                : Text("FaceKinds and WindowErosion are not used, as ",
                                    known ? "a window is given." : "FindWindow is off.");
}

bool IsFoundSource(const std::string& source)
{
  return source == CutFaces || source == Eroded;
}

FoundWindow FindWindow(const SpherePack& piece, const std::optional<Window>& box,
  const WindowChoices& choices, Communicator& ranks)
{
  CheckChoices(choices);
  FoundWindow found;
  if (box && box->IsFullyPeriodic())
  {
    found.Observed = box;
    found.Source = "File";
    return found;
  }
  if (!CanBeMeasured(piece, ranks))
  {
    return found;
  }
  const PackBounds bounds(piece, box, ranks);
  if (box)
  {
    WarnOfLongBox(bounds, *box, found);
  }
  if (bounds.Spheres < LeastSpheresOfWindow && choices.AreAutomatic() &&
    !(box && box->IsPeriodic()))
  {
    return found;
  }
  const Enclosure enclosure = FindEnclosure(piece, bounds, choices, ranks);
  found.Faces = enclosure.Describe();
  TakeWindow(piece, box, bounds, enclosure, choices, ranks, found);
  return found;
}
}

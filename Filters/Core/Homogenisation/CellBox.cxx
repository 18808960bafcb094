// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Homogenisation/CellBox.h"

#include "ruc/Base/Require.h"

#include <algorithm>

namespace ruc
{
namespace
{
// Whether all corners lie where no spheres are lacking
bool IsComplete(const Window& box, const Window& complete)
{
  bool inside = true;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 at = box.Origin;
    for (int q = 0; q < 3; ++q)
    {
      at[q] += (corner >> q) % 2 * box.Size[q];
    }
    inside = inside && complete.Contains(at);
  }
  return inside;
}
}

CellBox FindCellBox(const Window& observed, double largestRadius, CellBoundary boundary,
  const Vector3& origin, const Vector3& size)
{
  const bool part = size != Vector3{ 0.0, 0.0, 0.0 };
  const bool whole = observed.IsFullyPeriodic() && !part;
  if (boundary == CellBoundary::Periodic || (boundary == CellBoundary::Automatic && whole))
  {
    Require(whole, "Boundary Periodic", "a box that is periodic along all axes, and no WindowSize",
      part ? std::string("a WindowSize") : observed.Describe());
    return { observed, false };
  }
  if (!part)
  {
    Require(observed.GetShape() == Window::Shape::Box, "WindowSize",
      "the edges of a box where the window is a cylinder", "0 0 0");
    Window box = observed.Shrunk(largestRadius);
    box.Periodic = { false, false, false };
    return { box, true };
  }
  Require(*std::min_element(size.begin(), size.end()) > 0.0, "WindowSize",
    "three edges > 0, or 0 0 0", Text(size[0], " ", size[1], " ", size[2]));
  const Window box = Window::MakeBox(origin, size, { false, false, false });
  Require(IsComplete(box, observed.Shrunk(largestRadius)), "WindowOrigin and WindowSize",
    Text("a box within the window of the pack, ", observed.Describe(),
      ", as far as the largest radius, ", largestRadius, ", from faces that are not periodic"),
    Text("one from ", origin[0], " ", origin[1], " ", origin[2], " to ", origin[0] + size[0], " ",
      origin[1] + size[1], " ", origin[2] + size[2]));
  return { box, true };
}
}

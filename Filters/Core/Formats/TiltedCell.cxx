// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/TiltedCell.h"

#include "ruc/Base/Text.h"

#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
bool IsWhole(double x)
{
  return std::abs(x - std::round(x)) < 1e-9;
}

// Takes an edge off a centre as often as its own axis asks for
bool WrapAlong(int axis, const Vector3& edge, const Vector3& origin, Vector3& centre)
{
  const double length = edge[axis];
  const double times = std::floor((centre[axis] - origin[axis]) / length);
  if (times == 0.0)
  {
    return false;
  }
  if (!(std::abs(times) <= 1e9))
  {
    throw std::invalid_argument(
      Text("A centre at most 10^9 edges away from the box is required, got ", centre[axis],
        " along ", "xyz"[axis], "."));
  }
  for (int q = 0; q <= axis; ++q)
  {
    centre[q] -= times * edge[q];
  }
  // Rounding may leave it on the far side of either face
  if (!(centre[axis] >= origin[axis] && centre[axis] < origin[axis] + length))
  {
    centre[axis] = origin[axis];
  }
  return true;
}
}

Window BrickOf(const FrameBox& box)
{
  const auto [lx, ly, lz] = box.Edges;
  const auto [xy, xz, yz] = box.Tilts;
  std::array<bool, 3> periodic = box.Periodic;
  periodic[1] = periodic[1] && IsWhole(xy / lx);
  // (0, 0, lz) is c less whole edges b and a
  periodic[2] = periodic[2] && IsWhole(yz / ly) && IsWhole((xz - std::round(yz / ly) * xy) / lx);
  return Window::MakeBox(box.Origin, box.Edges, periodic);
}

std::size_t WrapIntoBrick(PackFrame& frame, const FrameBox& box)
{
  const FrameCell cell = FrameCell::FromBox(box);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    Vector3 centre = { frame.X[i], frame.Y[i], frame.Z[i] };
    bool any = false;
    for (int q = 2; q >= 0; --q)
    {
      if (box.Periodic[q])
      {
        any = WrapAlong(q, cell.Edges[q], box.Origin, centre) || any;
      }
    }
    if (any)
    {
      frame.X[i] = centre[0];
      frame.Y[i] = centre[1];
      frame.Z[i] = centre[2];
      ++moved;
    }
  }
  return moved;
}
}

// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Formats/PackFrame.h"

#include "ruc/Base/Text.h"

#include <cmath>
#include <stdexcept>

namespace ruc
{
namespace
{
std::string Describe(const Vector3& v)
{
  return Text("(", v[0], ", ", v[1], ", ", v[2], ")");
}

Vector3 Scaled(const Vector3& v, double factor)
{
  return { factor * v[0], factor * v[1], factor * v[2] };
}

Vector3 Sum(const Vector3& a, const Vector3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

void CheckCell(const FrameCell& cell)
{
  const auto& [a, b, c] = cell.Edges;
  const double volume = std::abs(Dot(Cross(a, b), c));
  const double product = Length(a) * Length(b) * Length(c);
  if (!std::isfinite(volume) || !std::isfinite(product) || !(volume > 1e-9 * product) ||
    !std::isfinite(Length(cell.Origin)))
  {
    throw std::invalid_argument(Text("The box requires three finite edges that span a volume, got ",
      Describe(a), ", ", Describe(b), " and ", Describe(c), " from ", Describe(cell.Origin), "."));
  }
}

// The directions that are to become x, y and z
std::array<Vector3, 3> AxesOf(const FrameCell& cell)
{
  const auto& [a, b, c] = cell.Edges;
  const Vector3 x = Scaled(a, 1.0 / Length(a));
  const Vector3 normal = Cross(a, b);
  const Vector3 z = Scaled(normal, 1.0 / Length(normal));
  return { x, Cross(z, x), z };
}

// Turns cell and centres about the cell's origin
void Turn(PackFrame& frame, FrameCell& cell)
{
  const std::array<Vector3, 3> axes = AxesOf(cell);
  const auto turned = [&](const Vector3& v) {
    return Vector3{ Dot(axes[0], v), Dot(axes[1], v), Dot(axes[2], v) };
  };
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    const Vector3 v = turned(
      { frame.X[i] - cell.Origin[0], frame.Y[i] - cell.Origin[1], frame.Z[i] - cell.Origin[2] });
    frame.X[i] = cell.Origin[0] + v[0];
    frame.Y[i] = cell.Origin[1] + v[1];
    frame.Z[i] = cell.Origin[2] + v[2];
  }
  for (Vector3& edge : cell.Edges)
  {
    edge = turned(edge);
  }
  // What is left here is rounding
  cell.Edges[0][1] = cell.Edges[0][2] = cell.Edges[1][2] = 0.0;
  frame.Warnings.push_back("The pack was turned so that the first edge of its box lies along x and "
                           "the second in the plane of x and y.");
}
}

FrameCell FrameCell::FromBounds(const Vector3& low, const Vector3& high)
{
  return { low,
    { Vector3{ high[0] - low[0], 0, 0 }, { 0, high[1] - low[1], 0 }, { 0, 0, high[2] - low[2] } } };
}

FrameCell FrameCell::FromBox(const FrameBox& box)
{
  return { box.Origin,
    { Vector3{ box.Edges[0], 0, 0 }, { box.Tilts[0], box.Edges[1], 0 },
      { box.Tilts[1], box.Tilts[2], box.Edges[2] } } };
}

void SetBox(PackFrame& frame, const FrameCell& given, const std::array<bool, 3>& periodic,
  bool periodicityKnown)
{
  CheckCell(given);
  FrameCell cell = given;
  auto& [a, b, c] = cell.Edges;
  if (a[1] != 0.0 || a[2] != 0.0 || b[2] != 0.0)
  {
    Turn(frame, cell);
  }
  for (int q = 0; q < 3; ++q)
  {
    Vector3& edge = cell.Edges[q];
    if (edge[q] < 0.0)
    {
      cell.Origin = Sum(cell.Origin, edge);
      edge = Sum(Vector3{}, Scaled(edge, -1.0)); // no negative zeros
    }
  }
  FrameBox box;
  box.Origin = cell.Origin;
  box.Edges = { a[0], b[1], c[2] };
  box.Tilts = { b[0], c[0], c[1] };
  box.Periodic = periodic;
  box.PeriodicityKnown = periodicityKnown;
  frame.Box = box;
}

void PlaceFractions(PackFrame& frame, const FrameCell& cell)
{
  const auto& [a, b, c] = cell.Edges;
  for (std::size_t i = 0; i < frame.Size(); ++i)
  {
    const double u = frame.X[i], v = frame.Y[i], w = frame.Z[i];
    frame.X[i] = cell.Origin[0] + u * a[0] + v * b[0] + w * c[0];
    frame.Y[i] = cell.Origin[1] + u * a[1] + v * b[1] + w * c[1];
    frame.Z[i] = cell.Origin[2] + u * a[2] + v * b[2] + w * c[2];
  }
}
}

// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Images/SphereFractions.h"

#include "ruc/Images/BallInBox.h"

#include <algorithm>
#include <cmath>

namespace ruc
{
std::pair<int, int> VoxelsReached(double centre, double radius, double spacing, int first, int last)
{
  // Compared as doubles, since a far sphere has no integer
  const double from = std::floor((centre - radius) / spacing);
  const double to = std::floor((centre + radius) / spacing) + 1.0;
  const int begin = from > first ? static_cast<int>(std::min<double>(from, last)) : first;
  const int end = to < last ? static_cast<int>(std::max<double>(to, first)) : last;
  return { begin, std::max(begin, end) };
}

SphereFractions::SphereFractions(const VoxelGrid& grid, FractionMethod method, int samplesPerAxis)
  : Grid(grid)
  , Method(method)
  , Samples(samplesPerAxis)
{
}

void SphereFractions::SetAxis(int q, double centre, double radius, int first, int last)
{
  Axis& axis = this->Axes[q];
  const double h = this->Grid.Spacing[q];
  const auto [begin, end] = VoxelsReached(centre, radius, h, first, last);
  axis.First = begin;
  axis.Count = end - begin;
  axis.Corner.resize(axis.Count + 1);
  for (int i = 0; i <= axis.Count; ++i)
  {
    axis.Corner[i] = (axis.First + i) * h - centre;
  }
  axis.Near.resize(axis.Count);
  axis.Far.resize(axis.Count);
  for (int i = 0; i < axis.Count; ++i)
  {
    const double low = axis.Corner[i], high = axis.Corner[i + 1];
    const double near = std::max({ low, -high, 0.0 }), far = std::max(-low, high);
    axis.Near[i] = near * near;
    axis.Far[i] = far * far;
  }
  if (this->Method == FractionMethod::Exact)
  {
    axis.Cap.resize(axis.Count + 1);
    std::transform(axis.Corner.begin(), axis.Corner.end(), axis.Cap.begin(),
      [&](double corner) { return BallWedge(std::abs(corner), 0.0, radius); });
    return;
  }
  axis.SampleSquare.resize(axis.Count * this->Samples);
  for (int n = 0; n < axis.Count * this->Samples; ++n)
  {
    const double place =
      (axis.First + n / this->Samples + (n % this->Samples + 0.5) / this->Samples) * h - centre;
    axis.SampleSquare[n] = place * place;
  }
}

void SphereFractions::SetWedges(int p, int q, double radius, std::vector<double>& wedges) const
{
  wedges.clear();
  for (double b : this->Axes[q].Corner)
  {
    for (double a : this->Axes[p].Corner)
    {
      wedges.push_back(BallWedge(std::abs(a), std::abs(b), radius));
    }
  }
}

void SphereFractions::FindPlane(int k, double radius, std::vector<double>& differences)
{
  const auto& [axisX, axisY, axisZ] = this->Axes;
  const int corners = axisX.Count + 1;
  const double square = radius * radius, octant = BallWedge(0.0, 0.0, radius);
  const double z = axisZ.Corner[k];
  const double* x = axisX.Corner.data();
  const double* capX = axisX.Cap.data();
  const double* wedgesXZ = this->WedgesXZ.data() + std::size_t(k) * corners;
  const double* wedgesYZ = this->WedgesYZ.data() + std::size_t(k) * (axisY.Count + 1);
  differences.resize(std::size_t(axisX.Count) * axisY.Count);
  std::vector<double>& row = this->Row;
  row.resize(2 * corners);
  for (int j = 0; j <= axisY.Count; ++j)
  {
    // This row of corners, and that of the former j
    double* now = row.data() + (j % 2) * corners;
    const double* former = row.data() + ((j + 1) % 2) * corners;
    const double y = axisY.Corner[j], yz = y * z, yz2 = y * y + z * z;
    const double ofYZ = octant - axisY.Cap[j] - axisZ.Cap[k] + wedgesYZ[j];
    const double* wedgesXY = this->WedgesXY.data() + std::size_t(j) * corners;
    for (int i = 0; i < corners; ++i)
    {
      const double outside = ofYZ - capX[i] + wedgesXY[i] + wedgesXZ[i];
      const double product = x[i] * yz;
      now[i] = x[i] * x[i] + yz2 <= square ? product : std::copysign(outside, product);
    }
    for (int i = 0; j > 0 && i < axisX.Count; ++i)
    {
      differences[std::size_t(j - 1) * axisX.Count + i] =
        (now[i + 1] - now[i]) - (former[i + 1] - former[i]);
    }
  }
}

float* SphereFractions::RowOf(const VoxelBlock& block, int j, int k, float* values) const
{
  const std::size_t y = this->Axes[1].First + j - block.First[1];
  const std::size_t z = this->Axes[2].First + k - block.First[2];
  return values + (z * block.Count[1] + y) * block.Count[0] + this->Axes[0].First - block.First[0];
}

void SphereFractions::AddExact(double radius, const VoxelBlock& block, float* values)
{
  const auto& [axisX, axisY, axisZ] = this->Axes;
  this->SetWedges(0, 1, radius, this->WedgesXY);
  this->SetWedges(0, 2, radius, this->WedgesXZ);
  this->SetWedges(1, 2, radius, this->WedgesYZ);
  const double square = radius * radius, inverse = 1.0 / this->Grid.VoxelVolume();
  this->FindPlane(0, radius, this->Before);
  for (int k = 0; k < axisZ.Count; ++k)
  {
    this->FindPlane(k + 1, radius, this->After);
    for (int j = 0; j < axisY.Count; ++j)
    {
      float* row = this->RowOf(block, j, k, values);
      const double* before = this->Before.data() + std::size_t(j) * axisX.Count;
      const double* after = this->After.data() + std::size_t(j) * axisX.Count;
      const double nearYZ = axisY.Near[j] + axisZ.Near[k], farYZ = axisY.Far[j] + axisZ.Far[k];
      for (int i = 0; i < axisX.Count; ++i)
      {
        const double share = (after[i] - before[i]) * inverse;
        const double border = std::min(std::max(share, 0.0), 1.0);
        const double inside = axisX.Far[i] + farYZ <= square ? 1.0 : border;
        row[i] += static_cast<float>(axisX.Near[i] + nearYZ >= square ? 0.0 : inside);
      }
    }
    this->Before.swap(this->After);
  }
}

int SphereFractions::CountSamples(int i, int j, int k, double square) const
{
  const int n = this->Samples;
  const double* x = this->Axes[0].SampleSquare.data() + std::size_t(i) * n;
  const double* y = this->Axes[1].SampleSquare.data() + std::size_t(j) * n;
  const double* z = this->Axes[2].SampleSquare.data() + std::size_t(k) * n;
  int count = 0;
  for (int c = 0; c < n; ++c)
  {
    for (int b = 0; b < n; ++b)
    {
      const double yz2 = y[b] + z[c];
      for (int a = 0; a < n; ++a)
      {
        count += x[a] + yz2 <= square;
      }
    }
  }
  return count;
}

void SphereFractions::AddSampled(double radius, const VoxelBlock& block, float* values)
{
  const auto& [axisX, axisY, axisZ] = this->Axes;
  const double square = radius * radius, each = 1.0 / std::pow(this->Samples, 3);
  for (int k = 0; k < axisZ.Count; ++k)
  {
    for (int j = 0; j < axisY.Count; ++j)
    {
      float* row = this->RowOf(block, j, k, values);
      for (int i = 0; i < axisX.Count; ++i)
      {
        if (axisX.Far[i] + axisY.Far[j] + axisZ.Far[k] <= square)
        {
          row[i] += 1.0f;
        }
        else if (axisX.Near[i] + axisY.Near[j] + axisZ.Near[k] < square)
        {
          row[i] += static_cast<float>(each * this->CountSamples(i, j, k, square));
        }
      }
    }
  }
}

void SphereFractions::Add(const Vector3& centre, double radius, const VoxelBlock& block,
  const VoxelRange& planes, float* values)
{
  const std::array<int, 3> last = { block.First[0] + block.Count[0],
    block.First[1] + block.Count[1], planes.Last };
  const std::array<int, 3> first = { block.First[0], block.First[1], planes.First };
  for (int q = 0; q < 3; ++q)
  {
    this->SetAxis(q, centre[q] - this->Grid.Lower[q], radius, first[q], last[q]);
    if (this->Axes[q].Count == 0)
    {
      return;
    }
  }
  if (this->Method == FractionMethod::Exact)
  {
    this->AddExact(radius, block, values);
  }
  else
  {
    this->AddSampled(radius, block, values);
  }
}
}

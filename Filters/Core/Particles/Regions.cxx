// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/Regions.h"

#include <algorithm>

namespace ruc
{
RegionTree::RegionTree(const SpherePack& piece, std::int64_t total, Communicator& ranks)
{
  constexpr std::int64_t sampleSize = 65536;
  const std::size_t stride = static_cast<std::size_t>((total + sampleSize - 1) / sampleSize);
  std::vector<Vector3> sample;
  for (std::size_t i = 0; i < piece.Size(); i += stride)
  {
    sample.push_back(piece.Centre(i));
  }
  std::vector<Vector3> points = ranks.Concatenate(sample);
  this->Root = this->Divide(points.begin(), points.end(), 0, ranks.Size());
}

int RegionTree::Divide(
  std::vector<Vector3>::iterator begin, std::vector<Vector3>::iterator end, int first, int last)
{
  if (last - first == 1)
  {
    return -1 - first;
  }
  int axis = 0;
  double longest = -1.0;
  for (int q = 0; q < 3 && begin != end; ++q)
  {
    const auto [low, high] = std::minmax_element(
      begin, end, [q](const Vector3& a, const Vector3& b) { return a[q] < b[q]; });
    if ((*high)[q] - (*low)[q] > longest)
    {
      longest = (*high)[q] - (*low)[q];
      axis = q;
    }
  }
  // The lower half of the ranks gets its share of the points; with too few points some get none
  const int middle = first + (last - first) / 2;
  const auto cut = begin + (end - begin) * (middle - first) / (last - first);
  std::nth_element(
    begin, cut, end, [axis](const Vector3& a, const Vector3& b) { return a[axis] < b[axis]; });
  const int node = static_cast<int>(this->Nodes.size());
  this->Nodes.push_back({ axis, cut != end ? (*cut)[axis] : 0.0, 0, 0 });
  const int lower = this->Divide(begin, cut, first, middle);
  const int upper = this->Divide(cut, end, middle, last);
  this->Nodes[node].Lower = lower;
  this->Nodes[node].Upper = upper;
  return node;
}

int RegionTree::OwnerOf(const Vector3& point) const
{
  int node = this->Root;
  while (node >= 0)
  {
    const Node& n = this->Nodes[node];
    node = point[n.Axis] < n.Cut ? n.Lower : n.Upper;
  }
  return -1 - node;
}
}

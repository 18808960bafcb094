// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/Population/GeneticOperators.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ruc
{
namespace
{
double Wrapped(double c, double edge)
{
  const double rest = c - edge * std::floor(c / edge);
  return rest < edge ? rest : 0.0; // rounding may give the edge itself
}

// The difference to the nearest image
double Difference(double from, double to, double edge)
{
  const double difference = to - from;
  return difference - edge * std::round(difference / edge);
}

int NumberOfSpheres(const Chromosome& centres)
{
  return static_cast<int>(centres.size() / 3);
}

// Draws `number` different spheres of `all` by the start of a Fisher-Yates shuffle
std::vector<int> DrawSpheres(int all, int number, RandomSequence& random)
{
  std::vector<int> spheres(all);
  std::iota(spheres.begin(), spheres.end(), 0);
  for (int n = 0; n < number; ++n)
  {
    std::swap(spheres[n], spheres[n + random.NextIndex(all - n)]);
  }
  spheres.resize(number);
  return spheres;
}

// Changes every gene of `spheres` drawn spheres into change(place of the gene)
template <class Change>
Chromosome ChangeSpheres(
  const Chromosome& parent, int spheres, RandomSequence& random, Change&& change)
{
  Chromosome child = parent;
  for (int i : DrawSpheres(NumberOfSpheres(parent), spheres, random))
  {
    for (int k = 3 * i; k < 3 * i + 3; ++k)
    {
      child[k] = change(k);
    }
  }
  return child;
}

double MovedTowardsBound(
  double gene, double edge, const MutationRange& range, RandomSequence& random)
{
  const double bound = random.Next() < 0.5 ? -0.5 * edge : 0.5 * edge;
  const double f = random.Next() * std::pow(1.0 - range.Share, range.Shape);
  return Wrapped(gene + bound * range.Reach * f, edge);
}
}

Chromosome UniformMutation(
  const Chromosome& parent, double edge, int spheres, RandomSequence& random)
{
  return ChangeSpheres(parent, spheres, random, [&](int) { return edge * random.Next(); });
}

Chromosome BoundaryMutation(const Chromosome& parent, int spheres, RandomSequence& random)
{
  Chromosome child = parent;
  for (int i : DrawSpheres(NumberOfSpheres(parent), spheres, random))
  {
    child[3 * i + random.NextIndex(3)] = 0.0;
  }
  return child;
}

Chromosome NonUniformMutation(const Chromosome& parent, double edge, int spheres,
  const MutationRange& range, RandomSequence& random)
{
  return ChangeSpheres(parent, spheres, random,
    [&](int k) { return MovedTowardsBound(parent[k], edge, range, random); });
}

Chromosome MultiNonUniformMutation(
  const Chromosome& parent, double edge, const MutationRange& range, RandomSequence& random)
{
  Chromosome child = parent;
  for (double& gene : child)
  {
    gene = MovedTowardsBound(gene, edge, range, random);
  }
  return child;
}

Chromosome SimpleCrossover(
  const Chromosome& first, const Chromosome& second, RandomSequence& random)
{
  const int cut = 1 + random.NextIndex(NumberOfSpheres(first) - 1);
  Chromosome child = first;
  std::copy(second.begin() + 3 * cut, second.end(), child.begin() + 3 * cut);
  return child;
}

Chromosome SimpleArithmeticCrossover(const Chromosome& first, const Chromosome& second, double edge,
  int spheres, RandomSequence& random)
{
  const double p = random.Next();
  return ChangeSpheres(first, spheres, random,
    [&](int k)
    { return Wrapped(first[k] + (1.0 - p) * Difference(first[k], second[k], edge), edge); });
}

Chromosome WholeArithmeticCrossover(
  const Chromosome& first, const Chromosome& second, double edge, RandomSequence& random)
{
  const double p = random.Next();
  Chromosome child = first;
  for (std::size_t k = 0; k < child.size(); ++k)
  {
    child[k] = Wrapped(first[k] + (1.0 - p) * Difference(first[k], second[k], edge), edge);
  }
  return child;
}

Chromosome HeuristicCrossover(
  const Chromosome& better, const Chromosome& worse, double edge, RandomSequence& random)
{
  const double p = random.Next();
  Chromosome child = better;
  for (std::size_t k = 0; k < child.size(); ++k)
  {
    child[k] = Wrapped(better[k] + p * Difference(worse[k], better[k], edge), edge);
  }
  return child;
}

GeneticOperator DrawOperator(const OperatorWeights& weights, RandomSequence& random)
{
  double rest = random.Next() * std::accumulate(weights.begin(), weights.end(), 0.0);
  int last = 0;
  for (int n = 0; n < NumberOfGeneticOperators; ++n)
  {
    if (weights[n] > 0.0)
    {
      last = n;
      if (rest < weights[n])
      {
        break;
      }
      rest -= weights[n];
    }
  }
  return static_cast<GeneticOperator>(last);
}

Chromosome ApplyOperator(GeneticOperator number, const Chromosome& parent, const Chromosome& mate,
  bool parentIsBetter, double edge, int spheres, const MutationRange& range, RandomSequence& random)
{
  switch (number)
  {
    case GeneticOperator::UniformMutation:
      return UniformMutation(parent, edge, spheres, random);
    case GeneticOperator::BoundaryMutation:
      return BoundaryMutation(parent, spheres, random);
    case GeneticOperator::NonUniformMutation:
      return NonUniformMutation(parent, edge, spheres, range, random);
    case GeneticOperator::MultiNonUniformMutation:
      return MultiNonUniformMutation(parent, edge, range, random);
    case GeneticOperator::SimpleCrossover:
      return SimpleCrossover(parent, mate, random);
    case GeneticOperator::SimpleArithmeticCrossover:
      return SimpleArithmeticCrossover(parent, mate, edge, spheres, random);
    case GeneticOperator::WholeArithmeticCrossover:
      return WholeArithmeticCrossover(parent, mate, edge, random);
    case GeneticOperator::HeuristicCrossover:
      break;
  }
  return parentIsBetter ? HeuristicCrossover(parent, mate, edge, random)
                        : HeuristicCrossover(mate, parent, edge, random);
}
}

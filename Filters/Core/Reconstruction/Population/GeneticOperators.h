// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Random.h"

#include <array>
#include <vector>

namespace ruc
{
/**
 * @file
 * The real-coded operators of the augmented simulated annealing: Michalewicz, Genetic Algorithms +
 * Data Structures = Evolution Programs, Springer 1992; Matous, Leps, Zeman, Sejnoha, Comput.
 * Methods Appl. Mech. Engrg. 190, 1629 (2000), the paper's reference [46].
 *
 * A gene is a coordinate of a sphere's centre, and a chromosome is x, y, z of all n spheres. The
 * bounds are those of the cell, L = 0 and U = edge. The cell is periodic and looks the same from
 * every point. Hence
 *
 * - every result is wrapped into [0, edge);
 * - a mutation that moves a gene towards a bound takes the box of that edge around the gene, so
 *   that L and U are half an edge away;
 * - an arithmetic combination goes the short way round, to the nearest image of the other gene.
 *
 * One gene of three thousand makes no difference that a search could feel. So where the textbook
 * changes one gene, x_k, these operators change `spheres` spheres, in 1…n: all three coordinates of
 * each, unless one is named. The spheres are different ones, drawn uniformly.
 *
 * All are pure functions of the parents and the random numbers.
 */

using Chromosome = std::vector<double>;

/** x'_k = u(L, U): the spheres go to new places, drawn uniformly. */
Chromosome UniformMutation(
  const Chromosome& parent, double edge, int spheres, RandomSequence& random);

/**
 * x'_k = L or U for one coordinate of each sphere, drawn by lot. L and U are the same plane of the
 * periodic cell, so the coordinate becomes 0.
 */
Chromosome BoundaryMutation(const Chromosome& parent, int spheres, RandomSequence& random);

/** How far a non-uniform mutation goes. */
struct MutationRange
{
  double Share = 0.0; // g / G, the share of the generations that are over, in [0, 1]
  double Shape = 2.0; // b
  double Reach = 1.0; // in half edges, in (0, 1]; 1 is the textbook's
};

/**
 * x'_k = x_k + (L - x_k) f or x_k + (U - x_k) f, each as often, where f = u(0, 1) (1 - g / G)^b.
 * The spheres move less and less far.
 */
Chromosome NonUniformMutation(const Chromosome& parent, double edge, int spheres,
  const MutationRange& range, RandomSequence& random);

/** The non-uniform mutation of all genes. */
Chromosome MultiNonUniformMutation(
  const Chromosome& parent, double edge, const MutationRange& range, RandomSequence& random);

/**
 * The spheres before a place drawn from 1…n - 1 come from the first parent, the others from the
 * second.
 */
Chromosome SimpleCrossover(
  const Chromosome& first, const Chromosome& second, RandomSequence& random);

/**
 * x'_k = p x_k + (1 - p) y_k, where p = u(0, 1) is the same for all genes that change. The other
 * genes are those of x.
 */
Chromosome SimpleArithmeticCrossover(const Chromosome& first, const Chromosome& second, double edge,
  int spheres, RandomSequence& random);

/** The arithmetic crossover of all genes. */
Chromosome WholeArithmeticCrossover(
  const Chromosome& first, const Chromosome& second, double edge, RandomSequence& random);

/**
 * x' = x + p (x - y) for all genes, where p = u(0, 1): on from the worse parent y beyond the better
 * one x.
 */
Chromosome HeuristicCrossover(
  const Chromosome& better, const Chromosome& worse, double edge, RandomSequence& random);

/** The operators above. Weights of operators are in this order. */
enum class GeneticOperator
{
  UniformMutation,
  BoundaryMutation,
  NonUniformMutation,
  MultiNonUniformMutation,
  SimpleCrossover,
  SimpleArithmeticCrossover,
  WholeArithmeticCrossover,
  HeuristicCrossover
};
constexpr int NumberOfGeneticOperators = 8;
using OperatorWeights = std::array<double, NumberOfGeneticOperators>;

/** Draws one of the operators by a roulette of these weights, whose sum is > 0. */
GeneticOperator DrawOperator(const OperatorWeights& weights, RandomSequence& random);

/**
 * Returns the child that an operator makes of `parent`, and of `mate` where it takes two.
 * `parentIsBetter` says which of the two is better, for the heuristic crossover.
 */
Chromosome ApplyOperator(GeneticOperator number, const Chromosome& parent, const Chromosome& mate,
  bool parentIsBetter, double edge, int spheres, const MutationRange& range,
  RandomSequence& random);
}

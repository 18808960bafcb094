// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientSearch.h"

#include <cmath>

namespace ruc
{
StageLengths::StageLengths(int maximum, bool withNeighbours)
  : First(maximum)
{
  if (withNeighbours)
  {
    this->First = static_cast<int>(std::ceil(0.6 * maximum));
    this->WithNeighbours = static_cast<int>(std::ceil(0.9 * maximum));
  }
}

Estimate EstimateGradientSearch(
  const CellFigures& cell, const LagGrid& lags, const GradientSearchSettings& settings)
{
  const NeighbourTarget& neighbours = settings.Neighbours;
  const StageLengths lengths(settings.MaximumIterations, neighbours.IsWanted());
  const double evaluation = EstimateEvaluation(cell, lags, true);
  Estimate estimate{ cell.Spheres * SecondsPerStartedSphere + (lengths.All() + 1.0) * evaluation,
    (cell.Spheres * 1000.0 + EstimateObjectiveBytes(cell, lags)) / BytesOfMegabyte, 0.0 };
  if (neighbours.IsWanted())
  {
    Estimate terms;
    terms += neighbours.PoreWeight > 0.0 ? EstimatePoreTerm(cell.Spheres) : Estimate();
    terms += neighbours.SpectrumWeight > 0.0 ? EstimateSpectrumTerm(cell) : Estimate();
    terms += neighbours.ThirdOrderWeight > 0.0 ? EstimateThirdOrderTerm(cell, settings.ThirdOrder)
                                               : Estimate();
    estimate.Seconds += lengths.WithNeighbours * terms.Seconds;
    estimate.MegabytesOfRank += terms.MegabytesOfRank;
  }
  estimate += EstimateDenseStart(cell);
  return estimate;
}
}

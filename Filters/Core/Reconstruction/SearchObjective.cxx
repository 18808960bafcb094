// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/SearchObjective.h"

namespace ruc
{
SearchObjective::SearchObjective(const CellContents& contents, const TwoPointProbability& target,
  const NeighbourTarget& neighbours, bool dense, ContactState& contacts, Communicator& communicator)
  : Neighbours(neighbours)
  , Pairs(contents, target, communicator)
{
  this->Pairs.SetPenaltyWeight(dense ? 0.0 : DescentPenaltyWeight);
  const std::vector<double> anywhere(3 * contents.NumberOfSpheres(), 0.0);
  const SpherePack spheres = contents.MakePack(anywhere.data());
  if (dense)
  {
    this->Contacts.emplace(
      contents.Enlarged().MakePack(anywhere.data()), contents.MakeBox(), contacts);
  }
  if (neighbours.HasContacts())
  {
    this->Near.emplace(spheres, contents.MakeBox(), neighbours.Pack);
  }
  if (neighbours.HasPores())
  {
    this->Pores.emplace(contents, neighbours.Pack, communicator);
  }
  if (neighbours.HasSpectrum())
  {
    this->Spectrum.emplace(contents, neighbours.Spectrum, communicator);
  }
  if (neighbours.HasThirdOrder())
  {
    this->ThirdOrder.emplace(contents, neighbours.ThirdOrder, communicator);
  }
}

void SearchObjective::BeginNeighbours(double reference)
{
  this->Reference = reference;
}

void SearchObjective::MoveLattice(int n)
{
  if (this->Pores)
  {
    this->Pores->MoveLattice(n);
  }
}

SearchObjective::Terms SearchObjective::Evaluate(
  const double* centres, double* gradient, std::int64_t* signal)
{
  const CellObjective::Terms pairs = this->Pairs.Evaluate(centres, gradient, signal);
  Terms terms;
  terms.TwoPoint = pairs.TwoPoint;
  if (this->Reference > 0.0)
  {
    terms.Misfits = this->AddNeighbours(centres, gradient);
  }
  const double penalty = this->Contacts ? this->Contacts->Add(centres, gradient) : pairs.Penalty;
  terms.Total = this->ValueOf(pairs.TwoPoint, terms.Misfits) + penalty;
  return terms;
}

NeighbourMisfits SearchObjective::FindMisfits(const double* centres)
{
  return this->AddNeighbours(centres, nullptr);
}

double SearchObjective::ValueOf(double twoPoint, const NeighbourMisfits& misfits) const
{
  const NeighbourMisfits worth = this->Worths();
  return twoPoint + worth.Gaps * misfits.Gaps + worth.Nearest * misfits.Nearest +
    worth.Pores * misfits.Pores + worth.Spectrum * misfits.Spectrum +
    worth.ThirdOrder * misfits.ThirdOrder;
}

NeighbourMisfits SearchObjective::Worths() const
{
  constexpr double shareOfStiff = 0.05; // found on the example pack
  const double stiff = shareOfStiff * this->Reference;
  NeighbourMisfits worth;
  worth.Gaps = worth.Nearest = stiff * this->Neighbours.ContactWeight;
  worth.Pores = stiff * this->Neighbours.PoreWeight;
  worth.Spectrum = this->Reference * this->Neighbours.SpectrumWeight;
  worth.ThirdOrder = this->Reference * this->Neighbours.ThirdOrderWeight;
  return worth;
}

NeighbourMisfits SearchObjective::AddNeighbours(const double* centres, double* gradient)
{
  const NeighbourMisfits worth = this->Worths();
  NeighbourMisfits misfits;
  if (this->Near)
  {
    const ContactTerm::Misfits near = this->Near->Evaluate(centres, worth.Gaps, gradient);
    misfits.Gaps = near.Gaps;
    misfits.Nearest = near.Nearest;
  }
  if (this->Pores)
  {
    misfits.Pores = this->Pores->Evaluate(centres, worth.Pores, gradient);
  }
  if (this->Spectrum)
  {
    misfits.Spectrum = this->Spectrum->Evaluate(centres, worth.Spectrum, gradient);
  }
  if (this->ThirdOrder)
  {
    misfits.ThirdOrder = this->ThirdOrder->Evaluate(centres, worth.ThirdOrder, gradient);
  }
  return misfits;
}
}

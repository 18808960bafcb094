// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Reconstruction/GradientState.h"

#include "ruc/Base/Text.h"
#include "ruc/Reconstruction/CellStart.h"

#include <stdexcept>

namespace ruc
{
namespace
{
bool FitsNeighbours(const GradientState& state)
{
  return state.Reference >= 0.0 && state.Reference < 1e30 && state.Before >= 0 &&
    state.Before <= state.Descent.Iterations && state.Lattice >= 0 &&
    state.Lattice <= state.Descent.Iterations;
}

}

void CheckState(const GradientState& state, const CellContents& contents, bool dense)
{
  const int spheres = contents.NumberOfSpheres();
  const std::size_t length = 3 * std::size_t(spheres);
  if (state.Descent.Place.size() != length || state.Best.size() != length)
  {
    throw std::invalid_argument(Text("Resuming requires a state of ", spheres,
      " spheres, got one of ", state.Descent.Place.size() / 3, "."));
  }
  const double longest = dense ? LongestEdge * contents.Edge : contents.Edge;
  if ((state.Contacts.Stiffness > 0.0) != dense || !state.Contacts.CanBe(spheres) ||
    !(state.Edge >= contents.Edge && state.Edge <= longest))
  {
    throw std::invalid_argument("The contacts of the state are damaged or of another cell.");
  }
  if (!FitsNeighbours(state))
  {
    throw std::invalid_argument("The near neighbours of the state are damaged.");
  }
}
}

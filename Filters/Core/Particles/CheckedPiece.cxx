// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ruc/Particles/CheckedPiece.h"

#include "ruc/Base/Text.h"

#include <stdexcept>
#include <utility>

namespace ruc
{
CheckedPiece::CheckedPiece(
  SpherePack piece, bool withModes, const WindowFinder& findWindow, bool crop, Communicator& ranks)
  : Piece(std::move(piece))
  , Modes(withModes)
{
  this->Count(ranks);
  if (this->Total == 0)
  {
    throw std::invalid_argument(NoSpheres);
  }
  ranks.ThrowIfAny(FindFaultySphere(this->Piece, withModes, this->Total));
  const Window& window = this->ObservedIn = findWindow(this->Piece);
  this->Moved = MoveIntoBox(this->Piece, window);
  ranks.Sum(&this->Moved, 1);
  if (crop)
  {
    this->Piece = CropToWindow(this->Piece, window);
    this->Count(ranks);
    if (this->Total == 0)
    {
      throw std::invalid_argument(
        Text("The ", window.Describe(), " requires at least one centre inside, got none."));
    }
  }
  std::int64_t outside = 0;
  const std::string example = FindOutside(this->Piece, window, outside);
  ranks.Sum(&outside, 1);
  ranks.ThrowIfAny(
    example.empty() ? example : OutsideMessage(window, outside, this->Total, example));
  double largest = -this->Piece.LargestRadius(); // minus the largest radius of all ranks
  ranks.Minimum(&largest, 1);
  ranks.ThrowIfAny(FindNarrowEdge(-largest, window));
}

CheckedPiece::CheckedPiece(
  SpherePack piece, const Window& window, bool withModes, Communicator& ranks)
  : CheckedPiece(
      std::move(piece), withModes, [&](const SpherePack&) { return window; }, false, ranks)
{
}

void CheckedPiece::Count(Communicator& ranks)
{
  this->Total = static_cast<std::int64_t>(this->Piece.Size());
  ranks.Sum(&this->Total, 1);
}
}

// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Communicator.h"
#include "ruc/Particles/SpherePack.h"

#include <cstdint>
#include <functional>

namespace ruc
{
/**
 * One rank's piece of a pack, which may be empty, after every check that needs no other rank's
 * spheres: the pack has spheres, their numbers are in range, their centres lie in the window, and
 * the window has room for the largest of them. Whoever takes one need not check that again.
 */
class CheckedPiece
{
public:
  /**
   * Finds the window of the whole pack from this rank's spheres, whose numbers were checked. It is
   * called on all ranks together, and must throw on all or on none.
   */
  using WindowFinder = std::function<Window(const SpherePack& piece)>;

  /**
   * Checks a piece. `Mode` is checked only if `withModes`. Centres outside the window along a
   * periodic axis are moved into it (MoveIntoBox). With `crop`, spheres with centres that are still
   * outside are left out; otherwise they are an error. Throws std::invalid_argument, the same on
   * every rank. Collective.
   */
  CheckedPiece(SpherePack piece, bool withModes, const WindowFinder& findWindow, bool crop,
    Communicator& ranks);

  /** The same with a known window. */
  CheckedPiece(SpherePack piece, const Window& window, bool withModes, Communicator& ranks);

  const SpherePack& Spheres() const { return this->Piece; }
  /** Moves the spheres out of this object. */
  SpherePack Take() { return std::move(this->Piece); }
  const Window& Observed() const { return this->ObservedIn; }
  /** Returns the number of spheres on all ranks together. */
  std::int64_t NumberOfSpheres() const { return this->Total; }
  /**
   * Returns how many of them were outside the window along a periodic axis, and were moved into it.
   */
  std::int64_t NumberMoved() const { return this->Moved; }
  /** Returns whether `Mode` was checked. */
  bool WithModes() const { return this->Modes; }

private:
  void Count(Communicator& ranks);

  SpherePack Piece;
  Window ObservedIn;
  std::int64_t Total = 0;
  std::int64_t Moved = 0;
  bool Modes;
};
}

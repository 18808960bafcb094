// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/SpherePack.h"

#include <optional>
#include <string>
#include <vector>

namespace ruc
{
/** What a user should see of a pack that was read, to notice a wrong column, unit or window. */
struct PackOverview
{
  std::string Text;                  // a single line
  std::vector<std::string> Warnings; // each is a sentence

  /**
   * Describes a pack whose centres were observed in `window`, if that is known; `source` says where
   * it comes from. The text gives the number of spheres, their diameters, the extent of their
   * centres, the window, and the fraction of it that the spheres' volumes add up to; without a
   * window, the fraction of the bounds of the centres. Warnings are for
   * - three or more centres that lie within a tenth of the window along every axis, as numbers in
   *   another unit than the window's do: by chance that has a probability below 3e-5;
   * - a fraction below 1e-4, as with radii in another unit than the centres;
   * - a fraction of a window of 1 or more, as with diameters taken as radii;
   * - radii of 0, which no filter takes.
   */
  PackOverview(const SpherePack& pack, const std::optional<Window>& window,
    const std::string& source, const std::string& unit);
};
}

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
  std::string Text;                  // one line
  std::vector<std::string> Warnings; // a sentence each

  /**
   * Of a pack whose centres were observed in `window`, where that is known; `source` says by what.
   * The text has the number of spheres, their radii, the extent of their centres, the window and
   * the fraction of it that the spheres' volumes add up to, without a window that of the bounds of
   * the centres. Warnings are for
   * - three or more centres that lie within a tenth of the window along every axis, as of numbers
   *   in another unit than the window's: by chance that has a probability below 3e-5;
   * - a fraction below 1e-4, as of radii in another unit than the centres;
   * - a fraction of a window of 1 or more, as of diameters taken as radii;
   * - radii of 0, which no filter takes.
   */
  PackOverview(const SpherePack& pack, const std::optional<Window>& window,
    const std::string& source, const std::string& unit);
};
}

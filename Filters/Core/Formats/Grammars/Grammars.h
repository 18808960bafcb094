// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Formats/PackFormats.h"

namespace ruc
{
// Each grammar has a file of its own, which says at its top what is taken from it, and its source.
extern const PackFormat BaranauXyzd;
extern const PackFormat EsysGeometry;
extern const PackFormat ExtendedXyz;
extern const PackFormat HoomdGsd;
extern const PackFormat LammpsData;
extern const PackFormat LammpsDump;
extern const PackFormat LbpmPack;
extern const PackFormat MercuryData;
extern const PackFormat SkogePack;
extern const PackFormat Table;
extern const PackFormat YadeText;

/** Returns the unit of length of a unit style of LAMMPS. It is empty for lj, which has none. */
std::string LengthUnitOfStyle(std::string_view style);

/** Returns the only unit style of LAMMPS with that unit of length, or an empty text. */
std::string StyleOfLengthUnit(std::string_view unit);

/** The Scan of formats that hold one frame. */
inline std::vector<FramePlace> ScanOneFrame(ByteStream&)
{
  return { FramePlace() };
}
}

// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PackWindow.h"
#include "RUCCommonModule.h"
#include "ResultData.h"
#include "ruc/Particles/PackShare.h"

#include "vtkType.h"

class RankCommunicator;
class vtkAbstractArray;
class vtkDataArray;
class vtkFieldData;
class vtkPointSet;
class vtkPolyData;

/**
 * Sphere packs as VTK point sets, with the arrays that README names. PackInput makes one point set
 * on each rank of what a filter gets as input.
 */
namespace PackData RUCCOMMON_EXPORT
{
/** A whole pack. */
struct ObservedPack : PackOrigin
{
  ruc::SpherePack Pack;
};

/** A rank's piece of a pack, as the input hands it out. */
struct PackPiece : PackOrigin
{
  ruc::CheckedPiece Piece;
};

/** A rank's share of a pack. */
struct SharedPack : PackOrigin
{
  ruc::PackShare Share;
};

/**
 * Returns this rank's piece of the pack and the window of the whole pack (FindOrigin). `Mode` is
 * required and read only `withModes`. Points with a radius from 0 to less than ruc::LeastLength are
 * left out if their diameter is below `leastDiameter`. Spheres outside a window that was found
 * (TakesFoundWindow) are left out as well. The warnings tell of centres that were moved
 * into a periodic box, and of a window that the centres do not fill. Collective.
 *
 * Throws std::invalid_argument, the same on every rank, where an array is missing or not of the
 * form required, and as FindOrigin and ruc::CheckedPiece do.
 */
PackPiece FindPiece(vtkPointSet* input, const WindowProperties& properties, bool withModes,
  RankCommunicator& ranks, double leastDiameter = 0.0);

/**
 * Does what FindPiece and ruc::SharePack do. No rank sees more of the pack than its share.
 * Collective.
 */
SharedPack FindShare(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/**
 * Does what FindPiece and ruc::GatherPack do, for packs that are small, such as unit cells.
 * Collective.
 */
ObservedPack GatherPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/**
 * Returns the array of that name with numbers of one component and a value for each of `count`
 * points, cells or rows, or null where there is none. An array may be shorter than what it belongs
 * to, and VTK reads past its end; so whatever is read point by point comes from here or from
 * RequireArray.
 */
vtkDataArray* FindArray(vtkFieldData* arrays, const char* name, vtkIdType count);

/** Returns what an array holds for messages: numbers of how many components, or text such as what.
 */
std::string DescribeArray(vtkAbstractArray* array);

/** Returns the names of all arrays for messages, such as "'a', 'b' (text)". */
std::string ListArrays(vtkFieldData* arrays);

/**
 * Returns the point array of that name. Throws std::invalid_argument unless it is numeric, with one
 * component and a value for every point.
 */
vtkDataArray* RequireArray(vtkPointSet* input, const char* name);

/** Returns whether any rank's piece has a numeric point array of that name. Collective. */
bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks);

/**
 * Fills in the points, with vertex cells, and the arrays `Radius`, `Mode` where the pack has modes,
 * and `Id`, which is the place in the pack where the pack has none.
 */
void FillPolyData(const ruc::SpherePack& pack, vtkPolyData* output);

}

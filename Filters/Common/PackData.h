// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PackWindow.h"
#include "RUCCommonModule.h"
#include "ResultData.h"
#include "ruc/Particles/PackShare.h"

#include "vtkType.h"

class RankCommunicator;
class vtkDataArray;
class vtkFieldData;
class vtkPointSet;
class vtkPolyData;

/** Sphere packs as VTK point sets, with the arrays that README names. What a filter gets as input
 * becomes one point set a rank in PackInput. */
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
 * Collective: this rank's piece of the pack and the window of the whole (FindOrigin). `Mode` is
 * required and read only `withModes`. Throws std::invalid_argument, the same on every rank, where
 * an array is missing or not of the form required, and as FindOrigin and ruc::CheckedPiece do.
 */
PackPiece FindPiece(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** Collective: FindPiece, and ruc::SharePack. No rank sees more than its share. */
SharedPack FindShare(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** Collective: FindPiece, and ruc::GatherPack. For packs that are small, such as unit cells. */
ObservedPack GatherPack(
  vtkPointSet* input, const WindowProperties& properties, bool withModes, RankCommunicator& ranks);

/** The array of that name with numbers of one component and a value for each of `count` points,
 * cells or rows; null where there is none. An array may be shorter than what it belongs to, and VTK
 * reads past its end: whatever is read a point at a time comes from here or from RequireArray. */
vtkDataArray* FindArray(vtkFieldData* arrays, const char* name, vtkIdType count);

/** The point array of that name, checked: numeric, one component, a value for every point. */
vtkDataArray* RequireArray(vtkPointSet* input, const char* name);

/** Collective: whether any rank's piece has a point array of that name that is of numbers. */
bool HasArray(vtkPointSet* input, const char* name, RankCommunicator& ranks);

/** Points with vertex cells, `Radius`, `Mode` where the pack has modes, and `Id`, where it has none
 * the place in the pack. */
void FillPolyData(const ruc::SpherePack& pack, vtkPolyData* output);

}

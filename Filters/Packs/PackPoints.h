// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Particles/CheckedPiece.h"

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkPointSet;
class vtkPolyData;

/** Packs that keep the arrays of the points that they are made of. */
namespace PackPoints
{
/**
 * Fills the output with the points of the input for which `keep` holds and, with `crop`, whose
 * centres lie in the window of `piece`, which is the input after its checks. Centres go to where
 * the piece has moved them. The output gets vertex cells, and all arrays that have a value for
 * every point. Returns the numbers that its points have in the input.
 */
std::vector<vtkIdType> Copy(vtkPointSet* input, const ruc::CheckedPiece& piece, bool crop,
  const std::function<bool(vtkIdType point)>& keep, vtkPolyData* output);
}

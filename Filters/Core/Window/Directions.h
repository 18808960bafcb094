// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ruc/Base/Vector3.h"

#include <vector>

namespace ruc
{
/**
 * Returns directions (of length 1) that are spread evenly over the half sphere z > 0, on a
 * Fibonacci spiral; every one stands for the same solid angle. Throws std::invalid_argument for a
 * count below 2.
 */
std::vector<Vector3> EvenDirections(int count);
}

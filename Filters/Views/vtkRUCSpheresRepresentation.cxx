// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRUCSpheresRepresentation.h"

#include <vtkObjectFactory.h>

vtkStandardNewMacro(vtkRUCSpheresRepresentation);

# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
include(CMakeFindDependencyMacro)
find_dependency(OpenMP COMPONENTS CXX)
find_dependency(ZLIB)
include("${CMAKE_CURRENT_LIST_DIR}/ruc-targets.cmake")
foreach (component IN LISTS ruc_FIND_COMPONENTS) # folders, in lower case and with _ for /
  if (NOT TARGET ruc::${component} AND ruc_FIND_REQUIRED_${component})
    set(ruc_FOUND FALSE)
    set(ruc_NOT_FOUND_MESSAGE "ruc has no component ${component}")
  endif ()
endforeach ()

# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Packages of the plugin, without what only developers need, for a ParaView of the version that it was built against:
#   cpack -G DEB      for this Debian: depends on its ParaView, and is loaded by it with nothing to set,
#   cpack -G TGZ      to unpack in the folder that holds ParaView's bin and lib.
set(CPACK_PACKAGE_NAME "paraview-representative-unit-cell")
set(CPACK_PACKAGE_VENDOR "Representative Unit Cell plugin developers")
set(CPACK_PACKAGE_CONTACT "${CPACK_PACKAGE_VENDOR} <representative-unit-cell@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ParaView plugin for the statistics of sphere packs and their unit cells")
set(CPACK_PACKAGE_DESCRIPTION "One-, two- and three-point probability functions of packs of spheres, and small periodic cells that have the same ones:
 parallel filters in the menus of ParaView, in pvbatch and in pvserver.")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR "DEB;TGZ")

set(CPACK_INSTALL_CMAKE_PROJECTS
  "${CMAKE_BINARY_DIR};${PROJECT_NAME};runtime;/"
  "${CMAKE_BINARY_DIR};${PROJECT_NAME};Unspecified;/")
set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY OFF)
set(CPACK_INCLUDE_TOPLEVEL_DIRECTORY OFF)

string(REGEX MATCH "^[0-9]+\\.[0-9]+" version "${ParaView_VERSION}")
string(REGEX REPLACE ".*\\." "" next "${version}")
string(REGEX REPLACE "\\..*" "" major "${version}")
math(EXPR next "${next} + 1")
execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE architecture OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE "${architecture}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "paraview (>= ${ParaView_VERSION}), paraview (<< ${major}.${next}), libgomp1, libvoro++1")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-paraview")
set(CPACK_DEBIAN_PACKAGE_SECTION "science")
set(CPACK_PACKAGE_FILE_NAME "${CPACK_PACKAGE_NAME}-${PROJECT_VERSION}-paraview${version}-${CMAKE_SYSTEM_NAME}-${CMAKE_SYSTEM_PROCESSOR}")
set(CPACK_DEBIAN_PACKAGE_RELEASE "paraview${version}")

include(CPack)

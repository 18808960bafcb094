# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
#
# Finds ParaView, 5.11 or later, and its Qt: everything that differs between the versions and between their packages stands here. Sets
#   RUC_MPI               whether the plugin is built with MPI,
#   RUC_QT                "Qt5" or "Qt6", the one that this ParaView uses, with Widgets found where RUC_WINDOW is on,
#   RUC_QT_HELP           whether the pages of the help can be built,
#   RUC_QT_HELP_MISSING   what they lack where they cannot.

# Debian 13 and later give the files of ParaView's Python modules names with the version of Python in them, but not in ParaView's CMake
# files, whose check that the files are there would end the configuration. CMake 3.28 and later leave the check out for a target that this
# variable calls part of a framework. Nothing here links with these modules.
file(GLOB targets_files
  "/usr/lib/*/cmake/paraview-*/ParaViewPython*-targets.cmake"
  "/usr/lib/*/cmake/paraview-*/vtk/VTKPython-targets.cmake"
  "/usr/lib/*/cmake/vtk-*/VTKPython-targets.cmake")
foreach (file IN LISTS targets_files)
  file(STRINGS "${file}" targets REGEX "^add_library\\([^ ]+ MODULE IMPORTED")
  foreach (target IN LISTS targets)
    string(REGEX REPLACE "^add_library\\(([^ ]+) .*" "\\1" target "${target}")
    set(_cmake_import_check_xcframework_for_${target} "/")
  endforeach ()
endforeach ()

# Exodus is not used, but ParaView 5.13's components name libraries that only its component brings.
find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingViews OPTIONAL_COMPONENTS VTKExtensionsIOExodus)

set(has_mpi OFF)
if (TARGET VTK::ParallelMPI)
  set(has_mpi ON)
endif ()
option(RUC_MPI "Run on the ranks of MPI; OFF for a ParaView without MPI, where there is one rank" ${has_mpi})

set(RUC_QT "Qt${PARAVIEW_QT_MAJOR_VERSION}")
if (NOT PARAVIEW_QT_MAJOR_VERSION)
  set(RUC_QT Qt5) # ParaView 5.11 has no other, and does not say it
endif ()
if (RUC_WINDOW)
  find_package(${RUC_QT} REQUIRED COMPONENTS Widgets)
endif ()

# The pages of ParaView's help take programs of Qt that nothing else here needs: qhelpgenerator, which is in ToolsTools since Qt 6, and
# xmlpatterns, in whose place ParaView takes xsltproc since Qt 6.
find_package(${RUC_QT} QUIET COMPONENTS Help OPTIONAL_COMPONENTS ToolsTools)
find_program(XMLPATTERNS NAMES xmlpatterns-qt5 xmlpatterns xsltproc)
mark_as_advanced(XMLPATTERNS)
set(RUC_QT_HELP OFF)
if (RUC_QT STREQUAL "Qt6" AND ParaView_VERSION VERSION_LESS 6)
  set(RUC_QT_HELP_MISSING "ParaView ${ParaView_VERSION} cannot build pages of the help with Qt 6")
elseif (NOT TARGET ${RUC_QT}::qhelpgenerator)
  set(RUC_QT_HELP_MISSING "qhelpgenerator is missing (Debian's qttools5-dev, or qt6-tools-dev-tools)")
elseif (NOT XMLPATTERNS)
  set(RUC_QT_HELP_MISSING "xmlpatterns and xsltproc are missing (Debian's qtxmlpatterns5-dev-tools, or xsltproc)")
else ()
  set(RUC_QT_HELP ON)
endif ()

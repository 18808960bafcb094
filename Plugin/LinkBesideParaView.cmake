# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
#
# At installation into ParaView's own prefix, and in a package, which goes there: links the plugin into the folder `plugins` beside ParaView's programs, where these look for
# plugins by themselves. `programs` and `folder` are those of the programs and of the plugin below the prefix.
if (EXISTS "${CMAKE_INSTALL_PREFIX}/${programs}/paraview" OR CMAKE_INSTALL_PREFIX MATCHES "/_CPack_Packages/")
  set(root "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}")
  set(links "${root}/${programs}/plugins/RepresentativeUnitCell")
  file(MAKE_DIRECTORY "${links}")
  file(GLOB libraries "${root}/${folder}/*.so")
  foreach (library IN LISTS libraries)
    get_filename_component(name "${library}" NAME)
    file(RELATIVE_PATH target "${links}" "${library}")
    message(STATUS "Linking: ${links}/${name}")
    file(CREATE_LINK "${target}" "${links}/${name}" SYMBOLIC)
  endforeach ()
endif ()

# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
# Run by cmake -P: the pages of the help in the folder PAGES are UTF-8, but do not say so, and Qt takes them for Latin-1.
file(GLOB pages "${PAGES}/*.html")
foreach (page IN LISTS pages)
  file(READ "${page}" text)
  if (NOT text MATCHES "charset=")
    string(REPLACE "<head>" "<head><meta charset=\"utf-8\"/>" text "${text}")
    file(WRITE "${page}" "${text}")
  endif ()
endforeach ()

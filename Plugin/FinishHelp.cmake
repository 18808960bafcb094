# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
# Run by cmake -P on the pages of the help in the folder PAGES. They are UTF-8, but mostly do not say so, and Qt takes them for Latin-1. And
# a page lists only the properties of the proxy itself, but the reader has most of them from its reader of one file.
set(end "</table>")
set(end_of_row "</tr>")
file(GLOB inner "${PAGES}/*SpherePackFile.html")
file(READ "${inner}" rows)
string(FIND "${rows}" "${end_of_row}" begin) # behind the names of the columns
string(FIND "${rows}" "${end}" length)
math(EXPR begin "${begin} + 5")
math(EXPR length "${length} - ${begin}")
string(SUBSTRING "${rows}" ${begin} ${length} rows)

file(GLOB pages "${PAGES}/*.html")
foreach (page IN LISTS pages)
  file(READ "${page}" text)
  set(finished "${text}")
  if (NOT text MATCHES "charset=")
    string(REPLACE "<head>" "<head><meta charset=\"utf-8\"/>" finished "${finished}")
  endif ()
  string(FIND "${text}" "${rows}" place)
  if (place EQUAL -1 AND page MATCHES "sources.SpherePackReader.html$")
    string(REPLACE "${end}" "${rows}${end}" finished "${finished}")
  endif ()
  if (NOT finished STREQUAL text)
    file(WRITE "${page}" "${finished}")
  endif ()
endforeach ()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""cut_gsd.py FILE SPHERES: prints the GSD file with the first SPHERES of its particles alone, a thousand bytes that a fuzzer changes all over. The layout is that
of gsd's documents (file layer): a header of 256 bytes, an index, names, chunks."""
import struct
import sys

HEADER, ENTRY = struct.Struct("<QQQQQII64s64s80x"), struct.Struct("<QQqIHBB")
BYTES_OF_TYPE = [0, 1, 2, 4, 8, 1, 2, 4, 8, 4, 8, 1]

source, spheres = sys.argv[1], int(sys.argv[2])
with open(source, "rb") as file:
    content = file.read()
magic, index, entries, names, room, schema, version, application, kind = HEADER.unpack_from(content)
chunks = [ENTRY.unpack_from(content, index + n * ENTRY.size) for n in range(entries)]
chunks = [chunk for chunk in chunks if chunk[2]]
listed = content[names:names + 64 * room].rstrip(b"\0")
name_of = listed.split(b"\0")
count = next(chunk for chunk in chunks if name_of[chunk[4]] == b"particles/N")
particles = struct.unpack_from("<I", content, count[2])[0]
listed = listed.ljust(64 * (len(listed) // 64 + 1), b"\0")
place = HEADER.size + ENTRY.size * (len(chunks) + 1) + len(listed)
kept, data = b"", b""
for frame, rows, at, columns, name, kind_of_number, flags in chunks:
    rows = spheres if rows == particles else rows
    numbers = content[at:at + rows * columns * BYTES_OF_TYPE[kind_of_number]]
    kept += ENTRY.pack(frame, rows, place + len(data), columns, name, kind_of_number, flags)
    data += struct.pack("<I", spheres) if name == count[4] else numbers
header = HEADER.pack(magic, HEADER.size, len(chunks) + 1, HEADER.size + ENTRY.size * (len(chunks) + 1), len(listed) // 64, schema, version, application, kind)
sys.stdout.buffer.write(header + kept + bytes(ENTRY.size) + listed + data)

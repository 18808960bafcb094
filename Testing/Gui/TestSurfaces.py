# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The surfaces of Periodic Replicas with Clip To Box are closed, oriented outwards, of the right volume and periodic.

    pvbatch TestSurfaces.py pack.csv cell.stl

One rank also writes the surfaces for meshing and reads them back.
"""
import math
import sys

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkFiltersCore import vtkFeatureEdges

pack, stl = sys.argv[1:]
EDGE, RESOLUTION = 10.0, 24
# The filter moves points closer to a face than 1e-9 radii onto it. The rounding of coordinates, 2e-15, is less even where an edge
# meets a face at an angle of 1e-5.
ROUNDING = 1e-9 * 1.15

reader = SpherePackReader(FileName=pack, BoxSize=[EDGE] * 3, BoxPeriodic=[1, 1, 1])
replicas = PeriodicReplicas(Input=ParticleModes(Input=reader, Method="One Per Size"), ClipToBox=1, SurfaceResolution=RESOLUTION)
replicas.UpdatePipeline()


def open_edges(data):
    """The edges that not just two faces share."""
    edges = vtkFeatureEdges()
    edges.SetInputData(data)
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.Update()
    return edges.GetOutput().GetNumberOfCells()


surfaces = servermanager.Fetch(replicas, idx=2)
assert open_edges(surfaces) == 0
assert surfaces.GetPointData().GetScalars().GetName() == "Mode"
originals = servermanager.Fetch(replicas.Input)
arrays = originals.GetPointData()
radius = [arrays.GetArray("Radius").GetValue(i) for i in range(originals.GetNumberOfPoints())]
mode = [arrays.GetArray("Mode").GetValue(i) for i in range(originals.GetNumberOfPoints())]
centre = [originals.GetPoint(i) for i in range(originals.GetNumberOfPoints())]

# For each piece, by its original's Id and Image: the volume by the divergence theorem, and the corners and the area of each cap
data = surfaces.GetPointData()
ids, images, modes = (data.GetArray(name) for name in ("Id", "Image", "Mode"))
volume, corners, area = {}, {}, {}
cell = vtkIdList()
for c in range(surfaces.GetNumberOfCells()):
    surfaces.GetCellPoints(c, cell)
    points = [surfaces.GetPoint(cell.GetId(k)) for k in range(cell.GetNumberOfIds())]
    first = cell.GetId(0)
    piece = ids.GetValue(first), tuple(map(int, images.GetTuple(first)))
    assert all((ids.GetValue(cell.GetId(k)), tuple(map(int, images.GetTuple(cell.GetId(k))))) == piece for k in range(len(points)))
    assert modes.GetValue(first) == mode[piece[0]]
    middle = [centre[piece[0]][q] + EDGE * piece[1][q] for q in range(3)]
    for p in points:
        assert all(-ROUNDING <= p[q] <= EDGE + ROUNDING for q in range(3)), p
    a = [points[0][q] - middle[q] for q in range(3)]
    for second, third in zip(points[1:], points[2:]):
        b, d = ([p[q] - middle[q] for q in range(3)] for p in (second, third))
        u, v = [b[q] - a[q] for q in range(3)], [d[q] - a[q] for q in range(3)]
        normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        volume[piece] = volume.get(piece, 0.0) + sum(x * y for x, y in zip(a, normal)) / 6
        for q in range(3):
            for side, face in enumerate((0.0, EDGE)):
                if all(abs(p[q] - face) <= ROUNDING for p in points):
                    assert normal[q] * (2 * side - 1) > 0.0, (piece, q, side, normal)  # the normal points outwards
                    key = piece[0], piece[1][:q] + piece[1][q + 1:], q, side
                    area[key] = area.get(key, 0.0) + abs(normal[q]) / 2
                    corners.setdefault(key, set()).update(p[:q] + p[q + 1:] for p in points)

# Each sphere's pieces make up its polyhedron, whose volume is the sphere's to within the rounding of its corners. The facets' planes are
# at least cos(w) of the corners' distance from the centre, w the angle from the middle of a facet to its corners.
pieces = {}
for (original, _), part in volume.items():
    assert part > 0.0
    pieces.setdefault(original, []).append(part)
assert sorted(pieces) == list(range(len(radius)))
whole = {}
w = math.hypot(math.pi / RESOLUTION, math.pi / 2 / (RESOLUTION // 2))
# The volume of the polyhedron with corners at 1, of rings of RESOLUTION corners between the poles: each layer is a frustum of a pyramid
heights = [math.cos(math.pi * k / (RESOLUTION // 2)) for k in range(RESOLUTION // 2 + 1)]
polygon = RESOLUTION / 2 * math.sin(2 * math.pi / RESOLUTION)
rings = [polygon * (1 - z * z) for z in heights]
inside = sum((top - below) * (a + b + math.sqrt(abs(a * b))) / 3 for top, below, a, b in zip(heights, heights[1:], rings, rings[1:]))
scale = (4 / 3 * math.pi / inside)**(1 / 3)
assert 1.0 < scale < 1.0 / math.cos(w)
errors = [surfaces.GetFieldData().GetArray(name).GetValue(0) for name in ("VolumeErrorPercent", "AreaErrorPercent")]
assert abs(errors[0]) < 1e-10 and 0.0 < errors[1] < 100.0 * (scale**2 - 1.0), errors
total = sum(sum(parts) for parts in pieces.values())
assert abs(total / sum(4 / 3 * math.pi * r**3 for r in radius) - 1.0) < 1e-8, total
for original, parts in pieces.items():
    r = radius[original]
    share = sum(parts) / (4 / 3 * math.pi * r**3)
    whole.setdefault(r, []).append(share)
    # Between planes and corners the area depends on how the facets lie
    reach = min(min(c, EDGE - c) for c in centre[original]) / (scale * r)
    assert len(parts) == 1 if reach > 1.0 else len(parts) > 1 or reach > math.cos(w), (original, len(parts), reach)
for r, shares in whole.items():
    assert max(abs(share - 1.0) for share in shares) < 4 * math.pi * r**2 * ROUNDING / (4 / 3 * math.pi * r**3), (r, min(shares), max(shares))
assert {len(parts) for parts in pieces.values()} >= {1, 2, 4}  # edges of the box are among them

# A cap of a sphere that only one face cuts agrees with the formula of the segment, and is a polygon in the circle
caps = 0
for (original, others, q, side), value in area.items():
    r, c = scale * radius[original], centre[original]
    if all(r < c[p] < EDGE - r for p in range(3) if p != q):
        height = min(c[q], EDGE - c[q])
        share = value / (math.pi * (r**2 - height**2))
        assert share < 1.0 + 2 * ROUNDING * r / (r**2 - height**2), (original, share)
        caps += 1
    # The cap on the opposite face is the same, moved by the edge
    twin = original, others, q, 1 - side
    assert abs(area[twin] - value) <= 2 * math.pi * r * ROUNDING, (original, q)
    assert len(corners[twin]) == len(corners[original, others, q, side])
    for point in corners[original, others, q, side]:
        assert min(math.dist(point, other) for other in corners[twin]) <= 2 * ROUNDING, (original, q, point)
assert caps > 10 and len(area) > caps

if servermanager.ActiveConnection.GetNumberOfDataPartitions() == 1:
    SaveData(stl, proxy=servermanager.OutputPort(replicas, 2))
    again = servermanager.Fetch(STLReader(FileNames=[stl]))
    assert open_edges(again) == 0
    triangles = 0
    for c in range(surfaces.GetNumberOfCells()):
        triangles += surfaces.GetCellSize(c) - 2
    assert again.GetNumberOfCells() == triangles, (again.GetNumberOfCells(), triangles)
print(f"{len(volume)} pieces of {len(radius)} spheres, {len(area)} caps")

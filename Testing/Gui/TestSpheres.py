# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The representation Spheres: every pixel is that of spheres of the true radius, on every number of ranks.

    pvbatch TestSpheres.py folder            on one rank writes the pictures of a large pack, on several compares with these
    pvpython TestSpheres.py folder port ranks        the same by a server that draws
"""
import math
import os
import sys

from paraview import servermanager
from paraview.simple import *
from vtkmodules.vtkIOImage import vtkPNGReader

folder = sys.argv[1]
server = len(sys.argv) > 2
if server:
    Connect("127.0.0.1", int(sys.argv[2]))
    GetSettingsProxy("RenderViewSettings").RemoteRenderThreshold = 0.0
ranks = servermanager.ActiveConnection.GetNumberOfDataPartitions()
several = ranks > 1
assert not server or ranks == int(sys.argv[3])
name = os.path.join(folder, f"spheres_{'server' if server else ranks}")
width, height = 240, 180
view = CreateView("RenderView", ViewSize=[width, height], OrientationAxesVisibility=0, UseFXAA=0,
                  UseColorPaletteForBackground=0, Background=[0, 0, 0])


def picture(what):
    """The colours of the pixels, with the rows from below."""
    path = f"{name}_{what}.png"
    SaveScreenshot(path, view, ImageResolution=view.ViewSize)
    return pixels_of(path)


def pixels_of(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    values = bytes(memoryview(reader.GetOutput().GetPointData().GetScalars()))
    columns, rows = view.ViewSize
    return [[tuple(values[i:i + 3]) for i in range(3 * columns * row, 3 * columns * (row + 1), 3)] for row in range(rows)]


def pack(what, spheres, box=(20.0, 15.0, 15.0)):
    """A pack of [x, y, z, radius], whose parts are on the ranks in turn."""
    path = f"{name}_{what}.csv"
    with open(path, "w") as file:
        file.write("x,y,z,radius\n" + "".join(",".join(map(str, sphere)) + "\n" for sphere in spheres))
    modes = ParticleModes(Input=SpherePackReader(FileName=path, BoxSize=box, BoxPeriodic=[1, 1, 1]), Method="One Per Size")
    return PeriodicReplicas(Input=modes, Method="Tiling")


def subtract(a, b):
    return [p - q for p, q in zip(a, b)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    return [p / math.sqrt(dot(a, a)) for p in a]


class Camera:
    """The lines of sight through the centres of the pixels."""

    def __init__(self):
        self.eye, self.parallel = list(view.CameraPosition), view.CameraParallelProjection
        self.forward = unit(subtract(view.CameraFocalPoint, self.eye))
        self.right = unit(cross(self.forward, view.CameraViewUp))
        self.up = cross(self.right, self.forward)
        half = view.CameraParallelScale if self.parallel else math.tan(math.radians(view.CameraViewAngle / 2))
        self.pixel = 2 * half / height

    def sight(self, column, row):
        x, y = (column + 0.5 - width / 2) * self.pixel, (row + 0.5 - height / 2) * self.pixel
        aside = [x * a + y * b for a, b in zip(self.right, self.up)]
        if self.parallel:
            return [a + b for a, b in zip(self.eye, aside)], self.forward
        return self.eye, unit([a + b for a, b in zip(self.forward, aside)])


def check_pixels(spheres, what):
    """Each pixel shows the sphere that its line of sight meets first; those left out lie on an edge to within rounding."""
    table = GetColorTransferFunction("Mode")
    sizes = sorted({sphere[3] for sphere in spheres})
    assert list(table.Annotations) == [str(1 + i // 2) for i in range(2 * len(sizes))], table.Annotations
    colours = [unit(table.IndexedColors[3 * i:3 * i + 3]) for i in range(len(sizes))]
    camera, pixels = Camera(), picture(what)
    edges, shown = 0, set()
    for row in range(height):
        for column in range(width):
            eye, sight = camera.sight(column, row)
            hits, on_edge = [], False
            for i, (*centre, radius) in enumerate(spheres):
                to_centre = subtract(centre, eye)
                along = dot(to_centre, sight)
                aside = math.sqrt(max(dot(to_centre, to_centre) - along**2, 0.0))
                # A hundredth of a pixel, for float coordinates and the pixel centres of the rasteriser
                on_edge = on_edge or abs(aside - radius) < 0.01 * camera.pixel * (1 if camera.parallel else along)
                if aside < radius:
                    hits.append((along - math.sqrt(radius**2 - aside**2), i))
            hits.sort()
            if on_edge or len(hits) > 1 and hits[1][0] - hits[0][0] < 1e-3:
                edges += 1
                continue
            colour = pixels[row][column]
            if not hits:
                assert colour == (0, 0, 0), (what, column, row, colour)
                continue
            assert max(colour) > 10, (what, column, row, colour, hits[0])
            likeness = [dot(unit(colour), other) for other in colours]
            assert likeness.index(max(likeness)) == sizes.index(spheres[hits[0][1]][3]), (what, column, row, colour, hits)
            shown.add(hits[0][1])
    assert edges < 0.01 * width * height, edges
    assert len(shown) == len(spheres), (what, shown)


# In each third, which is a rank's on three ranks, are spheres at the picture's edges, alone, in contact, one in another, and one
# that sticks out of the bounds of its rank's centres by far.
SPHERES = [[10.0, 14.5, 5.0, 1.5], [10.0, 0.4, 5.0, 1.0], [4.0, 4.0, 4.0, 1.5], [6.0, 4.0, 4.5, 1.0], [0.2, 7.0, 9.0, 2.2],
           [13.0, 9.0, 3.0, 2.2], [14.5, 9.5, 4.5, 1.5], [12.0, 10.0, 4.0, 1.5], [15.0, 8.0, 5.5, 1.0], [4.5, 10.0, 2.0, 2.2],
           [19.9, 7.0, 8.0, 1.5], [19.5, 14.2, 2.0, 1.0], [18.0, 3.0, 6.0, 2.2], [16.5, 3.5, 7.0, 1.5], [9.0, 6.0, 12.0, 1.5]]
few = pack("few", SPHERES)
display = Show(few, view, ShowWindow=0)
assert display.Representation == "Spheres" and list(display.ColorArrayName) == ["POINTS", "Mode"], display.ColorArrayName
view.CameraFocalPoint, view.CameraViewUp = [10.0, 7.5, 7.5], [0.0, 1.0, 0.0]
view.CameraPosition, view.CameraParallelProjection, view.CameraParallelScale = [10.0, 7.5, 50.0], 1, 7.5
check_pixels(SPHERES, "parallel")
view.CameraPosition, view.CameraParallelProjection, view.CameraViewAngle = [12.0, 9.0, 28.0], 0, 50.0
check_pixels(SPHERES, "perspective")
assert bool(view.GetClientSideObject().GetUseDistributedRenderingForRender()) == several

# The bounds contain the radii, so that the first picture cuts nothing off.
ResetCamera(view)
view.CameraParallelProjection = 1
ResetCamera(view)
pixels = picture("reset")
assert {*pixels[0], *pixels[-1], *(row[0] for row in pixels), *(row[-1] for row in pixels)} == {(0, 0, 0)}

# Along the edges of the window the picture has its colour, white or black against the background; without a window it has none.


def window_colours(edges, what):
    """Samples of the colours at the edges: of the 3 x 3 pixels around each point the one farthest from the background."""
    camera, pixels = Camera(), picture(what)
    background = pixels[0][0]
    found = []
    for first, second in edges:
        for step in range(11):
            point = [a + (b - a) * step / 10 for a, b in zip(first, second)]
            offset = subtract(point, camera.eye)
            column = int(dot(offset, camera.right) / camera.pixel + width / 2)
            row = int(dot(offset, camera.up) / camera.pixel + height / 2)
            near = [pixels[row + i][column + j] for i in (-1, 0, 1) for j in (-1, 0, 1)]
            found.append(max(near, key=lambda colour: abs(sum(colour) - sum(background))))
    return set(found)


def corner(i, box):
    return [box[q] * (i >> q & 1) for q in range(3)]


BOX = (20.0, 15.0, 15.0)
BOX_EDGES = [(corner(i, BOX), corner(i | bit, BOX)) for i in range(8) for bit in (1, 2, 4) if not i & bit]
Hide(few, view)
small = pack("small", [[10.0, 7.5, 7.5, 0.1]]).Input  # it is on the first rank alone
display = Show(small, view)
view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = [10.0, 7.5, 7.5], [40.0, 30.0, 60.0], [0.0, 1.0, 0.0]
view.CameraParallelScale = 14.0
for background, colour in (([0.32, 0.34, 0.43], (255, 255, 255)), ([1.0, 1.0, 1.0], (0, 0, 0))):
    view.Background = background
    assert window_colours(BOX_EDGES, "window") == {colour}, window_colours(BOX_EDGES, "window")
display.ShowWindow = 0
assert window_colours(BOX_EDGES, "none") == {(255, 255, 255)}
display.ShowWindow = 1
assert window_colours(BOX_EDGES, "again") == {(0, 0, 0)}
Hide(small, view)

# The pack has no Mode and a cylinder as window
base, axis, radius, length = [1.0, 2.0, 3.0], [2.0, 1.0, 2.0], 4.0, 9.0
fields = {"CylinderBase": base, "CylinderAxis": axis, "CylinderRadius": [radius], "CylinderHeight": [length]}
with open(f"{name}_cylinder.vtk", "w") as file:
    numbers = lambda values: " ".join(map(str, values)) + "\n"
    file.write("# vtk DataFile Version 3.0\npack\nASCII\nDATASET POLYDATA\n" + f"FIELD window {len(fields)}\n")
    for field, values in fields.items():
        file.write(f"{field} {len(values)} 1 double\n" + numbers(values))
    file.write("POINTS 1 double\n" + numbers(b + a * length / 6 for a, b in zip(axis, base)))
    file.write("POINT_DATA 1\nFIELD arrays 1\nRadius 1 1 double\n0.1\n")
cylinder = LegacyVTKReader(FileNames=[f"{name}_cylinder.vtk"])
display = Show(cylinder, view, Representation="Spheres")
assert display.ColorArrayName[1] in ("", None), display.ColorArrayName
axis = unit(axis)
side = unit(cross(axis, [0.0, 0.0, 1.0]))
other = cross(axis, side)
view.CameraFocalPoint = [b + a * length / 2 for a, b in zip(axis, base)]
view.CameraPosition, view.CameraParallelScale = [p + q for p, q in zip(view.CameraFocalPoint, [30.0, 10.0, -20.0])], 8.0
rim = [[[b + level * a + radius * (math.cos(angle) * s + math.sin(angle) * t) for a, b, s, t in zip(axis, base, side, other)]
        for angle in (math.pi * k / 8 for k in range(16))] for level in (0.0, length)]
assert window_colours([(point, point) for circle in rim for point in circle], "cylinder") == {(0, 0, 0)}
Delete(cylinder)

# A large pack, opaque, translucent and opaque again: the pictures of several ranks are that of one, pixel by pixel.
view.ViewSize = [600, 450]
view.Background = [0.32, 0.34, 0.43]
reader = SpherePackReader(FileName=os.path.join(os.path.dirname(os.path.abspath(__file__)), "pack.csv"), BoxSize=[10, 10, 10],
                          BoxPeriodic=[1, 1, 1])
tiles = PeriodicReplicas(Input=ParticleModes(Input=reader, Method="One Per Size"), Method="Tiling", Tiles=[7, 7, 7])
display = Show(tiles, view)
assert tiles.GetDataInformation().GetNumberOfPoints() == 343 * 60 > 20000
view.CameraParallelProjection = 0
view.CameraFocalPoint, view.CameraPosition, view.CameraViewAngle = [35.0, 35.0, 35.0], [90.0, 75.0, 160.0], 30.0
pictures = {}
for what, opacity in (("many", 1.0), ("translucent", 0.5), ("opaque", 1.0)):
    display.Opacity = opacity
    pictures[what] = picture(what)
assert pictures["many"] == pictures["opaque"] != pictures["translucent"]
if several:
    for what in ("many", "translucent"):
        one = pixels_of(os.path.join(folder, f"spheres_1_{what}.png"))
        different = sum(a != b for own, others in zip(pictures[what], one) for a, b in zip(own, others))
        print(f"{what}: {different} pixels differ from those of one rank")
        assert different == 0

# More modes than before have labels too; a map that somebody has changed stays as it is.
Hide(tiles, view)
modes = pack("more", [[1.0 + 2.0 * i, 7.5, 7.5, 0.2 + 0.1 * i] for i in range(9)]).Input
modes.Method, modes.Edges = "Explicit Edges", [0.1, 10.0]
display = Show(modes, view)
Render(view)
table = GetColorTransferFunction("Mode")
assert len(table.Annotations) == 6
modes.Method = "One Per Size"
Render(view)
assert list(table.Annotations) == [str(1 + i // 2) for i in range(18)], table.Annotations
assert len({tuple(table.IndexedColors[3 * i:3 * i + 3]) for i in range(9)}) == 9 and table.InterpretValuesAsCategories == 1
table.ApplyPreset("Cividis")
modes.UpdatePipeline()
Render(view)
assert table.InterpretValuesAsCategories == 0

Delete(view)  # otherwise the window would outlive its GL context and end with GLXBadContext
del view, display

# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Goes the whole way of the paper from a micro-CT image to a unit cell: image, particles, pack, statistics, cell.

    pvbatch from_image.py --output results
    pvbatch from_image.py --scan my_scan.tif --output results

Without an image of your own it makes one of a block of the bead pack, with the paper's 15.6 voxels in a mean diameter, a blur of a voxel and
noise of a tenth of the contrast, and knows what is in it. It finds the particles, compares the volume fractions of the modes in the voxels, in
the pack that was found and in the cell (Figure 12 of the paper), and S_mm of voxels and spheres, and writes all as files, from which image_pictures.py draws. No
display is needed. With --check it then tests its own results and ends with an error where one of them fails.
"""
import math
import os
import sys
import time

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import VTK_UNSIGNED_SHORT
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkMetaImageWriter

from common import (add_output, check_all, fetch, field, make_parser, path_in, require, run, spheres, table_of, whole_image, write_image, write_points,
                    write_table, write_tables)

MATRIX, PARTICLE = 10000.0, 30000.0  # grey values of the image that is made
MARGIN = 60.0  # so far around the block are the spheres that reach into it


def parse_arguments():
    parser = make_parser("from_image.py", __doc__)
    parser.set_defaults(origin=[360.0, 320.0, 200.0], box=[500.0, 450.0, 390.0], modes=5)
    image = parser.add_argument_group("image")
    image.add_argument("--scan", default="", help="an image of your own, which ParaView reads, in place of the one of the pack")
    image.add_argument("--voxels", type=float, default=15.6, help="voxels in the mean diameter")
    image.add_argument("--blur", type=float, default=1.0, help="standard deviation of the blur, in voxels")
    image.add_argument("--noise", type=float, default=0.1, help="standard deviation of the noise, over the contrast")
    image.add_argument("--dark", action="store_true", help="particles of your image are darker than the matrix")
    cell = parser.add_argument_group("cell")
    cell.add_argument("--particles", type=int, default=400, help="spheres in the cell")
    cell.add_argument("--target", type=float, default=0.06, help="end when F2 is this small; 0: never, for the best cell")
    cell.add_argument("--iterations", type=int, default=1000, help="end after so many iterations")
    cell.add_argument("--lags", type=int, default=60, help="number K of lags of one voxel")
    parser.add_argument("--seed", type=int, default=1, help="seed of the noise and of the cell")
    add_output(parser, "from_image_results")
    return parser.parse_args()


# ---- An image such as a tomograph makes ----


def block(args, margin):
    """The spheres with centres in the block and so far around it."""
    reader = SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit)
    return ParticleModes(Input=reader, NumberOfModes=1, BoxOrigin=[q - margin for q in args.origin],
                         BoxSize=[q + 2 * margin for q in args.box], CropToWindow=1)


def blurred(values, deviation):
    """The mean under a Gaussian along each axis."""
    reach = math.ceil(4 * deviation)
    weights = numpy.exp(-0.5 * (numpy.arange(-reach, reach + 1) / deviation)**2)
    for axis in range(3):
        padded = numpy.pad(values, [(reach, reach) if q == axis else (0, 0) for q in range(3)], mode="edge")
        length = values.shape[axis]
        values = sum(weight * numpy.take(padded, range(n, n + length), axis) for n, weight in enumerate(weights / weights.sum()))
    return values


def write_scan(args, path):
    """Writes an image of 16 bits of the block."""
    truth = block(args, 0.0)
    radius = vtk_to_numpy(fetch(truth).GetPointData().GetArray("Radius"))
    voxel = 2 * float(radius.mean()) / args.voxels
    around = math.ceil(MARGIN / voxel)
    shares = LabelImage(Input=block(args, around * voxel), VoxelSize=voxel, Phases=0, VolumeFractions=1, ArrayOn="Points")
    image = whole_image(shares, 0)
    size = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetArray("VolumeFraction")).reshape(size[::-1]).astype(numpy.float32)
    values = blurred(values, args.blur) if args.blur > 0 else values
    values = values[tuple(slice(around, n - around) for n in size[::-1])]
    noise = numpy.random.default_rng(args.seed).normal(0.0, args.noise, values.shape)
    values = numpy.clip(numpy.rint(MATRIX + (PARTICLE - MATRIX) * (values + noise)), 0, 65535).astype(numpy.uint16)
    scan = vtkImageData()
    scan.SetDimensions(values.shape[::-1])
    scan.SetSpacing(voxel, voxel, voxel)
    scan.SetOrigin([q + 0.5 * voxel for q in args.origin])
    grey = numpy_to_vtk(values.ravel(), deep=1, array_type=VTK_UNSIGNED_SHORT)
    grey.SetName("Grey")
    scan.GetPointData().SetScalars(grey)
    writer = vtkMetaImageWriter()
    writer.SetCompression(False)
    writer.SetInputData(scan)
    writer.SetFileName(path)
    writer.Write()
    return truth


# ---- The chain ----


class Job:
    """The filters, and what they are told."""

    def __init__(self, args):
        self.args, self.truth = args, None
        os.makedirs(args.output, exist_ok=True)
        scan = os.path.abspath(args.scan) if args.scan else path_in(args.output, "scan.mhd")
        if not args.scan:
            print(f"image    {scan}, {args.voxels:g} voxels in a mean diameter, noise {args.noise:g} …", flush=True)
            self.truth = write_scan(args, scan)
        self.scan = OpenDataFile(scan)
        self.particles = ParticlesFromImage(Input=self.scan, ParticlesAre="Dark" if args.dark else "Bright", LengthUnit=args.unit, Residual=1)
        self.pack = ParticleModes(Input=self.particles, Method=args.division, NumberOfModes=args.modes)
        voxel = field(fetch(self.particles), "VoxelSize")[0]
        self.lags = {"MaximumLag": args.lags * voxel, "NumberOfLags": args.lags}
        self.one = OnePointProbability(Input=self.pack)
        self.two = TwoPointProbability(Input=self.pack, **self.lags)
        solid = Calculator(Input=OutputPort(self.particles, 1), ResultArrayName="Solid", Function="if(ParticleId != 0, 1, 0)")
        self.voxels = ImageStatistics(Input=solid, PhaseArray="Solid", Boundary="Window", ImagePairs="", ChordLengths=0, **self.lags)
        self.cell = UnitCellReconstruction(Input=self.pack, NumberOfParticles=args.particles, TargetObjective=args.target,
                                           MaximumIterations=args.iterations, Seed=args.seed, **self.lags)

    def fractions(self):
        """Of each mode the volume fractions in the voxels, in the pack and in the cell, and the errors of equation 16. The volume of a particle that the border
        of the image cuts is that of its sphere."""
        data, modes = fetch(self.particles), table_of(self.pack, 1)["Mode"]
        volume = math.prod(field(data, "BoxSize"))
        mode = {id_: m for id_, m in zip(*(vtk_to_numpy(fetch(self.pack).GetPointData().GetArray(name)) for name in ("Id", "Mode")))}
        names = ("Id", "Radius", "EqualVolumeRadius", "BorderFaces")
        voxels = dict.fromkeys(modes, 0.0)
        for id_, radius, equal, cut in zip(*(vtk_to_numpy(data.GetPointData().GetArray(name)) for name in names)):
            voxels[mode[id_]] += 4 / 3 * math.pi * float(radius if cut else equal)**3 / volume
        table = {"Mode": [f"{m:g}" for m in modes], "voxels": list(voxels.values()),
                 "pack": table_of(self.one)["VolumeFraction"][:-1], "cell": field(fetch(self.cell), "VolumeFractions")[:-1]}
        for name in ("pack", "cell"):
            table[f"error_{name}"] = [100 * abs(a - b) / sum(table["voxels"]) for a, b in zip(table["voxels"], table[name])]
        return table

    def two_point(self):
        """S_mm by lag."""
        return {"r": table_of(self.two)["r"], "voxels": table_of(self.voxels)["S_m_m"], "pack": table_of(self.two)["S_m_m"],
                "cell": table_of(self.cell, 2)["S_m_m_cell"]}


def middle(image, name):
    """The plane in the middle of an image, as an image."""
    size = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetArray(name)).reshape(size[::-1])[size[2] // 2]
    plane = vtkImageData()
    plane.SetDimensions(size[0], size[1], 1)
    plane.SetSpacing(image.GetSpacing())
    origin = image.GetOrigin()
    plane.SetOrigin(origin[0], origin[1], origin[2] + size[2] // 2 * image.GetSpacing()[2])
    array = numpy_to_vtk(values.ravel().astype(numpy.float32), deep=1)
    array.SetName(name)
    plane.GetPointData().SetScalars(array)
    return plane


def write_files(job):
    folder = job.args.output
    write_points(folder, {"particles.vtp": (job.particles, 0), "dropped.vtp": (job.particles, 2), "pack.vtp": (job.pack, 0), "cell.vtp": (job.cell, 0)})
    write_tables(folder, {"modes.csv": (job.pack, 1)})
    write_table(folder, "fractions.csv", job.fractions())
    write_table(folder, "two_point.csv", job.two_point())
    scan = whole_image(job.scan, 0)
    write_image(folder, "slice.vti", middle(scan, scan.GetPointData().GetArrayName(0)))
    write_image(folder, "residual.vti", middle(whole_image(job.particles, 3), "Residual"))


def print_summary(job):
    data = fetch(job.particles)
    print(f"particles {data.GetNumberOfPoints()}, {field(data, 'VoxelsPerDiameter'):.1f} voxels in a diameter, noise {field(data, 'Noise'):.3f} of the contrast, "
          f"blur {field(data, 'Blur') / field(data, 'VoxelSize')[0]:.2f} voxels")
    table = job.fractions()
    print(f"{'mode':>6} {'c voxels':>10} {'c pack':>10} {'c cell':>10} {'error pack':>12} {'error cell':>12}")
    for row in zip(*table.values()):
        print(f"{row[0]:>6} " + " ".join(f"{value:10.5f}" for value in row[1:4]) + " " + " ".join(f"{value:10.3f} %" for value in row[4:]))
    print(f"{'all':>6} " + " ".join(f"{sum(table[name]):10.5f}" for name in ("voxels", "pack", "cell")))


# ---- Checks ----


def nearest(job):
    """Of each sphere of the truth with its centre two voxels and more inside: the sphere that was found nearest to it, how far that is, both radii, and whether
    it is whole."""
    found, voxel = fetch(job.particles), field(fetch(job.particles), "VoxelSize")[0]
    names = ("Radius", "RadiusError", "CenterError")
    places = vtk_to_numpy(found.GetPoints().GetData())
    arrays = [vtk_to_numpy(found.GetPointData().GetArray(name)) for name in names]
    box = [field(found, name) for name in ("BoxOrigin", "BoxSize")]
    for x, y, z, radius, _ in spheres(fetch(job.truth)):
        inside = min(min(q - low, low + size - q) for q, low, size in zip((x, y, z), *box))
        if inside > 2 * voxel and 2 * radius > 5 * voxel:
            away = numpy.hypot(numpy.hypot(places[:, 0] - x, places[:, 1] - y), places[:, 2] - z)
            n = int(away.argmin())
            yield float(away[n]), radius, [float(array[n]) for array in arrays], inside > radius + 4 * voxel, voxel


def check_particles(job):
    """all spheres are found, as well as is possible"""
    rows = list(nearest(job))
    require(all(away < 0.5 * radius for away, radius, *_ in rows), "spheres are missing")
    whole = [row for row in rows if row[3] and 2 * row[1] > 8 * row[4]]
    require(len(whole) > 50, "too few whole spheres")
    pull = math.sqrt(sum(((fit[0] - radius) / fit[1])**2 for _, radius, fit, *_ in whole) / len(whole))
    # The errors are told to 20 %, as far as so many spheres show
    require(abs(pull - 1) < 0.2 + 3 / math.sqrt(2 * len(whole)), f"errors of radii are {pull:.2f} of what the fit tells")
    bias = sum(fit[0] / radius - 1 for _, radius, fit, *_ in whole) / len(whole)
    require(abs(bias) < 1e-3, f"radii are off by {100 * bias:.3f} %")


def check_fractions(job):
    """the pack has the volume of its voxels, and of the truth"""
    table = job.fractions()
    # Voxels at the surfaces lie on either side
    require(max(table["error_pack"]) < 0.8, f"equation 16 of pack and voxels: {max(table['error_pack']):.2f} %")
    require(max(table["error_cell"]) < 2.0, f"equation 16 of cell and voxels: {max(table['error_cell']):.2f} %")
    expected = sum(4 / 3 * math.pi * radius**3 for *_, radius, _ in spheres(fetch(job.truth))) / math.prod(job.args.box)
    # Spheres with centres within a voxel of the border are found on either side of it
    require(abs(sum(table["pack"]) / expected - 1) < 0.02, f"volume {sum(table['pack']):.4f} of {expected:.4f}")


def check_two_point(job):
    """S_mm of voxels and of spheres agree"""
    table = job.two_point()
    rms = math.sqrt(sum((a - b)**2 for a, b in zip(table["voxels"][1:], table["pack"][1:])) / job.args.lags)
    require(rms < 0.015, f"S_mm of voxels and pack differ by {rms:.4f}")  # of a block of some hundred spheres, by its faces


def main(args):
    job = Job(args)
    start = time.time()
    print_summary(job)
    write_files(job)
    print(f"files    {os.path.abspath(args.output)}, {time.time() - start:.1f} s", flush=True)
    if args.check:
        check_all((check_particles, check_fractions, check_two_point), job)


if __name__ == "__main__":
    run(main, parse_arguments())

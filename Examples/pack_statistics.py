# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Computes the statistics of a sphere pack by all methods, with their errors, and writes them as files.

    mpirun -np 2 pvbatch pack_statistics.py --output results

is the paper's program STAT3D for a pack of your own: one- and two-point probabilities exactly, by chords and by the paper's template,
their checks, gradients, isotropy, chord lengths, radial distribution functions, autocovariances, and S_rs(x) as an image. No display
is needed. With --check it then tests its own results and ends with an error where one of them fails.
"""
import csv
import itertools
import math
import os
import sys
import time
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from paraview.simple import *
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLImageDataWriter

from unit_cell import close, fetch, field, make_parser, pair, require, sort_spheres, values_of

CHORDS, TEMPLATE = "Chord Sampling", "Template Sampling"
TABLES = {}  # on this rank, by filter and port


def parse_arguments():
    parser = make_parser("pack_statistics.py", __doc__)
    statistics = parser.add_argument_group("statistics")
    statistics.add_argument("--maximum-lag", type=float, default=200.0, help="last lag r of S_rs(r)")
    statistics.add_argument("--lags", type=int, default=277, help="number K of lags after 0")
    statistics.add_argument("--lines", type=int, default=100000, help="lines of the chord sampling")
    statistics.add_argument("--throws", type=int, default=2000, help="throws of the paper's template")
    statistics.add_argument("--directions", type=int, default=32, help="directions of the test of isotropy")
    statistics.add_argument("--phase-pairs", default="m m; 5 5", help="pairs of phases of the map S_rs(x)")
    statistics.add_argument("--resolution", type=int, default=20, help="steps from the centre of the map to its faces")
    statistics.add_argument("--seed", type=int, default=1, help="seed of lines and throws")
    parser.add_argument("--output", default="statistics_results", help="folder for the files")
    parser.add_argument("--check", action="store_true", help="test the results")
    return parser.parse_args()


class Job:
    """The filters, and the folder their results go to."""

    def __init__(self, args):
        self.args = args
        self.modes = sort_spheres(SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit,
                                                   BoxOrigin=args.origin, BoxSize=args.box), args)
        samples = {"NumberOfLines": args.lines, "NumberOfThrows": args.throws, "Seed": args.seed}
        self.one = {method: OnePointProbability(Input=self.modes, Method=method, **samples)
                    for method in ("Sphere Volumes", CHORDS, TEMPLATE)}
        lags = {"MaximumLag": args.maximum_lag, "NumberOfLags": args.lags}
        self.exact = TwoPointProbability(Input=self.modes, **lags)
        self.chords = TwoPointProbability(Input=self.modes, Method=CHORDS, **lags, **samples)
        self.template = TwoPointProbability(Input=self.modes, Method=TEMPLATE, **lags, **samples)
        self.directions = DirectionalProbability(Input=self.modes, NumberOfDirections=args.directions, **lags)
        self.chord_lengths = ChordLengths(Input=self.modes, NumberOfLines=args.lines, Seed=args.seed, **lags)
        self.distances = RadialDistribution(Input=self.modes, **lags)
        self.map = ProbabilityMap(Input=self.modes, PhasePairs=args.phase_pairs, Resolution=args.resolution, MaximumLag=args.maximum_lag)
        # What is written: file, filter, output port
        self.table_files = [
            ("modes.csv", self.modes, 1),
            ("two_point_exact.csv", self.exact, 0), ("two_point_chords.csv", self.chords, 0), ("two_point_template.csv", self.template, 0),
            ("checks_exact.csv", self.exact, 1), ("checks_chords.csv", self.chords, 1), ("checks_template.csv", self.template, 1),
            ("gradients.csv", self.exact, 2), ("isotropy.csv", self.directions, 0),
            ("chord_lengths.csv", self.chord_lengths, 0), ("radial_distribution.csv", self.distances, 0), ("autocovariance.csv", self.exact, 3)]

    def path(self, name):
        return os.path.join(os.path.abspath(self.args.output), name)

    def phases(self):
        return table_of(self.one["Sphere Volumes"])["Phase"]


def table_of(source, port=0):
    """A fetched table as {name: list of values}."""
    key = (source.GetGlobalIDAsString(), port)
    if key not in TABLES:
        data, TABLES[key] = fetch(source, port), {}
        for j in range(data.GetNumberOfColumns()):
            column = data.GetColumn(j)
            texts = (column.GetValue(i) for i in range(column.GetNumberOfValues()))
            TABLES[key][column.GetName()] = list(map(float, memoryview(column)) if column.IsNumeric() else texts)
    return TABLES[key]


def one_point(job):
    """c_r by all methods side by side."""
    table = {}
    for method, source in job.one.items():
        one, name = table_of(source), method.replace(" ", "")
        table["Phase"] = one["Phase"]
        table[name] = one["VolumeFraction"]
        table[name + "_error"] = one["VolumeFraction_error"]
    return table


def whole_image(source, port):
    """An image output of any number of ranks. Fetch brings one rank's slab of an image, with 6 digits of its spacing, but all of a point
    cloud."""
    slab, info = fetch(source, port), source.GetDataInformation(port)
    extent, bounds = info.GetExtent(), info.GetBounds()
    if tuple(slab.GetExtent()) == tuple(extent):
        return slab
    image, cloud = vtkImageData(), fetch(ConvertToPointCloud(Input=OutputPort(source, port)))
    spacing = [(bounds[2 * q + 1] - bounds[2 * q]) / max(extent[2 * q + 1] - extent[2 * q], 1) for q in range(3)]
    image.SetExtent(extent)
    image.SetSpacing(spacing)
    image.SetOrigin([bounds[2 * q] - spacing[q] * extent[2 * q] for q in range(3)])
    image.SetFieldData(slab.GetFieldData())
    arrays = []
    for i in range(slab.GetPointData().GetNumberOfArrays()):
        array = vtkDoubleArray()
        array.SetName(slab.GetPointData().GetArrayName(i))
        array.SetNumberOfValues(image.GetNumberOfPoints())
        array.Fill(math.nan)
        image.GetPointData().AddArray(array)
        arrays.append((array, cloud.GetPointData().GetArray(array.GetName())))
    # Row by row, along which x grows and y and z stay; most rows are as long as the one before
    total, begin, length = cloud.GetNumberOfPoints(), 0, 1
    while begin < total:
        first = cloud.GetPoint(begin)
        in_row = lambda i: (i < total and cloud.GetPoint(i)[1:] == first[1:] and
                            round((cloud.GetPoint(i)[0] - first[0]) / spacing[0]) == i - begin)
        length = length if in_row(begin + length - 1) else 1
        while in_row(begin + length):
            length += 1
        index = [round((x - low) / step) for x, low, step in zip(first, image.GetOrigin(), spacing)]
        for array, values in arrays:
            array.InsertTuples(image.ComputePointId(index), length, begin, values)
        begin += length
    return image


def fetch_map(job):
    if not hasattr(job, "image"):
        job.image = whole_image(job.map, 0)
    return job.image


def isotropy_in_percent(job, name):
    """The largest sigma_S in percent of S at the same lag, or of its limit where S is smaller."""
    s, sigma = table_of(job.exact)[name], table_of(job.directions)["sigma_" + name]
    checks = table_of(job.exact, 1)
    limit = checks["Limit"][checks["Pair"].index(name)]
    return max(100.0 * b / max(a, limit) for a, b in zip(s[1:], sigma[1:]))


def largest_pairs(job):
    """m m, and the modes of largest volume with themselves, each other and the matrix."""
    phases, c = job.phases(), table_of(job.one["Sphere Volumes"])["VolumeFraction"]
    largest = sorted(range(len(phases) - 1), key=c.__getitem__)[-2:] + [len(phases) - 1]
    return [pair(phases, phases[r], phases[s]) for r, s in itertools.combinations_with_replacement(sorted(largest), 2)]


def print_summary(job, seconds):
    unit, one = job.args.unit, one_point(job)
    print(f"\n{'phase':>5} {'sphere volumes':>15} {'chords':>20} {'template':>20} {'mean chord':>11}")
    mean_chords = field(fetch(job.chord_lengths), "MeanChordLength")
    for i, phase in enumerate(one["Phase"]):
        sampled = [f"{one[name][i]:.5f} ± {one[name + '_error'][i]:.5f}" for name in ("ChordSampling", "TemplateSampling")]
        print(f"{phase:>5} {one['SphereVolumes'][i]:15.5f} {sampled[0]:>20} {sampled[1]:>20} {mean_chords[i]:11.3f}")
    checks = fetch(job.exact, 1)
    print(f"\nsaturation length      {field(fetch(job.exact), 'SaturationLength'):.1f} {unit}, first guess of a cell twice that")
    print(f"error of the chords    {field(fetch(job.chords), 'TotalError'):.4f} (sum over all ordered pairs of the norm over "
          f"{job.args.lags} lags; {job.args.lines} lines)")
    print(f"error of the template  {field(fetch(job.template), 'TotalError'):.4f} ({job.args.throws} throws)")
    print(f"isotropy               largest sigma_S in percent of S: "
          + ", ".join(f"{name} {isotropy_in_percent(job, name):.2f}" for name in largest_pairs(job)))
    print(f"specific surface       {field(checks, 'SpecificSurface'):.6f} 1/{unit} of the spheres, "
          f"{field(checks, 'SpecificSurfaceFromSlope'):.6f} from the slope of S_mm")
    print("time                   " + ", ".join(f"{name} {value:.1f} s" for name, value in seconds.items()))


def write_files(job):
    """Tables with all digits, in the order of their columns; the map with inline binary data, which ParaView 5.11 reads
    everywhere (its default, appended data, fails with newer expat libraries)."""
    os.makedirs(job.args.output, exist_ok=True)
    tables = [(name, table_of(source, port)) for name, source, port in job.table_files]
    for name, table in [("one_point.csv", one_point(job))] + tables:
        with open(job.path(name), "w", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(table)
            for row in zip(*table.values()):
                writer.writerow(value if isinstance(value, str) else f"{value:.17g}" for value in row)
    writer = vtkXMLImageDataWriter()
    writer.SetDataModeToBinary()
    writer.SetInputData(fetch_map(job))
    writer.SetFileName(job.path("map.vti"))
    if not writer.Write():
        raise RuntimeError(f"Cannot write {job.path('map.vti')}.")


def main():
    args = parse_arguments()
    job = Job(args)
    print(f"reading  {args.input}")
    print(f"         {fetch(job.modes).GetNumberOfPoints()} spheres", flush=True)
    seconds = {}
    for name, source in (("exact", job.exact), ("chords", job.chords), ("template", job.template), ("directions", job.directions),
                         ("chord lengths", job.chord_lengths), ("distances", job.distances), ("map", job.map)):
        start = time.time()
        fetch(source)
        seconds[name] = time.time() - start
    print_summary(job, seconds)
    write_files(job)
    print(f"files    {job.path('')}")
    if args.check:
        check_all(job)
        print("check    passed")


# ---- Checks: everything below is plain Python on the fetched results ----


def check_all(job):
    for check in (check_fractions, check_identities, check_methods, check_isotropy, check_map, check_chord_lengths, check_distances,
                  check_files):
        check(job)
        print(f"check    {check.__doc__.splitlines()[0]}", flush=True)


def norm(values):
    """The discrete norm, over k = 1…K."""
    return math.sqrt(sum(value * value for value in values[1:]))


def blocks(job):
    """(one-point, two-point) exactly of the 8 octants of the window, up to a lag that fits into them. Their scatter tells how much parts
    of one pack differ, which no error of sampling knows of."""
    if not hasattr(job, "octants"):
        args, half = job.args, [edge / 2 for edge in job.args.box]
        # A pack without a window, so that the filters take theirs
        modes = sort_spheres(SpherePackReader(FileName=os.path.abspath(args.input), LengthUnit=args.unit), args)
        diameter = max(table_of(job.modes, 1)["MaximumDiameter"])
        spacing = args.maximum_lag / args.lags
        job.block_lags = max(1, min(args.lags, int(0.99 * (min(half) - diameter) / spacing)))
        job.octants = []
        for octant in itertools.product((0, 1), repeat=3):
            window = {"BoxOrigin": [args.origin[q] + octant[q] * half[q] for q in range(3)], "BoxSize": half, "CropToWindow": 1}
            two = TwoPointProbability(Input=modes, MaximumLag=job.block_lags * spacing, NumberOfLags=job.block_lags, **window)
            job.octants.append((fetch(two, 1), table_of(two)))
    return job.octants


def standard_error(values):
    mean = sum(values) / len(values)
    return math.sqrt(sum((value - mean)**2 for value in values) / (len(values) - 1) / len(values))


def check_fractions(job):
    """c_r: sums over phases, and the methods against each other"""
    one, phases = one_point(job), job.phases()
    for method in ("SphereVolumes", "ChordSampling", "TemplateSampling"):
        require(close(sum(one[method]), 1.0, 1e-12), f"the c_r of {method} do not add to 1")  # each by rounding only
    octants = [field(checks, "SphereVolumeFractions") for checks, _ in blocks(job)]
    for i, phase in enumerate(phases):
        chords, template = one["ChordSampling"][i], one["TemplateSampling"][i]
        # Chords and throws sample the same points. 5 standard errors, and where a phase is so rare that the batches cannot tell them,
        # those of counts: 5 throws
        error = math.hypot(one["ChordSampling_error"][i], one["TemplateSampling_error"][i])
        require(close(chords, template, 5.0 * error + 5.0 / job.args.throws), f"c_{phase}: {chords} by chords, {template} by throws")
        # The spheres are counted in the whole window, the chords lie within a margin of it: these parts of the pack differ by less than
        # the standard error of a part as large, which 8 octants give with 7 degrees of freedom: 5 of these
        part = standard_error([fractions[i] if i < len(fractions) else 0.0 for fractions in octants])
        require(close(one["SphereVolumes"][i], chords, 5.0 * math.hypot(part, one["ChordSampling_error"][i])),
                f"c_{phase}: {one['SphereVolumes'][i]} by spheres, {chords} by chords")


def check_identities(job):
    """S_rs: lags, values at 0, sums over phases, gradients, autocovariances, checks"""
    args, phases, c = job.args, job.phases(), table_of(job.one["Sphere Volumes"])["VolumeFraction"]
    exact, overlap = table_of(job.exact), field(fetch(job.exact), "OverlapPercent")
    for source in (job.exact, job.chords, job.template):
        table = table_of(source)
        require(len(table["r"]) == args.lags + 1, "the number of lags is wrong")
        require(all(close(r, args.maximum_lag * k / args.lags, 1e-9) for k, r in enumerate(table["r"])), "the lags are wrong")
        # Every pair of points lies in some pair of phases, whatever the method; rounding adds up over the pairs
        for k in range(args.lags + 1):
            total = sum(table[pair(phases, r, s)][k] for r, s in itertools.product(phases, phases))
            require(close(total, 1.0, 1e-11), f"the sum of all S_rs is {total} at lag {k}")
    at_zero = 1e-12 + 2.0 * overlap / 100.0  # an overlap counts for both orders of its two spheres
    for r, c_r in zip(phases, c):
        own = [exact[pair(phases, r, s)] for s in phases]
        require(all(close(sum(values), c_r, 1e-11) for values in zip(*own)), f"the sum over s of S_{r}_s is not c_{r}")
        for s, values in zip(phases, own):
            require(close(values[0], c_r if r == s else 0.0, at_zero), f"S_{r}_{s}(0) is wrong")
    gradients, covariances, step = table_of(job.exact, 2), table_of(job.exact, 3), args.maximum_lag / args.lags
    for (i, r), (j, s) in itertools.combinations_with_replacement(enumerate(phases), 2):
        name = pair(phases, r, s)
        values = exact[name]
        for k in range(1, args.lags):  # central differences
            slope = (values[k + 1] - values[k - 1]) / (2.0 * step)
            require(close(gradients[name][k], slope, 1e-9 / step),
                    f"the gradient of {name} is wrong at lag {k}")
        require(all(close(chi, value - c[i] * c[j], 1e-11) for chi, value in zip(covariances[f"chi_{r}_{s}"], values)),
                f"chi_{r}_{s} is not {name} - c_r c_s")
    checks = table_of(job.exact, 1)
    require(close(field(fetch(job.exact, 1), "VolumeCheck"), 0.0, 1e-12), "the c_r do not add to 1")
    require(all(error <= at_zero for error in checks["ErrorAtZero"]), "an error at lag 0 is not of rounding")
    for name, error, length in zip(checks["Pair"], checks["ErrorAtInfinity"], checks["SaturationLength"]):
        # Saturated means within the tolerance (0.0005, the default) at all lags beyond
        require(math.isnan(length) or error <= 0.0005 + 1e-12, f"{name} is called saturated, but {error} from its limit")
    surface, slope = (field(fetch(job.exact, 1), name) for name in ("SpecificSurface", "SpecificSurfaceFromSlope"))
    # Spheres just not in contact make the differences at 0 good to first order in the step only (see convergence.py): by 0.2 steps / mean
    # diameter there
    diameter = 6.0 * (1.0 - c[-1]) / surface
    require(close(surface, slope, 0.5 * surface * step / diameter), f"specific surface {surface}, from the slope {slope}")


def check_methods(job):
    """S_rs: chords against the template, and both against the exact sum"""
    phases = job.phases()
    exact, chords, template = (table_of(source) for source in (job.exact, job.chords, job.template))
    octants = [two for _, two in blocks(job)]
    for r, s in itertools.combinations_with_replacement(phases, 2):
        name = pair(phases, r, s)
        error = norm([math.hypot(a, b) for a, b in zip(chords[name + "_error"], template[name + "_error"])])
        difference = norm([a - b for a, b in zip(chords[name], template[name])])
        # The norm of the standard errors is that of a difference, root mean square; lags go together, so that the norm scatters as a
        # single number does: 5. Phases that the throws hardly meet have no good errors; 5 throws of 20 directions do not count
        rare = 5.0 / (20.0 * job.args.throws) * math.sqrt(job.args.lags)
        require(difference <= 5.0 * error + rare, f"{name}: template and chords differ by {difference}, the error is {error}")
        # The exact sum sees the whole window, the chords what lies within its margin: see check_fractions
        end = job.block_lags + 1
        scatter = [standard_error([two[name][k] if name in two else 0.0 for two in octants]) for k in range(end)]
        error = norm([math.hypot(a, b) for a, b in zip(scatter, chords[name + "_error"])])
        difference = norm([a - b for a, b in zip(chords[name][:end], exact[name])])
        require(difference <= 5.0 * error, f"{name}: exact and chords differ by {difference}, parts of the pack by {error}")
    checks = table_of(job.chords, 1)
    for name, asymmetry in zip(checks["Pair"], checks["Asymmetry"]):
        # C_rs - C_sr scatters twice as much as the mean of both, if they are independent: 5 times that
        bound = 5.0 * 2.0 * norm(chords[name + "_error"]) / norm(chords[name])
        require(asymmetry <= bound, f"{name}: asymmetry {asymmetry}, bound {bound}")


def check_isotropy(job):
    """isotropy: sigma_S is the scatter of the directions, whose mean is S_rs, and it is small"""
    along, sigma, exact = table_of(job.directions, 1), table_of(job.directions), table_of(job.exact)
    number, count = job.args.directions, job.args.lags + 1
    require(len(along["r"]) == number * count, "a row for each direction and lag is wanted")
    for name in largest_pairs(job):
        for k in range(1, count):
            values = along[name][k::count]
            mean = sum(values) / number
            deviation = math.sqrt(sum((value - mean)**2 for value in values) / (number - 1))
            require(close(deviation, sigma["sigma_" + name][k], 1e-12), f"sigma_{name} at lag {k} is not {deviation}")
            # Directions spread evenly have a mean nearer to that over the sphere than random ones: 5 standard errors of these
            require(close(mean, exact[name][k], 5.0 * deviation / math.sqrt(number) + 1e-9), f"{name} at lag {k}: mean {mean}")
    if job.args.input == os.path.join(HERE, "Data", "bead_block.csv"):
        # What the paper finds for its settled pack, of S_mm in Fig. 6
        require(isotropy_in_percent(job, "S_m_m") < 1.0, f"sigma of S_mm is {isotropy_in_percent(job, 'S_m_m')} % of S_mm")


def check_map(job):
    """map S_rs(x): the value at 0, x and -x, and the limits"""
    image, n = fetch_map(job), job.args.resolution
    edge = 2 * n + 1
    require(image.GetDimensions() == (edge, edge, edge), f"the map has {image.GetDimensions()} points")
    c = dict(zip(job.phases(), table_of(job.one["Sphere Volumes"])["VolumeFraction"]))
    overlap = field(fetch(job.exact), "OverlapPercent")
    for i in range(image.GetPointData().GetNumberOfArrays()):
        array = image.GetPointData().GetArray(i)
        _, r, s = array.GetName().split("_")
        values = list(memoryview(array))
        centre = values[len(values) // 2]
        # Overlaps count twice in the sum over pairs, rounding (2^-34 of a sphere a pair) once for each
        require(close(centre, c[r] if r == s else 0.0, 1e-8 + 2.0 * overlap / 100.0), f"{array.GetName()} is {centre} at 0")
        require(values == values[::-1], f"{array.GetName()} is not even")
        require(-1e-8 <= min(values) and max(values) <= min(c[r], c[s]) + 1e-8 + overlap / 50.0, f"{array.GetName()}: out of range")


def check_chord_lengths(job):
    """chord lengths: sums, lineal paths, and mean chords against volume and surface"""
    table, phases = table_of(job.chord_lengths), job.phases()
    two, step = table_of(job.chords), job.args.maximum_lag / job.args.lags
    means = field(fetch(job.chord_lengths), "MeanChordLength")
    for i, phase in enumerate(phases):
        density, path = table["p_" + phase], table["L_" + phase]
        # The probabilities of all lengths; there are longer chords than the last lag, and scatter
        total = step * (density[0] / 2.0 + sum(density[1:]))
        spread = step * math.sqrt(sum(error**2 for error in table[f"p_{phase}_error"] if not math.isnan(error)))
        require(total <= 1.0 + 5.0 * spread + 1e-9, f"the density of chords of {phase} adds to {total}")
        require(close(path[0], two[f"S_{phase}_{phase}"][0], 1e-9), f"L_{phase}(0) is not c_{phase}")
        # A segment in a phase has its ends there: by the same lines, so within rounding
        require(all(a <= b + 1e-9 for a, b in zip(path, two[f"S_{phase}_{phase}"])), f"L_{phase} exceeds S_{phase}_{phase}")
    # c_r / (surface of spheres / 4) of matrix: 4 c_m / s. The octants tell how much parts differ (5 standard errors, see above); a line
    # crosses at least one chord of the matrix, whose number therefore scatters by less than 1 / sqrt(lines): 5 of these
    expected = [4.0 * field(checks, "SphereVolumeFractions")[-1] / field(checks, "SpecificSurface") for checks, _ in blocks(job)]
    mean = sum(expected) / 8.0
    bound = 5.0 * math.hypot(standard_error(expected), mean / math.sqrt(job.args.lines))
    require(close(means[-1], mean, bound), f"mean chord of the matrix {means[-1]}, 4 c_m / s {mean}, bound {bound}")


def check_distances(job):
    """g_rs(r): none below contact, 1 far away"""
    table = table_of(job.distances)
    step, smallest = job.args.maximum_lag / job.args.lags, min(table_of(job.modes, 1)["MinimumDiameter"])
    if field(fetch(job.exact), "OverlapPercent") < 0.01:
        # Contacts may press in by a little, and a bin reaches half a step to either side
        require(all(g == 0.0 for r, g in zip(table["r"], table["g"]) if r + step < 0.95 * smallest), "spheres are nearer than contact")
    if not math.isnan(field(fetch(job.exact), "SaturationLength")):
        far = table["g"][3 * len(table["g"]) // 4:]
        # Saturated: what is left of order at the last quarter of the lags is a few percent at most, and is averaged
        require(close(sum(far) / len(far), 1.0, 0.05), f"g is {sum(far) / len(far)} far away")


def check_files(job):
    """the files, read again, hold what was written"""
    for name, source, port in job.table_files:
        written, read = table_of(source, port), table_of(CSVReader(FileName=[job.path(name)]))
        # As text, since nan (no saturation up to the last lag) does not equal itself
        require([*map(str, written.items())] == [*map(str, read.items())], f"{name} reads differently")
    require(one_point(job) == table_of(CSVReader(FileName=[job.path("one_point.csv")])), "one_point.csv reads differently")
    reader = vtkXMLImageDataReader()  # not of several ranks, of which Fetch would bring one slab
    reader.SetFileName(job.path("map.vti"))
    reader.Update()
    written, read = fetch_map(job), reader.GetOutput()
    require(written.GetDimensions() == read.GetDimensions() and written.GetSpacing() == read.GetSpacing(), "map.vti: other points")
    for i in range(written.GetPointData().GetNumberOfArrays()):
        array = written.GetPointData().GetArray(i)
        require(values_of(array) == values_of(read.GetPointData().GetArray(array.GetName())), f"map.vti: other {array.GetName()}")


if __name__ == "__main__":
    try:
        main()
    except Exception:
        # Under mpirun an exception that leaves the script would keep the other ranks waiting for ever
        sys.exit(traceback.format_exc())

# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The checks of pack_statistics.py: plain Python on the fetched results, by independent means, with what they share with its summary.
`job` has the filters, files and options."""
import itertools
import math
import os

from paraview.simple import *
from vtkmodules.vtkIOXML import vtkXMLImageDataReader

from common import (HERE, close, fetch, field, norm, pair, path_in, require, require_equal_images, require_equal_tables, sort_spheres,
                    standard_error, table_of)


def one_point(job):
    """c_r by all methods side by side."""
    table = {}
    for method, source in job.one.items():
        one, name = table_of(source), method.replace(" ", "")
        table["Phase"] = one["Phase"]
        table[name] = one["VolumeFraction"]
        if "VolumeFraction_error" in one:
            table[name + "_error"] = one["VolumeFraction_error"]
    return table


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


def check_fractions(job):
    """c_r: sums over phases, and the methods against each other"""
    one, phases = one_point(job), job.phases()
    for method in ("SphereVolumes", "ChordSampling", "TemplateSampling"):
        require(close(sum(one[method]), 1.0, 1e-12), f"the c_r of {method} do not add to 1")  # they differ by rounding only
    octants = [field(checks, "SphereVolumeFractions") for checks, _ in blocks(job)]
    for i, phase in enumerate(phases):
        chords, template = one["ChordSampling"][i], one["TemplateSampling"][i]
        # Chords and throws sample the same points. The limit is 5 standard errors; where a phase is so rare that the batches cannot tell them,
        # it is that of counts, 5 throws
        error = math.hypot(one["ChordSampling_error"][i], one["TemplateSampling_error"][i])
        require(close(chords, template, 5.0 * error + 5.0 / job.args.throws), f"c_{phase}: {chords} by chords, {template} by throws")
        # The spheres are counted in the whole window, the chords lie within a margin of it: these parts of the pack differ by less than
        # the standard error of a part as large, which 8 octants give with 7 degrees of freedom. The limit is 5 of these
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
    at_zero = 1e-12 + 2.0 * overlap / 100.0  # an overlap counts in both orders of its two spheres
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
        # S_rs has saturated where it is within the tolerance (0.0005, the default) at all lags beyond
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
        # The norm of the standard errors is that of a difference, root mean square; lags go together, so that the norm scatters as a single
        # number does; the limit is 5 of them. Phases that the throws hardly meet have no good errors; 5 throws of 20 directions do not count
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
        # C_rs - C_sr scatters twice as much as the mean of both, if they are independent; the limit is 5 times that
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
            # Directions spread evenly have a mean nearer to that over the sphere than random ones. The limit is 5 standard errors of these
            require(close(mean, exact[name][k], 5.0 * deviation / math.sqrt(number) + 1e-9), f"{name} at lag {k}: mean {mean}")
    if job.args.input == os.path.join(HERE, "Data", "bead_block.csv"):
        # The paper finds this for S_mm of its settled pack, in Fig. 6
        require(isotropy_in_percent(job, "S_m_m") < 1.0, f"sigma of S_mm is {isotropy_in_percent(job, 'S_m_m')} % of S_mm")


def check_map(job):
    """map S_rs(x): the value at 0, x and -x, and the limits"""
    image, n = job.fetch_map(), job.args.resolution
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
        # A segment in a phase has its ends there. Both are from the same lines, so they agree within rounding
        require(all(a <= b + 1e-9 for a, b in zip(path, two[f"S_{phase}_{phase}"])), f"L_{phase} exceeds S_{phase}_{phase}")
    # c_r / (surface of spheres / 4) of matrix: 4 c_m / s. The octants tell how much parts differ (the limit is 5 standard errors, see above); a
    # line crosses at least one chord of the matrix, whose number therefore scatters by less than 1 / sqrt(lines); the limit is 5 of these
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
        # g_rs has saturated: what is left of order at the last quarter of the lags is a few percent at most, and is averaged
        require(close(sum(far) / len(far), 1.0, 0.05), f"g is {sum(far) / len(far)} far away")


def check_files(job):
    """the files, read again, hold what was written"""
    require_equal_tables(job.args.output, job.tables)
    require(one_point(job) == table_of(CSVReader(FileName=[path_in(job.args.output, "one_point.csv")])), "one_point.csv reads differently")
    reader = vtkXMLImageDataReader()  # not on several ranks, of which Fetch would bring one slab
    reader.SetFileName(path_in(job.args.output, "map.vti"))
    reader.Update()
    require_equal_images(job.fetch_map(), reader.GetOutput(), "map.vti")


CHECKS = (check_fractions, check_identities, check_methods, check_isotropy, check_map, check_chord_lengths, check_distances, check_files)

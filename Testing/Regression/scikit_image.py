# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Particles From Image beside scikit-image, on an image of beads that touch: its threshold, which voxels are connected, the watershed, and
volumes, centres and surfaces of what that has cut.

    pvbatch scikit_image.py
"""
import os
import sys

from paraview.simple import *

try:
    import numpy
    from skimage import filters, measure, morphology, segmentation
    from scipy import ndimage
except ImportError as missing:
    print('left out: scikit-image is not there: %s' % missing)
    sys.exit(0)

from vtkmodules.util.numpy_support import vtk_to_numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import fetch, field, run

PACK = os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../Examples/Data/bead_block.csv')
VOXEL = 3.0
SIZE = [240, 210, 180]
EVERY = numpy.ones((3, 3, 3))  # a voxel is connected with all 26 around it

modes = ParticleModes(Input=SpherePackReader(FileName=PACK), NumberOfModes=1, BoxOrigin=[400, 400, 200], BoxSize=SIZE, CropToWindow=1)
image = LabelImage(Input=modes, VoxelSize=VOXEL, VolumeFractions=1)


def voxels(source, name, port=0):
    """The values of the cells, z before y before x."""
    data = fetch(source, port)
    x, y, z = (edge - 1 for edge in data.GetDimensions())
    return vtk_to_numpy(data.GetCellData().GetArray(name)).reshape(z, y, x)


def points(source, name):
    return vtk_to_numpy(fetch(source).GetPointData().GetArray(name))


def cut(height):
    """Every particle of the watershed, none of which is too small."""
    return ParticlesFromImage(Input=image, ImageArray='Phase', Method='Watershed', MarkerHeight=height, MinimumDiameter=1e-3)


def pairs(a, b):
    """Which numbers above 0 stand on the same voxels, and how often."""
    both = (a > 0) & (b > 0)
    return numpy.unique(numpy.stack([a[both], b[both]]), axis=1, return_counts=True)


def threshold():
    """Otsu's, of grey values: between the same two values of the histogram."""
    found = ParticlesFromImage(Input=image, ImageArray='VolumeFraction', Method='Watershed')
    ours, theirs = field(fetch(found), 'Threshold'), filters.threshold_otsu(voxels(image, 'VolumeFraction'))
    assert abs(ours - theirs) < 0.02, (ours, theirs)


def connected():
    """Basins that all are joined are the connected parts, voxel for voxel; here of voxels that lie within particles."""
    found = ParticlesFromImage(Input=image, ImageArray='VolumeFraction', Method='Watershed', MarkerHeight=1e6, MinimumDiameter=1e-3, Threshold=0.95, Smoothing=0)
    ours = voxels(found, 'ParticleId', 1)
    theirs = measure.label(voxels(image, 'VolumeFraction') > 0.95, connectivity=3)
    assert numpy.array_equal(ours > 0, theirs > 0)
    numbers, _ = pairs(ours, theirs)
    assert numbers.shape[1] == ours.max() == theirs.max() > 20, (numbers.shape, ours.max(), theirs.max())


def watershed():
    """As many particles, one around each of their markers, and nearly all voxels in the same one."""
    is_particle = voxels(image, 'Phase') > 0
    distance = ndimage.distance_transform_edt(is_particle)
    for height in (0.117, 0.517, 1.517):  # which no difference of two distances comes near
        markers = measure.label(morphology.h_maxima(distance, height, EVERY), connectivity=3)
        theirs = segmentation.watershed(-distance, markers, connectivity=EVERY, mask=is_particle)
        ours = voxels(cut(height), 'ParticleId', 1)
        assert numpy.array_equal(ours > 0, theirs > 0)
        numbers, _ = pairs(ours, markers)
        assert numbers.shape[1] == ours.max() == markers.max() > 20, (height, numbers.shape, ours.max(), markers.max())
        partner = dict(zip(numbers[0], numbers[1]))
        numbers, counts = pairs(ours, theirs)
        same = sum(count for a, b, count in zip(*numbers, counts) if partner[a] == b)
        assert same > 0.995 * is_particle.sum(), (height, same / is_particle.sum())
        print('  at %s: %d particles, %.2f %% of the voxels in the same one' % (height, ours.max(), 100 * same / is_particle.sum()))


def sphericity_of(mesh):
    """The surface of a ball of the same volume over that of the mesh."""
    corners, triangles = mesh[:2]
    a, b, c = (corners[triangles[:, n]].astype(float) for n in range(3))
    volume = abs(numpy.einsum('ij,ij', a, numpy.cross(b, c))) / 6
    return (36 * numpy.pi * volume ** 2) ** (1 / 3) / measure.mesh_surface_area(corners, triangles)


def shapes():
    """Volume and centre of what was cut; of particles within the image the surface, theirs of marching cubes, with the edges of voxels blurred."""
    found = cut(0.5)
    ours = voxels(found, 'ParticleId', 1)
    radii, sphericities, faces = (points(found, name) for name in ('Radius', 'Sphericity', 'BorderFaces'))
    centres = vtk_to_numpy(fetch(found).GetPoints().GetData())
    regions = measure.regionprops(ours)
    assert len(regions) == len(radii)
    ratios = []
    for region, radius, centre, sphericity, cut_by in zip(regions, radii, centres, sphericities, faces):
        assert abs(radius - VOXEL * (0.75 * region.area / numpy.pi) ** (1 / 3)) < 1e-9 * radius
        for ends, place, low in zip(centre, region.centroid[::-1], (400, 400, 200)):
            assert abs(ends - low - VOXEL * (place + 0.5)) < 1e-6
        if cut_by == 0 and radius > 6 * VOXEL:
            alone = ndimage.gaussian_filter(numpy.pad(region.image, 4).astype(float), 1.0)
            ratios.append(sphericity / sphericity_of(measure.marching_cubes(alone, 0.5)))
    print('  our sphericities over those of marching cubes: %.3f, deviation %.3f, of %d particles' % (numpy.mean(ratios), numpy.std(ratios), len(ratios)))
    assert len(ratios) > 10 and abs(numpy.mean(ratios) - 1) < 0.03 and numpy.std(ratios) < 0.02


if __name__ == '__main__':
    run((threshold, connected, watershed, shapes))

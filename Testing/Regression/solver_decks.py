# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Solvers take what Solver Deck Writer writes, and give the known conductivity and bulk modulus of a simple cubic array.

    pvbatch solver_decks.py FOLDER calculix|gmsh|meshio     FOLDER for its files

A program that is not installed is left out, with a line that says so.
"""
import importlib.util
import os
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from paraview.simple import *

from harness import fetch, field, run

FOLDER = os.path.join(sys.argv[1], 'solver_decks_' + sys.argv[2])
FRACTION, CONTRAST = 0.4, 10.0
# Rayleigh's method with all multipoles that matter: McPhedran, McKenzie, Proc. R. Soc. London A 359, 45 (1978)
CONDUCTIVITY = 2.3644


def mesh_of(size):
    """A cubic array, with elements of so many radii."""
    radius = (3.0 * FRACTION / (4.0 * 3.14159265358979)) ** (1.0 / 3.0)
    with open('cubic.csv', 'w') as file:
        file.write('x,y,z,radius\n0.5,0.5,0.5,%r\n' % radius)
    box = {'BoxSize': [1, 1, 1], 'BoxPeriodic': [1, 1, 1]}
    return PeriodicMesh(Input=SpherePackReader(FileName=[os.path.abspath('cubic.csv')], **box), ElementSize=size * radius)


def volumes_of(mesh):
    """The volume of each tetrahedron, whose numbers in a deck begin with 1."""
    data = fetch(mesh)
    volumes = []
    for n in range(data.GetNumberOfCells()):
        a, b, c, d = (data.GetPoint(data.GetCell(n).GetPointId(k)) for k in range(4))
        u, v, w = ([q - p for p, q in zip(a, end)] for end in (b, c, d))
        volumes.append((u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6.0)
    return volumes


def solve(mesh, physics, matrix, particles, step):
    """The means over the box of what the last table of CalculiX has for each element."""
    SaveData('cell.inp', proxy=mesh, Physics=physics)
    keyword, printed = ('ELASTIC', 'S') if physics == 'Elasticity' else ('CONDUCTIVITY', 'HFL')
    with open('job.inp', 'w') as deck:
        deck.write('*INCLUDE, INPUT=cell.inp\n')
        for name, constants in (('MATRIX', matrix), ('PARTICLES', particles)):
            deck.write('*MATERIAL, NAME=%s\n*%s\n%s\n' % (name, keyword, ', '.join(map(repr, constants))))
        for name in ('MATRIX', 'PARTICLES'):
            deck.write('*SOLID SECTION, ELSET=%s, MATERIAL=%s\n' % (name, name))
        deck.write('*STEP\n' + step + ''.join('*EL PRINT, ELSET=%s\n%s\n' % (name, printed) for name in ('MATRIX', 'PARTICLES')) + '*END STEP\n')
    subprocess.run(['ccx', 'job'], check=True, stdout=subprocess.DEVNULL, timeout=150)
    volumes = volumes_of(mesh)
    seen, sums = set(), None
    with open('job.dat') as results:
        for line in results:
            words = line.split()
            if len(words) > 2 and words[0].isdigit():
                values = [volumes[int(words[0]) - 1] * float(word) for word in words[2:]]
                sums = values if sums is None else [a + b for a, b in zip(sums, values)]
                seen.add(int(words[0]))
    assert len(seen) == len(volumes), (len(seen), len(volumes))
    return sums


def conductivity(mesh, of_particles):
    step = '*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\nCORNER_X0Y0Z0, 11, 11, 0.\n' + ''.join(
        'PERIOD_%s, 11, 11, %d.\n' % (axis, axis == 'X') for axis in 'XYZ')
    return [-flux for flux in solve(mesh, 'Conduction', [1.0], [of_particles], step)]


def bulk_modulus(mesh, matrix, particles, shear):
    def constants(bulk):  # Young's modulus and Poisson's ratio
        return [9 * bulk * shear / (3 * bulk + shear), (3 * bulk - 2 * shear) / (6 * bulk + 2 * shear)]
    step = '*STATIC\n*BOUNDARY\nCORNER_X0Y0Z0, 1, 3, 0.\n' + ''.join(
        'PERIOD_%s, %d, %d, %s\n' % (axis, k + 1, k + 1, '0.01' if 'XYZ'[k] == axis else '0.') for axis in 'XYZ' for k in range(3))
    stress = solve(mesh, 'Elasticity', constants(matrix), constants(particles), step)
    return sum(stress[:3]) / 3.0 / 0.03, stress


def calculix():
    coarse, fine = mesh_of(0.3), mesh_of(0.15)
    # Equal phases: every linear field is exact, but for the 7 digits of the tables
    assert all(abs(k - exact) < 1e-6 for k, exact in zip(conductivity(coarse, 1.0), (1, 0, 0)))
    bulk, stress = bulk_modulus(coarse, 2.0, 2.0, 1.0)
    assert abs(bulk - 2.0) < 1e-6 and max(map(abs, stress[3:])) < 1e-6, (bulk, stress)
    # The error of linear elements and of inscribed polyhedra falls with the square of the size, four times from coarse to fine: what is
    # left is a third of what has gone, and less than that much itself
    along = [conductivity(mesh, CONTRAST)[0] for mesh in (coarse, fine)]
    print('conductivity', along, 'exact', CONDUCTIVITY)
    assert abs(along[1] - CONDUCTIVITY) < abs(along[1] - along[0]), along
    # Phases of equal shear modulus have Hill's bulk modulus, whatever their shapes; c is that of the polyhedra. By the principle of
    # minimum energy elements give more
    errors = []
    for mesh in (coarse, fine):
        c = field(fetch(mesh), 'MeshFractions')[0]
        exact = 1.0 / (c / (20.0 + 4.0 / 3.0) + (1.0 - c) / (2.0 + 4.0 / 3.0)) - 4.0 / 3.0
        errors.append(bulk_modulus(mesh, 2.0, 20.0, 1.0)[0] / exact - 1.0)
    print('bulk modulus over the exact one, less 1:', errors)
    assert 0.0 < errors[1] < errors[0] / 2.0, errors


def elements_of(name):
    """The types of the elements of a file of gmsh, format 2."""
    with open(name) as file:
        lines = file.read().split('\n')
    begin = lines.index('$Elements') + 2
    return int(lines[lines.index('$Nodes') + 1]), [line.split()[1] for line in lines[begin:begin + int(lines[begin - 1])]]


def gmsh():
    mesh = mesh_of(0.3)
    SaveData('cell.msh', proxy=mesh)
    said = subprocess.run(['gmsh', 'cell.msh', '-save', '-format', 'msh2', '-o', 'again.msh'], check=True, timeout=60, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True).stdout
    assert 'Error' not in said, said
    nodes, kinds = elements_of('again.msh')
    data = fetch(mesh)
    assert nodes == data.GetNumberOfPoints() and kinds.count('4') == data.GetNumberOfCells(), (nodes, len(kinds))
    # Refined it has eight tetrahedra for each
    subprocess.run(['gmsh', 'again.msh', '-refine', '-format', 'msh2', '-o', 'fine.msh'], check=True, timeout=120, stdout=subprocess.DEVNULL)
    assert elements_of('fine.msh')[1].count('4') == 8 * data.GetNumberOfCells()


def meshio():
    from meshio import read
    mesh = mesh_of(0.3)
    data, volumes = fetch(mesh), volumes_of(mesh)
    for regions, name in (('Phases', 'PARTICLES'), ('Modes', 'MODE_1'), ('Particles', 'PARTICLE_1')):
        SaveData('cell.msh', proxy=mesh, Regions=regions)
        again = read('cell.msh')
        assert [list(again.points[n]) for n in range(len(again.points))] == [list(data.GetPoint(n)) for n in range(data.GetNumberOfPoints())]
        blocks = dict(zip(('MATRIX', name), [block.data for block in again.cells if block.type == 'tetra']))
        assert set(again.field_data) == {'x_min', 'x_max', 'y_min', 'y_max', 'z_min', 'z_max', 'MATRIX', name}
        assert sum(map(len, blocks.values())) == len(volumes)
        phase = data.GetCellData().GetArray('Phase')
        assert len(blocks[name]) == sum(phase.GetValue(n) == 1 for n in range(len(volumes)))
        for _, pair, _, nodes in again.gmsh_periodic:
            assert pair[0] == pair[1] + 1 and len(nodes) > 0
            for high, low in nodes:
                step = again.points[high] - again.points[low]
                assert sorted(step.round(12)) == [0.0, 0.0, 1.0], step
        SaveData('cell.inp', proxy=mesh, Regions=regions)
        again = read('cell.inp')
        assert len(again.points) == data.GetNumberOfPoints() + 3 and sum(len(block.data) for block in again.cells) == len(volumes)


def main():
    missing = {'calculix': shutil.which('ccx') is None, 'gmsh': shutil.which('gmsh') is None,
               'meshio': importlib.util.find_spec('meshio') is None}
    name = sys.argv[2]
    if missing[name]:
        print('left out: %s is not installed (%s)' % (name, {'calculix': 'apt-get install calculix-ccx', 'gmsh': 'apt-get install gmsh',
                                                             'meshio': 'pip install meshio'}[name]))
        return
    os.makedirs(FOLDER, exist_ok=True)
    os.chdir(FOLDER)
    globals()[name]()
    print(name, 'takes the decks')


run([main])

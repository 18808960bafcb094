# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The pages of the help that the plugin carries: one for each proxy, with formulas and source, in readable letters.

    pvpython TestHelp.py RepresentativeUnitCell.so RepresentativeUnitCell.qch FOLDER     FOLDER of the documents, if they are in the help, too

A help file of Qt is an SQLite database of compressed pages.
"""
import base64
import os
import re
import sqlite3
import sys
import zlib

PLUGIN, FILE, *DOCUMENTS = sys.argv[1:]
# For each proxy a formula that only its page has, as a user reads it
FORMULAS = {
    'filters.OnePointProbability': 'c_r = (1 / V) Σ (4 π / 3) a_i³',
    'filters.TwoPointProbability': 'S_rs(r) = (δ_rs / V) Σ V_ii(r) + Σ g(r, d_ij) / γ(d_ij)',
    'filters.DirectionalProbability': 'σ_S_rs(r) = √( Σ (S_rs(r n) − mean)² / (M − 1) )',
    'filters.ProbabilityMap': 'S_rs(x) = (δ_rs / V) Σ V_ii(|x|) + Σ V_ij(|d_ij − x|) / γ(d_ij)',
    'filters.ChordLengths': 'L_r(r) = Σ (c − r)+ / Σ (l − r)+',
    'filters.EffectiveProperties': '⟨a⟩ − c_1 c_2 (a_2 − a_1)² / (c_1 a_2 + c_2 a_1 + y)',
    'filters.ImageStatistics': 'S_rs(x) = (A_rs(x) + A_rs(−x)) / (2 W(x))',
    'filters.NeighbourStatistics': 'q_l² = Σ A_f A_g P_l(n_f · n_g) / (Σ A)²',
    'filters.RadialDistribution': 'g_rs(r_k) = Σ (V / γ(d_ij)) / (N shell_k / V)',
    'filters.ThirdOrderParameters': 'I_qrs = ⅓ ⟨χ_q F_r : F_s⟩',
    'filters.ThreePointProbability': 'ζ = 9 / (2 c (1 − c)) I_2 and η = 5 ζ / 21 + 150 / (7 c (1 − c)) I_4',
    'filters.VoidDistances': 'δ(x) = min |x − c_i| − r_i',
    'filters.UnitCellReconstruction': 'h_c³ = (4 π / 3) Σ n_i² r_i⁶ / Σ c_i n_i r_i³ (equation 12)',
    'filters.CompareProbabilities': 'E = Σ ‖S_rs pack − S_rs cell‖ / Σ (‖S_rs pack‖ + ‖S_rs cell‖) / 2 × 100 % (17)',
    'filters.CellSizeStudy': 'LeastSize = min { n : |Z| ≤ 2 for every descriptor at n and at every larger size }',
    'filters.CompareWithPack': 'Z = (Cell − Pack) / √(Pack_error² + Cell_deviation² / number of cells)',
    'filters.LabelImage': 'W(a, b) = (R³ atan2(R z, a b) + a b z) / 3',
    'filters.ParticleModes': '(Σ d³ / N)^(1/3)',
    'filters.ParticlesFromImage': 'B(r; R) = Φ(t) − (σ / r) φ(t) with t = (R − r) / σ',
    'filters.PeriodicMesh': 'ρ = √(2 a b g / (a + b)) · 1.8^k',
    'filters.PeriodicReplicas': 'x + (i L_x, j L_y, k L_z)',
    'filters.PointsToSpherePack': 'centre = Scale × point; Radius = Scale × a for an array a of radii',
    'sources.SpherePackSource': '(Σ 4 π r³ / (3 φ))^(1/3)',
    'sources.SpherePackReader': 'position = Scale × (x, y, z)',
    'writers.RawImageWriter': 'place i + n_x (j + n_y k) after the header',
    'writers.SolverDeckWriter': 'u(high) − u(low) − Σ u(PERIOD_a) = 0',
    'writers.SpherePackWriter': 'diameter = 2 × Radius',
}
BOOK, FROM_THE_BOOK = 'Torquato, Random Heterogeneous Materials, Springer 2002', ('filters.ChordLengths', 'filters.EffectiveProperties', 'filters.ImageStatistics', 'filters.RadialDistribution', 'filters.ThirdOrderParameters', 'filters.VoidDistances')
SOURCES = {'filters.PeriodicMesh': 'Bowyer, The Computer Journal 24, 162 (1981)',
           'filters.NeighbourStatistics': 'Mickel, Kapfer, Schröder-Turk, Mecke, J. Chem. Phys. 138, 044501 (2013)',
           'sources.SpherePackSource': 'Lubachevsky, Stillinger, J. Stat. Phys. 60, 561 (1990)'}
PROPERTIES = {'filters.DirectionalProbability': ['Number Of Directions', 'Number Of Lines', 'Seed'],
              'filters.ProbabilityMap': ['Phase Pairs', 'Resolution', 'Spacing'],
              'filters.ChordLengths': ['Number Of Lines', 'Target Error', 'Mask Label'],
              'filters.LabelImage': ['Voxel Size', 'Dimensions', 'Samples Per Axis', 'Memory Limit'],
              'filters.ParticlesFromImage': ['Method', 'Marker Height', 'Overlap Tolerance', 'Border Particles'],
              'filters.RadialDistribution': ['Maximum Lag', 'Number Of Lags', 'Estimated Memory'],
              'filters.TwoPointProbability': ['Method', 'Number Of Lines', 'Seed', 'Box Size', 'Estimated Time'],
              'filters.UnitCellReconstruction': ['Method', 'Cell Size', 'Checkpoint Interval', 'Cylinder Axis'],
              'sources.SpherePackReader': ['File Name', 'Format', 'Columns', 'Radius By Type', 'Length Unit', 'Box Periodic']}

# The plugin holds the help file in base64, in pieces
with open(PLUGIN, 'rb') as file:
    library = file.read()
with open(FILE, 'rb') as file:
    encoded = base64.b64encode(file.read())
assert encoded[:200] in library and encoded[-200:] in library, 'no help in the plugin'
database = sqlite3.connect(FILE)
pages, names = {}, set()
for name, data in database.execute('select Name, Data from FileNameTable join FileDataTable on FileId = Id where Data is not null'):
    names.add(name)
    if name.endswith('.html'):
        pages[name] = zlib.decompress(data[4:]).decode('utf-8')  # qCompress writes the length before it
print(len(pages), 'pages')

# A proxy without a formula here would go unseen
failures = [name + ' has no formula here' for name in pages
            if name.startswith(('filters.', 'sources.', 'writers.')) and name[:-len('.html')] not in FORMULAS]
for proxy, formula in FORMULAS.items():
    page = pages.get(proxy + '.html')
    if page is None:
        failures.append(proxy + ' has no page')
        continue
    text = ' '.join(page.split())
    if 'charset="utf-8"' not in page[:200].lower():
        failures.append(proxy + ' does not say its letters; Qt takes them for Latin-1')
    source = BOOK if proxy in FROM_THE_BOOK else SOURCES.get(proxy, 'Phys. Rev. E 80, 061301 (2009)')
    for part in [formula, source] + ['<th>%s</th>' % label for label in PROPERTIES.get(proxy, [])]:
        if part not in text:
            failures.append('%s does not have: %s' % (proxy, part))
    if sum(formula in ' '.join(other.split()) for other in pages.values()) != 1:
        failures.append('%s: the formula is on other pages too' % proxy)
# Every document has its page, and every link and picture of it what it leads to
for folder in DOCUMENTS:
    for document in os.listdir(folder):
        page = pages.get(document.replace('.md', '.html'))
        if not page:
            failures.append(document + ' has no page')
            continue
        for target in re.findall(r'(?:href|src)="([^"#]+)', page):
            if not target.startswith('https://') and target not in names:
                failures.append('%s leads to %s, which is not in the help' % (document, target))
        if '| ---' in page or '```' in page:
            failures.append(document + ' has Markdown left')
print('\n'.join(failures))
sys.exit(1 if failures else 0)

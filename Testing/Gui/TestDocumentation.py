# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""Loads the plugin by its path and looks at what a user reads: labels, functions, help texts.

    pvpython TestDocumentation.py RepresentativeUnitCell.so
"""
import os
import sys

from paraview import servermanager
from paraview.simple import *

assert not any(name in os.environ for name in ("PV_PLUGIN_CONFIG_FILE", "PV_PLUGIN_PATH")), "the plugin must not be there yet"
assert "TwoPointProbability" not in globals()
LoadPlugin(sys.argv[1], remote=False, ns=globals())

LABELS = {"Sphere Pack Reader": "sources", "Particle Modes": "filters", "One-Point Probability": "filters",
          "Two-Point Probability": "filters", "Three-Point Probability": "filters", "Compare Probabilities": "filters",
          "Directional Probability": "filters", "Probability Map": "filters", "Chord Lengths": "filters", "Radial Distribution": "filters",
          "Unit Cell Reconstruction": "filters", "Periodic Replicas": "filters"}
failures = []
manager = servermanager.ProxyManager().SMProxyManager
for label, group in LABELS.items():
    name = label.replace("-", "").replace(" ", "")
    prototype = manager.GetPrototypeProxy(group, name)
    if prototype is None or prototype.GetXMLLabel() != label:
        failures.append(f"{label}: no such proxy")
        continue
    if not callable(globals().get(name)):
        failures.append(f"{label}: no function {name}")
    for text in ("GetShortHelp", "GetLongHelp", "GetDescription"):
        if not (getattr(prototype.GetDocumentation(), text)() or "").strip():
            failures.append(f"{label}: {text} is empty")
    properties = prototype.NewPropertyIterator()
    properties.Begin()
    count = 0
    while not properties.IsAtEnd():
        key, item = properties.GetKey(), properties.GetProperty()
        documentation = item.GetDocumentation()
        help_text = (documentation.GetDescription() if documentation else None) or ""
        if not help_text.strip():
            failures.append(f"{label}: {key} has no help text")
        elif key not in ("Input", "Cell", "FileName") and not item.GetInformationOnly() and "Default:" not in help_text:
            failures.append(f"{label}: the help text of {key} does not say its default")
        # The label is what Python calls the property: it must be the name, spaced
        if item.GetXMLLabel().replace(" ", "") != key:
            failures.append(f"{label}: {key} has the label {item.GetXMLLabel()}")
        count += 1
        properties.Next()
    print(f"{label}: {count} properties")
    if count == 0:
        failures.append(f"{label}: no properties")
print("\n".join(failures))
sys.exit(1 if failures else 0)

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

failures = []
manager = servermanager.ProxyManager().SMProxyManager


def ours():
    # Its class is ParaView's reader of series
    yield manager.GetPrototypeProxy("sources", "SpherePackReader"), "SpherePackReader"
    for group in ("sources", "filters", "writers"):
        iterator = manager.GetProxyDefinitionManager().NewSingleGroupIterator(group)
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            definition = iterator.GetProxyDefinition()
            if definition and (definition.GetAttribute("class") or "").startswith("vtkRUC"):
                yield manager.GetPrototypeProxy(group, iterator.GetProxyName()), iterator.GetProxyName()
            iterator.GoToNextItem()


proxies = list(ours())
for prototype, proxy_name in proxies:
    label = prototype.GetXMLLabel()
    name = label.replace("-", "").replace(" ", "")
    if name != proxy_name:
        failures.append(f"{label}: the proxy is called {proxy_name}")
    if prototype.GetXMLGroup() != "writers" and not callable(globals().get(name)):
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
if len(proxies) < 13:
    failures.append(f"only {len(proxies)} proxies were found")
print("\n".join(failures))
sys.exit(1 if failures else 0)

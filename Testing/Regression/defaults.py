# SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
# SPDX-License-Identifier: BSD-3-Clause
"""The defaults that stand in the XML are those that the filters have themselves: each filter prints its properties as it was made, and
as a proxy has set it."""
import sys

from paraview import servermanager, simple

XML = '''<ServerManagerConfiguration><ProxyGroup name="bare"><SourceProxy name="{0}" class="{0}"/></ProxyGroup></ServerManagerConfiguration>'''
simple.Box()  # this connects
session = servermanager.ActiveConnection.Session
definitions = session.GetProxyDefinitionManager()
proxies = servermanager.ProxyManager().SMProxyManager


def printed(group, name):
    proxy = proxies.NewProxy(group, name)
    proxy.UpdateVTKObjects()
    lines = str(proxy.GetClientSideObject()).splitlines()
    # These are no properties, or differ for each object
    return [line.strip() for line in lines if line.startswith('  ') and not any(
        word in line for word in ('0x', 'Modified Time', 'Reference Count', 'Registered Events', '(none)', 'Debug'))]


def ours():
    for group in ('sources', 'filters', 'writers'):
        iterator = definitions.NewSingleGroupIterator(group)
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            name = iterator.GetProxyName()
            definition = iterator.GetProxyDefinition()
            class_name = definition.GetAttribute('class') if definition else None
            if class_name and class_name.startswith('vtkRUC'):
                yield group, name, class_name
            iterator.GoToNextItem()


# A wrong default would be seen
definitions.LoadConfigurationXMLFromString('''<ServerManagerConfiguration><ProxyGroup name="wrong"><SourceProxy name="wrong"
    class="vtkRUCUnitCellReconstruction"><IntVectorProperty name="Seed" command="SetSeed" number_of_elements="1" default_values="7"/>
    </SourceProxy></ProxyGroup></ServerManagerConfiguration>''')
if 'Seed: 7' not in printed('wrong', 'wrong'):
    sys.exit('a default of the XML is not seen')

checked = failed = 0
for group, name, class_name in list(ours()):
    definitions.LoadConfigurationXMLFromString(XML.format(class_name))
    own, xml = printed('bare', class_name), printed(group, name)
    checked += 1
    for line in sorted(set(own) ^ set(xml)):
        failed += 1
        print('FAILED: %s: %s %s' % (name, 'only in the filter:' if line in own else 'only in the XML:', line))
    print('%s: %d lines' % (name, len(own)))
if failed or checked < 10:
    sys.exit('%d proxies, %d differences' % (checked, failed))
print('passed: %d proxies' % checked)

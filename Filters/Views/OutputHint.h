// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

class vtkPVXMLElement;
class vtkSMProxy;
class vtkSMSourceProxy;

/**
 * What a filter says, in its hints, about how an output is to be shown:
 *
 *     <Representation view="XYChartView" type="RUCChart" port="0" bottom="Lag r" bottom_unit="%"/>
 */
namespace OutputHint
{
/** The output that a representation shows; `Source` is null where it has no input. */
struct Output
{
  vtkSMSourceProxy* Source;
  int Port;
};
Output OutputOf(vtkSMProxy* representation);

/**
 * Returns the element `Representation` of the output that names this kind of representation, or
 * null.
 */
vtkPVXMLElement* Find(vtkSMProxy* representation);

/**
 * Returns the title of `axis` (such as "bottom"), which is the attribute of that name. Where the
 * data has a `LengthUnit` among its field data and the hint a `bottom_unit`, this follows in
 * brackets, with % replaced by the unit: "Lag r (µm)". The title is empty without the attribute.
 */
std::string Title(vtkSMProxy* representation, vtkPVXMLElement* hint, const std::string& axis);
}

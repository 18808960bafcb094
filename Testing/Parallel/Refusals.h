// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Helpers of the claim that bad input gives one error, on rank 0, that names the filter, the array
 * or property, what is required and what was got, in one line without an address; that every output
 * is empty on every rank but for the reason; and that no rank waits for another.
 */
#pragma once

#include "Packs.h"
#include "Ranks.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataObject.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <string>

/** Collects the errors of an algorithm, or other messages, instead of printing them. */
struct Errors
{
  explicit Errors(vtkObject* object, unsigned long event = vtkCommand::ErrorEvent)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Texts.push_back(static_cast<const char*>(text)); });
    object->AddObserver(event, this->Command);
  }
  vtkNew<vtkCallbackCommand> Command;
  std::vector<std::string> Texts;
};

/** The same for warnings. */
struct Warnings : Errors
{
  explicit Warnings(vtkObject* object)
    : Errors(object, vtkCommand::WarningEvent)
  {
  }
};

/** Whether no output of the filter has a point, row or field on this rank, but for `Refusal`. */
inline bool IsEmpty(vtkAlgorithm* filter)
{
  bool empty = true;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* data = filter->GetOutputDataObject(port);
    empty = empty && data->GetNumberOfElements(vtkDataObject::POINT) == 0 &&
      data->GetNumberOfElements(vtkDataObject::ROW) == 0 &&
      data->GetFieldData()->GetNumberOfArrays() ==
        (data->GetFieldData()->GetAbstractArray("Refusal") ? 1 : 0);
  }
  return empty;
}

/** Returns the reason that an output gives for being empty. */
inline std::string RefusalOf(vtkDataObject* data)
{
  vtkAbstractArray* why = data->GetFieldData()->GetAbstractArray("Refusal");
  return why ? why->GetVariantValue(0).ToString() : "";
}

/** Expects that a text holds all parts. */
inline void ExpectParts(const std::string& text, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts)
  {
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is not in: " << text;
  }
}

/**
 * Expects that the filter has refused its input with one error that holds all parts, however often
 * its outputs are asked for.
 */
inline void ExpectRefusal(
  vtkAlgorithm* filter, const Errors& errors, const std::vector<std::string>& parts)
{
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    filter->Update(port);
    ExpectParts(RefusalOf(filter->GetOutputDataObject(port)), parts);
  }
  EXPECT_TRUE(IsEmpty(filter));
  EXPECT_EQ(errors.Texts.size(), Rank() == 0 ? 1u : 0u) << "one error, on rank 0";
  for (const std::string& text : errors.Texts)
  {
    ExpectParts(text, parts);
    EXPECT_EQ(text.find("(0x"), std::string::npos) << text;
  }
}

/** What makes a good input bad. What is not set leaves it as it is. */
template <class Filter>
struct Spoils
{
  std::function<void(ruc::SpherePack&)> Pack;
  std::function<void(vtkPolyData*)> Data;
  std::function<void(Filter*)> Settings;
  double BoxEdge = Edge;
};

/**
 * Expects that the filter takes a pack, and refuses it once it is spoiled. `parts` are in the
 * message; `configure` sets the filter up before it takes the good pack.
 */
template <class Filter>
void Refuses(const std::vector<std::string>& parts, const Spoils<Filter>& spoils,
  bool periodic = true, const std::function<void(Filter*)>& configure = {})
{
  vtkNew<Filter> filter;
  const Errors errors(filter);
  if (configure)
  {
    configure(filter);
  }
  filter->SetInputData(MakePolyData(FewSizes(), Edge, periodic, IsMine));
  filter->Update();
  EXPECT_TRUE(errors.Texts.empty()) << "the good pack is taken";
  if (Rank() == 0)
  {
    EXPECT_FALSE(IsEmpty(filter)) << "the good pack gives a result";
  }

  ruc::SpherePack bad = FewSizes();
  if (spoils.Pack)
  {
    spoils.Pack(bad);
  }
  const auto badData = MakePolyData(bad, spoils.BoxEdge, periodic, IsMine);
  if (spoils.Data)
  {
    spoils.Data(badData);
  }
  if (spoils.Settings)
  {
    spoils.Settings(filter);
  }
  filter->SetInputData(badData);
  filter->Update();
  ExpectRefusal(filter, errors, parts);
}

/** The same for spheres, for the data set that holds them, and for the filter's settings. */
template <class Filter>
void RefusesPack(
  const std::vector<std::string>& parts, const std::function<void(ruc::SpherePack&)>& spoil)
{
  Refuses<Filter>(parts, { spoil, {}, {} });
}
template <class Filter>
void RefusesData(
  const std::vector<std::string>& parts, const std::function<void(vtkPolyData*)>& spoil)
{
  Refuses<Filter>(parts, { {}, spoil, {} });
}
template <class Filter>
void RefusesSettings(const std::vector<std::string>& parts,
  const std::function<void(Filter*)>& spoil, bool periodic = true,
  const std::function<void(Filter*)>& configure = {})
{
  Refuses<Filter>(parts, { {}, {}, spoil }, periodic, configure);
}

// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PackInput.h"

#include "PackData.h"
#include "RankCommunicator.h"
#include "ResultData.h"
#include "ruc/Base/Text.h"
#include "ruc/Formats/TableColumns.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVariant.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace
{
using ruc::Text;

// A block, and the numbers of those of its points that are spheres
struct Block
{
  vtkPointSet* Points;
  std::vector<vtkIdType> Spheres;
};

vtkUnsignedCharArray* GhostTypes(vtkPointSet* points)
{
  return vtkUnsignedCharArray::SafeDownCast(
    points->GetPointData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
}

Block FindSpheres(vtkPointSet* points)
{
  constexpr int noSphere = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  Block block{ points, {} };
  vtkUnsignedCharArray* ghosts = GhostTypes(points);
  const vtkIdType marked = ghosts ? ghosts->GetNumberOfTuples() : 0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (i >= marked || !(ghosts->GetValue(i) & noSphere))
    {
      block.Spheres.push_back(i);
    }
  }
  return block;
}

// Returns the blocks, and after them the data sets that hold them
std::vector<vtkDataObject*> FindParts(vtkDataObject* input)
{
  std::vector<vtkDataObject*> parts, holders;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    const auto nodes = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
    nodes->VisitOnlyLeavesOff();
    for (nodes->InitTraversal(); !nodes->IsDoneWithTraversal(); nodes->GoToNextItem())
    {
      vtkDataObject* node = nodes->GetCurrentDataObject();
      (node->IsA("vtkCompositeDataSet") ? holders : parts).push_back(node);
    }
  }
  (input->IsA("vtkCompositeDataSet") ? holders : parts).push_back(input);
  parts.insert(parts.end(), holders.begin(), holders.end());
  return parts;
}

// Returns null unless all blocks have the array with a value for every point
vtkSmartPointer<vtkAbstractArray> MergeArrays(const std::vector<Block>& blocks, const char* name)
{
  vtkAbstractArray* first = nullptr;
  bool oneType = true, numbers = true;
  vtkIdType count = 0;
  for (const Block& block : blocks)
  {
    vtkAbstractArray* array = block.Points->GetPointData()->GetAbstractArray(name);
    first = first ? first : array;
    if (!array || array->GetNumberOfComponents() != first->GetNumberOfComponents() ||
      array->GetNumberOfTuples() < block.Points->GetNumberOfPoints())
    {
      return nullptr;
    }
    oneType = oneType && array->GetDataType() == first->GetDataType();
    numbers = numbers && array->IsA("vtkDataArray");
    count += static_cast<vtkIdType>(block.Spheres.size());
  }
  if (!oneType && !numbers)
  {
    return nullptr;
  }
  const auto merged = vtkSmartPointer<vtkAbstractArray>::Take(
    oneType ? vtkAbstractArray::CreateArray(first->GetDataType()) : vtkDoubleArray::New());
  merged->SetName(name);
  merged->SetNumberOfComponents(first->GetNumberOfComponents());
  merged->SetNumberOfTuples(count);
  vtkIdType place = 0;
  for (const Block& block : blocks)
  {
    vtkAbstractArray* array = block.Points->GetPointData()->GetAbstractArray(name);
    for (vtkIdType i : block.Spheres)
    {
      merged->SetTuple(place++, i, array);
    }
  }
  return merged;
}

vtkSmartPointer<vtkPoints> MergePoints(const std::vector<Block>& blocks)
{
  const int type = blocks.front().Points->GetPoints()->GetDataType();
  const bool oneType = std::all_of(blocks.begin(), blocks.end(),
    [&](const Block& block) { return block.Points->GetPoints()->GetDataType() == type; });
  vtkNew<vtkPoints> points;
  points->SetDataType(oneType ? type : VTK_DOUBLE);
  for (const Block& block : blocks)
  {
    for (vtkIdType i : block.Spheres)
    {
      points->InsertNextPoint(block.Points->GetPoint(i));
    }
  }
  return points;
}

std::vector<std::string> NamesOf(vtkTable* table)
{
  std::vector<std::string> names;
  for (vtkIdType n = 0; n < table->GetNumberOfColumns(); ++n)
  {
    names.emplace_back(table->GetColumnName(n) ? table->GetColumnName(n) : "");
  }
  return names;
}

// The columns become arrays, and those named as x, y and z the places as well
vtkSmartPointer<vtkPointSet> PointsOfTable(vtkTable* table)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->GetFieldData()->PassData(table->GetFieldData());
  if (table->GetNumberOfRows() == 0)
  {
    return result;
  }
  const std::vector<std::string> names = NamesOf(table);
  if (!ruc::NameCentres(names))
  {
    throw std::invalid_argument(Text("Columns x, y and z are required, got ",
      PackData::ListArrays(table->GetRowData()), "; Table To Points takes others."));
  }
  const ruc::TableColumns found = ruc::FindNamedColumns(names, {}, {});
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(table->GetNumberOfRows());
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkAbstractArray* column = table->GetColumn(found.Columns.Field[axis]);
    auto* numbers = vtkDataArray::SafeDownCast(column);
    if (!numbers || numbers->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument(Text("Column '", column->GetName(),
        "' requires numbers of one component, got ", PackData::DescribeArray(column), "."));
    }
    points->GetData()->CopyComponent(axis, numbers, 0);
  }
  result->SetPoints(points);
  result->GetPointData()->PassData(table->GetRowData());
  if (!found.LengthUnit.empty())
  {
    PackData::AddField(result, "LengthUnit", found.LengthUnit);
  }
  return result;
}

std::string ValuesOf(vtkAbstractArray* array)
{
  std::string text;
  for (vtkIdType n = 0; n < array->GetNumberOfValues(); ++n)
  {
    text += (n > 0 ? " " : "") + array->GetVariantValue(n).ToString();
  }
  return text;
}

bool AreEqual(vtkAbstractArray* a, vtkAbstractArray* b)
{
  bool equal = a->GetNumberOfValues() == b->GetNumberOfValues();
  for (vtkIdType n = 0; equal && n < a->GetNumberOfValues(); ++n)
  {
    equal = a->GetVariantValue(n) == b->GetVariantValue(n);
  }
  return equal;
}

const char* HowToMakePoints(vtkDataObject* data)
{
  return data->IsA("vtkTable")  ? "; Points To Sphere Pack makes a pack of one"
    : data->IsA("vtkImageData") ? "; Particles From Image makes a pack of one"
                                : "";
}

// Adds the first array of every name
void AddFields(vtkFieldData* fields, vtkFieldData* merged)
{
  for (int n = 0; n < fields->GetNumberOfArrays(); ++n)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(n);
    const char* name = array->GetName();
    vtkAbstractArray* present = name ? merged->GetAbstractArray(name) : array;
    if (!present)
    {
      merged->AddArray(array);
    }
    else if (name && PackData::IsOfWholePack(name) && !AreEqual(array, present))
    {
      throw std::invalid_argument(Text("Blocks of one pack require the same field data '", name,
        "', got ", ValuesOf(present), " and ", ValuesOf(array), "."));
    }
  }
}
}

void PackInput::Accept(vtkInformation* portInformation)
{
  // The pipeline looks only at the first type when it decides whether to go through the blocks
  portInformation->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObjectTree");
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  // Anything else is refused in one line, where the pipeline would say it a dozen times
  portInformation->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  portInformation->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
}

vtkSmartPointer<vtkPointSet> PackInput::FindHere(vtkDataObject* input, bool withTables)
{
  vtkTable* table = vtkTable::SafeDownCast(input);
  if (table && withTables)
  {
    return PointsOfTable(table);
  }
  auto* whole = vtkPointSet::SafeDownCast(input);
  if (!input || (whole && !GhostTypes(whole)))
  {
    return whole;
  }
  vtkNew<vtkPolyData> merged;
  std::vector<Block> blocks;
  for (vtkDataObject* part : FindParts(input))
  {
    auto* points = vtkPointSet::SafeDownCast(part);
    if (!points && !part->IsA("vtkCompositeDataSet"))
    {
      throw std::invalid_argument(Text(part == input ? "A pack requires points, got a "
                                                     : "Blocks of a pack require points, got a ",
        part->GetClassName(), HowToMakePoints(part), "."));
    }
    if (points && points->GetNumberOfPoints() > 0)
    {
      blocks.push_back(FindSpheres(points));
    }
    AddFields(part->GetFieldData(), merged->GetFieldData());
  }
  if (blocks.size() > 1)
  {
    merged->GetFieldData()->RemoveArray("NumberOfSpheres"); // it is that of one block
  }
  if (blocks.empty())
  {
    return merged;
  }
  merged->SetPoints(MergePoints(blocks));
  vtkPointData* arrays = blocks.front().Points->GetPointData();
  for (int n = 0; n < arrays->GetNumberOfArrays(); ++n)
  {
    const char* name = arrays->GetArrayName(n);
    if (name && name != std::string(vtkDataSetAttributes::GhostArrayName()))
    {
      if (const auto array = MergeArrays(blocks, name))
      {
        merged->GetPointData()->AddArray(array);
      }
    }
  }
  return merged;
}

vtkSmartPointer<vtkPointSet> PackInput::Find(
  vtkDataObject* input, RankCommunicator& ranks, bool withTables)
{
  vtkSmartPointer<vtkPointSet> points;
  ranks.Agree([&]() { points = FindHere(input, withTables); });
  return points;
}

std::string PackInput::TellTaken(vtkDataObject* input)
{
  auto* table = vtkTable::SafeDownCast(input);
  std::string told;
  for (const auto axis : { ruc::RowColumns::X, ruc::RowColumns::Y, ruc::RowColumns::Z })
  {
    const std::string of = table ? ruc::TellTaken(NamesOf(table), axis, "Table To Points") : "";
    told += (told.empty() || of.empty() ? "" : " ") + of;
  }
  return told;
}

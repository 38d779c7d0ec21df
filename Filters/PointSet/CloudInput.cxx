// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudInput.h"

#include "ArrayMemory.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <utility>

namespace sbvtk
{
namespace
{

std::string Refusal(vtkDataObject* data)
{
  const std::string remedy = data->IsA("vtkTable")
    ? "; apply Table To Points to it first."
    : "; convert it first, for instance by Extract Surface or Cell Centers.";
  return std::string("is of type ") + data->GetClassName() + ", not a set of points" + remedy;
}

/** The array itself if it has doubles, else a copy. */
vtkSmartPointer<vtkDoubleArray> AsDoubles(vtkDataArray* array)
{
  vtkSmartPointer<vtkDoubleArray> doubles = vtkDoubleArray::FastDownCast(array);
  if (!doubles)
  {
    doubles = vtkSmartPointer<vtkDoubleArray>::New();
    CopyTuples(array, doubles);
  }
  return doubles;
}

vtkDataArray* NormalsOf(vtkPointSet* cloud)
{
  vtkPointData* const attributes = cloud->GetPointData();
  return attributes->GetNormals() ? attributes->GetNormals() : attributes->GetArray("Normals");
}

/** The points of several sets in one, with the point arrays that all of them have. */
vtkSmartPointer<vtkPolyData> Joined(const std::vector<vtkPointSet*>& blocks)
{
  const auto joined = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkDataSetAttributes::FieldList common;
  vtkIdType count = 0;
  for (vtkPointSet* block : blocks)
  {
    count += block->GetNumberOfPoints();
    common.IntersectFieldList(block->GetPointData());
  }
  SetTuples(points, count);
  vtkPointData* attributes = joined->GetPointData();
  common.CopyAllocate(attributes, vtkDataSetAttributes::COPYTUPLE, count, 0);
  vtkIdType first = 0;
  for (std::size_t block = 0; block < blocks.size(); ++block)
  {
    const vtkIdType size = blocks[block]->GetNumberOfPoints();
    if (size > 0)
    {
      points->InsertPoints(first, size, 0, blocks[block]->GetPoints());
      common.CopyData(
        static_cast<int>(block), blocks[block]->GetPointData(), 0, size, attributes, first);
      first += size;
    }
  }
  joined->SetPoints(points);
  return joined;
}

void MarkBlocks(
  const std::vector<vtkPointSet*>& parts, const std::vector<int>& blockOfPart, vtkPolyData* joined)
{
  vtkNew<vtkIntArray> numbers;
  numbers->SetName(BlockArray);
  numbers->SetNumberOfValues(joined->GetNumberOfPoints());
  int* next = numbers->GetPointer(0);
  for (std::size_t part = 0; part < parts.size(); ++part)
  {
    next = std::fill_n(next, parts[part]->GetNumberOfPoints(), blockOfPart[part]);
  }
  joined->GetPointData()->AddArray(numbers);
}

} // namespace

std::string CloudInput::Read(vtkDataObject* data)
{
  *this = CloudInput();
  if (!data)
  {
    return "has no data; update the filter before it.";
  }
  if (vtkPointSet* cloud = vtkPointSet::SafeDownCast(data))
  {
    this->Cloud = cloud;
    this->NamesOfBlocks = CarriedBlockNames(cloud, cloud->GetPointData());
    this->AddToStamp(cloud);
  }
  else
  {
    const std::string refusal =
      vtkCompositeDataSet::SafeDownCast(data) ? this->ReadBlocks(data) : Refusal(data);
    if (!refusal.empty())
    {
      return refusal;
    }
  }
  if (this->NumberOfPoints() > 0)
  {
    this->PointArray = AsDoubles(this->Cloud->GetPoints()->GetData());
    this->ReadNormals();
  }
  return "";
}

std::string CloudInput::ReadBlocks(vtkDataObject* data)
{
  Blocks blocks = BlocksOf(data);
  std::vector<vtkPointSet*> parts;
  std::vector<int> blockOfPart;
  for (std::size_t leaf = 0; leaf < blocks.Leaves.size(); ++leaf)
  {
    vtkPointSet* part = vtkPointSet::SafeDownCast(blocks.Leaves[leaf]);
    if (!part)
    {
      return "has a block that " + Refusal(blocks.Leaves[leaf]);
    }
    if (part->GetNumberOfPoints() > 0) // an empty one need not have the arrays of the others
    {
      parts.push_back(part);
      blockOfPart.push_back(blocks.BlockOfLeaf[leaf]);
      this->AddToStamp(part);
    }
  }
  const vtkSmartPointer<vtkPolyData> joined = Joined(parts);
  if (!blocks.Names.empty())
  {
    MarkBlocks(parts, blockOfPart, joined);
  }
  this->Cloud = joined;
  this->NamesOfBlocks = std::move(blocks.Names);
  return "";
}

void CloudInput::AddToStamp(vtkPointSet* block)
{
  // Modification times are given out once in a process, so they tell arrays apart as well as their
  // states.
  vtkDataArray* const normals = NormalsOf(block);
  this->Stamp.push_back(block->GetPoints() ? block->GetPoints()->GetMTime() : 0);
  this->Stamp.push_back(block->GetPoints() ? block->GetPoints()->GetData()->GetMTime() : 0);
  this->Stamp.push_back(normals ? normals->GetMTime() : 0);
}

void CloudInput::ReadNormals()
{
  vtkDataArray* const normals = NormalsOf(this->Cloud);
  if (!normals)
  {
    return;
  }
  if (normals->GetNumberOfComponents() != 3 ||
    normals->GetNumberOfTuples() != this->NumberOfPoints())
  {
    this->Remark = std::string("The array ") +
      (normals->GetName() ? normals->GetName() : "Normals") + " has " +
      std::to_string(normals->GetNumberOfTuples()) + " tuples of " +
      std::to_string(normals->GetNumberOfComponents()) + " components for " +
      std::to_string(this->NumberOfPoints()) +
      " points, so normals are estimated; give it one vector a point.";
    return;
  }
  this->NormalArray = AsDoubles(normals);
}

const double* CloudInput::Points() const
{
  return this->PointArray ? this->PointArray->GetPointer(0) : nullptr;
}

const double* CloudInput::Normals() const
{
  return this->NormalArray ? this->NormalArray->GetPointer(0) : nullptr;
}

} // namespace sbvtk

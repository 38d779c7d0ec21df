// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudInput.h"

#include "ArrayMemory.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

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

/** The points of several sets in one, with the point arrays that all of them have. */
vtkSmartPointer<vtkPointSet> Joined(const std::vector<vtkPointSet*>& blocks)
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
  }
  else if (vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    std::vector<vtkPointSet*> blocks;
    const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    {
      vtkPointSet* block = vtkPointSet::SafeDownCast(iterator->GetCurrentDataObject());
      if (!block)
      {
        return "has a block that " + Refusal(iterator->GetCurrentDataObject());
      }
      if (block->GetNumberOfPoints() > 0) // an empty one need not have the arrays of the others
      {
        blocks.push_back(block);
      }
    }
    this->Cloud = Joined(blocks);
  }
  else
  {
    return Refusal(data);
  }
  if (this->NumberOfPoints() > 0)
  {
    this->PointArray = AsDoubles(this->Cloud->GetPoints()->GetData());
    this->ReadNormals();
  }
  return "";
}

void CloudInput::ReadNormals()
{
  vtkPointData* attributes = this->Cloud->GetPointData();
  vtkDataArray* normals =
    attributes->GetNormals() ? attributes->GetNormals() : attributes->GetArray("Normals");
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

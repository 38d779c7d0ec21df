// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudCurves.h"

#include "BlockNames.h"
#include "DesignedInput.h"
#include "NURBSArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace sbvtk
{
namespace
{

template <class Array>
void Name(Array& array, const char* name, int components = 1)
{
  array->SetName(name);
  array->SetNumberOfComponents(components);
}

struct PointArrays
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkDoubleArray> Normals;
  vtkNew<vtkDoubleArray> Curvatures;
  vtkNew<vtkIdTypeArray> Cells;
  vtkNew<vtkIntArray> Faces;
  vtkNew<vtkDoubleArray> Parameters;

  PointArrays()
  {
    this->Points->SetDataTypeToDouble();
    Name(this->Normals, "Normals", 3);
    Name(this->Curvatures, "Curvature");
    Name(this->Cells, "OriginalCellId");
    Name(this->Faces, FaceArray);
    Name(this->Parameters, ParametersArray, 2);
  }

  void Add(const sb::Real3& point, const CurvePlace& place, const sb::SurfaceValue& f)
  {
    const double steepness = sb::Length(f.Gradient);
    const sb::Real3 normal =
      steepness > 0.0 ? sb::Scaled(f.Gradient, 1.0 / steepness) : sb::Real3{};
    const double bending = sb::Length(place.CurvatureVector);
    this->Points->InsertNextPoint(point.data());
    this->Normals->InsertNextTuple(normal.data());
    this->Curvatures->InsertNextValue(place.Face < 0   ? sb::SectionCurvature(f, place.Normal)
        : sb::Dot(place.CurvatureVector, normal) < 0.0 ? -bending
                                                       : bending);
    this->Cells->InsertNextValue(place.Cell);
    this->Faces->InsertNextValue(place.Face);
    this->Parameters->InsertNextTuple(place.UV.data());
  }

  void Attach(CutWith cutter, vtkPolyData* output)
  {
    vtkPointData* const data = output->GetPointData();
    output->SetPoints(this->Points);
    data->SetNormals(this->Normals);
    data->AddArray(this->Curvatures);
    data->SetActiveScalars(this->Curvatures->GetName()); // ParaView colours by it at once
    if (cutter == CutWith::Mesh)
    {
      data->AddArray(this->Cells);
    }
    if (cutter == CutWith::Patches)
    {
      data->AddArray(this->Faces);
      data->AddArray(this->Parameters);
    }
  }
};

struct CurveArrays
{
  vtkNew<vtkDoubleArray> Lengths;
  vtkNew<vtkDoubleArray> Errors;
  vtkNew<vtkIntArray> Closed;
  vtkNew<vtkIntArray> Ends;
  vtkNew<vtkIntArray> Tangential;

  CurveArrays()
  {
    Name(this->Lengths, "Length");
    Name(this->Errors, "ChordError");
    Name(this->Closed, "Closed");
    Name(this->Ends, "Ends", 2);
    Name(this->Tangential, "Tangential");
  }

  void Add(const CloudCurve& curve)
  {
    double length = 0.0;
    for (std::size_t i = 1; i < curve.Points.size(); ++i)
    {
      length += sb::Length(sb::Difference(curve.Points[i], curve.Points[i - 1]));
    }
    const int ends[2] = { static_cast<int>(curve.Ends[0]), static_cast<int>(curve.Ends[1]) };
    this->Lengths->InsertNextValue(length);
    this->Errors->InsertNextValue(curve.ChordError);
    this->Closed->InsertNextValue(curve.Closed ? 1 : 0);
    this->Ends->InsertNextTypedTuple(ends);
    this->Tangential->InsertNextValue(curve.IsTangential ? 1 : 0);
  }

  void Attach(CutWith cutter, vtkPolyData* output)
  {
    vtkCellData* const data = output->GetCellData();
    data->AddArray(this->Lengths);
    data->AddArray(this->Closed);
    data->AddArray(this->Errors);
    data->AddArray(this->Ends);
    if (cutter != CutWith::Plane)
    {
      data->AddArray(this->Tangential);
    }
  }
};

} // namespace

void BuildCurves(const std::vector<CloudCurve>& curves, const sb::MovingLeastSquares& surface,
  CutWith cutter, vtkPolyData* output)
{
  PointArrays ofPoints;
  CurveArrays ofCurves;
  vtkNew<vtkCellArray> lines;
  sb::MovingLeastSquares::Neighbourhood near;
  for (const CloudCurve& curve : curves)
  {
    // A loop has its first point once, as a point, and twice in its line.
    const std::size_t distinct = curve.Points.size() - (curve.Closed ? 1 : 0);
    const vtkIdType first = ofPoints.Points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(curve.Points.size()));
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      lines->InsertCellPoint(first + static_cast<vtkIdType>(i < distinct ? i : 0));
      if (i < distinct)
      {
        ofPoints.Add(
          curve.Points[i], curve.Places[i], surface.EvaluateAt(curve.Points[i], 2, near));
      }
    }
    ofCurves.Add(curve);
  }
  output->SetLines(lines);
  ofPoints.Attach(cutter, output);
  ofCurves.Attach(cutter, output);
}

//------------------------------------------------------------------------------
void MarkBlocks(const DesignedInput& tool, vtkPolyData* output)
{
  if (tool.Names().empty())
  {
    return;
  }
  vtkCellData* const cells = tool.Data()->GetCellData();
  const vtkSmartPointer<vtkIntArray> ofCells = NumbersFrom(0, cells);
  vtkDataArray* const cellIds = output->GetPointData()->GetArray("OriginalCellId");
  vtkDataArray* const faceIds = output->GetPointData()->GetArray(FaceArray);
  std::vector<int> blockOfFace(tool.Surface().Patches.size(), -1);
  vtkDataArray* const facesOfCells = faceIds ? cells->GetArray(FaceArray) : nullptr;
  for (vtkIdType cell = 0; facesOfCells && cell < facesOfCells->GetNumberOfTuples(); ++cell)
  {
    const double face = facesOfCells->GetComponent(cell, 0);
    if (face >= 0.0)
    {
      blockOfFace[static_cast<std::size_t>(face)] = ofCells->GetValue(cell);
    }
  }
  vtkNew<vtkIntArray> blocks;
  Name(blocks, BlockArray);
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    blocks->InsertNextValue(cellIds
        ? ofCells->GetValue(static_cast<vtkIdType>(cellIds->GetComponent(i, 0)))
        : blockOfFace[static_cast<std::size_t>(faceIds->GetComponent(i, 0))]);
  }
  output->GetPointData()->AddArray(blocks);
  AddBlockNames(output, tool.Names());
}

} // namespace sbvtk

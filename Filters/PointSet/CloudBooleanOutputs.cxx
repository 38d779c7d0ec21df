// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudBooleanOutputs.h"

#include "BlockNames.h"
#include "FieldArrays.h"
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
#include "vtkTypeInt64Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace sbvtk
{
namespace
{

vtkSmartPointer<vtkPoints> MakePoints(const std::vector<double>& coordinates)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(ArrayOf<vtkDoubleArray>("Points", 3, coordinates));
  return points;
}

/** Cells that have the same number of corners. */
template <class Ids>
vtkSmartPointer<vtkCellArray> MakeCells(const Ids& corners, std::int64_t perCell)
{
  const std::int64_t count = static_cast<std::int64_t>(corners.size()) / perCell;
  vtkNew<vtkTypeInt64Array> offsets;
  SetTuples(offsets, count + 1);
  for (std::int64_t i = 0; i <= count; ++i)
  {
    offsets->GetPointer(0)[i] = i * perCell;
  }
  const auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, ArrayOf<vtkTypeInt64Array>("", 1, corners));
  return cells;
}

/** The seam's points are marked in all outputs by the same name. */
void MarkSeam(vtkPolyData* output, const std::vector<std::uint8_t>& onSeam)
{
  output->GetPointData()->AddArray(ArrayOf<vtkUnsignedCharArray>("SeamPoint", 1, onSeam));
}

std::vector<std::string> BuildSurface(
  const CloudBooleanParts& parts, vtkPolyData* surface, sb::Executor& executor)
{
  const sb::CloudBooleanResult& result = parts.Result;
  surface->SetPoints(MakePoints(result.Mesh.Points));
  surface->SetPolys(MakeCells(result.Mesh.Triangles, 3));
  std::vector<vtkIdType> original(result.ToolTriangle.size());
  std::transform(result.ToolTriangle.begin(), result.ToolTriangle.end(), original.begin(),
    [&](std::int32_t t) { return t < 0 ? -1 : vtkIdType(parts.Tool.CellOfTriangle(t)); });
  std::vector<std::string> sentences = CarrySurfaceArrays(parts, original, surface, executor);
  std::vector<std::uint8_t> onSeam(result.Sides.size());
  std::transform(result.Sides.begin(), result.Sides.end(), onSeam.begin(),
    [](std::uint8_t sides) { return static_cast<std::uint8_t>(sides == 3 ? 1 : 0); });
  vtkPointData* const points = surface->GetPointData();
  points->SetNormals(nullptr); // one normal a point would blur the edges of the tool
  points->AddArray(ArrayOf<vtkDoubleArray>("Normals", 3, result.Normals));
  points->AddArray(ArrayOf<vtkDoubleArray>("Residual", 1, result.Residuals));
  MarkSeam(surface, onSeam);
  vtkCellData* const cells = surface->GetCellData();
  cells->AddArray(ArrayOf<vtkIntArray>("SourceId", 1, result.Mesh.Source));
  cells->SetActiveScalars("SourceId"); // ParaView colours by it at once
  cells->AddArray(ArrayOf<vtkIdTypeArray>("OriginalCellId", 1, original));
  cells->AddArray(ArrayOf<vtkDoubleArray>("Confidence", 1, result.Mesh.Confidence));
  if (!result.FaceId.empty())
  {
    cells->AddArray(ArrayOf<vtkIntArray>(FaceArray, 1, result.FaceId));
    points->AddArray(ArrayOf<vtkDoubleArray>(ParametersArray, 2, result.UV));
  }
  return sentences;
}

std::vector<double> Flat(const std::vector<sb::Real3>& places)
{
  std::vector<double> flat;
  flat.reserve(3 * places.size());
  for (const sb::Real3& place : places)
  {
    flat.insert(flat.end(), place.begin(), place.end());
  }
  return flat;
}

/** The kept samples in the order of the input, then the seam. */
void BuildPoints(const CloudBooleanParts& parts, vtkPolyData* output, sb::Executor& executor)
{
  const sb::CloudBooleanResult& result = parts.Result;
  const sb::PointTree& samples = parts.Cloud.Surface->Samples();
  std::vector<std::int32_t> ids;
  for (std::int32_t i = 0; i < samples.Size(); ++i)
  {
    if (result.KeptSamples[static_cast<std::size_t>(i)])
    {
      ids.push_back(samples.Id(i));
    }
  }
  std::sort(ids.begin(), ids.end());
  std::vector<double> places;
  std::vector<double> normals;
  for (const std::int32_t id : ids)
  {
    const std::size_t first = 3 * static_cast<std::size_t>(id);
    places.insert(places.end(), parts.Input.Points() + first, parts.Input.Points() + first + 3);
    normals.insert(normals.end(), parts.Cloud.Normals.begin() + static_cast<std::ptrdiff_t>(first),
      parts.Cloud.Normals.begin() + static_cast<std::ptrdiff_t>(first + 3));
  }
  std::vector<vtkIdType> original(ids.begin(), ids.end());
  std::vector<std::uint8_t> onSeam(ids.size(), 0);
  const std::vector<double> seam = Flat(result.Seam.Points);
  const std::vector<double> seamNormals = Flat(result.Seam.Normals);
  places.insert(places.end(), seam.begin(), seam.end());
  normals.insert(normals.end(), seamNormals.begin(), seamNormals.end());
  original.resize(original.size() + result.Seam.Points.size(), -1);
  onSeam.resize(original.size(), 1);
  output->SetPoints(MakePoints(places));
  std::vector<vtkIdType> vertices(original.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  output->SetVerts(MakeCells(vertices, 1));
  if (!result.NearestSample.empty() || !result.SeamSample.empty())
  {
    ids.insert(ids.end(), result.SeamSample.begin(), result.SeamSample.end());
    CarryCloudArrays(parts.Input, ids, output->GetPointData(), executor);
  }
  output->GetPointData()->SetNormals(ArrayOf<vtkDoubleArray>("Normals", 3, normals));
  output->GetPointData()->AddArray(ArrayOf<vtkIdTypeArray>("OriginalPointId", 1, original));
  MarkSeam(output, onSeam);
}

void BuildCurves(const sb::CloudBooleanResult& result, vtkPolyData* output)
{
  const sb::SeamCurves& seam = result.Seam;
  output->SetPoints(MakePoints(Flat(seam.Points)));
  vtkNew<vtkCellArray> lines;
  std::vector<double> lengths;
  std::vector<double> errors;
  std::vector<int> closed;
  for (const sb::SeamCurve& curve : seam.Curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.Points.size()));
    double length = 0.0;
    for (std::size_t i = 0; i < curve.Points.size(); ++i)
    {
      lines->InsertCellPoint(curve.Points[i]);
      const auto place = [&](std::size_t k) {
        return seam.Points[static_cast<std::size_t>(curve.Points[k])];
      };
      length += i > 0 ? sb::Length(sb::Difference(place(i), place(i - 1))) : 0.0;
    }
    lengths.push_back(length);
    errors.push_back(curve.ChordError);
    closed.push_back(curve.Closed ? 1 : 0);
  }
  output->SetLines(lines);
  vtkPointData* const points = output->GetPointData();
  points->SetNormals(ArrayOf<vtkDoubleArray>("Normals", 3, Flat(seam.Normals)));
  points->AddArray(ArrayOf<vtkDoubleArray>("Residual", 1, seam.Residuals));
  if (!result.FaceId.empty())
  {
    std::vector<double> uv;
    for (const std::array<double, 2>& place : result.SeamUV)
    {
      uv.insert(uv.end(), place.begin(), place.end());
    }
    points->AddArray(ArrayOf<vtkDoubleArray>(ParametersArray, 2, uv));
  }
  output->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("Length", 1, lengths));
  output->GetCellData()->AddArray(ArrayOf<vtkIntArray>("Closed", 1, closed));
  output->GetCellData()->AddArray(ArrayOf<vtkDoubleArray>("ChordError", 1, errors));
}

/** The cloud's blocks are at points, as it has no cells, those of the tool at cells; both count
 * through. */
void MarkBlocks(const CloudBooleanParts& parts, const CloudBooleanOutputs& outputs)
{
  BlockNames names = parts.Input.Names();
  const int firstOfTool = static_cast<int>(names.size());
  const BlockNames& ofTool = parts.Tool.Names();
  names.insert(names.end(), ofTool.begin(), ofTool.end());
  AddBlockNames(outputs.Surface, names);
  AddBlockNames(outputs.Points, names);
  if (ofTool.empty())
  {
    return;
  }
  const vtkSmartPointer<vtkIntArray> blocks =
    NumbersFrom(firstOfTool, parts.Tool.Data()->GetCellData());
  std::vector<int> ofCells(parts.Result.ToolTriangle.size());
  std::transform(parts.Result.ToolTriangle.begin(), parts.Result.ToolTriangle.end(),
    ofCells.begin(),
    [&](std::int32_t t) { return t < 0 ? -1 : blocks->GetValue(parts.Tool.CellOfTriangle(t)); });
  outputs.Surface->GetCellData()->AddArray(ArrayOf<vtkIntArray>(BlockArray, 1, ofCells));
}

} // namespace

std::vector<std::string> BuildCloudBoolean(
  const CloudBooleanParts& parts, const CloudBooleanOutputs& outputs, sb::Executor& executor)
{
  std::vector<std::string> sentences = BuildSurface(parts, outputs.Surface, executor);
  BuildPoints(parts, outputs.Points, executor);
  MarkBlocks(parts, outputs);
  BuildCurves(parts.Result, outputs.Curves);
  return sentences;
}

} // namespace sbvtk

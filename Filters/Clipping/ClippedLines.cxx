// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClippedLines.h"

#include "vtkCellArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace sbvtk
{
namespace
{

/** Cuts the lines of a surface, one segment after the other. */
class LineClipper
{
public:
  LineClipper(const sb::ClipRequest& request, sb::ClipResult& result, ClippedLines& lines)
    : Request(request)
    , Result(result)
    , Lines(lines)
  {
  }

  void Clip(const vtkIdType* points, vtkIdType size, vtkIdType cell)
  {
    for (vtkIdType i = 0; i + 1 < size; ++i)
    {
      if (points[i] < 0 || points[i] >= this->Request.Mesh.NumberOfPoints || points[i + 1] < 0 ||
        points[i + 1] >= this->Request.Mesh.NumberOfPoints)
      {
        this->End(cell);
        continue;
      }
      const std::pair<double, double> inside = this->PartInFront(points[i], points[i + 1]);
      if (!this->Request.InsideOut)
      {
        this->AddPart(points[i], points[i + 1], inside.first, inside.second, cell);
      }
      else if (inside.first >= inside.second)
      {
        this->AddPart(points[i], points[i + 1], 0.0, 1.0, cell);
      }
      else
      {
        this->AddPart(points[i], points[i + 1], 0.0, inside.first, cell);
        this->AddPart(points[i], points[i + 1], inside.second, 1.0, cell);
      }
    }
    this->End(cell);
  }

private:
  const double* Place(vtkIdType point) const { return this->Request.Mesh.Points + 3 * point; }

  /** The part of a segment in front of all planes, as parameters from 0 to 1; empty if the first is
   * not less. */
  std::pair<double, double> PartInFront(vtkIdType from, vtkIdType to) const
  {
    std::pair<double, double> part{ 0.0, 1.0 };
    for (const sb::ClipPlane& plane : this->Request.Planes)
    {
      double heights[2] = { 0.0, 0.0 };
      for (int axis = 0; axis < 3; ++axis)
      {
        heights[0] += plane.Normal[axis] * (this->Place(from)[axis] - plane.Origin[axis]);
        heights[1] += plane.Normal[axis] * (this->Place(to)[axis] - plane.Origin[axis]);
      }
      if (heights[0] < 0.0 && heights[1] < 0.0)
      {
        return { 1.0, 0.0 };
      }
      if (heights[0] < 0.0)
      {
        part.first = std::max(part.first, heights[0] / (heights[0] - heights[1]));
      }
      else if (heights[1] < 0.0)
      {
        part.second = std::min(part.second, heights[0] / (heights[0] - heights[1]));
      }
    }
    return part;
  }

  void AddPart(vtkIdType from, vtkIdType to, double first, double last, vtkIdType cell)
  {
    if (first >= last)
    {
      return;
    }
    if (first > 0.0 || this->Points.empty())
    {
      this->End(cell);
      this->Points.push_back(this->IdAt(from, to, first));
    }
    this->Points.push_back(this->IdAt(from, to, last));
    if (last < 1.0)
    {
      this->End(cell);
    }
  }

  void End(vtkIdType cell)
  {
    if (this->Points.size() > 1)
    {
      this->Lines.Add(this->Points, 0, cell);
    }
    this->Points.clear();
  }

  std::int32_t IdAt(vtkIdType from, vtkIdType to, double parameter)
  {
    const auto next =
      static_cast<std::int32_t>(this->Result.KeptPoints.size() + this->Result.Created.size());
    if (parameter == 0.0 || parameter == 1.0)
    {
      const vtkIdType end = parameter == 0.0 ? from : to;
      const auto known = this->Ends.emplace(end, next);
      if (!known.second)
      {
        return known.first->second;
      }
      from = to = end;
    }
    sb::InterpolatedPoint point{ {}, 0,
      { static_cast<std::int32_t>(from), static_cast<std::int32_t>(to),
        static_cast<std::int32_t>(from) },
      { 1.0 - parameter, parameter, 0.0 } };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = this->Place(from)[axis];
      const double b = this->Place(to)[axis];
      point.Position[axis] = from == to ? a : a + parameter * (b - a);
    }
    this->Result.Created.push_back(point);
    return next;
  }

  const sb::ClipRequest& Request;
  sb::ClipResult& Result;
  ClippedLines& Lines;
  std::vector<std::int32_t> Points; ///< of the line in the making
  std::unordered_map<vtkIdType, std::int32_t> Ends;
};

} // namespace

void AddInputLines(
  vtkPolyData* input, const sb::ClipRequest& request, sb::ClipResult& result, ClippedLines& lines)
{
  vtkCellArray* cells = input->GetLines();
  if (!cells || cells->GetNumberOfCells() == 0)
  {
    return;
  }
  LineClipper clipper(request, result, lines);
  for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    cells->GetCellAtId(i, size, points);
    clipper.Clip(points, size, input->GetNumberOfVerts() + i);
  }
}

void AddOutline(const std::vector<sb::OutlineSegment>& outline, ClippedLines& lines)
{
  std::vector<std::uint8_t> done(outline.size(), 0);
  for (std::size_t begin = 0, end = 0; begin < outline.size(); begin = end)
  {
    std::unordered_multimap<std::int32_t, std::size_t> leaving;
    for (end = begin; end < outline.size() && outline[end].Plane == outline[begin].Plane; ++end)
    {
      leaving.emplace(outline[end].Points[0], end);
    }
    for (std::size_t first = begin; first < end; ++first)
    {
      if (done[first])
      {
        continue;
      }
      std::vector<std::int32_t> points{ outline[first].Points[0] };
      for (auto next = leaving.find(points[0]); next != leaving.end();
           next = points.back() == points[0] ? leaving.end() : leaving.find(points.back()))
      {
        done[next->second] = 1;
        points.push_back(outline[next->second].Points[1]);
        leaving.erase(next);
      }
      lines.Add(points, outline[begin].Plane + 1, -1);
    }
  }
}

} // namespace sbvtk

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudBooleanAttributes.h"

#include "AttributeUnion.h"

#include "vtkCellData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace sbvtk
{
namespace
{

constexpr std::int32_t OfCloud = 0;
constexpr std::int32_t OfTool = 1;

/** Runs of ids that are alike: not negative, of the operand; or of the other one, which has none.
 */
template <class Ids>
std::vector<CopyRun> RunsOf(const Ids& ids, std::int32_t operand)
{
  std::vector<CopyRun> runs;
  for (std::size_t first = 0; first < ids.size();)
  {
    std::size_t end = first + 1;
    while (end < ids.size() && (ids[end] < 0) == (ids[first] < 0))
    {
      ++end;
    }
    CopyRun run;
    run.Operand = ids[first] < 0 ? 1 - operand : operand;
    run.First = static_cast<std::int64_t>(first);
    run.Count = static_cast<std::int64_t>(end - first);
    runs.push_back(run);
    first = end;
  }
  return runs;
}

/** The weights of a triangle's corners at the place of its plane that is opposite to `place`. */
std::array<double, 3> WeightsAt(
  const sb::Real3& place, const sb::Real3& a, const sb::Real3& b, const sb::Real3& c)
{
  const sb::Real3 across = sb::Cross(sb::Difference(b, a), sb::Difference(c, a));
  const auto share = [&](const sb::Real3& from, const sb::Real3& to) {
    const sb::Real3 part = sb::Cross(sb::Difference(from, place), sb::Difference(to, place));
    return sb::Dot(part, across) / sb::Dot(across, across);
  };
  const std::array<double, 3> weights{ share(b, c), share(c, a), share(a, b) };
  const bool isFinite = std::isfinite(weights[0] + weights[1] + weights[2]);
  return isFinite ? weights : std::array<double, 3>{ 1.0, 0.0, 0.0 };
}

double LeastOf(const std::array<double, 3>& weights)
{
  return std::min({ weights[0], weights[1], weights[2] });
}

/** A point of the seam may have been moved beyond its triangle: a little of that is well continued
 * from inside, more is not. */
std::array<double, 3> Bounded(std::array<double, 3> weights)
{
  constexpr double most = 0.1;
  if (LeastOf(weights) < -most)
  {
    double sum = 0.0;
    for (double& weight : weights)
    {
      weight = std::max(0.0, weight);
      sum += weight;
    }
    for (double& weight : weights)
    {
      weight /= sum;
    }
  }
  return weights;
}

/** Where the values of the surface's points come from. */
class PointSources
{
public:
  explicit PointSources(const CloudBooleanParts& parts)
    : Parts(parts)
    , Places(parts.Result.Sides.size())
  {
    for (sb::InterpolatedPoint& place : this->Places)
    {
      place.Operand = OfCloud;
      place.PointIds = { 0, 0, 0 };
      place.Weights = { 1.0, 0.0, 0.0 };
    }
    const sb::CombinedMesh& mesh = parts.Result.Mesh;
    for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
    {
      const std::int32_t triangle = parts.Result.ToolTriangle[corner / 3];
      if (triangle >= 0)
      {
        this->Offer(mesh.Triangles[corner], triangle);
      }
    }
    for (sb::InterpolatedPoint& place : this->Places)
    {
      place.Weights = Bounded(place.Weights);
    }
  }

  /** Points of the cloud get its values, the seam's included. */
  std::vector<sb::InterpolatedPoint> CloudFirst() const
  {
    std::vector<sb::InterpolatedPoint> places = this->Places;
    const std::vector<std::int32_t>& nearest = this->Parts.Result.NearestSample;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      if (this->Parts.Result.Sides[i] & 1)
      {
        const std::int32_t sample = nearest.empty() ? 0 : std::max(0, nearest[i]);
        places[i].Operand = OfCloud;
        places[i].PointIds = { sample, sample, sample };
        places[i].Weights = { 1.0, 0.0, 0.0 };
      }
    }
    return places;
  }

  /** Points of the tool get its values, the seam's included. */
  const std::vector<sb::InterpolatedPoint>& ToolFirst() const { return this->Places; }

private:
  /** A triangle of the tool that a point may be on: of several, it is on that which it is farthest
   * inside of. */
  void Offer(std::int32_t point, std::int32_t triangle)
  {
    const sb::DesignedSurface& tool = this->Parts.Tool.Surface();
    std::array<std::int32_t, 3> ids{};
    sb::Real3 corners[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      ids[k] = tool.Triangles[3 * static_cast<std::size_t>(triangle) + k];
      std::copy_n(tool.Points.data() + 3 * static_cast<std::size_t>(ids[k]), 3, corners[k].begin());
    }
    sb::InterpolatedPoint& place = this->Places[static_cast<std::size_t>(point)];
    if (place.Operand == OfTool && place.PointIds == ids)
    {
      return;
    }
    const std::array<double, 3> weights =
      WeightsAt(this->Parts.Result.Mesh.Point(point), corners[0], corners[1], corners[2]);
    if (place.Operand != OfTool || LeastOf(weights) > LeastOf(place.Weights))
    {
      place.Operand = OfTool;
      place.PointIds = ids;
      place.Weights = weights;
    }
  }

  const CloudBooleanParts& Parts;
  std::vector<sb::InterpolatedPoint> Places; ///< on the tool; of the cloud where it is not
};

/** Those of the arrays that the other attributes have, or have not. */
void SelectArrays(
  vtkDataSetAttributes* from, vtkDataSetAttributes* other, bool wanted, vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* const array = from->GetAbstractArray(i);
    const bool has = array->GetName() && other->HasArray(array->GetName());
    if (has == wanted)
    {
      to->AddArray(array);
    }
  }
}

void CarryPoints(const AttributeUnion& arrays, const std::vector<sb::InterpolatedPoint>& places,
  vtkPolyData* surface, sb::Executor& executor)
{
  TupleSources from;
  from.NumberOfTuples = static_cast<std::int64_t>(places.size());
  from.Interpolated = &places;
  arrays.CopyTo(surface->GetPointData(), from, executor);
}

} // namespace

void CarryCloudArrays(const CloudInput& input, const std::vector<std::int32_t>& ids,
  vtkDataSetAttributes* target, sb::Executor& executor)
{
  vtkNew<vtkPointData> nothing;
  const AttributeUnion arrays(
    { { input.Data()->GetPointData(), input.NumberOfPoints(), "Input" }, { nothing, 0, "Tool" } },
    "point");
  TupleSources from;
  from.NumberOfTuples = static_cast<std::int64_t>(ids.size());
  from.Runs = RunsOf(ids, OfCloud);
  for (CopyRun& run : from.Runs)
  {
    run.PointIds = ids.data() + run.First;
  }
  arrays.CopyTo(target, from, executor);
}

std::vector<std::string> CarrySurfaceArrays(const CloudBooleanParts& parts,
  const std::vector<vtkIdType>& cells, vtkPolyData* surface, sb::Executor& executor)
{
  vtkPolyData* const tool = parts.Tool.Data();
  vtkPointData* const ofCloud = parts.Input.Data()->GetPointData();
  const vtkIdType samples = static_cast<vtkIdType>(parts.Input.NumberOfPoints());
  vtkNew<vtkPointData> nothing;
  vtkNew<vtkPointData> common;
  vtkNew<vtkPointData> own;
  SelectArrays(tool->GetPointData(), ofCloud, true, common);
  SelectArrays(tool->GetPointData(), ofCloud, false, own);
  const AttributeUnion ofBoth(
    { { ofCloud, samples, "Input" }, { common, tool->GetNumberOfPoints(), "Tool" } }, "point");
  // That the cloud has none keeps what a renderer needs everywhere from being chosen (SetActive).
  const AttributeUnion ofTool(
    { { nothing, samples, "Input" }, { own, tool->GetNumberOfPoints(), "Tool" } }, "point");
  const AttributeUnion ofCells(
    { { nothing, 0, "Input" }, { tool->GetCellData(), tool->GetNumberOfCells(), "Tool" } }, "cell");
  if (!ofBoth.IsEmpty() || !ofTool.IsEmpty())
  {
    const PointSources sources(parts);
    CarryPoints(ofTool, sources.ToolFirst(), surface, executor);
    CarryPoints(ofBoth, sources.CloudFirst(), surface, executor); // whose scalars are shown
  }
  TupleSources from;
  from.NumberOfTuples = static_cast<std::int64_t>(cells.size());
  from.Runs = RunsOf(cells, OfTool);
  for (CopyRun& run : from.Runs)
  {
    run.CellIds = cells.data() + run.First;
  }
  ofCells.CopyTo(surface->GetCellData(), from, executor);
  std::vector<std::string> sentences = ofBoth.Warnings();
  for (const AttributeUnion* arrays : { &ofTool, &ofCells })
  {
    sentences.insert(sentences.end(), arrays->Warnings().begin(), arrays->Warnings().end());
  }
  return sentences;
}

} // namespace sbvtk

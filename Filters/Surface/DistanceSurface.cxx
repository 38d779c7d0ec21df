// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DistanceSurface.h"

#include "CellLists.h"
#include "ConditionSentences.h"
#include "Ingest.h"

#include <cmath>

namespace sbvtk
{
namespace
{

DistanceSurface::Remark Error(sb::Status status, const std::string& name)
{
  sb::Remark remark;
  remark.Condition = status;
  return { static_cast<int>(status), ConditionSentence(remark, name, -1), true };
}

DistanceSurface::Remark Empty(const std::string& name)
{
  return { DistanceSurface::EMPTY_SURFACE,
    name +
      " has no polygon and no strip, so nothing has a distance to it; look at the filter "
      "before it.",
    true };
}

} // namespace

DistanceSurface::Remark DistanceSurface::Prepare(
  vtkPolyData* surface, const std::string& name, sb::Executor& executor)
{
  if (this->Prepared && this->Converted && this->Converted->IsConversionOf(surface))
  {
    return this->Remarked;
  }
  this->Prepared.reset();
  this->Converted.reset();
  const std::string damage = DamageOfCells(surface, executor);
  if (!damage.empty())
  {
    return { static_cast<int>(sb::Status::BadIndex), name + " " + damage, true };
  }
  if (!OperandSurface::FitsInt32(surface))
  {
    return Error(sb::Status::TooLarge, name);
  }
  this->Converted = std::make_shared<OperandSurface>(surface, executor);
  const Remark remark = this->Examine(name, executor);
  if (!remark.IsError)
  {
    const sb::Examination& known = *this->Converted->Examination(executor);
    this->Prepared.reset(new sb::SurfaceDistance(
      this->Converted->Mesh(), known.Report.Closed, known.IsInsideOut, executor));
  }
  this->Remarked = remark;
  return remark;
}

/** What the kernel found, as it matters to a distance. */
DistanceSurface::Remark DistanceSurface::Examine(
  const std::string& name, sb::Executor& executor) const
{
  if (this->Converted->Mesh().NumberOfTriangles == 0)
  {
    return Empty(name);
  }
  const sb::Examination& known = *this->Converted->Examination(executor);
  for (const sb::Remark& remark : known.Remarks)
  {
    const std::int64_t cell =
      remark.Triangle >= 0 ? this->Converted->CellOfTriangle(remark.Triangle) : -1;
    const std::string where = cell >= 0 ? " at cell " + std::to_string(cell) : "";
    switch (remark.Condition)
    {
      case sb::Status::BadCoordinate:
      case sb::Status::BadIndex:
        return { static_cast<int>(remark.Condition), ConditionSentence(remark, name, cell), true };
      case sb::Status::InconsistentOrientation:
        return { SIGNS_CONTRADICT,
          name + " has neighbouring polygons that are oriented against each other" + where +
            ", so signs contradict each other there; set Sign Method to Winding Number, or apply "
            "Generate Surface Normals with Consistency on to it.",
          false };
      case sb::Status::OpenOperand:
        return { static_cast<int>(remark.Condition),
          name + " is not closed" + where +
            ", so signs tell on which side of its nearest polygon a point lies; set Sign Method to "
            "Winding Number if it should enclose a volume, or switch Signed Distance off.",
          false };
      case sb::Status::InsideOut:
        return { static_cast<int>(remark.Condition),
          name +
            " has its normals inwards, so distances are negative outside of it; switch Negate "
            "Distance on, or apply Reverse Sense to it.",
          false };
      default:
        break;
    }
  }
  return {};
}

DistanceSurface::Remark DistanceSurface::PreparePoints(
  std::vector<double> points, const std::string& name, sb::Executor& executor)
{
  this->Prepared.reset();
  this->Converted.reset();
  this->Points.swap(points);
  this->PointTriangles.clear();
  const std::int64_t count = static_cast<std::int64_t>(this->Points.size() / 3);
  if (count > std::numeric_limits<std::int32_t>::max())
  {
    return Error(sb::Status::TooLarge, name);
  }
  for (std::int32_t i = 0; i < count; ++i)
  {
    const double* point = this->Points.data() + 3 * std::int64_t(i);
    if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
    {
      this->PointTriangles.insert(this->PointTriangles.end(), 3, i);
    }
  }
  sb::Surface cloud;
  cloud.Points = this->Points.data();
  cloud.NumberOfPoints = count;
  cloud.Triangles = this->PointTriangles.data();
  cloud.NumberOfTriangles = static_cast<std::int64_t>(this->PointTriangles.size() / 3);
  if (cloud.NumberOfTriangles == 0)
  {
    return { EMPTY_SURFACE,
      name +
        " has no point with finite coordinates, so nothing has a distance to it; look at the "
        "filter before it.",
      true };
  }
  this->Prepared.reset(new sb::SurfaceDistance(cloud, false, false, executor));
  return {};
}

std::int64_t DistanceSurface::CellOfTriangle(std::int32_t triangle) const
{
  return this->Converted ? this->Converted->CellOfTriangle(triangle)
                         : this->PointTriangles[3 * static_cast<std::size_t>(triangle)];
}

} // namespace sbvtk

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DistanceSurface.h
 * @brief A vtkPolyData, or a cloud of points, made ready to be asked for distances; kept until its
 * geometry changes.
 */
#ifndef DistanceSurface_h
#define DistanceSurface_h

#include "OperandSurface.h"
#include "SurfaceDistance.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace sbvtk
{

class DistanceSurface
{
public:
  /** Why a surface cannot serve, or with which reservation; Status is sb::Status or the filter's
   * own. */
  struct Remark
  {
    int Status = 0;
    std::string Sentence; ///< empty if there is nothing to remark
    bool IsError = false;
  };

  /** Beside the numbers of sb::Status. */
  enum StatusType
  {
    NOT_A_SURFACE = 20, ///< error: an input of another kind
    OUT_OF_MEMORY = 22, ///< error: the result does not fit into memory
    EMPTY_SURFACE = 30, ///< error: nothing to be near to
    POINTS_NOT_FINITE = 31, ///< warning: some points have no distance
    SIGNS_CONTRADICT = 32 ///< warning: neighbouring polygons are oriented against each other
  };

  /** Prepare the polygons and strips; nothing is done if they are those of the last time. */
  Remark Prepare(vtkPolyData* surface, const std::string& name, sb::Executor& executor);

  /** Prepare points, each as a triangle without area; those that are not finite are left out. */
  Remark PreparePoints(std::vector<double> points, const std::string& name, sb::Executor& executor);

  /** Only after a Prepare without an error. */
  const sb::SurfaceDistance& Distances() const { return *this->Prepared; }

  /** Whether a sign has a meaning: it has none for points. */
  bool HasSides() const { return this->Converted != nullptr; }

  /** The cell of the data set that a triangle belongs to; for points, the point. */
  std::int64_t CellOfTriangle(std::int32_t triangle) const;

private:
  Remark Examine(const std::string& name, sb::Executor& executor) const;

  std::shared_ptr<OperandSurface> Converted;
  std::vector<double> Points;
  std::vector<std::int32_t> PointTriangles;
  std::unique_ptr<sb::SurfaceDistance> Prepared;
  Remark Remarked;
};

} // namespace sbvtk

#endif

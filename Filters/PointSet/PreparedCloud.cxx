// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PreparedCloud.h"

#include <utility>

namespace sbvtk
{

void PreparedCloud::Prepare(const Settings& settings, sb::Executor& executor, sb::Monitor& monitor)
{
  if (!this->Stamp.empty() && this->Stamp == this->Points.GeometryStamp() && this->Used == settings)
  {
    return;
  }
  // Gone before their successors are made, so that both never need memory together.
  this->Stamp.clear();
  this->Made = {};
  this->KeptMesh.reset();
  sb::CloudRequest request;
  request.Points = this->Points.Points();
  request.Normals = this->Points.Normals();
  request.Count = this->Points.NumberOfPoints();
  request.Definition = static_cast<sb::SurfaceDefinition>(settings.Definition);
  request.Width = settings.Width;
  request.Flip = settings.FlipNormals;
  this->Made = sb::MakeCloudSurface(request, executor, monitor);
  if (this->Made.Status != sb::CloudStatus::Aborted)
  {
    this->Stamp = this->Points.GeometryStamp();
    this->Used = settings;
  }
}

void PreparedCloud::KeepMesh(double cell, std::shared_ptr<const sb::PointSurfaceMesh> mesh)
{
  this->MeshCell = cell;
  this->KeptMesh = std::move(mesh);
}

} // namespace sbvtk

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PreparedCloud.h
 * @brief The cloud of a filter with its surface, kept from one update to the next: it is made again
 * only when the points, their normals or the settings have changed, and not when a tool moves or
 * the points get other arrays.
 */
#ifndef PreparedCloud_h
#define PreparedCloud_h

#include "CloudInput.h"
#include "CloudSurface.h"
#include "PointSurfaceMesh.h"

#include <memory>
#include <string>
#include <vector>

namespace sbvtk
{

class PreparedCloud
{
public:
  struct Settings
  {
    int Definition = 0;
    double Width = 0.0;
    bool FlipNormals = false;

    bool operator==(const Settings& other) const
    {
      return this->Definition == other.Definition && this->Width == other.Width &&
        this->FlipNormals == other.FlipNormals;
    }
  };

  /** As CloudInput::Read. */
  std::string Read(vtkDataObject* data) { return this->Points.Read(data); }

  /** Make the surface of what was read. */
  void Prepare(const Settings& settings, sb::Executor& executor, sb::Monitor& monitor);

  const CloudInput& Input() const { return this->Points; }
  const sb::CloudSurface& Surface() const { return this->Made; }

  /** Its mesh with such cells, if KeepMesh was given it, else null. */
  std::shared_ptr<const sb::PointSurfaceMesh> Mesh(double cell) const
  {
    return this->MeshCell == cell ? this->KeptMesh : nullptr;
  }
  void KeepMesh(double cell, std::shared_ptr<const sb::PointSurfaceMesh> mesh);

private:
  CloudInput Points;
  std::vector<vtkMTimeType> Stamp; ///< of what Made was made of
  Settings Used;
  sb::CloudSurface Made;
  double MeshCell = 0.0;
  std::shared_ptr<const sb::PointSurfaceMesh> KeptMesh;
};

} // namespace sbvtk

#endif

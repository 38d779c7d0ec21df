// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file DesignedInput.h
 * @brief What a connection delivers, as the surface of a designed body: facets, and the exact
 * patches behind them where the data set carries these (NURBSArrays.h) and they fit.
 *
 * Filters move points and leave field data alone, so the patches may still be where the file had
 * them while the facets are elsewhere. Facets that have been moved, turned, scaled or mirrored take
 * their patches with them: the map is found again from the points' parameters. Of facets that have
 * been bent nothing exact is known; they are used as they are, and Warning() says so.
 */
#ifndef DesignedInput_h
#define DesignedInput_h

#include "DesignedSurface.h"
#include "Executor.h"
#include "SurfaceInput.h"
#include "sbPointSetModule.h" // for the export macro

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace sbvtk
{

class OperandSurface;

class SBPOINTSET_EXPORT DesignedInput
{
public:
  /** What becomes of facets without a patch in a data set that has patches, such as those of a mesh
   * which a designed body has been united with. */
  enum class Patchless
  {
    UseFacetsOnly, ///< a surface has patches everywhere or nowhere
    Keep ///< their FaceId is -1
  };

  DesignedInput();
  ~DesignedInput();
  DesignedInput(const DesignedInput&) = delete;
  void operator=(const DesignedInput&) = delete;

  /**
   * Read a surface; composite data are merged into one, with the patches of all. A closed surface
   * that is inside out, as after mirroring, is turned over: its triangles are counter-clockwise
   * seen from outside. An open one is taken as it is. Data that have not changed are not read
   * again.
   * @return empty, or the end of the sentence "Tool ..." that says why it cannot be used.
   */
  std::string Read(
    vtkDataObject* data, sb::Executor& executor, Patchless patchless = Patchless::UseFacetsOnly);

  const sb::DesignedSurface& Surface() const { return this->Designed; }

  /** The end of the sentence "Tool ..." that says why exact patches are there and not used, or
   * empty. */
  const std::string& Warning() const { return this->Remark; }

  bool IsOpen() const { return this->Open; }
  bool WasInsideOut() const { return this->InsideOut; }

  /** Names of the blocks that the surface is made of; Data() has the cell array BlockId then. */
  const BlockNames& Names() const { return this->Facets.Names(); }

  /** The surface with its attributes; merged, if the data were composite. */
  vtkPolyData* Data() const;

  /** The cell of Data() that a triangle was cut from. */
  std::int32_t CellOfTriangle(std::int64_t triangle) const;

private:
  std::string ReadExactSurfaces(vtkDataObject* data, sb::Executor& executor, Patchless patchless);
  std::string ReadFacets(sb::Executor& executor);
  void ReadPlaces(
    const std::vector<std::int32_t>& leafOfPatch, sb::Executor& executor, Patchless patchless);
  void TurnPatches();

  std::vector<vtkMTimeType> Stamp;
  std::string Refusal;
  SurfaceInput Facets;
  std::unique_ptr<OperandSurface> Triangulated;
  sb::DesignedSurface Designed;
  std::string Remark;
  bool Open = false;
  bool InsideOut = false;
};

} // namespace sbvtk

#endif

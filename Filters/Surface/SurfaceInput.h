// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SurfaceInput.h
 * @brief What one pipeline connection delivers: a surface, or the reason why it is none.
 */
#ifndef SurfaceInput_h
#define SurfaceInput_h

#include "BlockNames.h"
#include "Executor.h"
#include "sbSurfaceModule.h" // for the export macro

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataObject;

namespace sbvtk
{

/** The surface of one connection, kept from one update to the next so that merging is done again
 * only when needed. */
class SBSURFACE_EXPORT SurfaceInput
{
public:
  /**
   * Read what the connection delivers now. The surfaces of a composite data set are merged into
   * one: their points and cells are put after one another, their arrays are united by name, and
   * the cell array BlockId says which block each cell is of, counted from `firstBlock` on.
   * @return empty, or the end of the sentence "Input ..." that says what else it is.
   */
  std::string Read(vtkDataObject* data, sb::Executor& executor, int firstBlock = 0);

  vtkPolyData* Surface() const { return this->Current; }

  /** Names of the blocks that the surface is made of. */
  const BlockNames& Names() const { return this->NamesOfBlocks; }

private:
  void ReadSurface(vtkPolyData* surface, int firstBlock);

  vtkSmartPointer<vtkPolyData> Current;
  BlockNames NamesOfBlocks;
  int FirstBlock = 0;
  std::vector<vtkMTimeType> LeafTimes; ///< of what was merged
};

} // namespace sbvtk

#endif

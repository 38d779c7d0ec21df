// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file BlockNames.h
 * @brief The blocks of composite data by their names, which an array keeps when they are merged.
 *
 * Merged data carry the array BlockId: of each cell (of each point of a cloud) the number of its
 * block, which is a place in the field array BlockNames; -1 is of none. Numbers can be coloured by,
 * texts cannot. Several inputs count their blocks on from each other, and data that carry both
 * arrays already count as blocks, too, so that names live through one filter after another.
 */
#ifndef BlockNames_h
#define BlockNames_h

#include "sbSurfaceModule.h" // for the export macro

#include "vtkIntArray.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSetAttributes;

namespace sbvtk
{

constexpr const char* BlockArray = "BlockId";
constexpr const char* BlockNamesArray = "BlockNames";

using BlockNames = std::vector<std::string>;

/** The data of composite data, and which block each of them is of. */
struct Blocks
{
  /** In the order of the tree, empty blocks too, so that a number means the same block at all
   * times; nested names are joined by a slash. */
  BlockNames Names;
  std::vector<vtkDataObject*> Leaves; ///< those that are not null
  std::vector<int> BlockOfLeaf; ///< -1 for a part of what is not divided into blocks
};

/** What is not composite is one leaf of no block; so are the parts of a partitioned data set. */
SBSURFACE_EXPORT Blocks BlocksOf(vtkDataObject* data);

/** The names of blocks that were merged before: empty unless there is BlockId in those attributes.
 */
SBSURFACE_EXPORT BlockNames CarriedBlockNames(
  vtkDataObject* data, vtkDataSetAttributes* attributes);

/** BlockId, counted on from `firstBlock`. */
SBSURFACE_EXPORT vtkSmartPointer<vtkIntArray> NumbersFrom(
  int firstBlock, vtkDataSetAttributes* attributes);

/** The field array BlockNames; none without names, as ParaView shows no field data if one array is
 * empty. */
SBSURFACE_EXPORT void AddBlockNames(vtkDataObject* output, const BlockNames& names);

} // namespace sbvtk

#endif

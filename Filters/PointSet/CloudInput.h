// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file CloudInput.h
 * @brief The points of a data set, and their normals if it has any, as arrays of doubles.
 */
#ifndef CloudInput_h
#define CloudInput_h

#include "BlockNames.h"

#include "vtkDoubleArray.h"
#include "vtkPointSet.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;

namespace sbvtk
{

class CloudInput
{
public:
  /**
   * Read what a connection delivers. Composite data are joined: their points are put after one
   * another; point arrays that all blocks have are kept, and BlockId says which block each point is
   * of.
   * @return empty, or the end of the sentence "Input ..." that says what else it is.
   */
  std::string Read(vtkDataObject* data);

  /** The points, and point data with as many tuples. */
  vtkPointSet* Data() const { return this->Cloud; }

  /** Names of the blocks that the cloud is made of. */
  const BlockNames& Names() const { return this->NamesOfBlocks; }

  std::int64_t NumberOfPoints() const { return this->Cloud ? this->Cloud->GetNumberOfPoints() : 0; }
  const double* Points() const;

  /** Three doubles a point, or null if the cloud has none. */
  const double* Normals() const;

  /** Changes with the points and the normals, and with nothing else. */
  const std::vector<vtkMTimeType>& GeometryStamp() const { return this->Stamp; }

  /** A sentence on an array of normals that could not be used, or empty. */
  const std::string& Warning() const { return this->Remark; }

private:
  std::string ReadBlocks(vtkDataObject* data);
  void ReadNormals();
  void AddToStamp(vtkPointSet* block);

  vtkSmartPointer<vtkPointSet> Cloud;
  vtkSmartPointer<vtkDoubleArray> PointArray;
  vtkSmartPointer<vtkDoubleArray> NormalArray;
  BlockNames NamesOfBlocks;
  std::vector<vtkMTimeType> Stamp;
  std::string Remark;
};

} // namespace sbvtk

#endif

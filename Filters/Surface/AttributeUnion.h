// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file AttributeUnion.h
 * @brief Carries the point or cell arrays of all operands to the output: the union of their names.
 *
 * Arrays of one name are one array of the output. Where their number types differ, it has a type
 * that holds both; where their numbers of components differ, the first operand that has the name
 * keeps it. An operand without the array gives NaN in floating-point arrays, 0 in integer arrays
 * (-1 in FaceId, SolidId and BlockId: of none), an empty text in text arrays.
 */
#ifndef AttributeUnion_h
#define AttributeUnion_h

#include "Boolean.h"
#include "CopyRun.h"
#include "sbSurfaceModule.h" // for the export macro

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataSetAttributes;

namespace sbvtk
{

/** Where the tuples of an output come from. */
struct TupleSources
{
  std::int64_t NumberOfTuples = 0;
  std::vector<CopyRun> Runs;
  /** The output tuples from FirstInterpolated on, one for each of these points. */
  const std::vector<sb::InterpolatedPoint>* Interpolated = nullptr;
  std::int64_t FirstInterpolated = 0;
  /** The last tuples of the output: each is a second instance of the output tuple named. */
  std::vector<std::int32_t> Repeated;
};

class SBSURFACE_EXPORT AttributeUnion
{
public:
  /** One operand's arrays. */
  struct Source
  {
    vtkDataSetAttributes* Attributes = nullptr;
    std::int64_t NumberOfTuples = 0;
    std::string Name; ///< for sentences, such as "Input 2"
  };

  /** @param kind "point" or "cell", for sentences. */
  AttributeUnion(const std::vector<Source>& sources, const std::string& kind);

  bool IsEmpty() const { return this->Columns.empty(); }

  /** One sentence for each array that could not be carried wholly. */
  const std::vector<std::string>& Warnings() const { return this->Sentences; }

  /** Make the output's arrays. */
  void CopyTo(vtkDataSetAttributes* target, const TupleSources& from, sb::Executor& executor) const;

  /** Whether an operand has active normals that are carried. */
  bool HasNormals() const;

  /**
   * Turn the active normals of reversed tuples over.
   * @param operands the operand of each output tuple
   * @param reversed 1 for each tuple to be turned over
   */
  void NegateNormals(vtkDataSetAttributes* target, const std::vector<std::int32_t>& operands,
    const std::vector<std::uint8_t>& reversed) const;

private:
  /** One array of the output, and what each source has for it: null, or an array of the output's
   * type. */
  struct Column
  {
    std::string Name;
    std::vector<vtkSmartPointer<vtkAbstractArray>> Arrays;
    vtkAbstractArray* First = nullptr;
    bool TakeNearest = false; ///< ids, which an average would make meaningless
  };

  void Add(std::size_t source, vtkAbstractArray* array, const std::string& name);
  void Unify(Column& column);
  vtkSmartPointer<vtkAbstractArray> Carry(
    const Column& column, const TupleSources& from, sb::Executor& executor) const;
  void SetActive(vtkDataSetAttributes* target) const;
  std::string ActiveName(std::size_t source, int role) const;

  std::vector<Source> Sources;
  std::string Kind;
  std::vector<Column> Columns;
  std::vector<std::string> Sentences;
};

} // namespace sbvtk

#endif

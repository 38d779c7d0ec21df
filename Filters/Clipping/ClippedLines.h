// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ClippedLines.h
 * @brief The polylines of a clip: the outlines of its planes, joined end to end, and the input's
 * own lines.
 */
#ifndef ClippedLines_h
#define ClippedLines_h

#include "Clip.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace sbvtk
{

struct ClippedLines
{
  std::vector<std::int32_t> Connectivity; ///< point ids of the result
  std::vector<std::int64_t> Offsets{ 0 };
  std::vector<std::int32_t> Sources; ///< by line: 0 for an input line, else plane + 1
  std::vector<vtkIdType> Cells; ///< by line: the input line, or -1

  std::int64_t NumberOfLines() const { return static_cast<std::int64_t>(this->Sources.size()); }

  void Add(const std::vector<std::int32_t>& points, std::int32_t source, vtkIdType cell)
  {
    this->Connectivity.insert(this->Connectivity.end(), points.begin(), points.end());
    this->Offsets.push_back(static_cast<std::int64_t>(this->Connectivity.size()));
    this->Sources.push_back(source);
    this->Cells.push_back(cell);
  }
};

/** Join the segments of each plane; a closed line ends where it starts. */
void AddOutline(const std::vector<sb::OutlineSegment>& outline, ClippedLines& lines);

/**
 * Append the parts of the input's lines that lie in front of all planes (those that do not, if the
 * request is inside out); their points are appended to the result's created ones.
 */
void AddInputLines(
  vtkPolyData* input, const sb::ClipRequest& request, sb::ClipResult& result, ClippedLines& lines);

} // namespace sbvtk

#endif

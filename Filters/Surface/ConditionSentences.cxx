// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ConditionSentences.h"

namespace sbvtk
{
namespace
{

/** " at point 7", " at cell 3", or nothing where the place is not known. */
std::string Place(const sb::Remark& remark, std::int64_t cell)
{
  if (remark.Point >= 0)
  {
    return " at point " + std::to_string(remark.Point);
  }
  return cell >= 0 ? " at cell " + std::to_string(cell) : "";
}

/** " (12 places)" where there are several. */
std::string Several(const sb::Remark& remark)
{
  return remark.Count > 1 ? " (" + std::to_string(remark.Count) + " places)" : "";
}

} // namespace

std::string ConditionSentence(
  const sb::Remark& remark, const std::string& operandName, std::int64_t cell)
{
  const std::string where = Place(remark, cell) + Several(remark);
  switch (remark.Condition)
  {
    case sb::Status::Ok:
      return "The result is complete.";
    case sb::Status::EmptyOperand:
      return operandName +
        " has no polygon and no strip, so it counts as the empty set; if that is not meant, look "
        "at "
        "the filter before it.";
    case sb::Status::OpenOperand:
      return operandName + " is not closed" + where +
        ", so it separates as a sheet: its back is the inside; fill its holes if it should enclose "
        "a volume.";
    case sb::Status::NonSeparatingSheet:
      return operandName + " is an open sheet that does not cut the other surfaces through" +
        where + ", so it has no inside there; make it larger, or close it.";
    case sb::Status::InsideOut:
      return operandName + " has its normals inwards (its volume is negative)" + where +
        ", so it was turned over; apply Reverse Sense or Generate Surface Normals to it to silence "
        "this.";
    case sb::Status::InconsistentOrientation:
      return operandName + " has neighbouring polygons that are oriented against each other" +
        where + "; apply Generate Surface Normals with Consistency on to it first.";
    case sb::Status::BadCoordinate:
      return operandName + " has a coordinate that is not a finite number" + where +
        "; remove or repair that point first.";
    case sb::Status::BadIndex:
      return operandName + " has a polygon that names a point which does not exist" + where +
        "; repair the file or the filter that made it.";
    case sb::Status::TooLarge:
      return operandName +
        " has more points, cells or triangles than this filter can count (2147483647); decimate it "
        "or cut it into parts first.";
    case sb::Status::Aborted:
      return "The filter was stopped before it was done, so its outputs are empty; apply it again "
             "for a result.";
    case sb::Status::BadRequest:
      return "The filter's settings cannot be used; set Tolerance to 0 or a small positive length.";
  }
  return "";
}

} // namespace sbvtk

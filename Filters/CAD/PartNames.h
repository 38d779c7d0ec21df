// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PartNames.h
 * @brief The names and colours that a STEP file gives its parts and faces.
 *
 * They are read from the file's own entities, next to the shapes that were made of them: products
 * have names, and styled items colours. Open CASCADE's document of such things (XCAF) would need
 * its libraries for windows, too.
 */
#ifndef PartNames_h
#define PartNames_h

#include <NCollection_DataMap.hxx>
#include <STEPControl_Reader.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sbvtk
{

struct FaceStyle
{
  std::int32_t Part = -1; ///< of the names; -1 if it is in no product
  bool HasColor = false;
  std::array<std::uint8_t, 3> Color{}; ///< red, green, blue
};

/** One part for each use of a product that has faces of its own. */
struct PartNames
{
  std::vector<std::string> Names;
  NCollection_DataMap<TopoDS_Shape, FaceStyle, TopTools_ShapeMapHasher> StyleOfFace;

  FaceStyle Of(const TopoDS_Shape& face) const
  {
    const FaceStyle* const found = this->StyleOfFace.Seek(face);
    return found ? *found : FaceStyle();
  }
};

/** @param shape what the reader has made of the file */
PartNames FindPartNames(const STEPControl_Reader& reader, const TopoDS_Shape& shape);

} // namespace sbvtk

#endif

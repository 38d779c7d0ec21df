// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ArrayMemory.h
 * @brief Memory for VTK's arrays, which may be refused.
 *
 * A vtkDataArray that gets no memory throws std::bad_alloc only where VTK was built for release.
 * The packaged one ends the program, so what may be large is asked for here.
 */
#ifndef ArrayMemory_h
#define ArrayMemory_h

#include "sbSurfaceModule.h" // for the export macro

#include "vtkType.h"

class vtkAbstractArray;
class vtkDataArray;
class vtkPoints;

namespace sbvtk
{

/** Give the array room for that many tuples, whose values are then anything; its number of
 * components has to be set before. @throw std::bad_alloc */
SBSURFACE_EXPORT void SetTuples(vtkAbstractArray* array, vtkIdType count);

/** The same for points; their number type has to be set before. @throw std::bad_alloc */
SBSURFACE_EXPORT void SetTuples(vtkPoints* points, vtkIdType count);

/** Make `copy` a copy of `original`, in its own number type. @throw std::bad_alloc */
SBSURFACE_EXPORT void CopyTuples(vtkDataArray* original, vtkDataArray* copy);

/** The same for points, in the number type of the original ones. @throw std::bad_alloc */
SBSURFACE_EXPORT void CopyTuples(vtkPoints* original, vtkPoints* copy);

} // namespace sbvtk

#endif

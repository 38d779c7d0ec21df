// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file PreparedInput.h
 * @brief The input of a filter as triangles, kept from one update to the next.
 */
#ifndef PreparedInput_h
#define PreparedInput_h

#include "Boolean.h"
#include "OperandSurface.h"
#include "SurfaceConnections.h"
#include "SurfaceInput.h"

#include <memory>
#include <string>

class vtkInformationVector;

namespace sbvtk
{

using Failure = FilterFailure;

class PreparedInput
{
public:
  /** Prepare what the connection delivers, its points moved by at most the tolerance, unless it is
   * what was prepared before. Throws Failure. */
  void Read(
    vtkInformationVector* connections, int notASurface, double tolerance, sb::Executor& executor);

  OperandSurface& Surface() const { return *this->Triangles; }

  const BlockNames& Names() const { return this->Connection.Names(); }

  /** The failure that a kernel's remark amounts to. */
  Failure FailureOf(const sb::Remark& remark) const;

private:
  SurfaceInput Connection;
  std::shared_ptr<OperandSurface> Triangles;
};

} // namespace sbvtk

#endif

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PreparedInput.h"

#include "ConditionSentences.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"

namespace sbvtk
{

//------------------------------------------------------------------------------
void PreparedInput::Read(
  vtkInformationVector* connections, int notASurface, double tolerance, sb::Executor& executor)
{
  if (connections->GetNumberOfInformationObjects() == 0)
  {
    throw Failure{ static_cast<int>(sb::Status::BadRequest),
      "Input has no surface; set Input (in ParaView: right-click the filter in the Pipeline "
      "Browser, Change Input)." };
  }
  const std::string refusal =
    this->Connection.Read(vtkDataObject::GetData(connections, 0), executor);
  if (!refusal.empty())
  {
    throw Failure{ notASurface, "Input " + refusal };
  }
  vtkPolyData* surface = this->Connection.Surface();
  if (!OperandSurface::FitsInt32(surface))
  {
    sb::Remark remark;
    remark.Condition = sb::Status::TooLarge;
    throw this->FailureOf(remark);
  }
  if (this->Triangles && this->Triangles->IsConversionOf(surface, tolerance))
  {
    this->Triangles->SetAttributesFrom(surface);
    return;
  }
  this->Triangles.reset(); // before its successor is made, so that both never need memory together
  this->Triangles = std::make_shared<OperandSurface>(surface, executor, tolerance);
}

//------------------------------------------------------------------------------
Failure PreparedInput::FailureOf(const sb::Remark& remark) const
{
  const std::int64_t cell =
    this->Triangles && remark.Triangle >= 0 ? this->Triangles->CellOfTriangle(remark.Triangle) : -1;
  return { static_cast<int>(remark.Condition), ConditionSentence(remark, "Input", cell) };
}

} // namespace sbvtk

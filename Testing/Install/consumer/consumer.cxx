// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
// A program that uses the installed library: the volume of a cube with a cube taken out of its
// middle.

#include "vtkCubeSource.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataBooleanOperationFilter.h"

#include <iostream>

int main()
{
  vtkNew<vtkCubeSource> outer;
  vtkNew<vtkCubeSource> inner;
  outer->SetBounds(0, 2, 0, 2, 0, 2);
  inner->SetBounds(0.5, 1.5, 0.5, 1.5, 0.5, 1.5);
  vtkNew<vtkPolyDataBooleanOperationFilter> boolean;
  boolean->SetInputConnection(outer->GetOutputPort());
  boolean->SetInputConnection(1, inner->GetOutputPort());
  boolean->SetOperationToDifference();
  boolean->Update();
  std::cout << boolean->GetOutput()->GetFieldData()->GetArray("ResultVolume")->GetTuple1(0) << "\n";
}

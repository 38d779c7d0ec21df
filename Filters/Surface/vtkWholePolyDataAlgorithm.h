// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWholePolyDataAlgorithm
 * @brief   A filter that has to see all of its inputs at once, also where many processes share
 * them.
 *
 * On a parallel server the first process gathers the pieces of all processes (cells and points that
 * two of them have are taken once), computes, and has the whole result; the others have an empty
 * one with the same arrays and field data. The answer does not depend on the number of processes.
 * Pieces that have not changed are not sent again.
 *
 * The inputs and the result have to fit into the memory of the first process.
 */
#ifndef vtkWholePolyDataAlgorithm_h
#define vtkWholePolyDataAlgorithm_h

#include "sbSurfaceModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for std::unique_ptr

class vtkMultiProcessController;

namespace sbvtk
{
class RankGathering;
}

class SBSURFACE_EXPORT vtkWholePolyDataAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkWholePolyDataAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes that share the inputs; by default those of ParaView's server. All of them have to
   * update the filter. Null: the filter works for this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

protected:
  vtkWholePolyDataAlgorithm();
  ~vtkWholePolyDataAlgorithm() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) final;

  /** As RequestData, with whole inputs, in one process. */
  virtual void ComputeWhole(vtkInformationVector** inputs, vtkInformationVector* outputs) = 0;

private:
  vtkWholePolyDataAlgorithm(const vtkWholePolyDataAlgorithm&) = delete;
  void operator=(const vtkWholePolyDataAlgorithm&) = delete;

  void ComputeOnFirst(vtkInformationVector** inputs, vtkInformationVector* outputs);

  std::unique_ptr<sbvtk::RankGathering> Ranks;
};

#endif

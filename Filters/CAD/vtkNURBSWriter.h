// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkNURBSWriter
 * @brief   Writes exact surfaces, trimmed to the facets that are left of them, as a STEP file.
 *
 * The input is what vtkNURBSReader gives, or what a filter has left of it: facets with the arrays
 * `UV` and `FaceId`, and the field arrays of the patches. Each patch is trimmed where its facets
 * end; a face that was cut in two becomes two faces, and so does a sphere with holes. Faces whose
 * facets meet share an edge; what is closed becomes a solid, the rest open shells. Facets that have
 * been moved, turned, scaled or mirrored take their patches with them. Facets that are on no patch
 * (FaceId -1, or no UV) are left out, and a warning says how many. Coordinates are taken for
 * millimetres.
 *
 * Trimming curves go through the corners of the facets, as cubic splines; a file read with a
 * smaller ChordError is written more precisely.
 */
#ifndef vtkNURBSWriter_h
#define vtkNURBSWriter_h

#include "sbCADModule.h" // for the export macro
#include "vtkWriter.h"

#include <memory> // for std::unique_ptr
#include <string> // for sentences

class vtkMultiProcessController;

namespace sbvtk
{
class RankGathering;
}

class SBCAD_EXPORT vtkNURBSWriter : public vtkWriter
{
public:
  static vtkNURBSWriter* New();
  vtkTypeMacro(vtkNURBSWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** A file that ends in .step or .stp. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** What the last Write() has written. */
  vtkGetMacro(NumberOfFaces, int);
  vtkGetMacro(NumberOfSolids, int);
  vtkGetMacro(NumberOfOpenShells, int);
  ///@}

  ///@{
  /**
   * The processes that share the Input; by default those of ParaView's server. All of them have to
   * call Write(), and the first one writes what all of them have. Null: this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

protected:
  vtkNURBSWriter();
  ~vtkNURBSWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;

private:
  vtkNURBSWriter(const vtkNURBSWriter&) = delete;
  void operator=(const vtkNURBSWriter&) = delete;

  void WriteWhole(vtkDataObject* data);
  void Refuse(unsigned long error, const std::string& sentence);

  std::unique_ptr<sbvtk::RankGathering> Ranks;
  char* FileName = nullptr;
  int NumberOfFaces = 0;
  int NumberOfSolids = 0;
  int NumberOfOpenShells = 0;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNURBSReader.h"

#include "ArrayMemory.h"
#include "CADFile.h"
#include "CADSession.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "Ingest.h"
#include "KernelExecutor.h"
#include "NURBSArrays.h"
#include "ShapeFacets.h"
#include "Stopwatch.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkNURBSReader);

namespace
{

constexpr std::int64_t mostTriangles = 10000000;

} // namespace

/** One update: its steps in their order, and what they share. */
class vtkNURBSReader::Run
{
public:
  Run(vtkNURBSReader* reader, vtkPolyData* output)
    : Reader(reader)
    , Output(output)
  {
  }

  void Execute();

private:
  using Failure = sbvtk::FilterFailure;

  void CheckSettings() const;
  void ReadShape();
  void MakeFacets();
  void Examine();
  void FillOutput();
  void AddParts();
  void AddFields();
  void Warn(int status, const std::string& sentence);
  void Check(const sbvtk::CADOutcome& outcome) const;
  std::string File() const { return std::string("The file ") + this->Reader->FileName + " "; }

  vtkNURBSReader* Reader;
  vtkPolyData* Output;
  sbvtk::KernelExecutor Executor;
  sbvtk::Stopwatch Watch;
  std::vector<sb::StageTime> Times;
  TopoDS_Shape Shape;
  sbvtk::PartNames Parts;
  sbvtk::ShapeFacets Facets;
  sb::OperandReport Report;
  bool Closed = false;
  int Status = OK;
  std::string Message;
};

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::Execute()
{
  const auto steps = [this] {
    this->CheckSettings();
    this->ReadShape();
    this->MakeFacets();
    this->Examine();
    this->FillOutput();
    this->AddParts();
    this->AddFields();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Output->Initialize();
    sbvtk::AddField(this->Output, "Status", failure.Status);
    sbvtk::AddField(this->Output, "Message", failure.Sentence);
  };
  sbvtk::RunSteps(this->Reader, steps,
    { report, { ABORTED, "The reader was stopped." },
      { OUT_OF_MEMORY, "The facets do not fit into memory; choose a larger ChordError." } });
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::CheckSettings() const
{
  if (!this->Reader->FileName || !*this->Reader->FileName)
  {
    throw Failure{ BAD_REQUEST, "There is no file to read; set FileName." };
  }
  constexpr double least = 1e-7;
  constexpr double most = 0.1;
  if (!(this->Reader->ChordError >= least && this->Reader->ChordError <= most))
  {
    std::ostringstream sentence;
    sentence << "ChordError is " << this->Reader->ChordError << "; set it to a share from " << least
             << " to " << most << " of the diagonal of the box.";
    throw Failure{ BAD_REQUEST, sentence.str() };
  }
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::Check(const sbvtk::CADOutcome& outcome) const
{
  switch (outcome.Status)
  {
    case sbvtk::CADStatus::Ok:
      return;
    case sbvtk::CADStatus::Aborted:
      throw Failure{ ABORTED, "The reader was stopped." };
    case sbvtk::CADStatus::OutOfMemory:
      throw std::bad_alloc();
    case sbvtk::CADStatus::Failed:
      throw Failure{ NOT_READABLE,
        this->File() + "cannot be used, for Open CASCADE gave up on it (" + outcome.Reason +
          "); export it again, or as the other one of STEP and IGES." };
  }
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::ReadShape()
{
  sbvtk::KernelMonitor monitor(this->Reader, 0.0, 0.6);
  std::string refusal;
  this->Check(
    sbvtk::RunCAD(monitor, 0.0, 1.0, "Read file", [&](const Message_ProgressRange& progress) {
      refusal = sbvtk::ReadCADFile(this->Reader->FileName, this->Shape, this->Parts, progress);
    }));
  if (!refusal.empty())
  {
    throw Failure{ NOT_READABLE, this->File() + refusal };
  }
  this->Times.push_back({ "Read file", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::MakeFacets()
{
  if (!this->Shape.IsNull())
  {
    sbvtk::KernelMonitor monitor(this->Reader, 0.6, 0.95);
    this->Check(
      sbvtk::RunCAD(monitor, 0.0, 1.0, "Make facets", [&](const Message_ProgressRange& progress) {
        this->Facets = sbvtk::MakeShapeFacets(
          this->Shape, this->Reader->ChordError, mostTriangles, this->Executor, monitor, progress);
      }));
  }
  if (this->Facets.IsTooFine)
  {
    throw Failure{ TOO_MANY_FACETS,
      this->File() + "would take more than " + std::to_string(mostTriangles) +
        " facets; choose a larger ChordError." };
  }
  if (this->Facets.Surface.FaceId.empty())
  {
    throw Failure{ NO_FACES,
      this->File() +
        "has no faces that can be shown; export surfaces or solids to it, anew if it is damaged." };
  }
  this->Times.push_back({ "Make facets", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::Warn(int status, const std::string& sentence)
{
  this->Status = this->Message.empty() ? status : this->Status;
  this->Message += (this->Message.empty() ? "" : " ") + sentence;
  vtkWarningWithObjectMacro(this->Reader, << sentence);
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::Examine()
{
  const sb::DesignedSurface& surface = this->Facets.Surface;
  sb::Surface mesh;
  mesh.Points = surface.Points.data();
  mesh.NumberOfPoints = static_cast<std::int64_t>(surface.Points.size() / 3);
  mesh.Triangles = surface.Triangles.data();
  mesh.NumberOfTriangles = static_cast<std::int64_t>(surface.FaceId.size());
  const auto examination = sb::Examine(mesh, this->Executor, sb::OpenSurfaces::Accept);
  this->Report = examination->Report;
  this->Closed = !examination->IsOpen;
  if (this->Facets.NumberOfBareFaces > 0)
  {
    this->Warn(INCOMPLETE,
      std::to_string(this->Facets.NumberOfBareFaces) + " of the faces of the file " +
        this->Reader->FileName +
        " could not be cut into triangles and are left out; repair them in the program that made "
        "it.");
  }
  if (!this->Closed)
  {
    this->Warn(OPEN,
      this->File() +
        "is an open surface and encloses no volume; if it should be a solid, export it as one.");
  }
  const double bound = this->Reader->ChordError * this->Facets.Diagonal;
  if (this->Facets.LargestChordError > bound || this->Facets.NumberOfApproximations > 0)
  {
    std::ostringstream sentence;
    sentence << this->File() << "has facets up to " << this->Facets.LargestChordError
             << " off their face (asked for: " << bound << ") and "
             << this->Facets.NumberOfApproximations
             << " offset faces that could only be approximated; the field data have the figures.";
    this->Warn(APPROXIMATED, sentence.str());
  }
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::FillOutput()
{
  const sb::DesignedSurface& surface = this->Facets.Surface;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(sbvtk::ArrayOf<vtkDoubleArray>("Points", 3, surface.Points));
  std::vector<int> offsets(surface.FaceId.size() + 1);
  std::vector<int> solids(surface.FaceId.size());
  for (std::size_t i = 0; i < surface.FaceId.size(); ++i)
  {
    offsets[i + 1] = static_cast<int>(3 * (i + 1));
    solids[i] = this->Facets.SolidOfFace[static_cast<std::size_t>(surface.FaceId[i])];
  }
  vtkNew<vtkCellArray> cells;
  cells->SetData(sbvtk::ArrayOf<vtkTypeInt32Array>("", 1, offsets),
    sbvtk::ArrayOf<vtkTypeInt32Array>("", 1, surface.Triangles));
  this->Output->SetPoints(points);
  this->Output->SetPolys(cells);
  vtkPointData* pointData = this->Output->GetPointData();
  pointData->SetNormals(sbvtk::ArrayOf<vtkDoubleArray>("Normals", 3, this->Facets.Normals));
  pointData->AddArray(sbvtk::ArrayOf<vtkDoubleArray>(sbvtk::ParametersArray, 2, surface.UV));
  vtkCellData* cellData = this->Output->GetCellData();
  cellData->AddArray(sbvtk::ArrayOf<vtkIntArray>(sbvtk::FaceArray, 1, surface.FaceId));
  cellData->AddArray(sbvtk::ArrayOf<vtkIntArray>("SolidId", 1, solids));
  sbvtk::AttachPatches(this->Output, surface.Patches);
  this->Times.push_back({ "Build output", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::AddParts()
{
  const std::vector<std::int32_t>& faces = this->Facets.Surface.FaceId;
  std::vector<sbvtk::FaceStyle> styles;
  bool anyColor = false;
  for (const TopoDS_Shape& face : this->Facets.Faces)
  {
    styles.push_back(this->Parts.Of(face));
    anyColor = anyColor || styles.back().HasColor;
  }
  std::vector<int> parts;
  std::vector<unsigned char> colors;
  for (const std::int32_t face : faces)
  {
    const sbvtk::FaceStyle& style = styles[static_cast<std::size_t>(face)];
    parts.push_back(style.Part);
    for (const std::uint8_t share : style.Color)
    {
      colors.push_back(style.HasColor ? share : 255);
    }
  }
  if (!this->Parts.Names.empty()) // an empty array would hide all field data in the window
  {
    this->Output->GetCellData()->AddArray(sbvtk::ArrayOf<vtkIntArray>("PartId", 1, parts));
    sbvtk::AddField<vtkStringArray>(this->Output, "PartNames", this->Parts.Names);
  }
  if (anyColor)
  {
    this->Output->GetCellData()->AddArray(
      sbvtk::ArrayOf<vtkUnsignedCharArray>("PartColor", 3, colors));
  }
}

//------------------------------------------------------------------------------
void vtkNURBSReader::Run::AddFields()
{
  using sbvtk::AddField;
  AddField(this->Output, "Status", this->Status);
  AddField(this->Output, "Message", this->Message);
  AddField(this->Output, "Unit", std::string("mm"));
  AddField(this->Output, "NumberOfFaces", static_cast<int>(this->Facets.Surface.Patches.size()));
  AddField(this->Output, "NumberOfSolids", static_cast<int>(this->Facets.NumberOfSolids));
  AddField(this->Output, "NumberOfApproximatedFaces",
    static_cast<int>(this->Facets.NumberOfApproximations));
  AddField(this->Output, "Closed", this->Closed ? 1 : 0);
  AddField(this->Output, "Volume", this->Report.Volume);
  AddField(this->Output, "Area", this->Report.Area);
  AddField(this->Output, "ChordError", this->Facets.LargestChordError);
  AddField(this->Output, "Gap", this->Facets.LargestGap);
  sbvtk::AddStageFields(this->Output, this->Times);
}

//------------------------------------------------------------------------------
vtkNURBSReader::vtkNURBSReader() { this->SetNumberOfInputPorts(0); }

//------------------------------------------------------------------------------
vtkNURBSReader::~vtkNURBSReader() { delete[] this->FileName; }

//------------------------------------------------------------------------------
void vtkNURBSReader::ComputeWhole(vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  sbvtk::RunWithThreads(0, [&] { Run(this, output).Execute(); });
}

//------------------------------------------------------------------------------
void vtkNURBSReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ChordError: " << this->ChordError << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPointSetSurfaceFilter.h"

#include "ArrayMemory.h"
#include "CloudOrientation.h"
#include "CloudRun.h"
#include "CloudSampling.h"
#include "CloudSentences.h"
#include "FieldArrays.h"
#include "PointSurfaceMesh.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkTypeInt32Array.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkPointSetSurfaceFilter);

namespace
{

constexpr double LargestShare = 0.2; ///< of doubtful or invalid points that goes without a warning
constexpr double LargestThinShare = 0.001; ///< the same of points on walls that are too thin

/** Mean and Gauss curvature beside the principal ones. */
void AddCurvatures(vtkPolyData* output, vtkDoubleArray* maximum, vtkDoubleArray* minimum)
{
  const vtkIdType count = maximum->GetNumberOfTuples();
  const auto mean = sbvtk::NewArray<vtkDoubleArray>("MeanCurvature", 1, count);
  const auto gauss = sbvtk::NewArray<vtkDoubleArray>("GaussCurvature", 1, count);
  const double* const largest = maximum->GetPointer(0);
  const double* const least = minimum->GetPointer(0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    mean->GetPointer(0)[i] = 0.5 * (largest[i] + least[i]);
    gauss->GetPointer(0)[i] = largest[i] * least[i];
  }
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(mean), static_cast<vtkDataArray*>(gauss),
         static_cast<vtkDataArray*>(maximum), static_cast<vtkDataArray*>(minimum) })
  {
    output->GetPointData()->AddArray(array);
  }
}

} // namespace

/** One update: its steps in their order, and what they share. */
class vtkPointSetSurfaceFilter::Run : public sbvtk::CloudRun
{
public:
  Run(
    vtkPointSetSurfaceFilter* filter, vtkDataObject* input, vtkPolyData* points, vtkPolyData* mesh)
    : CloudRun(filter, input, *filter->Cloud, { points, mesh })
    , Filter(filter)
    , Points(points)
    , Mesh(mesh)
  {
  }

private:
  void TakeSteps() override;
  void Sample();
  void MarkDoubtful(const double* normals);
  void BuildPoints();
  void BuildMesh();
  void Judge();
  void AddFields(int status, const std::string& message) override;
  std::string AdviceOnMemory() const override { return "choose a larger CellSize or fewer points"; }
  std::string Share(double share) const;
  vtkIdType Count() const { return static_cast<vtkIdType>(this->Input.NumberOfPoints()); }

  vtkPointSetSurfaceFilter* Filter;
  vtkPolyData* Points;
  vtkPolyData* Mesh;
  vtkSmartPointer<vtkDoubleArray> Places;
  vtkSmartPointer<vtkUnsignedCharArray> Doubtful;
  vtkIdType NumberOfValid = 0;
  double ResidualRMS = 0.0;
  double DoubtfulShare = 0.0;
  double ContradictingShare = 0.0;
  vtkIdType NumberOfBorderEdges = 0;
  vtkIdType NumberOfSpecks = 0;
};

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::TakeSteps()
{
  CheckDefinition(this->Filter->Definition);
  CheckLength("Width", this->Filter->Width);
  CheckLength("CellSize", this->Filter->CellSize);
  this->ReadCloud();
  this->Times.push_back({ "Read input", this->Watch.Lap() });
  this->PrepareCloud(
    { this->Filter->Definition, this->Filter->Width, this->Filter->FlipNormals != 0 }, 0.02, 0.4);
  this->Times.push_back({ "Prepare cloud", this->Watch.Lap() });
  this->Sample();
  this->BuildPoints();
  if (this->Filter->GenerateSurface)
  {
    this->BuildMesh();
  }
  this->Judge();
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::Sample()
{
  const vtkIdType count = this->Count();
  this->Points->GetPointData()->PassData(this->Input.Data()->GetPointData());
  sbvtk::AddBlockNames(this->Points, this->Input.Names());
  this->Places = sbvtk::NewArray<vtkDoubleArray>("Points", 3, count);
  const auto normals = sbvtk::ArrayOf<vtkDoubleArray>("Normals", 3, this->Cloud.Normals);
  const auto residual = sbvtk::NewArray<vtkDoubleArray>("Residual", 1, count);
  const auto validity = sbvtk::NewArray<vtkUnsignedCharArray>("Validity", 1, count);
  const auto maximum = sbvtk::NewArray<vtkDoubleArray>("MaximumCurvature", 1, count);
  const auto minimum = sbvtk::NewArray<vtkDoubleArray>("MinimumCurvature", 1, count);
  sb::CloudArrays arrays;
  arrays.Projected = this->Places->GetPointer(0);
  arrays.Normal = normals->GetPointer(0);
  arrays.Residual = residual->GetPointer(0);
  arrays.Validity = validity->GetPointer(0);
  if (this->Filter->ComputeCurvatures)
  {
    arrays.MaximumCurvature = maximum->GetPointer(0);
    arrays.MinimumCurvature = minimum->GetPointer(0);
  }
  sbvtk::KernelMonitor monitor(this->Filter, 0.4, this->Filter->GenerateSurface ? 0.7 : 0.95);
  if (!sb::SampleCloudSurface(
        *this->Cloud.Surface, this->Input.Points(), count, arrays, this->Executor, monitor))
  {
    throw sbvtk::Stopped();
  }
  this->MarkDoubtful(arrays.Normal);
  double squares = 0.0;
  vtkIdType reached = 0;
  vtkIdType contradicting = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    this->NumberOfValid += arrays.Validity[i] == 0 ? 1 : 0;
    contradicting += arrays.Validity[i] == 3 ? 1 : 0;
    reached += std::isnan(arrays.Residual[i]) ? 0 : 1;
    squares += std::isnan(arrays.Residual[i]) ? 0.0 : arrays.Residual[i] * arrays.Residual[i];
  }
  this->ContradictingShare =
    static_cast<double>(contradicting) / static_cast<double>(std::max<vtkIdType>(1, count));
  this->ResidualRMS = reached > 0 ? std::sqrt(squares / static_cast<double>(reached)) : 0.0;
  vtkPointData* output = this->Points->GetPointData();
  output->SetNormals(normals);
  output->AddArray(residual);
  output->SetActiveScalars(residual->GetName()); // ParaView colours by it at once
  output->AddArray(validity);
  output->AddArray(this->Doubtful);
  if (this->Filter->ComputeCurvatures)
  {
    AddCurvatures(this->Points, maximum, minimum);
  }
  this->Times.push_back({ "Project points", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
/** A normal is doubtful if its estimate says so, or if it is turned against the surface's. */
void vtkPointSetSurfaceFilter::Run::MarkDoubtful(const double* normals)
{
  const vtkIdType count = this->Count();
  this->Doubtful = sbvtk::NewArray<vtkUnsignedCharArray>("DoubtfulNormal", 1, count);
  unsigned char* const doubtful = this->Doubtful->GetPointer(0);
  const double* const samples = this->Cloud.Normals.data();
  vtkIdType total = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* const a = samples + 3 * i;
    const double* const b = normals + 3 * i;
    const bool estimatedSo =
      !this->Cloud.Doubtful.empty() && this->Cloud.Doubtful[static_cast<std::size_t>(i)];
    doubtful[i] = estimatedSo || a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < 0.0 ? 1 : 0;
    total += doubtful[i];
  }
  this->DoubtfulShare = count > 0 ? static_cast<double>(total) / static_cast<double>(count) : 0.0;
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::BuildPoints()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  if (this->Filter->ProjectPoints)
  {
    points->SetData(this->Places);
  }
  else
  {
    sbvtk::CopyTuples(this->Input.Data()->GetPoints(), points);
  }
  this->Points->SetPoints(points);
  const vtkIdType count = this->Count();
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> ids;
  sbvtk::SetTuples(offsets, count + 1);
  sbvtk::SetTuples(ids, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    offsets->GetPointer(0)[i] = i;
    ids->GetPointer(0)[i] = i;
  }
  offsets->GetPointer(0)[count] = count;
  vtkNew<vtkCellArray> vertices;
  vertices->SetData(offsets, ids);
  this->Points->SetVerts(vertices);
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::BuildMesh()
{
  const double cell = this->Filter->CellSize > 0.0
    ? this->Filter->CellSize
    : sb::CellSizeFor(*this->Cloud.Surface, this->Cloud.Spacing);
  sbvtk::KernelMonitor monitor(this->Filter, 0.7, 0.95);
  std::shared_ptr<const sb::PointSurfaceMesh> kept = this->Kept.Mesh(cell);
  if (!kept)
  {
    kept = std::make_shared<sb::PointSurfaceMesh>(
      sb::MeshPointSurface(*this->Cloud.Surface, cell, this->Executor, monitor));
  }
  const sb::PointSurfaceMesh& mesh = *kept;
  if (mesh.End == sb::PointSurfaceMesh::Ending::Aborted)
  {
    throw sbvtk::Stopped();
  }
  if (mesh.End == sb::PointSurfaceMesh::Ending::TooFine)
  {
    throw Failure{ TOO_FINE,
      "Cells of " + sbvtk::Text(cell) +
        " are too small for the extent of Input; choose a larger CellSize, or remove outliers." };
  }
  this->Kept.KeepMesh(cell, kept);
  this->NumberOfBorderEdges = static_cast<vtkIdType>(mesh.NumberOfBorderEdges);
  this->NumberOfSpecks = static_cast<vtkIdType>(mesh.NumberOfSpecks);
  const vtkIdType count = static_cast<vtkIdType>(mesh.Points.size() / 3);
  const auto coordinates = sbvtk::ArrayOf<vtkDoubleArray>("Points", 3, mesh.Points);
  const auto normals = sbvtk::ArrayOf<vtkDoubleArray>("Normals", 3, mesh.Normals);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(coordinates);
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> corners;
  sbvtk::SetTuples(corners, static_cast<vtkIdType>(mesh.Triangles.size()));
  std::copy(mesh.Triangles.begin(), mesh.Triangles.end(), corners->GetPointer(0));
  sbvtk::SetTuples(offsets, corners->GetNumberOfValues() / 3 + 1);
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->GetPointer(0)[i] = static_cast<int>(3 * i);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, corners);
  this->Mesh->SetPoints(points);
  this->Mesh->SetPolys(triangles);
  this->Mesh->GetPointData()->SetNormals(normals);
  if (this->Filter->ComputeCurvatures)
  {
    const auto maximum = sbvtk::NewArray<vtkDoubleArray>("MaximumCurvature", 1, count);
    const auto minimum = sbvtk::NewArray<vtkDoubleArray>("MinimumCurvature", 1, count);
    sb::CloudArrays arrays;
    arrays.MaximumCurvature = maximum->GetPointer(0);
    arrays.MinimumCurvature = minimum->GetPointer(0);
    sbvtk::KernelMonitor rest(this->Filter, 0.95, 1.0);
    sb::SampleCloudSurface(
      *this->Cloud.Surface, coordinates->GetPointer(0), count, arrays, this->Executor, rest);
    AddCurvatures(this->Mesh, maximum, minimum);
    this->Mesh->GetPointData()->SetActiveScalars("MeanCurvature");
  }
  this->Times.push_back({ "Mesh", this->Watch.Lap() });
}

//------------------------------------------------------------------------------
std::string vtkPointSetSurfaceFilter::Run::Share(double share) const
{
  return "Of the " + std::to_string(this->Count()) + " points, " + sbvtk::PercentOf(share);
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::Judge()
{
  const std::string without = std::to_string(this->Cloud.NumberWithoutNormal);
  if (this->Input.Normals() && this->Cloud.Estimated)
  {
    this->Warn(BAD_NORMALS,
      "No normal of Input has a length and is finite, so normals were estimated; compute them "
      "anew, or leave the array out.");
  }
  else if (!this->Cloud.Estimated && this->Cloud.NumberWithoutNormal > 0)
  {
    this->Warn(BAD_NORMALS,
      without +
        " points of Input have a normal that is zero or not finite, and were left out of the "
        "surface; give them one, or remove all normals to have them estimated.");
  }
  if (sb::WindingOnSurface(*this->Cloud.Surface, this->Executor) < sb::WindingOfInsideOut)
  {
    this->Warn(DOUBTFUL_NORMALS,
      "The normals point into the solid that the points enclose, so that its surface is inside "
      "out; switch FlipNormals.");
  }
  if (this->Cloud.ThinShare > LargestThinShare)
  {
    this->Warn(THIN_PARTS,
      sbvtk::ThinPartsOf(this->Cloud) +
        "; choose a smaller Width, or give Input more points there.");
  }
  if (this->ContradictingShare > LargestThinShare && !(this->Cloud.ThinShare > LargestThinShare))
  {
    this->Warn(DOUBTFUL_NORMALS,
      Share(this->ContradictingShare) +
        " have normals that contradict those around them (Validity is 3 there), as if parts "
        "of Input were turned over; give Input normals that agree on a side, or none, to have them "
        "estimated.");
  }
  if (this->DoubtfulShare > LargestShare)
  {
    this->Warn(DOUBTFUL_NORMALS,
      Share(this->DoubtfulShare) +
        " have normals that may be wrong (DoubtfulNormal is 1 there); give Input normals that "
        "agree on a side, or more points where it is thin or sharp.");
  }
  const double invalid = 1.0 -
    static_cast<double>(this->NumberOfValid) /
      static_cast<double>(std::max<vtkIdType>(1, this->Count()));
  if (invalid > LargestShare)
  {
    this->Warn(INVALID_POINTS,
      Share(invalid) +
        " do not lie on a surface that the others define (see Validity); choose a larger Width, or "
        "remove outliers.");
  }
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::Run::AddFields(int status, const std::string& message)
{
  if (this->CloudData)
  {
    this->Points->GetFieldData()->PassData(this->CloudData->GetFieldData());
  }
  const auto addDouble = [this](const char* name, double value) {
    sbvtk::AddField(this->Points, name, value);
  };
  const auto addCount = [this](const char* name, std::int64_t value) {
    sbvtk::AddCount(this->Points, name, value);
  };
  this->AddCloudFields(this->Points, status, message);
  addDouble("ResidualRMS", this->ResidualRMS);
  addDouble("DoubtfulShare", this->DoubtfulShare);
  addCount("NumberOfValidPoints", this->NumberOfValid);
  addCount("NumberOfDuplicates", this->Cloud.NumberOfDuplicates);
  addCount("NumberOfBadPoints", this->Cloud.NumberOfNotFinite);
  addCount("NumberWithoutNormal", this->Cloud.NumberWithoutNormal);
  sbvtk::AddField(this->Points, "NormalsEstimated", this->Cloud.Estimated ? 1 : 0);
  addCount("NumberOfBorderEdges", this->NumberOfBorderEdges);
  addCount("NumberOfSpecks", this->NumberOfSpecks);
  addDouble("ThinShare", this->Cloud.ThinShare);
  addDouble("ThinWall", this->Cloud.ThinWall);
  sbvtk::AddStageFields(this->Points, this->Times);
}

//------------------------------------------------------------------------------
vtkPointSetSurfaceFilter::vtkPointSetSurfaceFilter()
  : Cloud(std::make_unique<sbvtk::PreparedCloud>())
{
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkPointSetSurfaceFilter::~vtkPointSetSurfaceFilter() = default;

//------------------------------------------------------------------------------
int vtkPointSetSurfaceFilter::FillInputPortInformation(int, vtkInformation* info)
{
  // Any data object, and optional: others get a sentence of ours instead of the pipeline's.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkPolyData* points = vtkPolyData::GetData(outputs, 0);
  vtkPolyData* mesh = vtkPolyData::GetData(outputs, 1);
  sbvtk::RunWithThreads(this->NumberOfThreads, [&] { Run(this, input, points, mesh).Execute(); });
}

//------------------------------------------------------------------------------
void vtkPointSetSurfaceFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Definition: " << this->Definition << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "FlipNormals: " << this->FlipNormals << "\n";
  os << indent << "ProjectPoints: " << this->ProjectPoints << "\n";
  os << indent << "ComputeCurvatures: " << this->ComputeCurvatures << "\n";
  os << indent << "GenerateSurface: " << this->GenerateSurface << "\n";
  os << indent << "CellSize: " << this->CellSize << "\n";
  os << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}

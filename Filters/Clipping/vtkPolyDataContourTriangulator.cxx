// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyDataContourTriangulator.h"

#include "ArrayMemory.h"
#include "AttributeUnion.h"
#include "CellLists.h"
#include "ConditionSentences.h"
#include "ContourFill.h"
#include "FieldArrays.h"
#include "FilterRun.h"
#include "KernelExecutor.h"
#include "PreparedInput.h"
#include "SurfaceInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <algorithm>
#include <numeric>
#include <string>

vtkStandardNewMacro(vtkPolyDataContourTriangulator);

/** One update: its steps in their order, and what they share. */
class vtkPolyDataContourTriangulator::Run
{
public:
  Run(vtkPolyDataContourTriangulator* filter, vtkPolyData* input, vtkPolyData* output)
    : Filter(filter)
    , Input(input)
    , Output(output)
  {
  }

  void Execute();

private:
  void ReadLines();
  void BuildPoints();
  void BuildTriangles();
  void Report();
  void AddFields(int status, const std::string& message);

  vtkPolyDataContourTriangulator* Filter;
  vtkPolyData* Input;
  vtkPolyData* Output;
  vtkNew<vtkDoubleArray> Coordinates;
  sb::ContourFillRequest Request;
  sb::ContourFillResult Result;
};

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::Execute()
{
  const auto steps = [this] {
    this->ReadLines();
    this->Result = sb::FillLines(this->Request);
    if (sb::IsError(this->Result.Condition))
    {
      throw sbvtk::Failure{ static_cast<int>(this->Result.Condition),
        sbvtk::ConditionSentence(this->Result.Remarks.front(), "Input", -1) };
    }
    this->BuildPoints();
    // Lines of a slice bring normals of the surface, which would shade the flat filling as if it
    // were bent: the array stays, but is no longer what the cells are shaded by.
    this->Output->GetPointData()->SetActiveAttribute(-1, vtkDataSetAttributes::NORMALS);
    this->BuildTriangles();
    this->Report();
  };
  const auto report = [this](const sbvtk::FilterFailure& failure) {
    this->Output->Initialize();
    this->Result = sb::ContourFillResult();
    this->AddFields(failure.Status, failure.Sentence);
  };
  sbvtk::RunSteps(this->Filter, steps,
    { report, sbvtk::FailureOf(sb::Status::Aborted),
      { OUT_OF_MEMORY, "The result does not fit into memory; close other data first." } });
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::ReadLines()
{
  sbvtk::KernelExecutor executor;
  const std::string damage = sbvtk::DamageOfCells(this->Input, executor);
  if (!damage.empty())
  {
    throw sbvtk::Failure{ NOT_A_SURFACE, "Input " + damage };
  }
  const vtkIdType numberOfPoints = this->Input->GetNumberOfPoints();
  if (numberOfPoints > 0)
  {
    sbvtk::CopyTuples(this->Input->GetPoints()->GetData(), this->Coordinates);
  }
  this->Request.Points = this->Coordinates->GetPointer(0);
  this->Request.NumberOfPoints = numberOfPoints;
  vtkCellArray* lines = this->Input->GetLines();
  for (vtkIdType cell = 0; lines && cell < lines->GetNumberOfCells(); ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    lines->GetCellAtId(cell, size, points);
    for (vtkIdType i = 0; i < size; ++i)
    {
      if (points[i] < 0 || points[i] >= numberOfPoints)
      {
        sb::Remark remark;
        remark.Condition = sb::Status::BadIndex;
        throw sbvtk::Failure{ static_cast<int>(remark.Condition),
          sbvtk::ConditionSentence(remark, "Input", this->Input->GetNumberOfVerts() + cell) };
      }
      if (i > 0)
      {
        this->Request.Segments.push_back(
          { static_cast<std::int32_t>(points[i - 1]), static_cast<std::int32_t>(points[i]) });
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::BuildPoints()
{
  if (this->Result.Crossings.empty())
  {
    this->Output->SetPoints(this->Input->GetPoints());
    this->Output->GetPointData()->PassData(this->Input->GetPointData());
    return;
  }
  const vtkIdType before = this->Input->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Input->GetPoints()->GetDataType());
  sbvtk::SetTuples(points, before + static_cast<vtkIdType>(this->Result.Crossings.size()));
  points->InsertPoints(0, before, 0, this->Input->GetPoints());
  vtkIdType next = before;
  for (const sb::InterpolatedPoint& crossing : this->Result.Crossings)
  {
    points->SetPoint(next++, crossing.Position.data());
  }
  this->Output->SetPoints(points);
  std::vector<std::int32_t> ids(static_cast<std::size_t>(before));
  std::iota(ids.begin(), ids.end(), 0);
  sbvtk::TupleSources tuples;
  sbvtk::CopyRun run;
  run.Count = before;
  run.PointIds = ids.data();
  tuples.Runs.push_back(run);
  tuples.NumberOfTuples = points->GetNumberOfPoints();
  tuples.Interpolated = &this->Result.Crossings;
  tuples.FirstInterpolated = before;
  sbvtk::KernelExecutor executor;
  const sbvtk::AttributeUnion attributes(
    { { this->Input->GetPointData(), before, "Input" } }, "point");
  attributes.CopyTo(this->Output->GetPointData(), tuples, executor);
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::BuildTriangles()
{
  const auto count = static_cast<vtkIdType>(this->Result.Triangles.size());
  vtkNew<vtkTypeInt64Array> offsets;
  vtkNew<vtkTypeInt64Array> connectivity;
  vtkNew<vtkIdTypeArray> polygonIds;
  vtkNew<vtkIntArray> nestings;
  sbvtk::SetTuples(offsets, count + 1);
  sbvtk::SetTuples(connectivity, 3 * count);
  polygonIds->SetName("PolygonId");
  sbvtk::SetTuples(polygonIds, count);
  nestings->SetName("Nesting");
  sbvtk::SetTuples(nestings, count);
  offsets->SetValue(0, 0);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const std::array<std::int32_t, 3>& triangle =
      this->Result.Triangles[static_cast<std::size_t>(i)];
    std::copy(triangle.begin(), triangle.end(), connectivity->GetPointer(3 * i));
    offsets->SetValue(i + 1, 3 * (i + 1));
    const std::int32_t polygon = this->Result.PolygonOfTriangle[static_cast<std::size_t>(i)];
    polygonIds->SetValue(i, polygon);
    nestings->SetValue(i, this->Result.Nesting[static_cast<std::size_t>(polygon)]);
  }
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, connectivity);
  this->Output->SetPolys(polygons);
  this->Output->GetCellData()->AddArray(polygonIds);
  this->Output->GetCellData()->AddArray(nestings);
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::Report()
{
  int status = 0;
  std::string sentence = "The result is complete.";
  if (this->Result.OpenSegments > 0)
  {
    status = OPEN_CONTOURS;
    sentence = "Input has " + std::to_string(this->Result.OpenSegments) +
      " line segments that are part of no closed contour, so they were left out; close the "
      "contours first.";
  }
  else if (this->Result.Deviation > 1e-3 * this->Result.Size)
  {
    status = NOT_PLANAR;
    sentence = "Input has points up to " + std::to_string(this->Result.Deviation) +
      " off the plane of its contours, so they were filled as seen along its normal; fill the "
      "contours of each plane by themselves.";
  }
  if (status != 0)
  {
    vtkWarningWithObjectMacro(this->Filter, << sentence);
  }
  this->AddFields(status, sentence);
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Run::AddFields(int status, const std::string& message)
{
  this->Output->GetFieldData()->PassData(this->Input->GetFieldData());
  sbvtk::AddField(this->Output, "Status", status);
  sbvtk::AddField(this->Output, "Message", message);
  sbvtk::AddCount(
    this->Output, "PolygonCount", static_cast<std::int64_t>(this->Result.Nesting.size()));
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::ComputeWhole(
  vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataObject* input = vtkDataObject::GetData(inputs[0], 0);
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  vtkCompositeDataSet* blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (!blocks)
  {
    this->Fill(input, vtkPolyData::SafeDownCast(output));
    return;
  }
  const auto filled = vtkSmartPointer<vtkCompositeDataSet>::Take(blocks->NewInstance());
  filled->CopyStructure(blocks);
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkNew<vtkPolyData> block;
    this->Fill(iterator->GetCurrentDataObject(), block);
    filled->SetDataSet(iterator, block);
  }
  vtkPolyData* merged = vtkPolyData::SafeDownCast(output);
  merged ? Merge(filled, merged) : output->ShallowCopy(filled);
}

//------------------------------------------------------------------------------
/** Blocks that were filled as one surface, with the polygons counted through. */
void vtkPolyDataContourTriangulator::Merge(vtkCompositeDataSet* filled, vtkPolyData* output)
{
  int status = 0;
  std::string message = "The result is complete.";
  vtkIdType count = 0;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(filled->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    vtkPolyData* block = vtkPolyData::SafeDownCast(iterator->GetCurrentDataObject());
    vtkFieldData* fields = block->GetFieldData();
    const int own = vtkIntArray::SafeDownCast(fields->GetArray("Status"))->GetValue(0);
    if (status == 0 && own != 0)
    {
      status = own;
      message = vtkStringArray::SafeDownCast(fields->GetAbstractArray("Message"))->GetValue(0);
    }
    vtkIdType largest = -1;
    if (auto* ids = vtkIdTypeArray::SafeDownCast(block->GetCellData()->GetArray("PolygonId")))
    {
      for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
      {
        largest = std::max(largest, ids->GetValue(i));
        ids->SetValue(i, ids->GetValue(i) + count);
      }
    }
    count += largest + 1;
  }
  sbvtk::SurfaceInput surface;
  sbvtk::KernelExecutor executor;
  surface.Read(filled, executor);
  output->ShallowCopy(surface.Surface());
  sbvtk::AddField(output, "Status", status);
  sbvtk::AddField(output, "Message", message);
  sbvtk::AddField<vtkIdTypeArray>(output, "PolygonCount", std::vector<vtkIdType>{ count });
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::Fill(vtkDataObject* input, vtkPolyData* output)
{
  if (vtkPolyData* lines = vtkPolyData::SafeDownCast(input))
  {
    Run(this, lines, output).Execute();
    return;
  }
  const std::string sentence = input ? std::string("Input is of type ") + input->GetClassName() +
      ", which has no lines; apply Extract Surface and Feature Edges to it first."
                                     : "Input has no data; update the filter before it.";
  sbvtk::AddField(output, "Status", static_cast<int>(NOT_A_SURFACE));
  sbvtk::AddField(output, "Message", sentence);
  vtkErrorMacro(<< sentence);
}

//------------------------------------------------------------------------------
int vtkPolyDataContourTriangulator::FillInputPortInformation(int, vtkInformation* info)
{
  // Composite data come whole: processes of a server may have different blocks, and if each went
  // through its own block by block, they would wait for each other for ever.
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
int vtkPolyDataContourTriangulator::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkDataObject");
  return 1;
}

//------------------------------------------------------------------------------
/** The output has blocks if the input has; but not of several processes, which the pipeline does
 * not always execute together where the output is composite. */
vtkTypeBool vtkPolyDataContourTriangulator::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (!request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  const bool alone = !this->GetController() || this->GetController()->GetNumberOfProcesses() < 2;
  vtkCompositeDataSet* blocks = alone ? vtkCompositeDataSet::GetData(inputs[0], 0) : nullptr;
  const char* wanted = blocks ? blocks->GetClassName() : "vtkPolyData";
  vtkDataObject* output = vtkDataObject::GetData(outputs, 0);
  if (!output || std::string(output->GetClassName()) != wanted)
  {
    const auto made = blocks ? vtkSmartPointer<vtkDataObject>::Take(blocks->NewInstance())
                             : vtkSmartPointer<vtkDataObject>(vtkSmartPointer<vtkPolyData>::New());
    outputs->GetInformationObject(0)->Set(vtkDataObject::DATA_OBJECT(), made);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkPolyDataContourTriangulator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

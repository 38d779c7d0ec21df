// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceConnections.h"

#include "ConditionSentences.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

namespace sbvtk
{

//------------------------------------------------------------------------------
FilterFailure FailureOf(sb::Status condition, const std::string& name)
{
  sb::Remark remark;
  remark.Condition = condition;
  return { static_cast<int>(condition), ConditionSentence(remark, name, -1) };
}

//------------------------------------------------------------------------------
void MatchConnections(SurfaceConnections& last, vtkInformationVector** inputs)
{
  SurfaceConnections connections;
  for (const sb::Group side : { sb::Group::Input, sb::Group::Tool })
  {
    const bool isInput = side == sb::Group::Input;
    const int count = inputs[isInput ? 0 : 1]->GetNumberOfInformationObjects();
    for (int i = 0; i < count; ++i)
    {
      const std::string name =
        std::string(isInput ? "Input" : "Tool") + (count > 1 ? " " + std::to_string(i + 1) : "");
      const auto known = std::find_if(last.begin(), last.end(),
        [&name](const SurfaceConnection& connection) { return connection.Name == name; });
      connections.push_back(known == last.end() ? SurfaceConnection() : *known);
      connections.back().Name = name;
      connections.back().Side = side;
    }
  }
  last.swap(connections);
}

//------------------------------------------------------------------------------
void ReadConnections(SurfaceConnections& connections, vtkInformationVector** inputs,
  int notASurface, double tolerance, sb::Executor& executor)
{
  int place[2] = { 0, 0 };
  int firstBlock = 0;
  for (SurfaceConnection& connection : connections)
  {
    const int port = connection.Side == sb::Group::Input ? 0 : 1;
    const std::string refusal = connection.Input.Read(
      vtkDataObject::GetData(inputs[port], place[port]++), executor, firstBlock);
    if (!refusal.empty())
    {
      throw FilterFailure{ notASurface, connection.Name + " " + refusal };
    }
    firstBlock += static_cast<int>(connection.Input.Names().size());
    vtkPolyData* surface = connection.Input.Surface();
    if (!OperandSurface::FitsInt32(surface))
    {
      throw FailureOf(sb::Status::TooLarge, connection.Name);
    }
    if (connection.Surface && connection.Surface->IsConversionOf(surface, tolerance))
    {
      connection.Surface->SetAttributesFrom(surface);
    }
    else
    {
      connection.Surface
        .reset(); // before its successor is made, so that both never need memory together
      connection.Surface = std::make_shared<OperandSurface>(surface, executor, tolerance);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::shared_ptr<OperandSurface>> SurfacesOf(const SurfaceConnections& connections)
{
  std::vector<std::shared_ptr<OperandSurface>> surfaces;
  for (const SurfaceConnection& connection : connections)
  {
    surfaces.push_back(connection.Surface);
  }
  return surfaces;
}

//------------------------------------------------------------------------------
BlockNames BlockNamesOf(const SurfaceConnections& connections)
{
  BlockNames names;
  for (const SurfaceConnection& connection : connections)
  {
    const BlockNames& own = connection.Input.Names();
    names.insert(names.end(), own.begin(), own.end());
  }
  return names;
}

//------------------------------------------------------------------------------
AttributeUnion::Source AttributesOf(const SurfaceConnection& connection, bool ofPoints)
{
  vtkPolyData* data = connection.Surface->Data();
  AttributeUnion::Source source;
  source.Attributes =
    ofPoints ? static_cast<vtkDataSetAttributes*>(data->GetPointData()) : data->GetCellData();
  source.NumberOfTuples = ofPoints ? data->GetNumberOfPoints() : data->GetNumberOfCells();
  source.Name = connection.Name;
  return source;
}

//------------------------------------------------------------------------------
std::string RemarkSentence(const sb::Remark& remark, const SurfaceConnections& connections)
{
  if (remark.Operand < 0)
  {
    return ConditionSentence(remark, "An input", -1);
  }
  const SurfaceConnection& connection = connections[remark.Operand];
  const std::int64_t cell =
    remark.Triangle >= 0 ? connection.Surface->CellOfTriangle(remark.Triangle) : -1;
  return ConditionSentence(remark, connection.Name, cell);
}

//------------------------------------------------------------------------------
void AppendTimes(const std::vector<sb::StageTime>& ofKernel, double secondsOfExaminations,
  std::vector<sb::StageTime>& all)
{
  for (sb::StageTime time : ofKernel)
  {
    time.Seconds += std::string(time.Name) == "Check" ? secondsOfExaminations : 0.0;
    all.push_back(time);
  }
}

//------------------------------------------------------------------------------
bool HaveFloatPoints(const SurfaceConnections& connections)
{
  return std::all_of(
    connections.begin(), connections.end(), [](const SurfaceConnection& connection) {
      vtkPoints* points = connection.Surface->Data()->GetPoints();
      return !points || points->GetNumberOfPoints() == 0 ||
        vtkFloatArray::FastDownCast(points->GetData()) != nullptr;
    });
}

} // namespace sbvtk

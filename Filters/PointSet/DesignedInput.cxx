// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DesignedInput.h"

#include "ArrayMemory.h"
#include "ConditionSentences.h"
#include "Ingest.h"
#include "NURBSArrays.h"
#include "OperandSurface.h"
#include "PatchPlacement.h"
#include "PatchTurning.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace sbvtk
{
namespace
{

std::vector<vtkDataObject*> LeavesOf(vtkDataObject* data)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return { data };
  }
  std::vector<vtkDataObject*> leaves;
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    leaves.push_back(iterator->GetCurrentDataObject());
  }
  return leaves;
}

/** The same blocks, of the same names, with these leaves. */
vtkSmartPointer<vtkDataObject> WithLeaves(
  vtkDataObject* data, const std::vector<vtkSmartPointer<vtkPolyData>>& leaves)
{
  vtkCompositeDataSet* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return leaves.front();
  }
  const auto copy = vtkSmartPointer<vtkCompositeDataSet>::Take(composite->NewInstance());
  copy->CopyStructure(composite);
  auto leaf = leaves.begin();
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
  {
    copy->SetDataSet(iterator, *leaf++);
  }
  return copy;
}

/** The array as doubles, or null if there is none of so many components and tuples. */
vtkSmartPointer<vtkDoubleArray> Doubles(
  vtkFieldData* attributes, const char* name, int components, vtkIdType tuples)
{
  vtkDataArray* array = attributes->GetArray(name);
  if (!array || array->GetNumberOfComponents() != components ||
    array->GetNumberOfTuples() != tuples)
  {
    return nullptr;
  }
  const auto doubles = vtkSmartPointer<vtkDoubleArray>::New();
  CopyTuples(array, doubles);
  return doubles;
}

/** The exact surfaces of all leaves, and the leaves with FaceId counted through all of them. */
struct ExactLeaves
{
  std::vector<sb::NURBSSurface> Patches;
  std::vector<std::int32_t> LeafOfPatch;
  std::vector<vtkSmartPointer<vtkPolyData>> Leaves;
  std::string Fault; ///< of the first leaf that has one

  void Add(vtkPolyData* leaf)
  {
    std::vector<sb::NURBSSurface> patches;
    std::string fault = ReadPatches(leaf, patches);
    const auto faces = Doubles(leaf->GetCellData(), FaceArray, 1, leaf->GetNumberOfCells());
    const auto parameters =
      Doubles(leaf->GetPointData(), ParametersArray, 2, leaf->GetNumberOfPoints());
    if (fault.empty() && !patches.empty() && !(faces && parameters))
    {
      fault = std::string("carries exact surfaces but not the cell array ") + FaceArray +
        " and the point array " + ParametersArray + " that place the facets on them";
    }
    this->Fault = this->Fault.empty() ? fault : this->Fault;
    if (!fault.empty())
    {
      patches.clear();
    }
    this->AddCopy(leaf, patches.empty() ? nullptr : faces.Get(),
      patches.empty() ? nullptr : parameters.Get(), static_cast<double>(patches.size()));
    this->LeafOfPatch.resize(this->LeafOfPatch.size() + patches.size(),
      static_cast<std::int32_t>(this->Leaves.size()) - 1);
    std::move(patches.begin(), patches.end(), std::back_inserter(this->Patches));
  }

private:
  void AddCopy(
    vtkPolyData* leaf, vtkDoubleArray* faces, vtkDoubleArray* parameters, double numberOfPatches)
  {
    const vtkIdType count = leaf->GetNumberOfCells();
    vtkNew<vtkIntArray> numbered;
    numbered->SetName(FaceArray);
    SetTuples(numbered, count);
    int* ids = numbered->GetPointer(0);
    const double* own = faces ? faces->GetPointer(0) : nullptr;
    for (vtkIdType cell = 0; cell < count; ++cell)
    {
      const bool known = own && own[cell] >= 0.0 && own[cell] < numberOfPatches;
      ids[cell] = known ? static_cast<int>(own[cell]) + static_cast<int>(this->Patches.size()) : -1;
    }
    vtkSmartPointer<vtkDoubleArray> places = parameters;
    if (!places)
    {
      places = vtkSmartPointer<vtkDoubleArray>::New();
      places->SetNumberOfComponents(2);
      SetTuples(places, leaf->GetNumberOfPoints());
      places->Fill(std::numeric_limits<double>::quiet_NaN());
    }
    places->SetName(ParametersArray);
    const auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(leaf);
    copy->GetCellData()->AddArray(numbered);
    copy->GetPointData()->AddArray(places);
    this->Leaves.push_back(copy);
  }
};

std::vector<vtkMTimeType> StampOf(
  const std::vector<vtkDataObject*>& leaves, DesignedInput::Patchless patchless)
{
  std::vector<vtkMTimeType> stamp{ static_cast<vtkMTimeType>(patchless) };
  for (vtkDataObject* leaf : leaves)
  {
    stamp.push_back(leaf ? leaf->GetMTime() : 0);
  }
  return stamp;
}

/** As the end of a sentence. */
std::string Ending(const sb::Remark& remark, std::int64_t cell)
{
  return ConditionSentence(remark, "", cell).substr(1);
}

} // namespace

DesignedInput::DesignedInput() = default;
DesignedInput::~DesignedInput() = default;

//------------------------------------------------------------------------------
std::string DesignedInput::Read(vtkDataObject* data, sb::Executor& executor, Patchless patchless)
{
  const std::vector<vtkDataObject*> leaves = LeavesOf(data);
  std::vector<vtkMTimeType> stamp = StampOf(leaves, patchless);
  const bool sameNames =
    !vtkCompositeDataSet::SafeDownCast(data) || BlocksOf(data).Names == this->Facets.Names();
  if (stamp == this->Stamp && sameNames)
  {
    return this->Refusal;
  }
  this->Designed = sb::DesignedSurface();
  this->Triangulated.reset();
  this->Remark.clear();
  this->Refusal = this->ReadExactSurfaces(data, executor, patchless);
  this->Stamp = std::move(stamp);
  return this->Refusal;
}

//------------------------------------------------------------------------------
std::string DesignedInput::ReadExactSurfaces(
  vtkDataObject* data, sb::Executor& executor, Patchless patchless)
{
  const std::vector<vtkDataObject*> leaves = LeavesOf(data);
  ExactLeaves exact;
  vtkSmartPointer<vtkDataObject> prepared;
  if (std::all_of(leaves.begin(), leaves.end(), vtkPolyData::SafeDownCast))
  {
    for (vtkDataObject* leaf : leaves)
    {
      exact.Add(vtkPolyData::SafeDownCast(leaf));
    }
    prepared = WithLeaves(data, exact.Leaves);
  }
  const bool hasPatches = !exact.Patches.empty();
  std::string refusal = this->Facets.Read(hasPatches ? prepared.Get() : data, executor);
  refusal = refusal.empty() ? this->ReadFacets(executor) : refusal;
  if (!refusal.empty())
  {
    return refusal;
  }
  if (!exact.Fault.empty())
  {
    this->Remark = exact.Fault + ", so the facets are used; read the file again.";
  }
  if (hasPatches)
  {
    this->Designed.Patches = std::move(exact.Patches);
    this->ReadPlaces(exact.LeafOfPatch, executor, patchless);
  }
  return "";
}

//------------------------------------------------------------------------------
std::string DesignedInput::ReadFacets(sb::Executor& executor)
{
  sb::Remark tooLarge;
  tooLarge.Condition = sb::Status::TooLarge;
  if (!OperandSurface::FitsInt32(this->Facets.Surface()))
  {
    return Ending(tooLarge, -1);
  }
  this->Triangulated = std::make_unique<OperandSurface>(this->Facets.Surface(), executor);
  const sb::Examination& examination =
    *this->Triangulated->Examination(executor, sb::OpenSurfaces::Accept);
  for (const sb::Remark& remark : examination.Remarks)
  {
    if (remark.Condition == sb::Status::BadCoordinate || remark.Condition == sb::Status::BadIndex)
    {
      return Ending(
        remark, remark.Triangle >= 0 ? this->Triangulated->CellOfTriangle(remark.Triangle) : -1);
    }
  }
  const sb::Surface& mesh = this->Triangulated->Mesh();
  this->Designed.Points.assign(mesh.Points, mesh.Points + 3 * mesh.NumberOfPoints);
  this->Designed.Triangles.assign(mesh.Triangles, mesh.Triangles + 3 * mesh.NumberOfTriangles);
  this->Open = examination.IsOpen;
  this->InsideOut = examination.IsInsideOut;
  for (std::size_t i = 0; this->InsideOut && i < this->Designed.Triangles.size(); i += 3)
  {
    std::swap(this->Designed.Triangles[i + 1], this->Designed.Triangles[i + 2]);
  }
  return "";
}

//------------------------------------------------------------------------------
/** Patches whose facets run clockwise in their parameters, as they do after the facets were turned
 * over, are turned, too: Du x Dv points to the front of the facets. */
void DesignedInput::TurnPatches()
{
  sb::DesignedSurface& surface = this->Designed;
  std::vector<double> areas(surface.Patches.size(), 0.0);
  std::vector<std::int32_t> faceOfPoint(surface.Points.size() / 3, -1);
  for (std::size_t i = 0; i < surface.FaceId.size(); ++i)
  {
    if (surface.FaceId[i] >= 0)
    {
      const std::int32_t* corners = surface.Triangles.data() + 3 * i;
      const double* a = surface.UV.data() + 2 * static_cast<std::size_t>(corners[0]);
      const double* b = surface.UV.data() + 2 * static_cast<std::size_t>(corners[1]);
      const double* c = surface.UV.data() + 2 * static_cast<std::size_t>(corners[2]);
      areas[static_cast<std::size_t>(surface.FaceId[i])] +=
        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
      for (int k = 0; k < 3; ++k)
      {
        faceOfPoint[static_cast<std::size_t>(corners[k])] = surface.FaceId[i];
      }
    }
  }
  for (std::size_t face = 0; face < areas.size(); ++face)
  {
    surface.Patches[face] =
      areas[face] < 0.0 ? sb::Turned(surface.Patches[face]) : surface.Patches[face];
  }
  for (std::size_t point = 0; point < faceOfPoint.size(); ++point)
  {
    if (faceOfPoint[point] >= 0 && areas[static_cast<std::size_t>(faceOfPoint[point])] < 0.0)
    {
      std::swap(surface.UV[2 * point], surface.UV[2 * point + 1]);
    }
  }
}

//------------------------------------------------------------------------------
void DesignedInput::ReadPlaces(
  const std::vector<std::int32_t>& leafOfPatch, sb::Executor& executor, Patchless patchless)
{
  sb::DesignedSurface& surface = this->Designed;
  const int* faces =
    vtkIntArray::SafeDownCast(this->Data()->GetCellData()->GetArray(FaceArray))->GetPointer(0);
  const double* places =
    vtkDoubleArray::SafeDownCast(this->Data()->GetPointData()->GetArray(ParametersArray))
      ->GetPointer(0);
  surface.UV.assign(places, places + surface.Points.size() / 3 * 2);
  surface.FaceId.resize(surface.Triangles.size() / 3);
  std::int64_t without = 0;
  for (std::size_t triangle = 0; triangle < surface.FaceId.size(); ++triangle)
  {
    // A filter that mixes facets of two surfaces has no number to put for "no face", but for
    // parameters it has NaN.
    const bool placed =
      std::all_of(surface.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * triangle),
        surface.Triangles.begin() + static_cast<std::ptrdiff_t>(3 * triangle + 3),
        [&](std::int32_t point) {
          const std::size_t i = 2 * static_cast<std::size_t>(point);
          return std::isfinite(surface.UV[i]) && std::isfinite(surface.UV[i + 1]);
        });
    surface.FaceId[triangle] =
      placed ? faces[this->CellOfTriangle(static_cast<std::int64_t>(triangle))] : -1;
    without += surface.FaceId[triangle] < 0 ? 1 : 0;
  }
  std::string misfit;
  if (without > 0 && patchless == Patchless::UseFacetsOnly)
  {
    misfit = "has " + std::to_string(without) +
      " facets that are on none of the exact surfaces which it carries, so these are not used; "
      "choose the surface as it was read from the file.";
  }
  else
  {
    misfit = PlacePatches(surface, leafOfPatch, executor);
    this->TurnPatches();
  }
  if (!misfit.empty())
  {
    this->Remark = misfit;
    surface.UV.clear();
    surface.FaceId.clear();
    surface.Patches.clear();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* DesignedInput::Data() const
{
  return this->Triangulated ? this->Triangulated->Data() : nullptr;
}

//------------------------------------------------------------------------------
std::int32_t DesignedInput::CellOfTriangle(std::int64_t triangle) const
{
  return this->Triangulated->CellOfTriangle(triangle);
}

} // namespace sbvtk

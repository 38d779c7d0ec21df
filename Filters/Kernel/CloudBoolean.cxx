// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudBoolean.h"

#include "BorderEdges.h"
#include "ClosestOnPatch.h"
#include "CloudMeshRefinement.h"
#include "FacePoints.h"
#include "Ingest.h"
#include "MeshParts.h"
#include "OpenScanBoolean.h"
#include "PointSurfaceMesh.h"
#include "SampleSides.h"
#include "Stages.h"
#include "SurfaceRefinement.h"
#include "ToolSurface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace sb
{
namespace
{

constexpr double ChordInSpacings = 0.1; ///< of the refined tool
constexpr double SpeckInCells = 4.0; ///< parts of the cloud's mesh not longer than this are noise
constexpr double LeastWindingOfScan = -0.25; ///< below it, the scan's normals point inwards
constexpr double Tangent = 0.995; ///< cosine between surfaces that hardly cross
constexpr std::size_t Probes = 10000; ///< at which errors are measured
constexpr std::int64_t Grain = 512;
constexpr double Pi = 3.14159265358979323846;
const double None = std::numeric_limits<double>::quiet_NaN();

/** All steps and what they share. */
class CloudBooleanRun
{
public:
  CloudBooleanRun(const CloudBooleanRequest& request, Executor& executor, Monitor& monitor)
    : Request(request)
    , Surface(*request.Cloud->Surface)
    , Spacing(request.Cloud->Spacing)
    , Cell(request.Cell > 0.0 ? request.Cell
                              : CellSizeFor(*request.Cloud->Surface, request.Cloud->Spacing))
    , Threads(executor)
    , Watch(monitor)
  {
  }

  CloudBooleanResult Run()
  {
    using Step = void (CloudBooleanRun::*)();
    const struct
    {
      const char* Name;
      double Progress;
      Step Do;
    } steps[] = { { "Check tool", 0.02, &CloudBooleanRun::CheckTool },
      { "Mesh cloud", 0.05, &CloudBooleanRun::MeshCloud },
      { "Check cloud", 0.5, &CloudBooleanRun::CheckCloud },
      { "Refine tool", 0.55, &CloudBooleanRun::RefineTool },
      { "Refine cloud", 0.58, &CloudBooleanRun::RefineCloud },
      { "Boolean", 0.6, &CloudBooleanRun::Combine }, { "Snap seam", 0.75, &CloudBooleanRun::Snap },
      { "Trace seam", 0.85, &CloudBooleanRun::Trace },
      { "Sort samples", 0.88, &CloudBooleanRun::SortSamples },
      { "Measure", 0.95, &CloudBooleanRun::Measure } };
    for (const auto& step : steps)
    {
      this->Watch.Progress(step.Progress, step.Name);
      const auto start = std::chrono::steady_clock::now();
      (this->*step.Do)();
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      this->Result.Times.push_back({ step.Name, elapsed.count() });
      if (this->Watch.Aborted())
      {
        this->Result.Status = CloudBooleanStatus::Aborted;
      }
      if (this->Result.Status != CloudBooleanStatus::Ok)
      {
        break;
      }
    }
    return std::move(this->Result);
  }

private:
  void CheckTool()
  {
    this->Body = *this->Request.Tool;
    const sb::Surface mesh{ this->Body.Points.data(),
      static_cast<std::int64_t>(this->Body.Points.size() / 3), this->Body.Triangles.data(),
      static_cast<std::int64_t>(this->Body.Triangles.size() / 3) };
    const std::shared_ptr<const Examination> found = Examine(mesh, this->Threads);
    this->Result.ToolRemarks = found->Remarks;
    if (HasError(found->Remarks) || mesh.NumberOfTriangles == 0)
    {
      this->Result.Status = CloudBooleanStatus::BadTool;
    }
    else if (found->IsOpen)
    {
      this->Result.Status = CloudBooleanStatus::OpenTool;
    }
    this->Result.ToolVolume = std::abs(found->Report.Volume);
    for (std::size_t i = 0; found->IsInsideOut && i < this->Body.Triangles.size(); i += 3)
    {
      std::swap(this->Body.Triangles[i + 1], this->Body.Triangles[i + 2]);
    }
  }

  void MeshCloud()
  {
    this->Result.CloudMesh = this->Request.CloudMesh
      ? this->Request.CloudMesh
      : std::make_shared<const PointSurfaceMesh>(
          MeshPointSurface(this->Surface, this->Cell, this->Threads, this->Watch));
    this->Scan = *this->Result.CloudMesh;
    switch (this->Scan.End)
    {
      case PointSurfaceMesh::Ending::TooFine:
        this->Result.Status = CloudBooleanStatus::TooFine;
        break;
      case PointSurfaceMesh::Ending::Aborted:
        this->Result.Status = CloudBooleanStatus::Aborted;
        break;
      default:
        this->Result.Status =
          this->Scan.Triangles.empty() ? CloudBooleanStatus::NoSurface : CloudBooleanStatus::Ok;
    }
  }

  /** Leave specks of noise out, and look whether the rest encloses something. */
  void CheckCloud()
  {
    this->Result.ScanIsOpen = this->Scan.NumberOfBorderEdges > 0;
    const MeshParts parts = FindParts(this->Scan.Points, this->Scan.Triangles);
    double largest = 0.0;
    for (const MeshPart& part : parts.Parts)
    {
      largest = std::max(largest, part.Diagonal());
      this->Result.CloudVolume += part.Volume;
    }
    const double speck = std::min(SpeckInCells * this->Cell, 0.5 * largest);
    std::vector<std::int32_t> kept;
    for (std::size_t t = 0; t < parts.PartOfTriangle.size(); ++t)
    {
      if (parts.Parts[static_cast<std::size_t>(parts.PartOfTriangle[t])].Diagonal() > speck)
      {
        kept.insert(kept.end(), this->Scan.Triangles.begin() + 3 * static_cast<std::ptrdiff_t>(t),
          this->Scan.Triangles.begin() + 3 * static_cast<std::ptrdiff_t>(t) + 3);
      }
    }
    this->Result.NumberOfSpecks = std::count_if(parts.Parts.begin(), parts.Parts.end(),
      [speck](const MeshPart& part) { return part.Diagonal() <= speck; });
    this->Scan.Triangles.swap(kept);
    if (!this->Result.ScanIsOpen && !this->IsRightSideOut(parts, speck))
    {
      this->Result.Status = CloudBooleanStatus::InsideOut;
    }
  }

  sb::Surface ScanMesh() const
  {
    return { this->Scan.Points.data(), static_cast<std::int64_t>(this->Scan.Points.size() / 3),
      this->Scan.Triangles.data(), static_cast<std::int64_t>(this->Scan.Triangles.size() / 3) };
  }

  /** Whether a closed scan has winding number 1 behind itself everywhere. A part that is inside out
   * can only be a cavity in another one. */
  bool IsRightSideOut(const MeshParts& parts, double speck) const
  {
    const auto isInsideOut = [speck](const MeshPart& part) {
      return part.Volume < 0.0 && part.Diagonal() > speck;
    };
    if (this->Result.CloudVolume <= 0.0)
    {
      return false;
    }
    if (std::none_of(parts.Parts.begin(), parts.Parts.end(), isInsideOut))
    {
      return true;
    }
    NearestTriangle tree;
    tree.Build(this->ScanMesh(), this->Threads);
    FastWinding winding;
    winding.Build(tree, this->Threads);
    return std::all_of(parts.Parts.begin(), parts.Parts.end(), [&](const MeshPart& part) {
      return !isInsideOut(part) || winding.At(this->JustBehind(part.FirstPoint)) > 0.5;
    });
  }

  Vector3 JustBehind(std::int32_t point) const
  {
    const double* const p = this->Scan.Points.data() + 3 * static_cast<std::size_t>(point);
    const double* const n = this->Scan.Normals.data() + 3 * static_cast<std::size_t>(point);
    return { p[0] - this->Spacing * n[0], p[1] - this->Spacing * n[1],
      p[2] - this->Spacing * n[2] };
  }

  void RefineTool()
  {
    RefinementRequest request;
    request.Near = this->Cell;
    request.LongestEdge = this->Cell;
    request.ChordError = ChordInSpacings * this->Spacing;
    RefinedSurface refined =
      RefineNearCloud(this->Body, this->Surface.Samples(), request, this->Threads, this->Watch);
    if (refined.Status == RefinementStatus::TooLarge)
    {
      this->Result.Status = CloudBooleanStatus::TooFine;
      return;
    }
    this->Body = std::move(refined.Surface);
    this->OriginalOfTool = std::move(refined.Original);
    this->Tool.emplace(this->Body, this->Threads);
  }

  void RefineCloud()
  {
    RefineNearTool(this->Scan, this->Surface, *this->Tool, this->Cell, this->Threads, this->Watch);
  }

  void Combine()
  {
    if (this->Result.ScanIsOpen)
    {
      this->CombineOpen();
    }
    else
    {
      this->CombineClosed();
    }
    this->Snapping = { &this->Surface, &this->Scan.Normals, this->ScanMesh(), &*this->Tool,
      this->Spacing };
  }

  void CombineClosed()
  {
    const bool reverse = this->Request.Op == CloudOperation::ReverseDifference;
    const auto isDifference = reverse || this->Request.Op == CloudOperation::Difference;
    BooleanRequest request;
    request.Operands.push_back({ this->ScanMesh(), reverse ? Group::Tool : Group::Input, nullptr });
    request.Operands.push_back(
      { this->Tool->Mesh(), reverse ? Group::Input : Group::Tool, nullptr });
    request.Op = isDifference                     ? Operation::Difference
      : this->Request.Op == CloudOperation::Union ? Operation::Union
                                                  : Operation::Intersection;
    BooleanResult found = ComputeBoolean(request, SeamPoints::Shared, this->Threads, this->Watch);
    if (!this->Accept(found.Condition))
    {
      return;
    }
    this->Result.Mesh = sb::Combine(
      { { &found, 0, nullptr, nullptr, false }, { &found, 1, nullptr, nullptr, false } },
      { this->ScanMesh(), this->Tool->Mesh() }, this->Threads);
    this->Curves = std::move(found.Intersection);
  }

  void CombineOpen()
  {
    OpenScanResult found = CombineOpenScan(
      this->Surface, this->ScanMesh(), *this->Tool, this->Request.Op, this->Threads, this->Watch);
    if (!this->Accept(found.Condition))
    {
      return;
    }
    this->Result.Confidence = found.LeastConfidence;
    if (found.LeastWinding < LeastWindingOfScan)
    {
      this->Result.Status = CloudBooleanStatus::InsideOut;
    }
    this->Result.Mesh = std::move(found.Mesh);
    this->Curves = std::move(found.Seam);
  }

  bool Accept(Status condition)
  {
    if (condition == Status::TooLarge)
    {
      this->Result.Status = CloudBooleanStatus::TooLarge;
    }
    else if (IsError(condition))
    {
      this->Result.Status =
        condition == Status::Aborted ? CloudBooleanStatus::Aborted : CloudBooleanStatus::BadTool;
    }
    return this->Result.Status == CloudBooleanStatus::Ok;
  }

  void Snap()
  {
    this->Snapped = SnapSeam(this->Result.Mesh, this->Snapping, this->Threads, this->Watch);
    this->Before = std::move(this->Result.Mesh);
    this->Result.Mesh = this->Snapped.Mesh;
    this->Result.LargestResidual = this->Snapped.LargestResidual;
    this->Result.Errors.Seam = this->Snapped.LargestResidual;
    this->Result.NumberOfBackedOff = this->Snapped.NumberOfBackedOff;
    this->Result.NumberOfSnapped =
      static_cast<std::int64_t>(this->Snapped.Vertices.size()) - this->Snapped.NumberOfBackedOff;
    this->Result.NumberOfCrossings = this->Snapped.NumberOfCrossings;
    const auto tangent = std::count_if(this->Snapped.Vertices.begin(), this->Snapped.Vertices.end(),
      [](const SeamVertex& v) { return v.Tangency > Tangent; });
    this->Result.TangentShare = static_cast<double>(tangent) /
      static_cast<double>(std::max<std::size_t>(1, this->Snapped.Vertices.size()));
  }

  void Trace()
  {
    this->Result.Seam =
      TraceSeam(this->Curves, this->Before, this->Snapped, this->Snapping, this->Threads);
    this->Result.Errors.Chord = this->Result.Seam.LargestChordError;
    for (std::size_t i = 0; this->Body.HasPatches() && i < this->Result.Seam.Points.size(); ++i)
    {
      this->Result.SeamUV.push_back(
        this->ParametersOf(this->Result.Seam.Triangle[i], this->Result.Seam.Points[i]));
    }
  }

  /** u and v of the place of the triangle's patch that is nearest to a place of the triangle. */
  std::array<double, 2> ParametersOf(std::int32_t triangle, const Real3& place) const
  {
    const std::array<double, 2> start = this->Tool->ParametersOf(triangle, place);
    const PlaceOnPatch found =
      ClosestOnPatchFrom(this->Tool->PatchOf(triangle), place, start[0], start[1]);
    return { found.U, found.V };
  }

  void SortSamples()
  {
    const bool inside = this->Request.Op == CloudOperation::Intersection ||
      this->Request.Op == CloudOperation::ReverseDifference;
    this->Result.KeptSamples =
      FindInside(this->Surface.Samples(), *this->Tool, this->Threads, this->Watch);
    for (std::uint8_t& kept : this->Result.KeptSamples)
    {
      kept = (kept != 0) == inside ? 1 : 0;
    }
  }

  void Measure()
  {
    this->FindSides();
    this->FillTriangles();
    this->FillNormals();
    this->FillResiduals();
    this->Result.NumberOfBorderEdges =
      CountBorderEdges(this->Result.Mesh.Triangles, this->Result.Mesh.OriginalPoint.size());
    this->CountFlipped();
    if (this->Body.HasPatches())
    {
      this->SeparateFaces();
    }
    if (this->Request.WithNearestSamples)
    {
      this->FindNearestSamples();
    }
    this->MeasureErrors();
  }

  void FindSides()
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    this->Result.Sides.assign(mesh.OriginalPoint.size(), 0);
    for (std::size_t corner = 0; corner < mesh.Triangles.size(); ++corner)
    {
      this->Result.Sides[static_cast<std::size_t>(mesh.Triangles[corner])] |=
        static_cast<std::uint8_t>(mesh.Source[corner / 3] == 0 ? 1 : 2);
    }
  }

  void FillTriangles()
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    for (std::size_t t = 0; t < mesh.Source.size(); ++t)
    {
      const bool ofTool = mesh.Source[t] != 0;
      const std::size_t parent = static_cast<std::size_t>(mesh.Parent[t]);
      this->Result.ToolTriangle.push_back(ofTool ? this->OriginalOfTool[parent] : -1);
      if (this->Body.HasPatches())
      {
        this->Result.FaceId.push_back(ofTool ? this->Body.FaceId[parent] : -1);
      }
    }
  }

  /** Those of the function where the cloud is, else the mean over the triangles by their areas. */
  void FillNormals()
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    std::vector<double>& normals = this->Result.Normals;
    normals.assign(mesh.Points.size(), 0.0);
    Real3 apex = mesh.OriginalPoint.empty() ? Real3{} : mesh.Point(0);
    for (std::int32_t t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      const std::int32_t* const ids = mesh.Corners(t);
      const Real3 a = mesh.Point(ids[0]);
      const Real3 turn =
        Cross(Difference(mesh.Point(ids[1]), a), Difference(mesh.Point(ids[2]), a));
      this->Result.Volume += Dot(Difference(a, apex), turn) / 6.0;
      this->Result.Area += 0.5 * Length(turn);
      for (int k = 0; k < 3; ++k)
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          normals[3 * static_cast<std::size_t>(ids[k]) + axis] += turn[axis];
        }
      }
    }
    const double sign = this->Request.Op == CloudOperation::ReverseDifference ? -1.0 : 1.0;
    this->ForPoints([&](std::size_t i, auto& near) {
      Real3 normal{ normals[3 * i], normals[3 * i + 1], normals[3 * i + 2] };
      const std::int32_t original =
        mesh.PointSource[i] == 0 && this->Result.Sides[i] == 1 ? mesh.OriginalPoint[i] : -1;
      if (original >= 0)
      {
        const double* const n = this->Scan.Normals.data() + 3 * static_cast<std::size_t>(original);
        normal = Scaled({ n[0], n[1], n[2] }, sign);
      }
      else if (this->Result.Sides[i] & 1)
      {
        normal = Scaled(
          this->Surface.EvaluateAt(mesh.Point(static_cast<std::int32_t>(i)), 1, near).Gradient,
          sign);
      }
      const double length = Length(normal);
      normal = length > 0.0 ? Scaled(normal, 1.0 / length) : normal;
      std::copy_n(normal.begin(), 3, normals.begin() + 3 * static_cast<std::ptrdiff_t>(i));
    });
  }

  template <class Body>
  void ForPoints(const Body& body)
  {
    this->Threads.For(
      this->Result.Mesh.NumberOfPoints(), Grain, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::int64_t i = begin; i < end; ++i)
        {
          body(static_cast<std::size_t>(i), near);
        }
      });
  }

  /** The cloud's own vertices are zeros of the function to 1e-7 of a spacing. */
  void FillResiduals()
  {
    this->Result.Residuals.resize(this->Result.Sides.size());
    std::transform(this->Result.Sides.begin(), this->Result.Sides.end(),
      this->Result.Residuals.begin(), [](std::uint8_t side) { return side == 2 ? None : 0.0; });
    for (const SeamVertex& vertex : this->Snapped.Vertices)
    {
      this->Result.Residuals[static_cast<std::size_t>(vertex.Point)] = vertex.Residual;
    }
  }

  /** Give each face of the tool, and the cloud, points of their own. */
  void SeparateFaces()
  {
    FacePoints found = FindFacePoints(this->Result.Mesh, *this->Tool);
    for (const std::int32_t point : found.Repeated)
    {
      this->RepeatPoint(static_cast<std::size_t>(point));
    }
    this->Result.Mesh.Triangles.swap(found.Triangles);
    this->FillParameters(found);
  }

  void RepeatPoint(std::size_t point)
  {
    CombinedMesh& mesh = this->Result.Mesh;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      mesh.Points.push_back(mesh.Points[3 * point + axis]);
      this->Result.Normals.push_back(this->Result.Normals[3 * point + axis]);
    }
    mesh.OriginalPoint.push_back(mesh.OriginalPoint[point]);
    mesh.PointSource.push_back(mesh.PointSource[point]);
    this->Result.Sides.push_back(this->Result.Sides[point]);
    this->Result.Residuals.push_back(this->Result.Residuals[point]);
  }

  /** u, v and the normal of the patch, of points that belong to one face each. */
  void FillParameters(const FacePoints& found)
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    this->Result.UV.assign(2 * mesh.OriginalPoint.size(), None);
    this->ForPoints([&](std::size_t i, auto&) {
      const std::int32_t triangle = found.TriangleOnFace[i];
      if (triangle < 0)
      {
        return;
      }
      const NURBSSurface& patch =
        this->Tool->PatchOf(mesh.Parent[static_cast<std::size_t>(triangle)]);
      std::array<double, 2> uv = found.UV[i];
      if (!found.IsExact[i]) // at a pole there is more than one answer
      {
        const PlaceOnPatch place =
          ClosestOnPatchFrom(patch, mesh.Point(static_cast<std::int32_t>(i)), uv[0], uv[1]);
        uv = { place.U, place.V };
      }
      std::copy_n(uv.begin(), 2, this->Result.UV.begin() + 2 * static_cast<std::ptrdiff_t>(i));
      const PatchPoint on = EvaluatePatch(patch, uv[0], uv[1], 1);
      const Real3 across = Cross(on.Du, on.Dv);
      const double length = Length(across);
      const Real3 front = this->FrontOf(triangle);
      if (length > 0.0)
      {
        const Real3 normal = Scaled(across, (Dot(across, front) < 0.0 ? -1.0 : 1.0) / length);
        std::copy_n(
          normal.begin(), 3, this->Result.Normals.begin() + 3 * static_cast<std::ptrdiff_t>(i));
      }
    });
  }

  /** The direction that a triangle of the result has to face. */
  Real3 FrontOf(std::int32_t triangle) const
  {
    return FrontOfTriangle(this->Result.Mesh, triangle, this->Snapping);
  }

  void CountFlipped()
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    for (std::int32_t t = 0; t < mesh.NumberOfTriangles(); ++t)
    {
      const std::int32_t* const ids = mesh.Corners(t);
      const Real3 a = mesh.Point(ids[0]);
      const Real3 turn =
        Cross(Difference(mesh.Point(ids[1]), a), Difference(mesh.Point(ids[2]), a));
      this->Result.NumberOfFlipped += Dot(turn, this->FrontOf(t)) < 0.0 ? 1 : 0;
    }
  }

  std::int32_t SampleNearestTo(const Real3& place) const
  {
    const PointTree& samples = this->Surface.Samples();
    PointTree::Neighbour nearest;
    return samples.Nearest(place, 1, &nearest) == 1 ? samples.Id(nearest.Index) : -1;
  }

  void FindNearestSamples()
  {
    const CombinedMesh& mesh = this->Result.Mesh;
    this->Result.NearestSample.assign(mesh.OriginalPoint.size(), -1);
    this->ForPoints([&](std::size_t i, auto&) {
      if (this->Result.Sides[i] & 1)
      {
        this->Result.NearestSample[i] =
          this->SampleNearestTo(mesh.Point(static_cast<std::int32_t>(i)));
      }
    });
    for (const Real3& place : this->Result.Seam.Points)
    {
      this->Result.SeamSample.push_back(this->SampleNearestTo(place));
    }
  }

  /** The largest, or the root of the mean square, of a length at `Probes` of `count` places. */
  template <class Body>
  std::vector<double> Probe(std::size_t count, const Body& body)
  {
    const std::size_t number = std::min(count, Probes);
    std::vector<double> values(number, 0.0);
    this->Threads.For(
      static_cast<std::int64_t>(number), 64, [&](std::int64_t begin, std::int64_t end) {
        MovingLeastSquares::Neighbourhood near;
        for (std::size_t i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end);
             ++i)
        {
          values[i] = body(count * i / number, near);
        }
      });
    return values;
  }

  double DistanceToScan(const Real3& place, MovingLeastSquares::Neighbourhood& near) const
  {
    const SurfaceValue f = this->Surface.EvaluateAt(place, 1, near);
    const double steepness = Length(f.Gradient);
    return f.IsNear && steepness > 0.0 ? std::abs(f.Value) / steepness : 0.0;
  }

  void MeasureErrors()
  {
    const PointTree& samples = this->Surface.Samples();
    const std::vector<double> residuals =
      this->Probe(static_cast<std::size_t>(samples.Size()), [&](std::size_t i, auto& near) {
        return this->DistanceToScan(samples.Point(static_cast<std::int32_t>(i)), near);
      });
    double squares = 0.0;
    for (const double residual : residuals)
    {
      squares += residual * residual;
    }
    const double sigma = std::sqrt(squares / static_cast<double>(residuals.size()));
    this->Result.Errors.Noise =
      sigma * this->Spacing / (this->Surface.Width() * std::sqrt(2.0 * Pi));
    const std::vector<double> facets =
      this->Probe(this->Scan.Triangles.size() / 3, [&](std::size_t t, auto& near) {
        Real3 sum{};
        for (std::size_t k = 0; k < 3; ++k)
        {
          const double* const p = this->Scan.Points.data() +
            3 * static_cast<std::size_t>(this->Scan.Triangles[3 * t + k]);
          sum = PlusScaled(sum, 1.0 / 3.0, { p[0], p[1], p[2] });
        }
        return this->DistanceToScan(sum, near);
      });
    this->Result.Errors.Facet = *std::max_element(facets.begin(), facets.end());
    if (this->Body.HasPatches())
    {
      const std::vector<double> tool = this->Probe(
        this->Body.Triangles.size() / 3, [&](std::size_t t, auto&) { return this->Deflection(t); });
      this->Result.Errors.Tool = *std::max_element(tool.begin(), tool.end());
    }
  }

  /** From the middle of a facet to its patch, at the mean of u and v. */
  double Deflection(std::size_t triangle) const
  {
    Real3 middle{};
    double u = 0.0;
    double v = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t id = static_cast<std::size_t>(this->Body.Triangles[3 * triangle + k]);
      const double* const p = this->Body.Points.data() + 3 * id;
      middle = PlusScaled(middle, 1.0 / 3.0, { p[0], p[1], p[2] });
      u += this->Body.UV[2 * id] / 3.0;
      v += this->Body.UV[2 * id + 1] / 3.0;
    }
    const NURBSSurface& patch =
      this->Body.Patches[static_cast<std::size_t>(this->Body.FaceId[triangle])];
    const PatchPoint on = EvaluatePatch(patch, u, v, 1);
    const Real3 normal = Cross(on.Du, on.Dv);
    const double length = Length(normal);
    return length > 0.0 ? std::abs(Dot(Difference(middle, on.Point), normal)) / length : 0.0;
  }

  const CloudBooleanRequest& Request;
  const MovingLeastSquares& Surface;
  const double Spacing;
  const double Cell;
  Executor& Threads;
  Monitor& Watch;
  DesignedSurface Body;
  std::vector<std::int32_t> OriginalOfTool;
  std::optional<ToolSurface> Tool;
  PointSurfaceMesh Scan;
  sb::Curves Curves;
  SeamSnapRequest Snapping;
  SeamSnap Snapped;
  CombinedMesh Before; ///< the mesh that was snapped
  CloudBooleanResult Result;
};

} // namespace

CloudBooleanResult ComputeCloudBoolean(
  const CloudBooleanRequest& request, Executor& executor, Monitor& monitor)
{
  return CloudBooleanRun(request, executor, monitor).Run();
}

} // namespace sb

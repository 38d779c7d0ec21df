// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeFacets.h"

#include "ClosestOnPatch.h"
#include "FaceSurface.h"
#include "PatchTurning.h"
#include "PointTree.h"
#include "PoleParameters.h"
#include "SurfaceRefinement.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Message_ProgressScope.hxx>
#include <NCollection_DataMap.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

namespace sbvtk
{
namespace
{

using sb::Real3;

constexpr double largestTurn = 0.5; // of an edge at a corner, in radians: small holes stay round
constexpr double coarse = 3e-3; // of the diagonal

struct MeshedFace
{
  TopoDS_Face Face;
  std::int32_t Solid = -1;
  Handle(Poly_Triangulation) Triangles{};
  TopLoc_Location Place{};
};

/** All faces; those of a closed shell are of a solid, too. */
class FaceList
{
public:
  explicit FaceList(const TopoDS_Shape& shape)
  {
    for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next())
    {
      this->Add(solid.Current(), this->NumberOfSolids++);
    }
    for (TopExp_Explorer shell(shape, TopAbs_SHELL, TopAbs_SOLID); shell.More(); shell.Next())
    {
      this->Add(
        shell.Current(), BRep_Tool::IsClosed(shell.Current()) ? this->NumberOfSolids++ : -1);
    }
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SHELL); face.More(); face.Next())
    {
      this->Add(face.Current(), -1);
    }
  }

  std::vector<MeshedFace> Faces;
  std::int32_t NumberOfSolids = 0;

private:
  void Add(const TopoDS_Shape& part, std::int32_t solid)
  {
    for (TopExp_Explorer face(part, TopAbs_FACE); face.More(); face.Next())
    {
      MeshedFace meshed;
      meshed.Face = TopoDS::Face(face.Current());
      meshed.Solid = solid;
      meshed.Triangles = BRep_Tool::Triangulation(meshed.Face, meshed.Place);
      this->Faces.push_back(meshed);
    }
  }
};

Real3 PointOf(const gp_Pnt& point) { return { point.X(), point.Y(), point.Z() }; }

Real3 PointAt(const std::vector<double>& points, std::int32_t i)
{
  const double* x = points.data() + 3 * static_cast<std::ptrdiff_t>(i);
  return { x[0], x[1], x[2] };
}

/** Which points the ends and the inner points of edges have, whichever face comes first. */
class SharedPoints
{
public:
  /** Give the points of a face's edges, at `points`, the coordinates that other faces gave them. */
  void Share(const MeshedFace& face, Real3* points)
  {
    for (TopExp_Explorer edges(face.Face, TopAbs_EDGE); edges.More(); edges.Next())
    {
      const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
      const Handle(Poly_PolygonOnTriangulation) polygon =
        BRep_Tool::PolygonOnTriangulation(edge, face.Triangles, face.Place);
      if (!polygon.IsNull())
      {
        this->ShareInner(edge, *polygon, points);
        this->ShareEnds(edge, *polygon, points);
      }
    }
  }

private:
  void ShareInner(
    const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon, Real3* points)
  {
    const int count = polygon.NbNodes();
    if (const std::vector<Real3>* known = this->OfEdge.Seek(edge))
    {
      for (int i = 2; i < count && static_cast<int>(known->size()) == count; ++i)
      {
        points[polygon.Node(i) - 1] = (*known)[static_cast<std::size_t>(i - 1)];
      }
      return;
    }
    std::vector<Real3> own;
    for (int i = 1; i <= count; ++i)
    {
      own.push_back(points[polygon.Node(i) - 1]);
    }
    this->OfEdge.Bind(edge, own);
  }

  void ShareEnds(const TopoDS_Edge& edge, const Poly_PolygonOnTriangulation& polygon, Real3* points)
  {
    // The polygon runs along the edge as it is when forward.
    TopoDS_Vertex first;
    TopoDS_Vertex last;
    TopExp::Vertices(TopoDS::Edge(edge.Oriented(TopAbs_FORWARD)), first, last);
    this->ShareEnd(first, points[polygon.Node(1) - 1]);
    this->ShareEnd(last, points[polygon.Node(polygon.NbNodes()) - 1]);
  }

  void ShareEnd(const TopoDS_Vertex& vertex, Real3& point)
  {
    if (vertex.IsNull())
    {
      return;
    }
    if (const Real3* known = this->OfVertex.Seek(vertex))
    {
      point = *known;
      return;
    }
    this->OfVertex.Bind(vertex, point);
  }

  NCollection_DataMap<TopoDS_Shape, std::vector<Real3>, TopTools_ShapeMapHasher> OfEdge;
  NCollection_DataMap<TopoDS_Shape, Real3, TopTools_ShapeMapHasher> OfVertex;
};

/** Facets of faces, put after one another. */
class Assembly
{
public:
  Assembly(ShapeFacets& result, sb::Executor& executor)
    : Result(result)
    , Executor(executor)
  {
  }

  void Add(const MeshedFace& face)
  {
    FaceSurface surface = MakeFaceSurface(face.Face, this->UsedParameters(face));
    this->Result.NumberOfApproximations += surface.IsExact ? 0 : 1;
    const bool turned = face.Face.Orientation() == TopAbs_REVERSED;
    this->AddPoints(face, surface);
    this->AddTriangles(face, turned);
    if (turned)
    {
      surface.Patch = sb::Turned(surface.Patch);
      std::vector<double>& uv = this->Result.Surface.UV;
      for (std::size_t i = 2 * static_cast<std::size_t>(this->FirstPoint); i < uv.size(); i += 2)
      {
        std::swap(uv[i], uv[i + 1]);
      }
    }
    this->Result.Surface.Patches.push_back(std::move(surface.Patch));
    this->Result.SolidOfFace.push_back(face.Solid);
    this->Result.Faces.push_back(face.Face);
  }

private:
  ParameterBox UsedParameters(const MeshedFace& face) const
  {
    ParameterBox box;
    BRepTools::UVBounds(face.Face, box.FirstU, box.LastU, box.FirstV, box.LastV);
    for (int i = 1; i <= face.Triangles->NbNodes(); ++i)
    {
      const gp_Pnt2d node = face.Triangles->UVNode(i);
      box.Add(node.X(), node.Y());
    }
    return box;
  }

  void AddPoints(const MeshedFace& face, const FaceSurface& surface)
  {
    const std::size_t count = static_cast<std::size_t>(face.Triangles->NbNodes());
    std::vector<Real3> points(count);
    std::vector<double> uv(2 * count);
    for (std::size_t i = 0; i < count; ++i)
    {
      const int node = static_cast<int>(i) + 1;
      points[i] = PointOf(face.Triangles->Node(node).Transformed(face.Place.Transformation()));
      uv[2 * i] = face.Triangles->UVNode(node).X();
      uv[2 * i + 1] = face.Triangles->UVNode(node).Y();
    }
    this->Shared.Share(face, points.data());
    this->Executor.For(
      static_cast<std::int64_t>(count), 64, [&](std::int64_t from, std::int64_t to) {
        for (std::size_t i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
        {
          this->Place(surface, points[i], uv[2 * i], uv[2 * i + 1]);
        }
      });
    sb::DesignedSurface& all = this->Result.Surface;
    this->FirstPoint = static_cast<std::int32_t>(all.Points.size() / 3);
    for (std::size_t i = 0; i < count; ++i)
    {
      all.Points.insert(all.Points.end(), points[i].begin(), points[i].end());
    }
    all.UV.insert(all.UV.end(), uv.begin(), uv.end());
  }

  /** The patch's parameters for a point, from those of its face. */
  void Place(const FaceSurface& surface, const Real3& point, double& u, double& v) const
  {
    surface.Near(u, v);
    const Real3 there = sb::EvaluatePatch(surface.Patch, u, v, 0).Point;
    if (sb::Length(sb::Difference(there, point)) > 1e-15 * this->Result.Diagonal)
    {
      const sb::PlaceOnPatch nearest = sb::ClosestOnPatchFrom(surface.Patch, point, u, v);
      u = nearest.U;
      v = nearest.V;
    }
  }

  void AddTriangles(const MeshedFace& face, bool turned)
  {
    sb::DesignedSurface& all = this->Result.Surface;
    const std::int32_t id = static_cast<std::int32_t>(all.Patches.size());
    for (int i = 1; i <= face.Triangles->NbTriangles(); ++i)
    {
      int a = 0;
      int b = 0;
      int c = 0;
      face.Triangles->Triangle(i).Get(a, b, c);
      if (turned)
      {
        std::swap(b, c);
      }
      const std::int32_t corners[3] = { this->FirstPoint + a - 1, this->FirstPoint + b - 1,
        this->FirstPoint + c - 1 };
      const Real3 points[3] = { PointAt(all.Points, corners[0]), PointAt(all.Points, corners[1]),
        PointAt(all.Points, corners[2]) };
      // At the pole of a sphere a face has many points in one place.
      if (points[0] != points[1] && points[1] != points[2] && points[2] != points[0])
      {
        all.Triangles.insert(all.Triangles.end(), corners, corners + 3);
        all.FaceId.push_back(id);
      }
    }
  }

  ShapeFacets& Result;
  sb::Executor& Executor;
  SharedPoints Shared;
  std::int32_t FirstPoint = 0; // of the current face
};

/** How far the patch is from the plane of a facet, at the middles of its edges and of itself. */
double ChordErrorOf(const sb::DesignedSurface& surface, std::size_t triangle)
{
  const sb::NURBSSurface& patch =
    surface.Patches[static_cast<std::size_t>(surface.FaceId[triangle])];
  const std::int32_t* corners = surface.Triangles.data() + 3 * triangle;
  const Real3 a = PointAt(surface.Points, corners[0]);
  const Real3 b = PointAt(surface.Points, corners[1]);
  const Real3 c = PointAt(surface.Points, corners[2]);
  const Real3 across = sb::Cross(sb::Difference(b, a), sb::Difference(c, a));
  const double area = sb::Length(across);
  if (!(area > 0.0))
  {
    return 0.0;
  }
  constexpr double shares[4][3] = { { 0.5, 0.5, 0.0 }, { 0.0, 0.5, 0.5 }, { 0.5, 0.0, 0.5 },
    { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } };
  double largest = 0.0;
  for (const auto& share : shares)
  {
    double u = 0.0;
    double v = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      u += share[k] * surface.UV[2 * static_cast<std::size_t>(corners[k])];
      v += share[k] * surface.UV[2 * static_cast<std::size_t>(corners[k]) + 1];
    }
    const Real3 there = sb::EvaluatePatch(patch, u, v, 0).Point;
    largest = std::max(largest, std::abs(sb::Dot(sb::Difference(there, a), across)) / area);
  }
  return largest;
}

/** The largest of measure(i) for i below count. */
double Largest(
  std::size_t count, sb::Executor& executor, const std::function<double(std::size_t)>& measure)
{
  std::vector<double> values(count);
  executor.For(static_cast<std::int64_t>(count), 256, [&](std::int64_t from, std::int64_t to) {
    for (std::size_t i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
    {
      values[i] = measure(i);
    }
  });
  return count == 0 ? 0.0 : *std::max_element(values.begin(), values.end());
}

/** Which patch each point is on; -1: it is in no facet. */
std::vector<std::int32_t> FacesOfPoints(const sb::DesignedSurface& surface)
{
  std::vector<std::int32_t> faces(surface.Points.size() / 3, -1);
  for (std::size_t corner = 0; corner < surface.Triangles.size(); ++corner)
  {
    faces[static_cast<std::size_t>(surface.Triangles[corner])] = surface.FaceId[corner / 3];
  }
  return faces;
}

void MeasureErrors(ShapeFacets& facets, sb::Executor& executor)
{
  const sb::DesignedSurface& surface = facets.Surface;
  const std::vector<std::int32_t> faces = FacesOfPoints(surface);
  facets.LargestChordError = Largest(surface.FaceId.size(), executor,
    [&surface](std::size_t triangle) { return ChordErrorOf(surface, triangle); });
  facets.LargestGap = Largest(faces.size(), executor, [&](std::size_t i) {
    if (faces[i] < 0)
    {
      return 0.0;
    }
    const sb::NURBSSurface& patch = surface.Patches[static_cast<std::size_t>(faces[i])];
    const Real3 there = sb::EvaluatePatch(patch, surface.UV[2 * i], surface.UV[2 * i + 1], 0).Point;
    return sb::Length(sb::Difference(there, PointAt(surface.Points, static_cast<std::int32_t>(i))));
  });
}

/** Points in no facet, such as those between facets without area at a pole, are taken out. */
void DropUnusedPoints(sb::DesignedSurface& surface)
{
  const std::vector<std::int32_t> faces = FacesOfPoints(surface);
  std::vector<std::int32_t> numbers(faces.size(), -1);
  std::size_t count = 0;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i] >= 0)
    {
      std::copy_n(surface.Points.data() + 3 * i, 3, surface.Points.data() + 3 * count);
      std::copy_n(surface.UV.data() + 2 * i, 2, surface.UV.data() + 2 * count);
      numbers[i] = static_cast<std::int32_t>(count++);
    }
  }
  surface.Points.resize(3 * count);
  surface.UV.resize(2 * count);
  for (std::int32_t& corner : surface.Triangles)
  {
    corner = numbers[static_cast<std::size_t>(corner)];
  }
}

/** The sums of the areas of the facets around each point, as vectors. */
std::vector<Real3> FacetNormals(const sb::DesignedSurface& surface)
{
  std::vector<Real3> sums(surface.Points.size() / 3);
  for (std::size_t i = 0; i < surface.Triangles.size(); i += 3)
  {
    const std::int32_t* corners = surface.Triangles.data() + i;
    const Real3 a = PointAt(surface.Points, corners[0]);
    const Real3 across = sb::Cross(sb::Difference(PointAt(surface.Points, corners[1]), a),
      sb::Difference(PointAt(surface.Points, corners[2]), a));
    for (int k = 0; k < 3; ++k)
    {
      Real3& sum = sums[static_cast<std::size_t>(corners[k])];
      sum = sb::PlusScaled(sum, 1.0, across);
    }
  }
  return sums;
}

/** Those of the patches; at the pole of a sphere, where a patch has none, those of the facets. */
void AddNormals(ShapeFacets& facets)
{
  const sb::DesignedSurface& surface = facets.Surface;
  const std::vector<std::int32_t> faces = FacesOfPoints(surface);
  std::vector<Real3> normals = FacetNormals(surface);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i] >= 0)
    {
      const sb::PatchPoint at =
        sb::EvaluatePatch(surface.Patches[static_cast<std::size_t>(faces[i])], surface.UV[2 * i],
          surface.UV[2 * i + 1], 1);
      const Real3 across = sb::Cross(at.Du, at.Dv);
      const bool isKnown =
        sb::Length(across) > 1e-10 * (sb::Dot(at.Du, at.Du) + sb::Dot(at.Dv, at.Dv));
      normals[i] = isKnown ? across : normals[i];
    }
    const double length = sb::Length(normals[i]);
    const Real3 unit = length > 0.0 ? sb::Scaled(normals[i], 1.0 / length) : Real3{};
    facets.Normals.insert(facets.Normals.end(), unit.begin(), unit.end());
  }
}

/** Solids whose facets enclose less than nothing are turned over. */
void OrientSolids(ShapeFacets& facets)
{
  sb::DesignedSurface& surface = facets.Surface;
  std::vector<double> volumes(static_cast<std::size_t>(facets.NumberOfSolids), 0.0);
  for (std::size_t i = 0; i < surface.FaceId.size(); ++i)
  {
    const std::int32_t solid = facets.SolidOfFace[static_cast<std::size_t>(surface.FaceId[i])];
    if (solid >= 0)
    {
      const std::int32_t* corners = surface.Triangles.data() + 3 * i;
      const Real3 origin = PointAt(surface.Points, surface.Triangles.front());
      const Real3 a = sb::Difference(PointAt(surface.Points, corners[0]), origin);
      const Real3 b = sb::Difference(PointAt(surface.Points, corners[1]), origin);
      const Real3 c = sb::Difference(PointAt(surface.Points, corners[2]), origin);
      volumes[static_cast<std::size_t>(solid)] += sb::Dot(sb::Cross(a, b), c);
    }
  }
  std::vector<char> turned(facets.SolidOfFace.size());
  for (std::size_t face = 0; face < turned.size(); ++face)
  {
    const std::int32_t solid = facets.SolidOfFace[face];
    turned[face] = solid >= 0 && volumes[static_cast<std::size_t>(solid)] < 0.0;
    surface.Patches[face] =
      turned[face] ? sb::Turned(surface.Patches[face]) : surface.Patches[face];
  }
  std::vector<char> done(surface.Points.size() / 3);
  for (std::size_t i = 0; i < surface.FaceId.size(); ++i)
  {
    if (!turned[static_cast<std::size_t>(surface.FaceId[i])])
    {
      continue;
    }
    std::swap(surface.Triangles[3 * i + 1], surface.Triangles[3 * i + 2]);
    for (std::size_t corner = 3 * i; corner < 3 * i + 3; ++corner)
    {
      const std::size_t point = static_cast<std::size_t>(surface.Triangles[corner]);
      if (!done[point])
      {
        done[point] = 1;
        std::swap(surface.UV[2 * point], surface.UV[2 * point + 1]);
      }
    }
  }
}

/** Of a box that may be too large: it holds the poles of splines. */
double LooseDiagonal(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

double DiagonalOfNodes(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
  {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles =
      BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
    for (int i = 1; !triangles.IsNull() && i <= triangles->NbNodes(); ++i)
    {
      box.Add(triangles->Node(i).Transformed(place.Transformation()));
    }
  }
  return box.IsVoid() ? 0.0 : std::sqrt(box.SquareExtent());
}

std::int64_t Mesh(
  const TopoDS_Shape& shape, double deflection, const Message_ProgressRange& progress)
{
  BRepTools::Clean(shape);
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = largestTurn;
  const BRepMesh_IncrementalMesh mesh(shape, parameters, progress);
  std::int64_t count = 0;
  for (TopExp_Explorer face(shape, TopAbs_FACE); face.More(); face.Next())
  {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles =
      BRep_Tool::Triangulation(TopoDS::Face(face.Current()), place);
    count += triangles.IsNull() ? 0 : triangles->NbTriangles();
  }
  return count;
}

ShapeFacets Assemble(const TopoDS_Shape& shape, double diagonal, sb::Executor& executor)
{
  ShapeFacets facets;
  facets.Diagonal = diagonal;
  Assembly assembly(facets, executor);
  const FaceList list(shape);
  facets.NumberOfSolids = list.NumberOfSolids;
  for (const MeshedFace& face : list.Faces)
  {
    if (face.Triangles.IsNull() || !face.Triangles->HasUVNodes())
    {
      ++facets.NumberOfBareFaces;
      continue;
    }
    assembly.Add(face);
  }
  OrientSolids(facets);
  SetPoleParameters(facets.Surface, diagonal);
  MeasureErrors(facets, executor);
  return facets;
}

/** Whether so many facets of one bound would become too many with another: facets on curved faces
 * are as long as the root of the error, so their number grows as its inverse. */
bool IsTooFine(std::int64_t count, double bound, double next, std::int64_t mostTriangles)
{
  return static_cast<double>(count) * bound > static_cast<double>(mostTriangles) * next;
}

/** Cut the facets that are further from their patch than they may be. The refinement is made for
 * what is near a cloud; here everything is near. */
void Refine(ShapeFacets& facets, double bound, sb::Executor& executor, sb::Monitor& monitor)
{
  const double here[3] = { facets.Surface.Points[0], facets.Surface.Points[1],
    facets.Surface.Points[2] };
  sb::RefinementRequest request;
  request.Near = request.LongestEdge = 4.0 * facets.Diagonal;
  request.ChordError = 0.9 * bound; // it looks at fewer places than are measured here
  sb::RefinedSurface refined = sb::RefineNearCloud(
    facets.Surface, sb::PointTree(here, 1, nullptr, executor), request, executor, monitor);
  if (refined.Status == sb::RefinementStatus::Ok)
  {
    facets.Surface = std::move(refined.Surface);
    SetPoleParameters(facets.Surface, facets.Diagonal);
    MeasureErrors(facets, executor);
  }
}

} // namespace

ShapeFacets MakeShapeFacets(const TopoDS_Shape& shape, double chordError,
  std::int64_t mostTriangles, sb::Executor& executor, sb::Monitor& monitor,
  const Message_ProgressRange& progress)
{
  Message_ProgressScope scope(progress, "", 2);
  // First coarsely, to see how large the shape is and how many facets there would be.
  const double deflection = std::max(chordError, coarse) * LooseDiagonal(shape);
  ShapeFacets facets;
  if (!(deflection > 0.0))
  {
    return facets;
  }
  const std::int64_t count = Mesh(shape, deflection, scope.Next());
  const double diagonal = DiagonalOfNodes(shape);
  const double bound = chordError * diagonal;
  if (deflection > bound)
  {
    facets.IsTooFine = IsTooFine(count, deflection, bound, mostTriangles);
    if (facets.IsTooFine)
    {
      return facets;
    }
    Mesh(shape, bound, scope.Next());
  }
  facets = Assemble(shape, diagonal, executor);
  if (facets.LargestChordError > bound && scope.More())
  {
    Refine(facets, bound, executor, monitor);
  }
  DropUnusedPoints(facets.Surface);
  AddNormals(facets);
  return facets;
}

} // namespace sbvtk

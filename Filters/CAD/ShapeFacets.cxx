// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShapeFacets.h"

#include "ClosestOnPatch.h"
#include "FaceSurface.h"
#include "PatchTurning.h"

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
#include <utility>

namespace sbvtk
{
namespace
{

using sb::Real3;

constexpr double largestTurn = 0.5; // of an edge at a corner, in radians: small holes stay round
constexpr int mostRounds = 4;
constexpr double worthIt = 0.9; // what a round has to make of the error
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
    this->AddNormals(surface.Patch);
    this->Result.Surface.Patches.push_back(std::move(surface.Patch));
    this->Result.SolidOfFace.push_back(face.Solid);
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
    std::vector<double> gaps(count);
    this->Executor.For(
      static_cast<std::int64_t>(count), 64, [&](std::int64_t from, std::int64_t to) {
        for (std::size_t i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
        {
          gaps[i] = this->Place(surface, points[i], uv[2 * i], uv[2 * i + 1]);
        }
      });
    sb::DesignedSurface& all = this->Result.Surface;
    this->FirstPoint = static_cast<std::int32_t>(all.Points.size() / 3);
    for (std::size_t i = 0; i < count; ++i)
    {
      all.Points.insert(all.Points.end(), points[i].begin(), points[i].end());
      this->Result.LargestGap = std::max(this->Result.LargestGap, gaps[i]);
    }
    all.UV.insert(all.UV.end(), uv.begin(), uv.end());
  }

  /** The patch's parameters for a point, from those of its face; and how far off they are. */
  double Place(const FaceSurface& surface, const Real3& point, double& u, double& v) const
  {
    surface.Near(u, v);
    const double there =
      sb::Length(sb::Difference(sb::EvaluatePatch(surface.Patch, u, v, 0).Point, point));
    if (there <= 1e-15 * this->Result.Diagonal)
    {
      return there;
    }
    const sb::PlaceOnPatch nearest = sb::ClosestOnPatchFrom(surface.Patch, point, u, v);
    u = nearest.U;
    v = nearest.V;
    return nearest.Distance;
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

  void AddNormals(const sb::NURBSSurface& patch)
  {
    const sb::DesignedSurface& all = this->Result.Surface;
    for (std::size_t i = 2 * static_cast<std::size_t>(this->FirstPoint); i < all.UV.size(); i += 2)
    {
      const sb::PatchPoint at = sb::EvaluatePatch(patch, all.UV[i], all.UV[i + 1], 1);
      const Real3 across = sb::Cross(at.Du, at.Dv);
      const double size = sb::Length(across);
      const bool known = size > 1e-12 * sb::Dot(at.Du, at.Du) + 1e-12 * sb::Dot(at.Dv, at.Dv);
      const Real3 normal = known ? sb::Scaled(across, 1.0 / size) : Real3{};
      this->Result.Normals.insert(this->Result.Normals.end(), normal.begin(), normal.end());
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

double LargestChordError(const sb::DesignedSurface& surface, sb::Executor& executor)
{
  const std::size_t count = surface.FaceId.size();
  std::vector<double> errors(count);
  executor.For(static_cast<std::int64_t>(count), 256, [&](std::int64_t from, std::int64_t to) {
    for (std::size_t i = static_cast<std::size_t>(from); i < static_cast<std::size_t>(to); ++i)
    {
      errors[i] = ChordErrorOf(surface, i);
    }
  });
  return count == 0 ? 0.0 : *std::max_element(errors.begin(), errors.end());
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
        for (std::size_t k = 3 * point; k < 3 * point + 3; ++k)
        {
          facets.Normals[k] = -facets.Normals[k];
        }
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
  facets.LargestChordError = LargestChordError(facets.Surface, executor);
  return facets;
}

/** Whether so many facets of one bound would become too many with another: facets on curved faces
 * are as long as the root of the error, so their number grows as its inverse. */
bool IsTooFine(std::int64_t count, double bound, double next, std::int64_t mostTriangles)
{
  return static_cast<double>(count) * bound > static_cast<double>(mostTriangles) * next;
}

} // namespace

ShapeFacets MakeShapeFacets(const TopoDS_Shape& shape, double chordError,
  std::int64_t mostTriangles, sb::Executor& executor, const Message_ProgressRange& progress)
{
  Message_ProgressScope scope(progress, "", mostRounds + 1);
  // First coarsely, to see how large the shape is and how many facets there would be.
  double deflection = std::max(chordError, coarse) * LooseDiagonal(shape);
  ShapeFacets facets;
  if (!(deflection > 0.0))
  {
    return facets;
  }
  std::int64_t count = Mesh(shape, deflection, scope.Next());
  const double diagonal = DiagonalOfNodes(shape);
  const double bound = chordError * diagonal;
  if (deflection > bound)
  {
    if (IsTooFine(count, deflection, bound, mostTriangles))
    {
      facets.IsTooFine = true;
      return facets;
    }
    deflection = bound;
    count = Mesh(shape, deflection, scope.Next());
  }
  facets = Assemble(shape, diagonal, executor);
  for (int round = 1; round < mostRounds && scope.More() && facets.LargestChordError > bound;
       ++round)
  {
    const double next = deflection * std::clamp(0.8 * bound / facets.LargestChordError, 0.2, 0.8);
    if (IsTooFine(count, deflection, next, mostTriangles))
    {
      break;
    }
    deflection = next;
    count = Mesh(shape, deflection, scope.Next());
    ShapeFacets finer = Assemble(shape, diagonal, executor);
    if (finer.LargestChordError > worthIt * facets.LargestChordError)
    {
      break;
    }
    facets = std::move(finer);
  }
  return facets;
}

} // namespace sbvtk

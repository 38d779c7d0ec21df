// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "TrimmedFaces.h"

#include "DisjointSets.h"
#include "FaceLoops.h"
#include "FaceSurface.h"
#include "HalvedFaces.h"
#include "ShellSolids.h"

#include <BRep_Builder.hxx>
#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace sbvtk
{
namespace
{

constexpr double leastTolerance = 1e-7; // Open CASCADE's own: two points of a shape are one

class ShapeBuilder
{
public:
  explicit ShapeBuilder(const sb::DesignedSurface& surface)
    : Surface(surface)
    , Found(FindFaceLoops(surface))
    , FaceOfChain(Found.Chains.size(), -1)
  {
  }

  /** What has to be divided before it can be built (HalvedFaces.h). */
  std::vector<FaceToHalve> RoundFaces()
  {
    std::vector<FaceToHalve> found;
    this->MakeFaces();
    for (const Face& face : this->Faces)
    {
      const std::vector<std::int32_t> chains = this->OuterChains(face);
      if (face.Loops.size() > 1 && this->IsThereAndBack(chains))
      {
        // The seam is a line of constant u if u does not change along it.
        const FaceChain& seam = this->Chain(chains.front());
        const gp_Pnt2d first = this->Parameters(seam.Points.front());
        const gp_Pnt2d last = this->Parameters(seam.Points.back());
        found.push_back({ this->Found.Loops[face.Loops.front()].Face,
          std::abs(last.X() - first.X()) < std::abs(last.Y() - first.Y()) });
      }
    }
    return found;
  }

  /** After RoundFaces. */
  TrimmedFaces Build()
  {
    this->MakeEdges();
    this->MakeWires();
    return this->MakeShells();
  }

private:
  struct Face
  {
    TopoDS_Face Shape;
    Handle(Geom_BSplineSurface) Spline;
    std::vector<std::size_t> Loops; ///< the outer one first
  };

  const FaceChain& Chain(std::int32_t chain) const
  {
    return this->Found.Chains[static_cast<std::size_t>(chain)];
  }
  gp_Pnt2d Parameters(std::int32_t point) const
  {
    const std::size_t i = 2 * static_cast<std::size_t>(point);
    return { this->Surface.UV[i], this->Surface.UV[i + 1] };
  }
  gp_Pnt Point(std::int32_t point) const
  {
    const std::size_t i = 3 * static_cast<std::size_t>(point);
    return { this->Surface.Points[i], this->Surface.Points[i + 1], this->Surface.Points[i + 2] };
  }

  /** A patch that is left in several parts becomes several faces. */
  void MakeFaces()
  {
    for (std::size_t i = 0; i < this->Found.Loops.size(); ++i)
    {
      if (this->Found.Loops[i].Area > 0.0)
      {
        Face face;
        face.Spline =
          MakeBSpline(this->Surface.Patches[static_cast<std::size_t>(this->Found.Loops[i].Face)]);
        this->Builder.MakeFace(face.Shape, face.Spline, leastTolerance);
        face.Loops.push_back(i);
        this->Faces.push_back(face);
      }
    }
    for (std::size_t i = 0; i < this->Found.Loops.size(); ++i)
    {
      const std::ptrdiff_t around = this->Found.Loops[i].Area < 0.0 ? this->FaceAround(i) : -1;
      if (around >= 0)
      {
        this->Faces[static_cast<std::size_t>(around)].Loops.push_back(i);
      }
    }
    for (std::size_t face = 0; face < this->Faces.size(); ++face)
    {
      for (const std::size_t loop : this->Faces[face].Loops)
      {
        for (const std::int32_t chain : this->Found.Loops[loop].Chains)
        {
          this->FaceOfChain[static_cast<std::size_t>(chain)] = static_cast<std::int32_t>(face);
        }
      }
    }
  }

  /** The chains of a face's outer border, without poles. */
  std::vector<std::int32_t> OuterChains(const Face& face) const
  {
    std::vector<std::int32_t> chains = this->Found.Loops[face.Loops.front()].Chains;
    chains.erase(std::remove_if(chains.begin(), chains.end(),
                   [this](std::int32_t chain) { return this->Chain(chain).IsPole; }),
      chains.end());
    return chains;
  }

  /** Whether a border is nothing but a seam, there and back from pole to pole. */
  bool IsThereAndBack(const std::vector<std::int32_t>& chains) const
  {
    const std::size_t count = chains.size();
    for (std::size_t start = 0; start < count; ++start)
    {
      bool returns = true;
      for (std::size_t i = 0; i < count; ++i)
      {
        returns = returns &&
          this->Chain(chains[(start + i) % count]).Twin ==
            chains[(start + 2 * count - 1 - i) % count];
      }
      if (returns)
      {
        return true;
      }
    }
    return false;
  }

  /** The face whose outer loop is the smallest around a hole; -1 if none is. */
  std::ptrdiff_t FaceAround(std::size_t hole) const
  {
    const FaceLoop& inner = this->Found.Loops[hole];
    const FaceChain& chain = this->Chain(inner.Chains.front());
    const gp_Pnt2d a = this->Parameters(chain.Points[0]);
    const gp_Pnt2d b = this->Parameters(chain.Points[1]);
    const gp_Pnt2d middle(0.5 * (a.X() + b.X()), 0.5 * (a.Y() + b.Y()));
    std::ptrdiff_t best = -1;
    for (std::size_t face = 0; face < this->Faces.size(); ++face)
    {
      const FaceLoop& outer = this->Found.Loops[this->Faces[face].Loops.front()];
      if (outer.Face == inner.Face && this->IsInside(outer, middle) &&
        (best < 0 ||
          outer.Area <
            this->Found.Loops[this->Faces[static_cast<std::size_t>(best)].Loops.front()].Area))
      {
        best = static_cast<std::ptrdiff_t>(face);
      }
    }
    return best;
  }

  /** By the number of sides that a ray to larger u crosses. */
  bool IsInside(const FaceLoop& loop, const gp_Pnt2d& p) const
  {
    bool inside = false;
    for (const std::int32_t id : loop.Chains)
    {
      const FaceChain& chain = this->Chain(id);
      for (std::size_t i = 1; i < chain.Points.size(); ++i)
      {
        const gp_Pnt2d a = this->Parameters(chain.Points[i - 1]);
        const gp_Pnt2d b = this->Parameters(chain.Points[i]);
        const bool crosses = (a.Y() <= p.Y()) != (b.Y() <= p.Y());
        inside = inside !=
          (crosses && a.X() + (p.Y() - a.Y()) / (b.Y() - a.Y()) * (b.X() - a.X()) > p.X());
      }
    }
    return inside;
  }

  /** One parameter for the curve in space and for those in the faces: the length of the polygon. */
  std::vector<double> Lengths(const FaceChain& chain) const
  {
    std::vector<double> lengths{ 0.0 };
    for (std::size_t i = 1; i < chain.Points.size(); ++i)
    {
      const double step = chain.IsPole
        ? this->Parameters(chain.Points[i]).Distance(this->Parameters(chain.Points[i - 1]))
        : this->Point(chain.Points[i]).Distance(this->Point(chain.Points[i - 1]));
      lengths.push_back(lengths.back() + step);
    }
    return lengths;
  }

  static Handle(TColStd_HArray1OfReal) ArrayOf(const std::vector<double>& values)
  {
    const Handle(TColStd_HArray1OfReal) array =
      new TColStd_HArray1OfReal(1, static_cast<int>(values.size()));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      array->SetValue(static_cast<int>(i) + 1, values[i]);
    }
    return array;
  }

  Handle(Geom_BSplineCurve)
    CurveInSpace(const FaceChain& chain, const std::vector<double>& lengths) const
  {
    const int count = static_cast<int>(chain.Points.size());
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    for (int i = 0; i < count; ++i)
    {
      points->SetValue(i + 1, this->Point(chain.Points[static_cast<std::size_t>(i)]));
    }
    if (count == 2)
    {
      TColStd_Array1OfInteger twice(1, 2);
      twice.Init(2);
      return new Geom_BSplineCurve(points->Array1(), ArrayOf(lengths)->Array1(), twice, 1);
    }
    GeomAPI_Interpolate interpolation(points, ArrayOf(lengths), Standard_False, 0.0);
    interpolation.Perform();
    return interpolation.Curve();
  }

  /** Through the parameters of the points; those of a twin are passed in the other direction. */
  Handle(Geom2d_BSplineCurve)
    CurveInFace(const FaceChain& chain, const std::vector<double>& lengths, bool backwards) const
  {
    const int count = static_cast<int>(chain.Points.size());
    const Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, count);
    for (int i = 0; i < count; ++i)
    {
      points->SetValue(i + 1,
        this->Parameters(chain.Points[static_cast<std::size_t>(backwards ? count - 1 - i : i)]));
    }
    if (count == 2)
    {
      TColStd_Array1OfInteger twice(1, 2);
      twice.Init(2);
      return new Geom2d_BSplineCurve(points->Array1(), ArrayOf(lengths)->Array1(), twice, 1);
    }
    Geom2dAPI_Interpolate interpolation(points, ArrayOf(lengths), Standard_False, 0.0);
    interpolation.Perform();
    return interpolation.Curve();
  }

  TopoDS_Vertex Vertex(std::int32_t place, std::int32_t point, double tolerance)
  {
    TopoDS_Vertex& vertex = this->Vertices[place];
    if (vertex.IsNull())
    {
      this->Builder.MakeVertex(vertex, this->Point(point), leastTolerance);
    }
    this->Builder.UpdateVertex(vertex, tolerance);
    return vertex;
  }

  void AddEnds(TopoDS_Edge& edge, const FaceChain& chain, double length, double tolerance)
  {
    const TopoDS_Vertex first = this->Vertex(chain.Places.front(), chain.Points.front(), tolerance);
    const TopoDS_Vertex last = this->Vertex(chain.Places.back(), chain.Points.back(), tolerance);
    this->Builder.Add(edge, first.Oriented(TopAbs_FORWARD));
    this->Builder.Add(edge, last.Oriented(TopAbs_REVERSED));
    this->Builder.Range(edge, 0.0, length);
  }

  /** How far the curves in space and in a face are apart. */
  double Deviation(const Handle(Geom_BSplineCurve) & inSpace,
    const Handle(Geom2d_BSplineCurve) & inFace, const Face& face,
    const std::vector<double>& lengths) const
  {
    constexpr int samples = 8; // between two points
    double largest = 0.0;
    for (std::size_t i = 1; i < lengths.size(); ++i)
    {
      for (int k = 0; k <= samples; ++k)
      {
        const double t = lengths[i - 1] + (lengths[i] - lengths[i - 1]) * k / samples;
        const gp_Pnt2d uv = inFace->Value(t);
        largest = std::max(largest, inSpace->Value(t).Distance(face.Spline->Value(uv.X(), uv.Y())));
      }
    }
    return largest;
  }

  /** Whether a face is on the other side of a chain, too: what is there may have been left out. */
  bool HasTwin(const FaceChain& chain) const
  {
    return chain.Twin >= 0 && this->FaceOfChain[static_cast<std::size_t>(chain.Twin)] >= 0;
  }

  void MakeEdges()
  {
    this->Edges.resize(this->Found.Chains.size());
    for (std::size_t i = 0; i < this->Found.Chains.size(); ++i)
    {
      const FaceChain& chain = this->Found.Chains[i];
      const bool isFirst = !this->HasTwin(chain) || static_cast<std::int32_t>(i) < chain.Twin;
      if (this->FaceOfChain[i] < 0 || !isFirst)
      {
        continue;
      }
      if (chain.IsPole)
      {
        this->MakePole(i);
      }
      else
      {
        this->MakeEdge(i);
      }
    }
  }

  void MakePole(std::size_t i)
  {
    const FaceChain& chain = this->Found.Chains[i];
    const std::vector<double> lengths = this->Lengths(chain);
    TopoDS_Edge& edge = this->Edges[i];
    this->Builder.MakeEdge(edge);
    this->Builder.UpdateEdge(
      edge, this->CurveInFace(chain, lengths, false), this->FaceAt(i).Shape, leastTolerance);
    this->Builder.Degenerated(edge, Standard_True);
    this->AddEnds(edge, chain, lengths.back(), leastTolerance);
  }

  const Face& FaceAt(std::size_t chain) const
  {
    return this->Faces[static_cast<std::size_t>(this->FaceOfChain[chain])];
  }

  void MakeEdge(std::size_t i)
  {
    const FaceChain& chain = this->Found.Chains[i];
    const std::vector<double> lengths = this->Lengths(chain);
    const Handle(Geom_BSplineCurve) inSpace = this->CurveInSpace(chain, lengths);
    const Handle(Geom2d_BSplineCurve) inFace = this->CurveInFace(chain, lengths, false);
    double tolerance = this->Deviation(inSpace, inFace, this->FaceAt(i), lengths);
    TopoDS_Edge& edge = this->Edges[i];
    this->Builder.MakeEdge(edge, inSpace, leastTolerance);
    const std::size_t twin = static_cast<std::size_t>(chain.Twin);
    const bool hasTwin = this->HasTwin(chain);
    if (hasTwin)
    {
      const Handle(Geom2d_BSplineCurve) inTwin =
        this->CurveInFace(this->Found.Chains[twin], lengths, true);
      tolerance =
        std::max(tolerance, this->Deviation(inSpace, inTwin, this->FaceAt(twin), lengths));
      if (this->FaceOfChain[twin] == this->FaceOfChain[i])
      {
        this->Builder.UpdateEdge(edge, inFace, inTwin, this->FaceAt(i).Shape, leastTolerance);
      }
      else
      {
        this->Builder.UpdateEdge(edge, inTwin, this->FaceAt(twin).Shape, leastTolerance);
      }
    }
    if (!hasTwin || this->FaceOfChain[twin] != this->FaceOfChain[i])
    {
      this->Builder.UpdateEdge(edge, inFace, this->FaceAt(i).Shape, leastTolerance);
    }
    tolerance = std::max(leastTolerance, 1.1 * tolerance); // it was measured at samples
    this->Builder.UpdateEdge(edge, tolerance);
    this->AddEnds(edge, chain, lengths.back(), tolerance);
    this->Builder.SameRange(edge, Standard_True);
    this->Builder.SameParameter(edge, Standard_True);
  }

  void MakeWires()
  {
    for (Face& face : this->Faces)
    {
      for (const std::size_t loop : face.Loops)
      {
        TopoDS_Wire wire;
        this->Builder.MakeWire(wire);
        for (const std::int32_t id : this->Found.Loops[loop].Chains)
        {
          const std::int32_t twin = this->Chain(id).Twin;
          const bool isFirst = !this->Edges[static_cast<std::size_t>(id)].IsNull();
          const TopoDS_Edge& edge = this->Edges[static_cast<std::size_t>(isFirst ? id : twin)];
          this->Builder.Add(wire, edge.Oriented(isFirst ? TopAbs_FORWARD : TopAbs_REVERSED));
        }
        wire.Closed(Standard_True);
        this->Builder.Add(face.Shape, wire);
      }
    }
  }

  /** Faces that share an edge are of one shell. */
  std::vector<std::vector<std::size_t>> ConnectedFaces() const
  {
    sb::DisjointSets sets(static_cast<std::int32_t>(this->Faces.size()));
    for (std::size_t i = 0; i < this->Found.Chains.size(); ++i)
    {
      const FaceChain& chain = this->Found.Chains[i];
      if (this->FaceOfChain[i] >= 0 && this->HasTwin(chain))
      {
        sets.Unite(this->FaceOfChain[i], this->FaceOfChain[static_cast<std::size_t>(chain.Twin)]);
      }
    }
    std::map<std::int32_t, std::vector<std::size_t>> groups;
    for (std::size_t face = 0; face < this->Faces.size(); ++face)
    {
      groups[sets.Find(static_cast<std::int32_t>(face))].push_back(face);
    }
    std::vector<std::vector<std::size_t>> connected;
    for (const auto& group : groups)
    {
      connected.push_back(group.second);
    }
    return connected;
  }

  bool IsClosed(const std::vector<std::size_t>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(), [this](std::size_t face) {
      const std::vector<std::size_t>& loops = this->Faces[face].Loops;
      return std::all_of(loops.begin(), loops.end(), [this](std::size_t loop) {
        const std::vector<std::int32_t>& chains = this->Found.Loops[loop].Chains;
        return std::all_of(chains.begin(), chains.end(), [this](std::int32_t chain) {
          return this->Chain(chain).IsPole || this->HasTwin(this->Chain(chain));
        });
      });
    });
  }

  TrimmedFaces MakeShells();

  const sb::DesignedSurface& Surface;
  FaceLoops Found;
  std::vector<std::int32_t> FaceOfChain; // -1: of none
  BRep_Builder Builder;
  std::vector<Face> Faces;
  std::vector<TopoDS_Edge> Edges; // of each chain; null where it is that of the twin
  std::map<std::int32_t, TopoDS_Vertex> Vertices; // of each place
};

TrimmedFaces ShapeBuilder::MakeShells()
{
  TrimmedFaces result;
  result.NumberOfFaces = static_cast<std::int64_t>(this->Faces.size());
  result.NumberOfUnfitPatches = static_cast<std::int64_t>(this->Found.Unfit.size());
  if (this->Faces.empty())
  {
    return result;
  }
  TopoDS_Compound all;
  this->Builder.MakeCompound(all);
  std::vector<TopoDS_Shell> closed;
  for (const std::vector<std::size_t>& faces : this->ConnectedFaces())
  {
    TopoDS_Shell shell;
    this->Builder.MakeShell(shell);
    for (const std::size_t face : faces)
    {
      this->Builder.Add(shell, this->Faces[face].Shape);
    }
    if (this->IsClosed(faces))
    {
      shell.Closed(Standard_True);
      closed.push_back(shell);
    }
    else
    {
      this->Builder.Add(all, shell);
      ++result.NumberOfOpenShells;
    }
  }
  for (const TopoDS_Solid& solid : MakeSolids(closed))
  {
    this->Builder.Add(all, solid);
    ++result.NumberOfSolids;
  }
  result.Shape = all;
  return result;
}

} // namespace

TrimmedFaces MakeTrimmedFaces(const sb::DesignedSurface& surface)
{
  ShapeBuilder builder(surface);
  const std::vector<FaceToHalve> round = builder.RoundFaces();
  return round.empty() ? builder.Build() : MakeTrimmedFaces(HalveFaces(surface, round));
}

} // namespace sbvtk

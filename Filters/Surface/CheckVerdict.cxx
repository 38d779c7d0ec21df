// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CheckVerdict.h"

#include <algorithm>
#include <cstdio>

namespace sbvtk
{
namespace
{

/** "1 edge", "2 edges". */
std::string Number(std::int64_t count, const std::string& one, const std::string& many)
{
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

/** The one word that fits the number. */
std::string Either(std::int64_t count, const char* one, const char* many)
{
  return count == 1 ? one : many;
}

std::string Value(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

bool IsEmpty(const CheckFindings& findings) { return findings.Triangles == 0; }

std::string Headline(const CheckFindings& findings)
{
  if (IsEmpty(findings))
  {
    return "There is no polygon and no strip to check; look at the filter before this one.";
  }
  if (IsClean(findings))
  {
    return "This surface is fit for Booleans, and nothing is wrong with it.";
  }
  if (IsFit(findings))
  {
    return "This surface is fit for Surface Boolean, which takes it as a solid, but there is "
           "something to know.";
  }
  return "This surface is not fit for Booleans as a solid.";
}

std::string Shape(const CheckFindings& findings)
{
  const sb::SurfaceCheckResult& result = findings.Result;
  const auto shells = static_cast<std::int64_t>(result.Shells.size());
  std::string text = " It has " + Number(shells, "shell", "shells");
  const auto inner = std::count_if(result.Shells.begin(), result.Shells.end(),
    [](const sb::Shell& shell) { return shell.Depth > 0; });
  text += inner > 0 ? ", of which " + std::to_string(inner) + Either(inner, " lies", " lie") +
      " inside of others (ShellDepth)"
                    : "";
  if (result.Report.Closed)
  {
    const std::int64_t genus = result.Genus();
    text += ", closed";
    text += genus >= 0 ? ", of genus " + std::to_string(genus) : "";
    text += ", volume " + Value(result.Report.Volume);
  }
  return text + ", area " + Value(result.Report.Area) + ".";
}

std::string OfUnusableCells(const CheckFindings& findings)
{
  std::string text;
  if (findings.BadCells > 0)
  {
    text += " " + Number(findings.BadCells, "cell names a point", "cells name points") + " that " +
      Either(findings.BadCells, "does", "do") +
      " not exist (field array BadCellIds): " + Either(findings.BadCells, "it is", "they are") +
      " left out of Surface; repair the file or the filter that made it.";
  }
  const std::int64_t points = findings.Result.Counts.NotFinitePoints;
  if (points > 0)
  {
    text += " " + Number(points, "point has", "points have") +
      " coordinates that are not finite numbers, ";
    text += findings.NotFiniteCells > 0
      ? "and " + Number(findings.NotFiniteCells, "cell uses", "cells use") +
        " such points: both are left out of Surface (field arrays BadPointIds, BadCellIds); repair "
        "the points, or go on with Surface and close the holes that are left."
      : "but no cell uses " + Either(points, "it", "them") + ": Clean removes " +
        Either(points, "it", "them") + ", and Surface is without.";
  }
  return text;
}

std::string OfPoints(const CheckFindings& findings)
{
  const std::int64_t count = findings.Result.Counts.DuplicatePoints;
  if (count == 0)
  {
    return "";
  }
  return " " + Number(count, "point is", "points are") +
    " at the place of an earlier one (DuplicatePoint), as where normals differ along a crease: "
    "Surface Boolean takes them as one, and Clean makes one of them.";
}

std::string OfOrientation(const CheckFindings& findings)
{
  const sb::SurfaceCheckResult& result = findings.Result;
  const sb::SurfaceCheckCounts& counts = result.Counts;
  std::string text;
  if (counts.ContradictoryEdges > 0)
  {
    text += " At " + Number(counts.ContradictoryEdges, "edge", "edges") +
      " neighbouring polygons are oriented against each other: apply Clean, then Generate Surface "
      "Normals with Consistency on.";
  }
  if (counts.OneSidedShells > 0)
  {
    text += " " + Number(counts.OneSidedShells, "shell is", "shells are") +
      " one-sided, like a Moebius strip, which no orientation can cure: take apart what should not "
      "be joined.";
  }
  if (result.IsInsideOut)
  {
    text +=
      " It is inside out (its volume is negative): apply Reverse Sense; Surface Boolean turns "
      "it over by itself, with a warning.";
  }
  else if (counts.InvertedShells > 0)
  {
    text += " " + Number(counts.InvertedShells, "shell is", "shells are") +
      " inside out: Threshold WrongWay from 1 to 1, apply Extract Surface and Reverse Sense to "
      "that, and Append Geometry with what WrongWay from 0 to 0 gives.";
  }
  if (counts.CoveredShells > 0)
  {
    text += " " + Number(counts.CoveredShells, "shell lies", "shells lie") +
      " inside of what another one encloses, and " + Either(counts.CoveredShells, "faces", "face") +
      " outwards like that one, so " + Either(counts.CoveredShells, "it encloses", "they enclose") +
      " nothing new: if hollows are meant, turn " + Either(counts.CoveredShells, "it", "them") +
      " over (Threshold ShellId, Extract Surface, Reverse Sense, Append Geometry), else Surface "
      "Boolean with Operation Resolve takes " +
      Either(counts.CoveredShells, "it", "them") + " away.";
  }
  return text;
}

std::string OfEdges(const CheckFindings& findings)
{
  const sb::SurfaceCheckCounts& counts = findings.Result.Counts;
  std::string text;
  if (counts.RimEdges > 0)
  {
    text += " It is open: " + Number(counts.RimEdges, "edge has", "edges have") +
      " one polygon only and " + Either(counts.RimEdges, "makes ", "make ") +
      Number(counts.Rims, "loop", "loops") +
      " (LoopId): where points that should be one lie a little apart, apply Clean with a small "
      "tolerance; a flat hole is filled by Threshold of its LoopId in Defects, Extract Surface and "
      "Contour Triangulator, then Append Geometry, Clean, and Generate Surface Normals with "
      "Consistency on; as a Tool of Surface Boolean the surface may stay open, if it cuts the "
      "Input through.";
  }
  if (counts.ManyFoldEdges > 0)
  {
    text += " " + Number(counts.ManyFoldEdges, "edge has", "edges have") +
      " more than two polygons (non-manifold): ";
    text += findings.Result.Report.Closed || counts.RimEdges + counts.ContradictoryEdges > 0
      ? "that by itself is no obstacle to Surface Boolean."
      : "an odd number, so that the surface is not closed there; remove the polygons that should "
        "not be there, which are often duplicates or inner walls.";
  }
  if (counts.TouchingVertices > 0)
  {
    text += " In " + Number(counts.TouchingVertices, "point", "points") +
      " parts of the surface touch each other (non-manifold): that is no obstacle to Surface "
      "Boolean.";
  }
  return text;
}

std::string OfCells(const CheckFindings& findings)
{
  const sb::SurfaceCheckCounts& counts = findings.Result.Counts;
  std::string text;
  if (counts.DuplicateCells > 0)
  {
    text += " " + Number(counts.DuplicateCells, "cell repeats", "cells repeat") +
      " an earlier one: Threshold Duplicate from 0 to 0, then apply Extract Surface.";
  }
  if (findings.DegenerateCells > 0)
  {
    text += " " + Number(findings.DegenerateCells, "cell has", "cells have") +
      " no area (at least in part): that is no obstacle to Surface Boolean; Clean removes those "
      "whose points coincide.";
  }
  if (counts.SelfIntersections > 0)
  {
    text += " " +
      Number(counts.SelfIntersections, "pair of triangles meets", "pairs of triangles meet") +
      " elsewhere than in common points and edges: ";
    text += findings.Result.Report.Closed
      ? "Surface Boolean with Operation Resolve makes one clean surface of it."
      : "Surface Intersection without Tool cuts it along these lines.";
  }
  return text;
}

} // namespace

bool IsFit(const CheckFindings& findings)
{
  const sb::SurfaceCheckResult& result = findings.Result;
  return !IsEmpty(findings) && findings.BadCells == 0 && findings.NotFiniteCells == 0 &&
    result.Report.Closed && !result.IsInsideOut && result.Counts.InvertedShells == 0;
}

bool IsClean(const CheckFindings& findings)
{
  const sb::SurfaceCheckCounts& counts = findings.Result.Counts;
  return IsFit(findings) && counts.NotFinitePoints == 0 && counts.ManyFoldEdges == 0 &&
    counts.TouchingVertices == 0 && counts.SelfIntersections == 0 && counts.DuplicateCells == 0 &&
    findings.DegenerateCells == 0 && counts.CoveredShells == 0;
}

std::string Verdict(const CheckFindings& findings)
{
  std::string text = Headline(findings);
  if (IsEmpty(findings))
  {
    return text;
  }
  text += Shape(findings) + OfUnusableCells(findings) + OfCells(findings) + OfEdges(findings) +
    OfOrientation(findings) + OfPoints(findings);
  if (!findings.LookedForSelfIntersections)
  {
    text += " Self-intersections were not looked for.";
  }
  return text;
}

} // namespace sbvtk

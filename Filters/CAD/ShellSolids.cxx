// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShellSolids.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRepGProp.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace sbvtk
{
namespace
{

struct Body
{
  double Volume = 0.0;
  TopoDS_Solid Solid;
};

/** Whether a corner of the shell is inside of the solid. */
bool IsIn(const TopoDS_Solid& inner, const TopoDS_Solid& outer)
{
  const TopExp_Explorer vertex(inner, TopAbs_VERTEX);
  if (!vertex.More())
  {
    return false;
  }
  constexpr double tolerance = 1e-7;
  BRepClass3d_SolidClassifier classifier(
    outer, BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())), tolerance);
  return classifier.State() == TopAbs_IN;
}

} // namespace

std::vector<TopoDS_Solid> MakeSolids(const std::vector<TopoDS_Shell>& shells)
{
  const BRep_Builder builder;
  std::vector<Body> bodies;
  for (const TopoDS_Shell& shell : shells)
  {
    Body body;
    builder.MakeSolid(body.Solid);
    builder.Add(body.Solid, shell);
    if (shells.size() > 1) // one alone has no void, and the volume takes its time
    {
      GProp_GProps properties;
      BRepGProp::VolumeProperties(body.Solid, properties);
      body.Volume = properties.Mass();
    }
    bodies.push_back(body);
  }
  // Smallest first: a void belongs to the innermost solid around it.
  std::stable_sort(
    bodies.begin(), bodies.end(), [](const Body& a, const Body& b) { return a.Volume < b.Volume; });
  const auto firstSolid =
    std::find_if(bodies.begin(), bodies.end(), [](const Body& body) { return body.Volume >= 0.0; });
  std::vector<TopoDS_Solid> solids;
  std::vector<std::pair<TopoDS_Solid*, TopoDS_Shell>> voids;
  for (auto body = bodies.begin(); body != firstSolid; ++body)
  {
    const auto outer = std::find_if(firstSolid, bodies.end(),
      [body](const Body& other) { return IsIn(body->Solid, other.Solid); });
    if (outer == bodies.end())
    {
      solids.push_back(body->Solid);
    }
    else
    {
      const TopExp_Explorer shell(body->Solid, TopAbs_SHELL);
      voids.emplace_back(&outer->Solid, TopoDS::Shell(shell.Current()));
    }
  }
  for (const auto& [solid, shell] : voids) // last, so that voids do not change what is inside
  {
    builder.Add(*solid, shell);
  }
  for (auto body = firstSolid; body != bodies.end(); ++body)
  {
    solids.push_back(body->Solid);
  }
  return solids;
}

} // namespace sbvtk

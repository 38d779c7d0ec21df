// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaceSurface.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_OffsetSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_Surface.hxx>
#include <Geom_SweptSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Pnt.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sbvtk
{
namespace
{

Handle(Geom_Surface) WithoutTrimming(Handle(Geom_Surface) surface)
{
  Handle(Geom_RectangularTrimmedSurface) trimmed =
    Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
  while (!trimmed.IsNull())
  {
    surface = trimmed->BasisSurface();
    trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface);
  }
  return surface;
}

/** [first, last] within a surface's own bounds, or one period of it; never empty. */
void Restrict(double& first, double& last, double lower, double upper, double period)
{
  if (period > 0.0)
  {
    last = last - first > period * (1.0 - 1e-9) ? first + period : last;
  }
  else
  {
    first = std::max(first, lower);
    last = std::min(last, upper);
  }
  if (!(last > first))
  {
    const double room = 1e-6 * std::max(1.0, std::abs(first));
    first -= room;
    last += room;
  }
}

/** A B-spline as it is in the file, only unrolled where it is periodic. */
Handle(Geom_BSplineSurface)
  Unrolled(const Handle(Geom_BSplineSurface) & surface, const ParameterBox& box)
{
  const Handle(Geom_BSplineSurface) copy = Handle(Geom_BSplineSurface)::DownCast(surface->Copy());
  const bool inU = copy->IsUPeriodic();
  const bool inV = copy->IsVPeriodic();
  if (inU || inV)
  {
    double firstU = 0.0;
    double lastU = 0.0;
    double firstV = 0.0;
    double lastV = 0.0;
    copy->Bounds(firstU, lastU, firstV, lastV);
    copy->Segment(inU ? box.FirstU : firstU, inU ? box.LastU : lastU, inV ? box.FirstV : firstV,
      inV ? box.LastV : lastV);
  }
  return copy;
}

/** Make it end in its first and last rows of poles. */
void Clamp(Geom_BSplineSurface& spline)
{
  spline.SetUNotPeriodic();
  spline.SetVNotPeriodic();
  const bool inU = spline.UMultiplicity(1) == spline.UDegree() + 1;
  const bool inV = spline.VMultiplicity(1) == spline.VDegree() + 1;
  if (!inU || !inV)
  {
    double firstU = 0.0;
    double lastU = 0.0;
    double firstV = 0.0;
    double lastV = 0.0;
    spline.Bounds(firstU, lastU, firstV, lastV);
    spline.Segment(firstU, lastU, firstV, lastV);
  }
}

bool IsExactlyRational(const Handle(Geom_Surface) & surface)
{
  return !surface->IsKind(STANDARD_TYPE(Geom_OffsetSurface));
}

sb::NURBSSurface PatchOf(const Handle(Geom_BSplineSurface) & surface)
{
  sb::NURBSSurface patch;
  patch.DegreeU = surface->UDegree();
  patch.DegreeV = surface->VDegree();
  patch.CountU = surface->NbUPoles();
  patch.CountV = surface->NbVPoles();
  for (int i = 1; i <= surface->NbUKnots(); ++i)
  {
    patch.KnotsU.insert(patch.KnotsU.end(), surface->UMultiplicity(i), surface->UKnot(i));
  }
  for (int i = 1; i <= surface->NbVKnots(); ++i)
  {
    patch.KnotsV.insert(patch.KnotsV.end(), surface->VMultiplicity(i), surface->VKnot(i));
  }
  patch.Poles.reserve(4 * static_cast<std::size_t>(patch.CountU) * patch.CountV);
  for (int i = 1; i <= patch.CountU; ++i)
  {
    for (int j = 1; j <= patch.CountV; ++j)
    {
      const gp_Pnt pole = surface->Pole(i, j);
      patch.Poles.insert(
        patch.Poles.end(), { pole.X(), pole.Y(), pole.Z(), surface->Weight(i, j) });
    }
  }
  return patch;
}

double Shifted(double x, double first, double last, double period)
{
  // The ends of a whole turn are both inside, and stay what they are.
  const double margin = 1e-9 * (last - first);
  if (period > 0.0 && x < first - margin)
  {
    x += period * std::ceil((first - margin - x) / period);
  }
  else if (period > 0.0 && x > last + margin)
  {
    x -= period * std::ceil((x - last - margin) / period);
  }
  return std::clamp(x, first, last);
}

/** Knots without repetition, and how often each is there. */
void Condense(
  const std::vector<double>& knots, std::vector<double>& values, std::vector<int>& multiplicities)
{
  for (const double knot : knots)
  {
    if (values.empty() || knot != values.back())
    {
      values.push_back(knot);
      multiplicities.push_back(0);
    }
    ++multiplicities.back();
  }
}

} // namespace

void ParameterBox::Add(double u, double v)
{
  this->FirstU = std::min(this->FirstU, u);
  this->LastU = std::max(this->LastU, u);
  this->FirstV = std::min(this->FirstV, v);
  this->LastV = std::max(this->LastV, v);
}

void FaceSurface::Near(double& u, double& v) const
{
  u = Shifted(u, this->Patch.FirstU(), this->Patch.LastU(), this->PeriodU);
  v = Shifted(v, this->Patch.FirstV(), this->Patch.LastV(), this->PeriodV);
}

FaceSurface MakeFaceSurface(const TopoDS_Face& face, const ParameterBox& used)
{
  const Handle(Geom_Surface) surface = WithoutTrimming(BRep_Tool::Surface(face));
  FaceSurface result;
  result.PeriodU = surface->IsUPeriodic() ? surface->UPeriod() : 0.0;
  result.PeriodV = surface->IsVPeriodic() ? surface->VPeriod() : 0.0;
  ParameterBox own;
  surface->Bounds(own.FirstU, own.LastU, own.FirstV, own.LastV);
  ParameterBox box = used;
  Restrict(box.FirstU, box.LastU, own.FirstU, own.LastU, result.PeriodU);
  Restrict(box.FirstV, box.LastV, own.FirstV, own.LastV, result.PeriodV);
  Handle(Geom_BSplineSurface) spline = Handle(Geom_BSplineSurface)::DownCast(surface);
  if (!spline.IsNull())
  {
    spline = Unrolled(spline, box);
  }
  else
  {
    spline = GeomConvert::SurfaceToBSplineSurface(
      new Geom_RectangularTrimmedSurface(surface, box.FirstU, box.LastU, box.FirstV, box.LastV));
    Clamp(*spline);
    result.IsExact = IsExactlyRational(surface);
  }
  result.Patch = PatchOf(spline);
  return result;
}

Handle(Geom_BSplineSurface) MakeBSpline(const sb::NURBSSurface& patch)
{
  TColgp_Array2OfPnt poles(1, patch.CountU, 1, patch.CountV);
  TColStd_Array2OfReal weights(1, patch.CountU, 1, patch.CountV);
  const double* pole = patch.Poles.data();
  for (int i = 1; i <= patch.CountU; ++i)
  {
    for (int j = 1; j <= patch.CountV; ++j, pole += 4)
    {
      poles.SetValue(i, j, gp_Pnt(pole[0], pole[1], pole[2]));
      weights.SetValue(i, j, pole[3]);
    }
  }
  std::vector<double> valuesU;
  std::vector<double> valuesV;
  std::vector<int> timesU;
  std::vector<int> timesV;
  Condense(patch.KnotsU, valuesU, timesU);
  Condense(patch.KnotsV, valuesV, timesV);
  const int countU = static_cast<int>(valuesU.size());
  const int countV = static_cast<int>(valuesV.size());
  return new Geom_BSplineSurface(poles, weights, TColStd_Array1OfReal(valuesU.front(), 1, countU),
    TColStd_Array1OfReal(valuesV.front(), 1, countV),
    TColStd_Array1OfInteger(timesU.front(), 1, countU),
    TColStd_Array1OfInteger(timesV.front(), 1, countV), patch.DegreeU, patch.DegreeV);
}

} // namespace sbvtk

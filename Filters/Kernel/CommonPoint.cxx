// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "CommonPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sb
{
namespace
{

constexpr int MostIterations = 40;
constexpr double Margin = 0.35; ///< of the samples gathered, in widths: most searches stay in it
constexpr double LongestStep = 0.4; ///< in widths
constexpr double FarthestFromStart = 2.0; ///< in widths
constexpr double ShortestStep = 1e-14; ///< in widths
constexpr double NearlyThere = 1e-12; ///< in widths: from there on the residual has to fall
constexpr double LeastSlope = 1e-7; ///< along the patch, against the gradient
constexpr double Degenerate = 1e-7; ///< ratio of lengths of S_u and S_v
constexpr int Turns = 32;

/** A step in the parameters, or what one is worth. */
struct Step
{
  double U = 0.0;
  double V = 0.0;
};

/** The shortest step in space along which a function with slopes w falls by f; false if there is
 * none, as the slope is 0. */
bool ShortestRoot(const PatchPoint& p, const Step& w, double f, double steepness, Step& step)
{
  const double lengthU = Length(p.Du);
  const double lengthV = Length(p.Dv);
  // Of unit tangents, so that parameters of any scale do; a tangent that is 0 has no part in it.
  const double slopeU = lengthU > 0.0 ? w.U / lengthU : 0.0;
  const double slopeV = lengthV > 0.0 ? w.V / lengthV : 0.0;
  const double cosine =
    lengthU > 0.0 && lengthV > 0.0 ? Dot(p.Du, p.Dv) / (lengthU * lengthV) : 0.0;
  const double squaredSine = 1.0 - cosine * cosine;
  Step direction{ slopeU, slopeV };
  if (squaredSine > 1e-12)
  {
    direction = { (slopeU - cosine * slopeV) / squaredSine,
      (slopeV - cosine * slopeU) / squaredSine };
  }
  const double fall = slopeU * direction.U + slopeV * direction.V;
  if (!(fall > LeastSlope * LeastSlope * steepness * steepness))
  {
    return false;
  }
  step.U = lengthU > 0.0 ? -f * direction.U / (fall * lengthU) : 0.0;
  step.V = lengthV > 0.0 ? -f * direction.V / (fall * lengthV) : 0.0;
  return true;
}

double LengthOf(const PatchPoint& p, const Step& step)
{
  return Length(PlusScaled(Scaled(p.Du, step.U), step.V, p.Dv));
}

/** Newton's method on a patch, with what its steps share. */
class SearchOnPatch
{
public:
  SearchOnPatch(const MovingLeastSquares& surface, const NURBSSurface& patch,
    MovingLeastSquares::Neighbourhood& near)
    : Surface(surface)
    , Patch(patch)
    , Near(near)
  {
  }

  CommonPoint Run(double u, double v)
  {
    const CommonPoint direct = this->Search(u, v);
    if (direct.Found)
    {
      return direct;
    }
    // Around a pole of the patch straight steps are no straight lines in u and v, and may lead to
    // nowhere; from the pole itself all directions are one step away.
    const double us[4] = { u, u, this->Patch.FirstU(), this->Patch.LastU() };
    const double vs[4] = { this->Patch.FirstV(), this->Patch.LastV(), v, v };
    const Real3 start = EvaluatePatch(this->Patch, u, v, 0).Point;
    for (int border = 0; border < 4; ++border)
    {
      const PatchPoint pole = EvaluatePatch(this->Patch, us[border], vs[border], 1);
      const bool isNear =
        Length(Difference(pole.Point, start)) <= FarthestFromStart * this->Surface.Width();
      if (isNear && this->IsPole(pole))
      {
        const CommonPoint around = this->Search(us[border], vs[border]);
        if (around.Found)
        {
          return around;
        }
      }
    }
    return direct;
  }

private:
  CommonPoint Search(double u, double v)
  {
    // Gathered afresh, so that what was searched before does not matter.
    this->Surface.Gather(
      EvaluatePatch(this->Patch, u, v, 0).Point, Margin * this->Surface.Width(), this->Near);
    CommonPoint best;
    CommonPoint now = this->At(u, v);
    const double width = now.Surface.Width; // as the samples have it there
    const Real3 start = now.Point;
    for (int iteration = 0; iteration < MostIterations; ++iteration)
    {
      if (!now.Surface.IsNear ||
        !(Length(Difference(now.Point, start)) <= FarthestFromStart * width))
      {
        return now;
      }
      const double residual = std::abs(now.Surface.Value);
      if (best.Found && !(residual < std::abs(best.Surface.Value)))
      {
        return best; // rounding is all that is left
      }
      if (residual <= NegligibleValue(now.Point, width))
      {
        best = now;
        best.Found = true;
      }
      Step step;
      if (residual == 0.0 || !this->StepFrom(now, step))
      {
        return best.Found ? best : now;
      }
      if (LengthOf(this->Place, step) <= ShortestStep * width && best.Found)
      {
        return best;
      }
      now = this->At(now.U + step.U, now.V + step.V);
    }
    return best.Found ? best : now;
  }

  /** Whether lines of constant v (or u) are single points here. */
  bool IsPole(const PatchPoint& p) const
  {
    const double acrossU = Length(p.Du) * (this->Patch.LastU() - this->Patch.FirstU());
    const double acrossV = Length(p.Dv) * (this->Patch.LastV() - this->Patch.FirstV());
    return (acrossU <= Degenerate * acrossV) != (acrossV <= Degenerate * acrossU);
  }

  CommonPoint At(double u, double v)
  {
    CommonPoint now;
    now.U = std::clamp(u, this->Patch.FirstU(), this->Patch.LastU());
    now.V = std::clamp(v, this->Patch.FirstV(), this->Patch.LastV());
    this->Place = EvaluatePatch(this->Patch, now.U, now.V, 1);
    now.Point = this->Place.Point;
    now.Surface = this->Surface.EvaluateNear(now.Point, 1, this->Near);
    return now;
  }

  /** The next step, not too long and within the domain. */
  bool StepFrom(CommonPoint& now, Step& step)
  {
    this->TurnWherePointed(now);
    const Real3& gradient = now.Surface.Gradient;
    const Step w{ Dot(gradient, this->Place.Du), Dot(gradient, this->Place.Dv) };
    const double steepness = Length(gradient);
    if (!ShortestRoot(this->Place, w, now.Surface.Value, steepness, step))
    {
      return false;
    }
    const bool inU = Keep(now.U, this->Patch.FirstU(), this->Patch.LastU(), step.U);
    const bool inV = Keep(now.V, this->Patch.FirstV(), this->Patch.LastV(), step.V);
    // Where the border stops one parameter, the other has to bring what is left.
    if (!inU && inV && std::abs(w.V) > LeastSlope * steepness * Length(this->Place.Dv))
    {
      step.V = -(now.Surface.Value + w.U * step.U) / w.V;
      Keep(now.V, this->Patch.FirstV(), this->Patch.LastV(), step.V);
    }
    else if (inU && !inV && std::abs(w.U) > LeastSlope * steepness * Length(this->Place.Du))
    {
      step.U = -(now.Surface.Value + w.V * step.V) / w.U;
      Keep(now.U, this->Patch.FirstU(), this->Patch.LastU(), step.U);
    }
    const double length = LengthOf(this->Place, step);
    const double longest = LongestStep * now.Surface.Width;
    if (length > longest)
    {
      step.U *= longest / length;
      step.V *= longest / length;
    }
    return step.U != 0.0 || step.V != 0.0;
  }

  /** Cut a step at the border; returns whether it was within. */
  static bool Keep(double at, double first, double last, double& step)
  {
    const double cut = std::clamp(at + step, first, last) - at;
    const bool within = at + step >= first && at + step <= last;
    step = within ? step : cut;
    return within;
  }

  /** Where one parameter moves nothing, it can have any value: that from which the other one leads
   * to the surface most directly. */
  void TurnWherePointed(CommonPoint& now)
  {
    if (!this->IsPole(this->Place))
    {
      return;
    }
    const double domainU = this->Patch.LastU() - this->Patch.FirstU();
    const double domainV = this->Patch.LastV() - this->Patch.FirstV();
    const bool pointInU = Length(this->Place.Du) * domainU < Length(this->Place.Dv) * domainV;
    const Real3 gradient = now.Surface.Gradient;
    double bestSlope = -1.0;
    CommonPoint best = now;
    for (int k = 0; k <= Turns; ++k)
    {
      const double t = double(k) / Turns;
      const double u = pointInU ? this->Patch.FirstU() + t * domainU : now.U;
      const double v = pointInU ? now.V : this->Patch.FirstV() + t * domainV;
      const PatchPoint p = EvaluatePatch(this->Patch, u, v, 1);
      const Real3& along = pointInU ? p.Dv : p.Du;
      // The step has to lead into the domain.
      const double at = pointInU ? v : u;
      const double first = pointInU ? this->Patch.FirstV() : this->Patch.FirstU();
      const double last = pointInU ? this->Patch.LastV() : this->Patch.LastU();
      const double slope = -now.Surface.Value * Dot(gradient, along) / Length(along);
      const double inwards = at - first < last - at ? slope : -slope;
      if (inwards > bestSlope)
      {
        bestSlope = inwards;
        best.U = u;
        best.V = v;
      }
    }
    now.U = best.U;
    now.V = best.V;
    this->Place = EvaluatePatch(this->Patch, now.U, now.V, 1);
    (pointInU ? this->Place.Du : this->Place.Dv) = {}; // and no rounding has a direction
  }

  const MovingLeastSquares& Surface;
  const NURBSSurface& Patch;
  MovingLeastSquares::Neighbourhood& Near;
  PatchPoint Place; ///< where the search is
};

} // namespace

double NegligibleValue(const Real3& x, double width)
{
  return NearlyThere * width + 8.0 * std::numeric_limits<double>::epsilon() * Length(x);
}

CommonPoint OntoCloudAndPatch(const MovingLeastSquares& surface, const NURBSSurface& patch,
  double u, double v, MovingLeastSquares::Neighbourhood& near)
{
  return SearchOnPatch(surface, patch, near).Run(u, v);
}

CommonPoint OntoCloudAndPlane(const MovingLeastSquares& surface, const Real3& origin,
  const Real3& normal, const Real3& start, MovingLeastSquares::Neighbourhood& near)
{
  const auto inPlane = [&](const Real3& x) {
    return PlusScaled(x, -Dot(Difference(x, origin), normal), normal);
  };
  CommonPoint best;
  CommonPoint now;
  now.Point = inPlane(start);
  const Real3 first = now.Point;
  surface.Gather(first, Margin * surface.Width(), near);
  for (int iteration = 0; iteration < MostIterations; ++iteration)
  {
    now.Surface = surface.EvaluateNear(now.Point, 1, near);
    const double width = now.Surface.Width; // as the samples have it there
    if (!now.Surface.IsNear || !(Length(Difference(now.Point, first)) <= FarthestFromStart * width))
    {
      return now;
    }
    const double residual = std::abs(now.Surface.Value);
    if (best.Found && !(residual < std::abs(best.Surface.Value)))
    {
      return best;
    }
    if (residual <= NegligibleValue(now.Point, width))
    {
      best = now;
      best.Found = true;
    }
    const Real3 along = WithoutPartAlong(now.Surface.Gradient, normal);
    const double steepness = Length(along);
    if (residual == 0.0 || !(steepness > LeastSlope * Length(now.Surface.Gradient)))
    {
      return best.Found ? best : now;
    }
    const double step =
      std::clamp(-now.Surface.Value / steepness, -LongestStep * width, LongestStep * width);
    now.Point = inPlane(PlusScaled(now.Point, step / steepness, along));
  }
  return best.Found ? best : now;
}

Real3 CurvatureOfCommonCurve(const SurfaceValue& value, const PatchPoint& at)
{
  const Real3 normal = Cross(at.Du, at.Dv);
  const Real3 tangent = Cross(value.Gradient, normal);
  const double nn = Dot(normal, normal);
  const double gg = Dot(value.Gradient, value.Gradient);
  const double tt = Dot(tangent, tangent); // = gg nn - gn^2
  if (!(tt > 1e-14 * gg * nn))
  {
    return {};
  }
  const Real3 t = Scaled(tangent, 1.0 / std::sqrt(tt));
  // The unit tangent as du, dv: t = S_u du + S_v dv.
  const double du = Dot(Cross(t, at.Dv), normal) / nn;
  const double dv = Dot(Cross(at.Du, t), normal) / nn;
  const Real3 bend =
    PlusScaled(PlusScaled(Scaled(at.Duu, du * du), 2.0 * du * dv, at.Duv), dv * dv, at.Dvv);
  const double alongNormal = Dot(bend, normal);
  const double alongGradient = -Dot(t, Times(value.Hessian, t));
  const double gn = Dot(value.Gradient, normal);
  // a gradient + b normal with these products.
  const double a = (alongGradient * nn - alongNormal * gn) / tt;
  const double b = (alongNormal * gg - alongGradient * gn) / tt;
  return PlusScaled(Scaled(value.Gradient, a), b, normal);
}

} // namespace sb

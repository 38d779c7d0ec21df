// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosestOnPatch.h"

#include "PatchBounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace sb
{
namespace
{

constexpr int MostIterations = 60;
constexpr int MostHalvings = 30;
constexpr double Negligible = 1e-17;

/** Half of the squared distance, as a function of u and v at a place. */
struct Descent
{
  PatchPoint At;
  Real3 Away{}; ///< from x to the place
  double SlopeU = 0.0;
  double SlopeV = 0.0;

  Descent(const NURBSSurface& patch, const Real3& x, double u, double v)
    : At(EvaluatePatch(patch, u, v, 2))
    , Away(Difference(At.Point, x))
    , SlopeU(Dot(Away, At.Du))
    , SlopeV(Dot(Away, At.Dv))
  {
  }

  /** The step to the minimum of the quadratic model; `held` parameters stay. */
  std::pair<double, double> Step(bool heldU, bool heldV) const
  {
    const double uu = Dot(this->At.Du, this->At.Du);
    const double uv = Dot(this->At.Du, this->At.Dv);
    const double vv = Dot(this->At.Dv, this->At.Dv);
    // Newton's matrix if it leads down everywhere, else that of Gauss and Newton.
    const double fullUU = uu + Dot(this->Away, this->At.Duu);
    const double fullUV = uv + Dot(this->Away, this->At.Duv);
    const double fullVV = vv + Dot(this->Away, this->At.Dvv);
    if (heldU || heldV)
    {
      const double alongU = fullUU > 0.1 * uu ? fullUU : uu;
      const double alongV = fullVV > 0.1 * vv ? fullVV : vv;
      return { heldU || !(alongU > 0.0) ? 0.0 : -this->SlopeU / alongU,
        heldV || !(alongV > 0.0) ? 0.0 : -this->SlopeV / alongV };
    }
    const double full = fullUU * fullVV - fullUV * fullUV;
    if (fullUU > 0.0 && full > 1e-8 * uu * vv)
    {
      return { (fullUV * this->SlopeV - fullVV * this->SlopeU) / full,
        (fullUV * this->SlopeU - fullUU * this->SlopeV) / full };
    }
    const double gauss = uu * vv - uv * uv;
    if (gauss > 1e-14 * uu * vv)
    {
      return { (uv * this->SlopeV - vv * this->SlopeU) / gauss,
        (uv * this->SlopeU - uu * this->SlopeV) / gauss };
    }
    return { uu > 0.0 ? -this->SlopeU / uu : 0.0, vv > 0.0 ? -this->SlopeV / vv : 0.0 };
  }
};

/** A part of the patch that may hold a closer point. */
struct Part
{
  double Bound; ///< all of it is at least so far
  ParameterBox Box;

  bool operator<(const Part& other) const { return this->Bound > other.Bound; }
};

/** Branch and bound: the part with the least bound is on top of a heap. */
class GlobalSearch
{
public:
  GlobalSearch(const NURBSSurface& patch, const Real3& x)
    : Patch(patch)
    , X(x)
  {
  }

  PlaceOnPatch Run()
  {
    this->Best.Distance = std::numeric_limits<double>::max();
    this->Add(
      { this->Patch.FirstU(), this->Patch.LastU(), this->Patch.FirstV(), this->Patch.LastV() });
    for (int k = 0; k < MostParts && !this->Parts.empty(); ++k)
    {
      std::pop_heap(this->Parts.begin(), this->Parts.end());
      const Part part = this->Parts.back();
      this->Parts.pop_back();
      if (part.Bound >= Enough * this->Best.Distance)
      {
        break;
      }
      this->Split(part.Box);
    }
    return this->Best;
  }

private:
  static constexpr int MostParts = 20000; ///< for points that are equally far from a whole area
  static constexpr double Enough = 0.999;

  void Add(const ParameterBox& box)
  {
    const double u = 0.5 * (box.FirstU + box.LastU);
    const double v = 0.5 * (box.FirstV + box.LastV);
    const Real3 away = Difference(EvaluatePatch(this->Patch, u, v, 0).Point, this->X);
    const double distance = Length(away);
    const double bound = distance > 0.0
      ? std::max(0.0, LeastAlong(this->Patch, box, this->X, Scaled(away, 1.0 / distance)))
      : 0.0;
    if (bound >= Enough * this->Best.Distance)
    {
      return;
    }
    if (distance < this->Best.Distance)
    {
      const PlaceOnPatch place = ClosestOnPatchFrom(this->Patch, this->X, u, v);
      this->Best = place.Distance < this->Best.Distance ? place : this->Best;
    }
    this->Parts.push_back({ bound, box });
    std::push_heap(this->Parts.begin(), this->Parts.end());
  }

  /** Across the longer direction in space. */
  void Split(const ParameterBox& box)
  {
    const PatchBounds bounds = BoundsOf(this->Patch, box);
    ParameterBox lower = box;
    ParameterBox upper = box;
    if (bounds.LengthU >= bounds.LengthV)
    {
      lower.LastU = upper.FirstU = 0.5 * (box.FirstU + box.LastU);
    }
    else
    {
      lower.LastV = upper.FirstV = 0.5 * (box.FirstV + box.LastV);
    }
    this->Add(lower);
    this->Add(upper);
  }

  const NURBSSurface& Patch;
  const Real3 X;
  PlaceOnPatch Best;
  std::vector<Part> Parts;
};

} // namespace

PlaceOnPatch ClosestOnPatchFrom(const NURBSSurface& patch, const Real3& x, double u, double v)
{
  const auto inU = [&](double at) { return std::clamp(at, patch.FirstU(), patch.LastU()); };
  const auto inV = [&](double at) { return std::clamp(at, patch.FirstV(), patch.LastV()); };
  u = inU(u);
  v = inV(v);
  PlaceOnPatch place{ u, v, {}, 0.0 };
  for (int iteration = 0; iteration < MostIterations; ++iteration)
  {
    const Descent d(patch, x, u, v);
    place = { u, v, d.At.Point, Length(d.Away) };
    const auto isHeld = [](double at, double first, double last, double slope) {
      return (at <= first && slope > 0.0) || (at >= last && slope < 0.0);
    };
    const auto [stepU, stepV] = d.Step(isHeld(u, patch.FirstU(), patch.LastU(), d.SlopeU),
      isHeld(v, patch.FirstV(), patch.LastV(), d.SlopeV));
    // What is left to gain, squared, against rounding of the distance.
    const double gain = -(stepU * d.SlopeU + stepV * d.SlopeV);
    const double rounding = std::numeric_limits<double>::epsilon() * Length(d.At.Point);
    if (!(gain > std::max(Negligible * place.Distance * place.Distance, rounding * rounding)))
    {
      break;
    }
    double factor = 1.0;
    bool moved = false;
    for (int halving = 0; halving < MostHalvings && !moved; ++halving, factor *= 0.5)
    {
      const double nextU = inU(u + factor * stepU);
      const double nextV = inV(v + factor * stepV);
      const Real3 next = EvaluatePatch(patch, nextU, nextV, 0).Point;
      if (Length(Difference(next, x)) < place.Distance)
      {
        u = nextU;
        v = nextV;
        moved = true;
      }
    }
    if (!moved)
    {
      break;
    }
  }
  return place;
}

PlaceOnPatch ClosestOnPatch(const NURBSSurface& patch, const Real3& x)
{
  return GlobalSearch(patch, x).Run();
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ClosestOnPatch.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sb
{
namespace
{

constexpr int MostIterations = 60;
constexpr int MostHalvings = 30;
constexpr std::size_t Candidates = 16;

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

/** Places to start from: in all spans more than their degree asks for, at least sixteen in all.
 * None is on the border, which may be a single point, from where no parameter leads anywhere. */
std::vector<double> Starts(const std::vector<double>& knots, int degree, int count)
{
  std::vector<double> starts;
  const auto first = knots.begin() + degree;
  const auto last = knots.begin() + count;
  const int spans = count - degree;
  const int each = std::max(2 * (degree + 1), (15 + spans) / spans);
  for (auto knot = first; knot != last; ++knot)
  {
    for (int k = 0; k < each && knot[0] < knot[1]; ++k)
    {
      starts.push_back(knot[0] + (knot[1] - knot[0]) * (k + 0.5) / each);
    }
  }
  return starts;
}

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
  struct Start
  {
    double Distance;
    double U;
    double V;
  };
  const std::vector<double> us = Starts(patch.KnotsU, patch.DegreeU, patch.CountU);
  const std::vector<double> vs = Starts(patch.KnotsV, patch.DegreeV, patch.CountV);
  std::vector<double> distances(us.size() * vs.size());
  for (std::size_t i = 0; i < us.size(); ++i)
  {
    for (std::size_t j = 0; j < vs.size(); ++j)
    {
      distances[i * vs.size() + j] =
        Length(Difference(EvaluatePatch(patch, us[i], vs[j], 0).Point, x));
    }
  }
  // Those that no neighbour on the grid is closer than.
  std::vector<Start> starts;
  for (std::size_t i = 0; i < us.size(); ++i)
  {
    for (std::size_t j = 0; j < vs.size(); ++j)
    {
      const double own = distances[i * vs.size() + j];
      const bool isLeast = (i == 0 || own < distances[(i - 1) * vs.size() + j]) &&
        (i + 1 == us.size() || own <= distances[(i + 1) * vs.size() + j]) &&
        (j == 0 || own < distances[i * vs.size() + j - 1]) &&
        (j + 1 == vs.size() || own <= distances[i * vs.size() + j + 1]);
      if (isLeast)
      {
        starts.push_back({ own, us[i], vs[j] });
      }
    }
  }
  std::stable_sort(starts.begin(), starts.end(),
    [](const Start& a, const Start& b) { return a.Distance < b.Distance; });
  starts.resize(std::min(starts.size(), Candidates));
  PlaceOnPatch best;
  for (std::size_t k = 0; k < starts.size(); ++k)
  {
    const PlaceOnPatch place = ClosestOnPatchFrom(patch, x, starts[k].U, starts[k].V);
    if (k == 0 || place.Distance < best.Distance)
    {
      best = place;
    }
  }
  return best;
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "NURBSSurface.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace sb
{
namespace
{

constexpr int Most = NURBSSurface::LargestDegree + 1;

/** The basis functions that are not 0 at a parameter, and their derivatives. */
struct Basis
{
  std::size_t First = 0; ///< the pole that the first of them belongs to
  double Values[3][Most]; ///< of derivative 0, 1, 2
};

/** The last span of the domain that is not empty and begins at or before t. */
std::size_t SpanOf(const std::vector<double>& knots, int degree, int count, double t)
{
  const auto first = knots.begin() + degree;
  const auto end = knots.begin() + count;
  // At the end of the domain the span before it, as the one that begins there is no part of it.
  const auto after =
    t < *end ? std::upper_bound(first, end, t) : std::lower_bound(first, end, *end);
  return static_cast<std::size_t>(after - knots.begin()) - 1;
}

/** From the values of all functions of degree - 1 to those of one degree more (Eq. 2.5), in place.
 */
void RaiseDegree(const double* spanKnots, int degree, double t, double* values)
{
  double carried = 0.0;
  for (int r = 0; r < degree; ++r)
  {
    const double right = spanKnots[r + 1];
    const double left = spanKnots[r + 1 - degree];
    const double share = values[r] / (right - left);
    values[r] = carried + (right - t) * share;
    carried = (t - left) * share;
  }
  values[degree] = carried;
}

/** From a derivative of all functions of degree - 1 to the next one of those of one degree more
 * (Eq. 2.7), in place. */
void RaiseDerivative(const double* spanKnots, int degree, double* values)
{
  double carried = 0.0;
  for (int r = 0; r < degree; ++r)
  {
    const double share = degree * values[r] / (spanKnots[r + 1] - spanKnots[r + 1 - degree]);
    values[r] = carried - share;
    carried = share;
  }
  values[degree] = carried;
}

void EvaluateBasis(
  const std::vector<double>& knots, int degree, int count, double t, int order, Basis& basis)
{
  const std::size_t span = SpanOf(knots, degree, count, t);
  const double* spanKnots = knots.data() + span;
  basis.First = span - static_cast<std::size_t>(degree);
  double values[Most] = { 1.0 };
  for (int d = 1; d <= degree; ++d)
  {
    // The derivative of number k needs the functions of k degrees less.
    const int derivative = degree - d + 1;
    if (derivative <= order)
    {
      std::copy(values, values + d, basis.Values[derivative]);
    }
    RaiseDegree(spanKnots, d, t, values);
  }
  std::copy(values, values + degree + 1, basis.Values[0]);
  for (int k = 1; k <= order; ++k)
  {
    if (k > degree)
    {
      std::fill(basis.Values[k], basis.Values[k] + degree + 1, 0.0);
      continue;
    }
    for (int d = degree - k + 1; d <= degree; ++d)
    {
      RaiseDerivative(spanKnots, d, basis.Values[k]);
    }
  }
}

/** A point of the patch in homogeneous coordinates, or a derivative of it. */
struct Homogeneous
{
  double X[4] = { 0.0, 0.0, 0.0, 0.0 };

  void Add(double factor, const Homogeneous& other)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->X[k] += factor * other.X[k];
    }
  }
};

/** Sums over the poles: derivative k in u and l in v is at [k][l], for k + l up to the order. */
void SumPoles(const NURBSSurface& surface, const Basis& inU, const Basis& inV, int order,
  Homogeneous (&sums)[3][3])
{
  for (int i = 0; i <= surface.DegreeU; ++i)
  {
    Homogeneous row[3];
    const std::size_t first =
      (inU.First + static_cast<std::size_t>(i)) * static_cast<std::size_t>(surface.CountV) +
      inV.First;
    const double* pole = surface.Poles.data() + 4 * first;
    for (int j = 0; j <= surface.DegreeV; ++j, pole += 4)
    {
      const double weight = pole[3];
      const Homogeneous weighted{ { weight * pole[0], weight * pole[1], weight * pole[2],
        weight } };
      for (int l = 0; l <= order; ++l)
      {
        row[l].Add(inV.Values[l][j], weighted);
      }
    }
    for (int k = 0; k <= order; ++k)
    {
      for (int l = 0; k + l <= order; ++l)
      {
        sums[k][l].Add(inU.Values[k][i], row[l]);
      }
    }
  }
}

/** (numerator - sum of factor times known) / weight: each derivative from the ones before it. */
Real3 Quotient(const Homogeneous& sum, double weight,
  std::initializer_list<std::pair<double, const Real3*>> known)
{
  Real3 result{ sum.X[0], sum.X[1], sum.X[2] };
  for (const auto& [factor, of] : known)
  {
    result = PlusScaled(result, -factor, *of);
  }
  return { result[0] / weight, result[1] / weight, result[2] / weight };
}

bool IsKnotVector(const std::vector<double>& knots, int degree, int count)
{
  return std::is_sorted(knots.begin(), knots.end()) &&
    std::all_of(knots.begin(), knots.end(), [](double knot) { return std::isfinite(knot); }) &&
    knots[static_cast<std::size_t>(degree)] < knots[static_cast<std::size_t>(count)];
}

} // namespace

const char* FaultOf(const NURBSSurface& surface)
{
  const int degrees[2] = { surface.DegreeU, surface.DegreeV };
  const int counts[2] = { surface.CountU, surface.CountV };
  const std::vector<double>* knots[2] = { &surface.KnotsU, &surface.KnotsV };
  for (int axis = 0; axis < 2; ++axis)
  {
    if (degrees[axis] < 1 || degrees[axis] > NURBSSurface::LargestDegree)
    {
      return "has a degree that is not from 1 to 25";
    }
    if (counts[axis] <= degrees[axis])
    {
      return "has too few poles for its degree";
    }
    const std::size_t expected =
      static_cast<std::size_t>(counts[axis]) + static_cast<std::size_t>(degrees[axis]) + 1;
    if (knots[axis]->size() != expected)
    {
      return "has a number of knots that does not fit its poles and degree";
    }
    if (!IsKnotVector(*knots[axis], degrees[axis], counts[axis]))
    {
      return "has knots that do not rise";
    }
  }
  if (surface.Poles.size() !=
    4 * static_cast<std::size_t>(surface.CountU) * static_cast<std::size_t>(surface.CountV))
  {
    return "has a number of poles that does not fit its counts";
  }
  for (std::size_t i = 0; i < surface.Poles.size(); i += 4)
  {
    const double* pole = surface.Poles.data() + i;
    if (!std::all_of(pole, pole + 4, [](double x) { return std::isfinite(x); }))
    {
      return "has a pole that is not finite";
    }
    if (!(pole[3] > 0.0))
    {
      return "has a weight that is not positive";
    }
  }
  return nullptr;
}

PatchPoint EvaluatePatch(const NURBSSurface& surface, double u, double v, int order)
{
  Basis inU;
  Basis inV;
  // std::max is handed the border first, so that a parameter that is no number becomes the border.
  EvaluateBasis(surface.KnotsU, surface.DegreeU, surface.CountU,
    std::min(surface.LastU(), std::max(surface.FirstU(), u)), order, inU);
  EvaluateBasis(surface.KnotsV, surface.DegreeV, surface.CountV,
    std::min(surface.LastV(), std::max(surface.FirstV(), v)), order, inV);
  Homogeneous sums[3][3];
  SumPoles(surface, inU, inV, order, sums);
  const double w = sums[0][0].X[3];
  PatchPoint p;
  p.Point = Quotient(sums[0][0], w, {});
  if (order >= 1)
  {
    p.Du = Quotient(sums[1][0], w, { { sums[1][0].X[3], &p.Point } });
    p.Dv = Quotient(sums[0][1], w, { { sums[0][1].X[3], &p.Point } });
  }
  if (order >= 2)
  {
    const double wu = sums[1][0].X[3];
    const double wv = sums[0][1].X[3];
    p.Duu = Quotient(sums[2][0], w, { { 2.0 * wu, &p.Du }, { sums[2][0].X[3], &p.Point } });
    p.Duv =
      Quotient(sums[1][1], w, { { wu, &p.Dv }, { wv, &p.Du }, { sums[1][1].X[3], &p.Point } });
    p.Dvv = Quotient(sums[0][2], w, { { 2.0 * wv, &p.Dv }, { sums[0][2].X[3], &p.Point } });
  }
  return p;
}

} // namespace sb

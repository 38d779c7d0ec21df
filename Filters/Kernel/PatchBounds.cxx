// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "PatchBounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace sb
{
namespace
{

constexpr std::size_t MostParts = 16; ///< that are bounded one by one

using Pole = std::array<double, 4>; ///< weighted coordinates, and the weight

/** The spans of one parameter that an interval reaches into. */
struct Spans
{
  const std::vector<double>& Knots;
  int Degree;
  double First;
  double Last;
  std::size_t Begin; ///< the span of First
  std::size_t End; ///< one past the span of Last
  std::size_t Count = 0; ///< of those that are not empty

  Spans(const std::vector<double>& knots, int degree, int count, double first, double last)
    : Knots(knots)
    , Degree(degree)
  {
    const auto lower = knots.begin() + degree;
    const auto upper = knots.begin() + count;
    this->First = std::clamp(first, *lower, *upper);
    this->Last = std::clamp(last, *lower, *upper);
    const auto begin = this->First < *upper ? std::upper_bound(lower, upper, this->First)
                                            : std::lower_bound(lower, upper, *upper);
    const auto end = std::max(begin, std::lower_bound(lower, upper, this->Last));
    this->Begin = static_cast<std::size_t>(begin - knots.begin()) - 1;
    this->End = static_cast<std::size_t>(end - knots.begin());
    for (std::size_t span = this->Begin; span < this->End; ++span)
    {
      this->Count += this->IsEmpty(span) ? 0 : 1;
    }
  }

  bool IsEmpty(std::size_t span) const { return !(this->Knots[span] < this->Knots[span + 1]); }
};

/** The value of the blossom of a span at `atFirst` times a and else b; de Boor's scheme with
 * another parameter in each round. */
Pole BlossomOf(const double* spanKnots, int degree, double a, double b, int atFirst, Pole* poles)
{
  for (int round = 1; round <= degree; ++round)
  {
    const double t = round <= atFirst ? a : b;
    for (int i = degree; i >= round; --i)
    {
      const double left = spanKnots[i - degree];
      const double right = spanKnots[i + 1 - round];
      const double share = (t - left) / (right - left);
      Pole& pole = poles[i];
      for (std::size_t k = 0; k < 4; ++k)
      {
        pole[k] += (1.0 - share) * (poles[i - 1][k] - pole[k]);
      }
    }
  }
  return poles[degree];
}

/** Poles in rows along v. */
struct Net
{
  std::size_t Rows = 0;
  std::size_t Columns = 0;
  std::vector<Pole> Poles;

  Net(std::size_t rows, std::size_t columns)
    : Rows(rows)
    , Columns(columns)
    , Poles(rows * columns)
  {
  }
  Pole& At(std::size_t i, std::size_t j) { return this->Poles[i * this->Columns + j]; }
};

/** The poles that matter between two spans. */
Net PolesOf(const NURBSSurface& surface, std::size_t firstSpanU, std::size_t lastSpanU,
  std::size_t firstSpanV, std::size_t lastSpanV)
{
  const std::size_t degreeU = static_cast<std::size_t>(surface.DegreeU);
  const std::size_t degreeV = static_cast<std::size_t>(surface.DegreeV);
  Net net(lastSpanU - firstSpanU + degreeU + 1, lastSpanV - firstSpanV + degreeV + 1);
  for (std::size_t i = 0; i < net.Rows; ++i)
  {
    for (std::size_t j = 0; j < net.Columns; ++j)
    {
      const double* pole = surface.Poles.data() +
        4 *
          ((firstSpanU - degreeU + i) * static_cast<std::size_t>(surface.CountV) + firstSpanV -
            degreeV + j);
      net.At(i, j) = { pole[0] * pole[3], pole[1] * pole[3], pole[2] * pole[3], pole[3] };
    }
  }
  return net;
}

/** Turn the poles of one span into those of the Bezier patch over its part of the rectangle. */
void MakeBezier(const Spans& u, std::size_t spanU, const Spans& v, std::size_t spanV, Net& net)
{
  Pole line[NURBSSurface::LargestDegree + 1];
  Pole result[NURBSSurface::LargestDegree + 1];
  const auto along = [&](const Spans& spans, std::size_t span, const auto& pole) {
    const double a = std::max(spans.First, spans.Knots[span]);
    const double b = std::min(spans.Last, spans.Knots[span + 1]);
    for (int k = 0; k <= spans.Degree; ++k)
    {
      for (int i = 0; i <= spans.Degree; ++i)
      {
        line[i] = pole(static_cast<std::size_t>(i));
      }
      result[k] = BlossomOf(spans.Knots.data() + span, spans.Degree, a, b, spans.Degree - k, line);
    }
    for (int k = 0; k <= spans.Degree; ++k)
    {
      pole(static_cast<std::size_t>(k)) = result[k];
    }
  };
  for (std::size_t j = 0; j < net.Columns; ++j)
  {
    along(u, spanU, [&](std::size_t i) -> Pole& { return net.At(i, j); });
  }
  for (std::size_t i = 0; i < net.Rows; ++i)
  {
    along(v, spanV, [&](std::size_t j) -> Pole& { return net.At(i, j); });
  }
}

/** What the hull and the derivative of a net are bounded by. */
struct NetBounds
{
  Real3 Lower{};
  Real3 Upper{};
  double LeastWeight = std::numeric_limits<double>::max();
  double Radius = 0.0; ///< of the box
  Real3 Centre{};

  explicit NetBounds(const Net& net)
  {
    this->Lower.fill(std::numeric_limits<double>::max());
    this->Upper.fill(-std::numeric_limits<double>::max());
    for (const Pole& pole : net.Poles)
    {
      this->LeastWeight = std::min(this->LeastWeight, pole[3]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Lower[k] = std::min(this->Lower[k], pole[k] / pole[3]);
        this->Upper[k] = std::max(this->Upper[k], pole[k] / pole[3]);
      }
    }
    const Real3 diagonal = Difference(this->Upper, this->Lower);
    this->Radius = 0.5 * Length(diagonal);
    this->Centre = PlusScaled(this->Lower, 0.5, diagonal);
  }

  /** With A = w (S - centre): |S_u| <= (|A_u| + |w_u| |S - centre|) / w. Here without the factor
   * that the difference of two poles has in the derivative. */
  double Slope(const Pole& a, const Pole& b) const
  {
    Real3 difference{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      difference[k] = (b[k] - a[k]) - (b[3] - a[3]) * this->Centre[k];
    }
    return (Length(difference) + std::abs(b[3] - a[3]) * this->Radius) / this->LeastWeight;
  }
};

double LongestStepU(Net& net, const NetBounds& bounds, std::size_t i)
{
  double longest = 0.0;
  for (std::size_t j = 0; j < net.Columns; ++j)
  {
    longest = std::max(longest, bounds.Slope(net.At(i, j), net.At(i + 1, j)));
  }
  return longest;
}

double LongestStepV(Net& net, const NetBounds& bounds, std::size_t j)
{
  double longest = 0.0;
  for (std::size_t i = 0; i < net.Rows; ++i)
  {
    longest = std::max(longest, bounds.Slope(net.At(i, j), net.At(i, j + 1)));
  }
  return longest;
}

void Include(PatchBounds& bounds, const NetBounds& part)
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    bounds.Lower[k] = std::min(bounds.Lower[k], part.Lower[k]);
    bounds.Upper[k] = std::max(bounds.Upper[k], part.Upper[k]);
  }
}

/** Over many spans: from the poles as they are. */
PatchBounds BoundsOfPoles(const NURBSSurface& surface, const Spans& u, const Spans& v)
{
  Net net = PolesOf(surface, u.Begin, u.End - 1, v.Begin, v.End - 1);
  const NetBounds all(net);
  PatchBounds bounds{ all.Lower, all.Upper, 0.0, 0.0 };
  // The derivative is a sum of degree times a difference over a difference of knots (Eq. 3.4).
  const auto speed = [](const Spans& spans, std::size_t i, double step) {
    const double* knots = spans.Knots.data() + spans.Begin + i + 1;
    const double apart = knots[0] - knots[-spans.Degree];
    return step == 0.0 || !(apart > 0.0) ? 0.0 : spans.Degree * step / apart;
  };
  for (std::size_t i = 0; i + 1 < net.Rows; ++i)
  {
    bounds.LengthU = std::max(bounds.LengthU, speed(u, i, LongestStepU(net, all, i)));
  }
  for (std::size_t j = 0; j + 1 < net.Columns; ++j)
  {
    bounds.LengthV = std::max(bounds.LengthV, speed(v, j, LongestStepV(net, all, j)));
  }
  bounds.LengthU *= u.Last - u.First;
  bounds.LengthV *= v.Last - v.First;
  return bounds;
}

} // namespace

PatchBounds BoundsOf(const NURBSSurface& surface, const ParameterBox& box)
{
  const Spans u(surface.KnotsU, surface.DegreeU, surface.CountU, box.FirstU, box.LastU);
  const Spans v(surface.KnotsV, surface.DegreeV, surface.CountV, box.FirstV, box.LastV);
  if (u.Count * v.Count > MostParts)
  {
    return BoundsOfPoles(surface, u, v);
  }
  PatchBounds bounds;
  bounds.Lower.fill(std::numeric_limits<double>::max());
  bounds.Upper.fill(-std::numeric_limits<double>::max());
  std::array<double, MostParts> alongV{};
  for (std::size_t spanU = u.Begin; spanU < u.End; ++spanU)
  {
    double alongU = 0.0;
    std::size_t partV = 0;
    for (std::size_t spanV = v.Begin; !u.IsEmpty(spanU) && spanV < v.End; ++spanV)
    {
      if (v.IsEmpty(spanV))
      {
        continue;
      }
      Net net = PolesOf(surface, spanU, spanU, spanV, spanV);
      MakeBezier(u, spanU, v, spanV, net);
      const NetBounds part(net);
      Include(bounds, part);
      double longestU = 0.0;
      for (std::size_t i = 0; i + 1 < net.Rows; ++i)
      {
        longestU = std::max(longestU, surface.DegreeU * LongestStepU(net, part, i));
      }
      double longestV = 0.0;
      for (std::size_t j = 0; j + 1 < net.Columns; ++j)
      {
        longestV = std::max(longestV, surface.DegreeV * LongestStepV(net, part, j));
      }
      alongU = std::max(alongU, longestU);
      alongV[partV] = std::max(alongV[partV], longestV);
      ++partV;
    }
    bounds.LengthU += alongU;
  }
  for (const double part : alongV)
  {
    bounds.LengthV += part;
  }
  return bounds;
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "UnbiasedSurface.h"

#include "Lanes.h"
#include "WeightedQuotient.h"

namespace sb
{
namespace
{

constexpr double ThinnestSpread = 1e-10; ///< of D - B.B / W to D: all samples in one place

constexpr std::size_t GroupSize = SampleGroups::Size;

template <class L>
using Three = L[3];

struct Sums
{
  double Neighbours = 0.0;
  double W = 0.0;
  double K = 0.0;
  double D = 0.0;
  double U = 0.0; ///< sum th / R^2
  Real3 B{};
  Real3 N{};
};

/** Their derivatives by x, and what second derivatives need beside those of the weights. */
struct SlopesOfSums
{
  Real3 W{};
  Real3 K{};
  Real3 D{};
  Real3x3 B{}; ///< [a][c] = d B_a / d x_c
  Real3x3 N{};
  Real3x3 Spread{}; ///< sum th_b d_c
};

/** How F changes with each sum. */
struct Influence
{
  double W = 0.0;
  double K = 0.0;
  double D = 0.0;
  Real3 B{};
  Real3 N{};
};

/** One sample in each lane, as seen from x. */
template <class L, bool Uneven>
struct SeenSamples
{
  L Away[3];
  L Normal[3];
  L Squared;
  L Height; ///< v . d
  L Left; ///< 1 - |d|^2 / R^2
  L Inverse; ///< 1 / R^2

  SeenSamples(const Three<L>& x, const double* samples, double commonInverse)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      Load(this->Away[a], samples + a * GroupSize);
      this->Away[a] = x[a] - this->Away[a];
      Load(this->Normal[a], samples + (3 + a) * GroupSize);
    }
    if constexpr (Uneven)
    {
      Load(this->Inverse, samples + 6 * GroupSize);
    }
    else
    {
      Fill(this->Inverse, commonInverse);
    }
    this->Squared =
      this->Away[0] * this->Away[0] + this->Away[1] * this->Away[1] + this->Away[2] * this->Away[2];
    this->Height = this->Away[0] * this->Normal[0] + this->Away[1] * this->Normal[1] +
      this->Away[2] * this->Normal[2];
    L one;
    Fill(one, 1.0);
    this->Left = one - this->Squared * this->Inverse;
  }
};

template <class L>
inline void Spread(const Real3& a, Three<L>& lanes)
{
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    Fill(lanes[axis], a[axis]);
  }
}

/** The sums; and in Room, for each sample: the slope of its weight by d, v . d, and |d|^2. */
template <class L, bool Uneven, bool WithSlopes>
Sums SumUp(const Real3& place, const NearGroups& near)
{
  Three<L> x;
  Spread(place, x);
  Sums sums;
  for (std::size_t part = 0; part < GroupSize; part += NumberOfLanes<L>)
  {
    Three<L> b{}, n{};
    L neighbours{}, w{}, k{}, squares{}, u{};
    for (std::size_t i = 0; i < near.Count; ++i)
    {
      const SeenSamples<L, Uneven> at(x, near.Groups[i] + part, near.CommonInverseSquaredReach);
      CountPositive(neighbours, at.Left);
      L t = at.Left;
      KeepPositive(t);
      const L t2 = t * t;
      const L th = t2 * t;
      w += th;
      k += th * at.Height;
      squares += th * at.Squared;
      if constexpr (Uneven)
      {
        u += th * at.Inverse;
      }
      for (int a = 0; a < 3; ++a)
      {
        b[a] += th * at.Away[a];
        n[a] += th * at.Normal[a];
      }
      if constexpr (WithSlopes)
      {
        double* const room = near.Room + i * RoomOfGroup + part;
        const L slope = -6.0 * at.Inverse * t2;
        Store(room, slope);
        Store(room + GroupSize, at.Height);
        Store(room + 2 * GroupSize, at.Squared);
      }
    }
    sums.Neighbours += Sum(neighbours);
    sums.W += Sum(w);
    sums.K += Sum(k);
    sums.D += Sum(squares);
    sums.U += Uneven ? Sum(u) : 0.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      sums.B[a] += Sum(b[a]);
      sums.N[a] += Sum(n[a]);
    }
  }
  sums.U = Uneven ? sums.U : near.CommonInverseSquaredReach * sums.W;
  return sums;
}

/** sum (influence on a weight) grad th, from what SumUp noted. */
template <class L>
inline Real3 SumOfSlopes(const Real3& place, const NearGroups& near, const Influence& influence)
{
  Three<L> x, ofB, ofN;
  Spread(place, x);
  Spread(influence.B, ofB);
  Spread(influence.N, ofN);
  L ofW;
  Fill(ofW, influence.W);
  Real3 result{};
  for (std::size_t part = 0; part < GroupSize; part += NumberOfLanes<L>)
  {
    Three<L> sum{};
    for (std::size_t i = 0; i < near.Count; ++i)
    {
      const double* const samples = near.Groups[i] + part;
      const double* const room = near.Room + i * RoomOfGroup + part;
      Three<L> away;
      L normal, slope, height, squared;
      Load(slope, room);
      Load(height, room + GroupSize);
      Load(squared, room + 2 * GroupSize);
      L number = ofW + influence.K * height + influence.D * squared;
      for (std::size_t a = 0; a < 3; ++a)
      {
        Load(away[a], samples + a * GroupSize);
        away[a] = x[a] - away[a];
        Load(normal, samples + (3 + a) * GroupSize);
        number += ofB[a] * away[a] + ofN[a] * normal;
      }
      number = number * slope;
      for (int a = 0; a < 3; ++a)
      {
        sum[a] += number * away[a];
      }
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      result[a] += Sum(sum[a]);
    }
  }
  return result;
}

/** n, k and F from the sums, and how F changes with them. */
struct Fit
{
  double Curvature = 0.0;
  double Denominator = 0.0; ///< of the curvature; 0 if that is not defined, and taken for constant
  Real3 Direction{}; ///< n
  double Size = 0.0; ///< |N + k B|
  Real3 Turn{}; ///< how F changes with N + k B
  double Part = 0.0; ///< how F changes with k, by the denominator
  double F = 0.0;
  Influence By;

  explicit Fit(const Sums& sums)
  {
    const double squared = Dot(sums.B, sums.B);
    const double along = Dot(sums.N, sums.B);
    const double spread = sums.D - squared / sums.W;
    if (spread > ThinnestSpread * sums.D)
    {
      this->Denominator = spread;
      this->Curvature = (along / sums.W - sums.K) / spread;
    }
    const Real3 moved = PlusScaled(sums.N, this->Curvature, sums.B);
    this->Size = Length(moved);
    if (this->Size > 0.0)
    {
      this->Direction = Scaled(moved, 1.0 / this->Size);
      this->Turn = Scaled(WithoutPartAlong(sums.B, this->Direction), 1.0 / this->Size);
    }
    this->Part = this->Denominator > 0.0 ? Dot(this->Turn, sums.B) / this->Denominator : 0.0;
    this->F = Dot(this->Direction, sums.B) + sums.K;
    const double share = this->Part / sums.W;
    this->By.N = PlusScaled(this->Turn, share, sums.B);
    this->By.B = PlusScaled(PlusScaled(this->Direction, this->Curvature, this->Turn), share,
      PlusScaled(sums.N, 2.0 * this->Curvature, sums.B));
    this->By.K = 1.0 - this->Part;
    this->By.D = -this->Part * this->Curvature;
    this->By.W = -share / sums.W * (along + this->Curvature * squared);
  }
};

/** What the slopes of the sums contribute beside those of the weights. */
Real3 SlopeBesideWeights(const Sums& sums, const Influence& influence)
{
  return PlusScaled(
    PlusScaled(Scaled(influence.B, sums.W), influence.K, sums.N), 2.0 * influence.D, sums.B);
}

/** All slopes of the sums. */
template <class L, bool Uneven>
SlopesOfSums SumSlopes(const Real3& place, const NearGroups& near, const Sums& sums)
{
  Three<L> x;
  Spread(place, x);
  SlopesOfSums slopes;
  for (std::size_t part = 0; part < GroupSize; part += NumberOfLanes<L>)
  {
    Three<L> w{}, k{}, squares{};
    Three<L> n[3] = {};
    Three<L> spread[3] = {};
    for (std::size_t i = 0; i < near.Count; ++i)
    {
      const SeenSamples<L, Uneven> at(x, near.Groups[i] + part, near.CommonInverseSquaredReach);
      L slope;
      Load(slope, near.Room + i * RoomOfGroup + part);
      for (int c = 0; c < 3; ++c)
      {
        const L thc = slope * at.Away[c];
        w[c] += thc;
        k[c] += thc * at.Height;
        squares[c] += thc * at.Squared;
        for (int a = 0; a < 3; ++a)
        {
          n[a][c] += thc * at.Normal[a];
          spread[a][c] += thc * at.Away[a];
        }
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      slopes.W[c] += Sum(w[c]);
      slopes.K[c] += Sum(k[c]);
      slopes.D[c] += Sum(squares[c]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        slopes.N[a][c] += Sum(n[a][c]);
        slopes.Spread[a][c] += Sum(spread[a][c]);
      }
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    slopes.K[c] += sums.N[c];
    slopes.D[c] += 2.0 * sums.B[c];
    for (std::size_t a = 0; a < 3; ++a)
    {
      slopes.B[a][c] = slopes.Spread[a][c] + (a == c ? sums.W : 0.0);
    }
  }
  return slopes;
}

/** Sums with the second derivatives of the weights. */
struct SecondSums
{
  Real3x3 OfF{}; ///< sum (influence on the weight) th_bc
  Real3x3 OfW{}; ///< sum th_bc
};

template <class L, bool Uneven>
SecondSums SumSecond(const Real3& place, const NearGroups& near, const Influence& influence)
{
  Three<L> x, ofB, ofN;
  Spread(place, x);
  Spread(influence.B, ofB);
  Spread(influence.N, ofN);
  L ofW;
  Fill(ofW, influence.W);
  SecondSums sums;
  for (std::size_t part = 0; part < GroupSize; part += NumberOfLanes<L>)
  {
    Three<L> ofFWith[3] = {};
    Three<L> ofWWith[3] = {};
    L diagonalOfF{}, diagonalOfW{};
    for (std::size_t i = 0; i < near.Count; ++i)
    {
      const SeenSamples<L, Uneven> at(x, near.Groups[i] + part, near.CommonInverseSquaredReach);
      L number = ofW + influence.K * at.Height + influence.D * at.Squared;
      for (int a = 0; a < 3; ++a)
      {
        number += ofB[a] * at.Away[a] + ofN[a] * at.Normal[a];
      }
      L t = at.Left;
      KeepPositive(t);
      const L second = 24.0 * at.Inverse * at.Inverse * t;
      L first;
      Load(first, near.Room + i * RoomOfGroup + part);
      diagonalOfW += first;
      diagonalOfF += first * number;
      for (int r = 0; r < 3; ++r)
      {
        for (int c = 0; c <= r; ++c)
        {
          const L thrc = second * at.Away[r] * at.Away[c];
          ofWWith[r][c] += thrc;
          ofFWith[r][c] += number * thrc;
        }
      }
    }
    for (std::size_t r = 0; r < 3; ++r)
    {
      for (std::size_t c = 0; c <= r; ++c)
      {
        sums.OfF[r][c] += Sum(ofFWith[r][c]) + (r == c ? Sum(diagonalOfF) : 0.0);
        sums.OfW[r][c] += Sum(ofWWith[r][c]) + (r == c ? Sum(diagonalOfW) : 0.0);
      }
    }
  }
  for (std::size_t r = 0; r < 3; ++r)
  {
    for (std::size_t c = r + 1; c < 3; ++c)
    {
      sums.OfF[r][c] = sums.OfF[c][r];
      sums.OfW[r][c] = sums.OfW[c][r];
    }
  }
  return sums;
}

Real3 Column(const Real3x3& m, std::size_t c) { return { m[0][c], m[1][c], m[2][c] }; }

/** How the influences change along axis c. */
Influence SlopeOfInfluence(
  const Sums& sums, const SlopesOfSums& slopes, const Fit& fit, std::size_t c)
{
  const double w = sums.W;
  const double wc = slopes.W[c];
  const Real3 bc = Column(slopes.B, c);
  const Real3 nc = Column(slopes.N, c);
  const double k = fit.Curvature;
  const double along = Dot(sums.N, sums.B);
  const double squared = Dot(sums.B, sums.B);
  const double alongC = Dot(nc, sums.B) + Dot(sums.N, bc);
  const double squaredC = 2.0 * Dot(sums.B, bc);
  double denominatorC = 0.0;
  double kc = 0.0;
  if (fit.Denominator > 0.0)
  {
    denominatorC = slopes.D[c] - (squaredC - squared * wc / w) / w;
    const double numeratorC = (alongC - along * wc / w) / w - slopes.K[c];
    kc = (numeratorC - k * denominatorC) / fit.Denominator;
  }
  const Real3& n = fit.Direction;
  const Real3 movedC = PlusScaled(PlusScaled(nc, kc, sums.B), k, bc);
  const double sizeC = Dot(n, movedC);
  const Real3 directionC = Scaled(WithoutPartAlong(movedC, n), 1.0 / fit.Size);
  const Real3 turnC = Scaled(PlusScaled(PlusScaled(PlusScaled(bc, -Dot(n, sums.B), directionC),
                                          -(Dot(directionC, sums.B) + Dot(n, bc)), n),
                               -sizeC, fit.Turn),
    1.0 / fit.Size);
  const double partC = fit.Denominator > 0.0
    ? (Dot(turnC, sums.B) + Dot(fit.Turn, bc) - fit.Part * denominatorC) / fit.Denominator
    : 0.0;
  const double share = fit.Part / w;
  const double shareC = (partC - share * wc) / w;
  const Real3 both = PlusScaled(sums.N, 2.0 * k, sums.B);
  const Real3 bothC = PlusScaled(PlusScaled(nc, 2.0 * kc, sums.B), 2.0 * k, bc);
  Influence result;
  result.N = PlusScaled(PlusScaled(turnC, shareC, sums.B), share, bc);
  result.B = PlusScaled(PlusScaled(PlusScaled(directionC, kc, fit.Turn), k, turnC), shareC, both);
  result.B = PlusScaled(result.B, share, bothC);
  result.K = -partC;
  result.D = -(partC * k + fit.Part * kc);
  result.W = -(shareC - share * wc / w) / w * (along + k * squared) -
    share / w * (alongC + kc * squared + k * squaredC);
  return result;
}

Real3x3 HessianOf(
  const Sums& sums, const SlopesOfSums& slopes, const Fit& fit, const Real3x3& withSecond)
{
  Real3x3 hessian = withSecond;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const Influence by = SlopeOfInfluence(sums, slopes, fit, c);
    for (std::size_t b = 0; b < 3; ++b)
    {
      hessian[b][c] += by.W * slopes.W[b] + by.K * slopes.K[b] + by.D * slopes.D[b] +
        Dot(by.B, Column(slopes.B, b)) + Dot(by.N, Column(slopes.N, b));
      hessian[b][c] += fit.By.K * (slopes.N[b][c] + slopes.N[c][b]) +
        fit.By.D * (4.0 * slopes.Spread[b][c] + (b == c ? 2.0 * sums.W : 0.0)) +
        fit.By.B[c] * slopes.W[b] + fit.By.B[b] * slopes.W[c];
    }
  }
  return hessian;
}

template <class L, bool Uneven>
void AddSecondOrder(
  const Real3& x, const NearGroups& near, const Sums& sums, const Fit& fit, UnbiasedValue& f)
{
  const SlopesOfSums slopes = SumSlopes<L, Uneven>(x, near, sums);
  const SecondSums second = SumSecond<L, Uneven>(x, near, fit.By);
  f.Hessian = HessianOf(sums, slopes, fit, second.OfF);
  f.Gradient =
    PlusScaled(PlusScaled(Scaled(slopes.W, fit.By.W), fit.By.K, slopes.K), fit.By.D, slopes.D);
  f.Gradient = PlusScaled(f.Gradient, 1.0, TransposeTimes(slopes.B, fit.By.B));
  f.Gradient = PlusScaled(f.Gradient, 1.0, TransposeTimes(slopes.N, fit.By.N));
  const double ratio = 2.0 * f.Value;
  f.Hessian = HessianOfQuotient(sums.W, ratio, slopes.W, second.OfW, f.Gradient, f.Hessian);
  f.Gradient = GradientOfQuotient(sums.W, ratio, slopes.W, f.Gradient);
}

template <class L, bool Uneven>
inline UnbiasedValue EvaluateSamples(const Real3& x, int order, const NearGroups& near)
{
  const Sums sums = order > 0 ? SumUp<L, Uneven, true>(x, near) : SumUp<L, Uneven, false>(x, near);
  UnbiasedValue f;
  f.Neighbours = sums.Neighbours;
  if (!(sums.W > 0.0))
  {
    f.Neighbours = 0.0;
    return f;
  }
  const Fit fit(sums);
  f.Value = 0.5 * fit.F / sums.W;
  f.Agreement = Length(sums.N) / sums.W;
  f.Mean = Scaled(sums.B, 1.0 / sums.W);
  f.Normal = fit.Direction;
  f.MeanInverseSquaredReach = sums.U / sums.W;
  if (order > 1 && fit.Size > 0.0)
  {
    AddSecondOrder<L, Uneven>(x, near, sums, fit, f);
  }
  else if (order > 0)
  {
    Influence influence = fit.By;
    const Real3 beside = SlopeBesideWeights(sums, influence);
    influence.W -= 2.0 * f.Value; // what dividing by W adds
    const Real3 sum = PlusScaled(SumOfSlopes<L>(x, near, influence), 1.0, beside);
    f.Gradient = Scaled(sum, 0.5 / sums.W);
  }
  return f;
}

template <class L>
inline UnbiasedValue Evaluate(const Real3& x, int order, const NearGroups& near)
{
  return near.Uneven ? EvaluateSamples<L, true>(x, order, near)
                     : EvaluateSamples<L, false>(x, order, near);
}

#ifdef SB_WITH_AVX
__attribute__((target("avx512f,prefer-vector-width=512"), flatten)) UnbiasedValue EvaluateByEight(
  const Real3& x, int order, const NearGroups& near)
{
  return Evaluate<WideLanes>(x, order, near);
}
__attribute__((target("avx"), flatten)) UnbiasedValue EvaluateByFour(
  const Real3& x, int order, const NearGroups& near)
{
  return Evaluate<Lanes>(x, order, near);
}
#endif

} // namespace

UnbiasedValue EvaluateUnbiased(const Real3& x, int order, const NearGroups& near)
{
#ifdef SB_WITH_AVX
  static const int lanes = LanesOfMachine();
  if (lanes == 8)
  {
    return EvaluateByEight(x, order, near);
  }
  if (lanes == 4)
  {
    return EvaluateByFour(x, order, near);
  }
#endif
  return Evaluate<Lanes>(x, order, near);
}

} // namespace sb

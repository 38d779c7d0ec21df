// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "UnbiasedSurface.h"

#include "Lanes.h"

#if defined(__GNUC__) && defined(__x86_64__)
#define SB_WITH_AVX
#endif

namespace sb
{
namespace
{

constexpr double ThinnestSpread = 1e-10; ///< of D - B.B / W to D: all samples in one place

using Lanes3 = Lanes[3];

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
template <bool Uneven>
struct FourSamples
{
  Lanes3 Away;
  Lanes3 Normal;
  Lanes Squared;
  Lanes Height; ///< v . d
  Lanes Left; ///< 1 - |d|^2 / R^2
  Lanes Inverse; ///< 1 / R^2

  FourSamples(const Lanes3& x, const SampleRows& rows, std::size_t i)
  {
    for (int a = 0; a < 3; ++a)
    {
      Load(this->Away[a], rows.Position[a] + i);
      this->Away[a] = x[a] - this->Away[a];
      Load(this->Normal[a], rows.Normal[a] + i);
    }
    if constexpr (Uneven)
    {
      Load(this->Inverse, rows.InverseSquaredReach + i);
    }
    else
    {
      Fill(this->Inverse, rows.CommonInverseSquaredReach);
    }
    this->Squared =
      this->Away[0] * this->Away[0] + this->Away[1] * this->Away[1] + this->Away[2] * this->Away[2];
    this->Height = this->Away[0] * this->Normal[0] + this->Away[1] * this->Normal[1] +
      this->Away[2] * this->Normal[2];
    Lanes one;
    Fill(one, 1.0);
    this->Left = one - this->Squared * this->Inverse;
  }
};

/** The sums; and in Room, for each sample: the slope of its weight by d, v . d, and |d|^2. */
template <bool Uneven, bool WithSlopes>
Sums SumUp(const Real3& place, const SampleRows& rows)
{
  Lanes3 x;
  Lanes3 b{}, n{};
  Lanes neighbours{}, w{}, k{}, squares{}, u{}, minusEight;
  Fill(minusEight, -8.0);
  for (int a = 0; a < 3; ++a)
  {
    Fill(x[a], place[static_cast<std::size_t>(a)]);
  }
  for (std::size_t i = 0; i < rows.Count; i += NumberOfLanes)
  {
    const FourSamples<Uneven> at(x, rows, i);
    CountPositive(neighbours, at.Left);
    Lanes t = at.Left;
    KeepPositive(t);
    const Lanes t2 = t * t;
    const Lanes t3 = t2 * t;
    const Lanes th = t3 * t;
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
      const Lanes slope = minusEight * at.Inverse * t3;
      Store(rows.Room[0] + i, slope);
      Store(rows.Room[1] + i, at.Height);
      Store(rows.Room[2] + i, at.Squared);
    }
  }
  Sums sums;
  sums.Neighbours = Sum(neighbours);
  sums.W = Sum(w);
  sums.K = Sum(k);
  sums.D = Sum(squares);
  sums.U = Uneven ? Sum(u) : rows.CommonInverseSquaredReach * sums.W;
  sums.B = { Sum(b[0]), Sum(b[1]), Sum(b[2]) };
  sums.N = { Sum(n[0]), Sum(n[1]), Sum(n[2]) };
  return sums;
}

/** sum (influence on a weight) grad th, from what SumUp noted. */
inline Real3 SumOfSlopes(const Real3& place, const SampleRows& rows, const Influence& influence)
{
  Lanes3 x, ofB, ofN;
  Lanes3 sum{};
  Lanes ofW, ofK, ofD;
  Fill(ofW, influence.W);
  Fill(ofK, influence.K);
  Fill(ofD, influence.D);
  for (int a = 0; a < 3; ++a)
  {
    const std::size_t axis = static_cast<std::size_t>(a);
    Fill(x[a], place[axis]);
    Fill(ofB[a], influence.B[axis]);
    Fill(ofN[a], influence.N[axis]);
  }
  for (std::size_t i = 0; i < rows.Count; i += NumberOfLanes)
  {
    Lanes3 away, normal;
    Lanes slope, height, squared;
    Load(slope, rows.Room[0] + i);
    Load(height, rows.Room[1] + i);
    Load(squared, rows.Room[2] + i);
    Lanes number = ofW + ofK * height + ofD * squared;
    for (int a = 0; a < 3; ++a)
    {
      Load(away[a], rows.Position[a] + i);
      away[a] = x[a] - away[a];
      Load(normal[a], rows.Normal[a] + i);
      number += ofB[a] * away[a] + ofN[a] * normal[a];
    }
    number = number * slope;
    for (int a = 0; a < 3; ++a)
    {
      sum[a] += number * away[a];
    }
  }
  return { Sum(sum[0]), Sum(sum[1]), Sum(sum[2]) };
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
template <bool Uneven>
SlopesOfSums SumSlopes(const Real3& place, const SampleRows& rows, const Sums& sums)
{
  Lanes3 x;
  Lanes3 w{}, k{}, squares{};
  Lanes3 n[3] = {};
  Lanes3 spread[3] = {};
  for (int a = 0; a < 3; ++a)
  {
    Fill(x[a], place[static_cast<std::size_t>(a)]);
  }
  for (std::size_t i = 0; i < rows.Count; i += NumberOfLanes)
  {
    const FourSamples<Uneven> at(x, rows, i);
    Lanes slope;
    Load(slope, rows.Room[0] + i);
    for (int c = 0; c < 3; ++c)
    {
      const Lanes thc = slope * at.Away[c];
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
  SlopesOfSums slopes;
  for (std::size_t c = 0; c < 3; ++c)
  {
    slopes.W[c] = Sum(w[c]);
    slopes.K[c] = Sum(k[c]) + sums.N[c];
    slopes.D[c] = Sum(squares[c]) + 2.0 * sums.B[c];
    for (std::size_t a = 0; a < 3; ++a)
    {
      slopes.N[a][c] = Sum(n[a][c]);
      slopes.Spread[a][c] = Sum(spread[a][c]);
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

template <bool Uneven>
SecondSums SumSecond(const Real3& place, const SampleRows& rows, const Influence& influence)
{
  Lanes3 x, ofB, ofN;
  Lanes ofW, ofK, ofD, bend;
  Lanes ofFWith[3][3] = {};
  Lanes ofWWith[3][3] = {};
  Lanes diagonalOfF{}, diagonalOfW{};
  Fill(ofW, influence.W);
  Fill(ofK, influence.K);
  Fill(ofD, influence.D);
  Fill(bend, 48.0);
  for (int a = 0; a < 3; ++a)
  {
    const std::size_t axis = static_cast<std::size_t>(a);
    Fill(x[a], place[axis]);
    Fill(ofB[a], influence.B[axis]);
    Fill(ofN[a], influence.N[axis]);
  }
  for (std::size_t i = 0; i < rows.Count; i += NumberOfLanes)
  {
    const FourSamples<Uneven> at(x, rows, i);
    Lanes number = ofW + ofK * at.Height + ofD * at.Squared;
    for (int a = 0; a < 3; ++a)
    {
      number += ofB[a] * at.Away[a] + ofN[a] * at.Normal[a];
    }
    Lanes t = at.Left;
    KeepPositive(t);
    const Lanes second = bend * at.Inverse * at.Inverse * t * t;
    Lanes first;
    Load(first, rows.Room[0] + i);
    diagonalOfW += first;
    diagonalOfF += first * number;
    for (int r = 0; r < 3; ++r)
    {
      for (int c = 0; c <= r; ++c)
      {
        const Lanes thrc = second * at.Away[r] * at.Away[c];
        ofWWith[r][c] += thrc;
        ofFWith[r][c] += number * thrc;
      }
    }
  }
  SecondSums sums;
  for (std::size_t r = 0; r < 3; ++r)
  {
    for (std::size_t c = 0; c <= r; ++c)
    {
      sums.OfF[r][c] = sums.OfF[c][r] = Sum(ofFWith[r][c]) + (r == c ? Sum(diagonalOfF) : 0.0);
      sums.OfW[r][c] = sums.OfW[c][r] = Sum(ofWWith[r][c]) + (r == c ? Sum(diagonalOfW) : 0.0);
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

/** Turn F and its derivatives into those of F / (2 W). */
void DivideByWeights(double w, const Real3& wb, const Real3x3& wbc, UnbiasedValue& f)
{
  const double scale = 0.5 / w;
  const double value = 2.0 * f.Value;
  for (std::size_t b = 0; b < 3; ++b)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      f.Hessian[b][c] = scale *
        (f.Hessian[b][c] - (f.Gradient[b] * wb[c] + f.Gradient[c] * wb[b]) / w - value * wbc[b][c] +
          2.0 * value * wb[b] * wb[c] / w);
    }
  }
  for (std::size_t b = 0; b < 3; ++b)
  {
    f.Gradient[b] = scale * (f.Gradient[b] - value * wb[b]);
  }
}

template <bool Uneven>
void AddSecondOrder(
  const Real3& x, const SampleRows& rows, const Sums& sums, const Fit& fit, UnbiasedValue& f)
{
  const SlopesOfSums slopes = SumSlopes<Uneven>(x, rows, sums);
  const SecondSums second = SumSecond<Uneven>(x, rows, fit.By);
  f.Hessian = HessianOf(sums, slopes, fit, second.OfF);
  f.Gradient =
    PlusScaled(PlusScaled(Scaled(slopes.W, fit.By.W), fit.By.K, slopes.K), fit.By.D, slopes.D);
  f.Gradient = PlusScaled(f.Gradient, 1.0, TransposeTimes(slopes.B, fit.By.B));
  f.Gradient = PlusScaled(f.Gradient, 1.0, TransposeTimes(slopes.N, fit.By.N));
  DivideByWeights(sums.W, slopes.W, second.OfW, f);
}

template <bool Uneven>
inline UnbiasedValue Evaluate(const Real3& x, int order, const SampleRows& rows)
{
  const Sums sums = order > 0 ? SumUp<Uneven, true>(x, rows) : SumUp<Uneven, false>(x, rows);
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
    AddSecondOrder<Uneven>(x, rows, sums, fit, f);
  }
  else if (order > 0)
  {
    Influence influence = fit.By;
    const Real3 beside = SlopeBesideWeights(sums, influence);
    influence.W -= 2.0 * f.Value; // what dividing by W adds
    const Real3 sum = PlusScaled(SumOfSlopes(x, rows, influence), 1.0, beside);
    f.Gradient = Scaled(sum, 0.5 / sums.W);
  }
  return f;
}

#ifdef SB_WITH_AVX
__attribute__((target("avx"), flatten)) UnbiasedValue EvaluateByFour(
  const Real3& x, int order, const SampleRows& rows)
{
  return rows.InverseSquaredReach ? Evaluate<true>(x, order, rows)
                                  : Evaluate<false>(x, order, rows);
}
#endif

} // namespace

UnbiasedValue EvaluateUnbiased(const Real3& x, int order, const SampleRows& rows)
{
#ifdef SB_WITH_AVX
  static const bool hasAVX = __builtin_cpu_supports("avx") != 0;
  if (hasAVX)
  {
    return EvaluateByFour(x, order, rows);
  }
#endif
  return rows.InverseSquaredReach ? Evaluate<true>(x, order, rows)
                                  : Evaluate<false>(x, order, rows);
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MovingLeastSquares.h"

#include "Lanes.h"
#include "UnbiasedSurface.h"
#include "WeightedQuotient.h"

#include <algorithm>
#include <atomic>

namespace sb
{
namespace
{

constexpr std::int32_t FewestNeighbours = 6;
constexpr double LeastAgreement = 0.3; ///< of |N| to the sum of weights
constexpr double LargestOffset = 0.5; ///< of the samples' mean along the surface, in h
constexpr double MarginOfIterations = 0.35; ///< in h: most projections stay within it
constexpr double Slack = 0.8; ///< in R: how far around a place the tree is looked up
constexpr double LastStep = 1e-6; ///< in h
constexpr double ReachOfUnbiased = 2.0; ///< in h
constexpr double ReachOfAmentaKil = 4.5;
constexpr std::size_t FirstRoom = 6; ///< rows before it hold samples, two from it on are room
constexpr std::size_t NumberOfRows = FirstRoom + 2;
const double OneOverRootThree = 1.0 / std::sqrt(3.0);

/** Cut where it has fallen below 2e-9, so that the function has no step that its curvature shows.
 */
struct GaussianWeight
{
  double InverseSquaredWidth;
  double SquaredReach;

  double At(double squared) const
  {
    return squared < this->SquaredReach ? std::exp(-squared * this->InverseSquaredWidth) : 0.0;
  }
};

/** Six sums of products of coordinates, read as a matrix. */
template <class Number>
struct SymmetricSum
{
  Number XX{}, XY{}, XZ{}, YY{}, YZ{}, ZZ{};

  /** Add factor * d d^T. */
  void Add(Number factor, Number x, Number y, Number z)
  {
    this->XX += factor * x * x;
    this->XY += factor * x * y;
    this->XZ += factor * x * z;
    this->YY += factor * y * y;
    this->YZ += factor * y * z;
    this->ZZ += factor * z * z;
  }

  /** With `diagonal` added to each element of the diagonal. */
  Real3x3 PlusDiagonal(Number diagonal) const
  {
    return { { { this->XX + diagonal, this->XY, this->XZ },
      { this->XY, this->YY + diagonal, this->YZ }, { this->XZ, this->YZ, this->ZZ + diagonal } } };
  }
};

/** The field of normals n = N / |N| and its derivatives. */
struct NormalField
{
  Real3 Unit{};
  double Length = 0.0;
  Real3x3 Derivative{}; ///< [a][b] = d n_a / d x_b

  NormalField(const Real3& sum, const Real3x3& derivativeOfSum)
    : Length(sb::Length(sum))
  {
    if (!(this->Length > 0.0))
    {
      return;
    }
    this->Unit = Scaled(sum, 1.0 / this->Length);
    const Real3 along = TransposeTimes(derivativeOfSum, this->Unit);
    for (std::size_t a = 0; a < 3; ++a)
    {
      for (std::size_t b = 0; b < 3; ++b)
      {
        this->Derivative[a][b] = (derivativeOfSum[a][b] - this->Unit[a] * along[b]) / this->Length;
      }
    }
  }

  /** What stands beside a vector D in sum th_bc (PD . v) / |N|, the part of D . d_b d_c n with
   * second derivatives of the weights. */
  Real3 Contraction(const Real3& d) const
  {
    return this->Length > 0.0 ? Scaled(WithoutPartAlong(d, this->Unit), 1.0 / this->Length)
                              : Real3{};
  }

  /** Add the other part: -((D.n_b)(n.N_c) + (D.n_c)(n.N_b)) / |N| - (D.n)(n_b.n_c). */
  void AddContracted(const Real3& d, const Real3x3& derivativeOfSum, Real3x3& hessian) const
  {
    if (!(this->Length > 0.0))
    {
      return;
    }
    const Real3 dn = TransposeTimes(this->Derivative, d);
    const Real3 along = TransposeTimes(derivativeOfSum, this->Unit);
    const double normalPart = Dot(d, this->Unit);
    for (std::size_t b = 0; b < 3; ++b)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        double both = 0.0;
        for (std::size_t a = 0; a < 3; ++a)
        {
          both += this->Derivative[a][b] * this->Derivative[a][c];
        }
        hessian[b][c] -= (dn[b] * along[c] + dn[c] * along[b]) / this->Length + normalPart * both;
      }
    }
  }
};

/** Of the Gaussian weight, what does not need n. */
struct NormalSums
{
  std::int32_t Neighbours = 0;
  double W = 0.0;
  Real3 B{}; ///< sum th d
  Real3 N{};
  Real3x3 NB{}; ///< sum v_a th_b
  SymmetricSum<double> Spread; ///< sum th_bc, without its diagonal part
};

/** The gradient of the energy along n, and what its derivatives are made of. */
struct EnergySums
{
  double G = 0.0;
  double S = 0.0; ///< sum th phi'
  Real3 D{}; ///< sum th phi' d
  Real3 Steep{}; ///< sum phi grad th
};

/** The passes over the neighbours of x for the energy of Amenta and Kil, phi being 2 u - c u^3. */
struct GaussianSamples
{
  const Real3& X;
  const double* const* Rows;
  double* Weights; ///< filled in by the first pass
  std::size_t Count;
  double Slope; ///< -1 / h^2, the first derivative of a weight by the weight; c is -2 of it

  Real3 Away(std::size_t i) const
  {
    return { this->X[0] - this->Rows[0][i], this->X[1] - this->Rows[1][i],
      this->X[2] - this->Rows[2][i] };
  }
  Real3 Normal(std::size_t i) const
  {
    return { this->Rows[3][i], this->Rows[4][i], this->Rows[5][i] };
  }

  NormalSums SumNormals(const GaussianWeight& weight, int order) const
  {
    NormalSums sums;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const Real3 d = this->Away(i);
      const Real3 v = this->Normal(i);
      const double th = weight.At(Dot(d, d));
      this->Weights[i] = th;
      sums.Neighbours += th > 0.0 ? 1 : 0;
      sums.W += th;
      sums.B = PlusScaled(sums.B, th, d);
      sums.N = PlusScaled(sums.N, th, v);
      for (std::size_t a = 0; order > 0 && a < 3; ++a)
      {
        sums.NB[a] = PlusScaled(sums.NB[a], 2.0 * this->Slope * th * v[a], d);
      }
      if (order > 1)
      {
        sums.Spread.Add(4.0 * this->Slope * this->Slope * th, d[0], d[1], d[2]);
      }
    }
    return sums;
  }

  EnergySums SumEnergy(const Real3& n) const
  {
    EnergySums sums;
    const double c = -2.0 * this->Slope;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const Real3 d = this->Away(i);
      const double th = this->Weights[i];
      const double u = Dot(d, n);
      const double phi = u * (2.0 - c * u * u);
      const double phi1 = 2.0 - 3.0 * c * u * u;
      sums.G += th * phi;
      sums.S += th * phi1;
      sums.D = PlusScaled(sums.D, th * phi1, d);
      sums.Steep = PlusScaled(sums.Steep, 2.0 * this->Slope * th * phi, d);
    }
    return sums;
  }

  /** sum (phi + contraction . v) th_bc + phi' (th_b u_c + th_c u_b) + th phi'' u_b u_c. */
  Real3x3 SumHessian(const NormalField& field, const Real3& contraction) const
  {
    Real3x3 sums{};
    const double c = -2.0 * this->Slope;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const Real3 d = this->Away(i);
      const double th = this->Weights[i];
      const double u = Dot(d, field.Unit);
      const double number = u * (2.0 - c * u * u) + Dot(contraction, this->Normal(i));
      const double mixed = 2.0 * this->Slope * (2.0 - 3.0 * c * u * u);
      const Real3 gu = PlusScaled(TransposeTimes(field.Derivative, d), 1.0, field.Unit);
      for (std::size_t r = 0; r < 3; ++r)
      {
        for (std::size_t t = 0; t < 3; ++t)
        {
          sums[r][t] += th *
            (4.0 * this->Slope * this->Slope * number * d[r] * d[t] +
              (r == t ? 2.0 * this->Slope * number : 0.0) + mixed * (d[r] * gu[t] + d[t] * gu[r]) -
              6.0 * c * u * gu[r] * gu[t]);
        }
      }
    }
    return sums;
  }
};

/** Surfaces have numbers, as one may come to lie in memory where another one was. */
std::uint64_t NextNumber()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

/** @param agreement |N| / W. @param mean the weighted mean of d */
Support Judge(double agreement, const Real3& mean, const Real3& n, double h)
{
  if (agreement < LeastAgreement)
  {
    return Support::Contradicting;
  }
  return sb::Length(WithoutPartAlong(mean, n)) > LargestOffset * h ? Support::Border
                                                                   : Support::Defined;
}

} // namespace

MovingLeastSquares::MovingLeastSquares(std::shared_ptr<const PointTree> tree, const double* normals,
  SurfaceDefinition definition, double width, const std::vector<double>& widths)
  : Tree(std::move(tree))
  , Number(NextNumber())
  , Kind(definition)
  , H(width)
  , R((definition == SurfaceDefinition::AmentaKil ? ReachOfAmentaKil : ReachOfUnbiased) * width)
{
  this->MostWidth = this->H;
  std::vector<double> reaches;
  if (definition == SurfaceDefinition::Unbiased && !widths.empty())
  {
    reaches = this->TakeWidths(widths);
  }
  this->Groups = std::make_unique<SampleGroups>(*this->Tree, normals, reaches, this->R);
}

/** @return how far each sample reaches. */
std::vector<double> MovingLeastSquares::TakeWidths(const std::vector<double>& widths)
{
  std::vector<double> reaches = widths;
  const auto narrow = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() / 100);
  std::nth_element(reaches.begin(), narrow, reaches.end());
  this->Narrow = *narrow;
  this->MostWidth = *std::max_element(widths.begin(), widths.end());
  this->R = ReachOfUnbiased * this->MostWidth;
  std::transform(widths.begin(), widths.end(), reaches.begin(),
    [](double width) { return ReachOfUnbiased * width; });
  return reaches;
}

void MovingLeastSquares::Surround(const Real3& middle, double radius, Neighbourhood& near) const
{
  near.Of = this->Number;
  near.Middle = middle;
  near.Around = radius;
  this->Groups->Surround(*this->Tree, middle, radius, near.Groups);
}

/** Places mostly follow each other closely. Then the tree is looked up once for several of them. */
void MovingLeastSquares::Gather(const Real3& x, double margin, Neighbourhood& near) const
{
  const double away = Length(Difference(x, near.Middle));
  if (near.Of != this->Number || away + margin > near.Around)
  {
    const bool follows = near.Of == this->Number && away < Slack * this->R;
    this->Surround(x, margin + (follows ? Slack * this->R : 0.0), near);
  }
  near.Centre = x;
  near.Margin = margin;
  this->Groups->Filter(x, margin, near.Groups);
  if (this->Kind == SurfaceDefinition::AmentaKil)
  {
    this->Copy(near);
  }
}

/** The samples of the groups that are within reach, one after the other. */
void MovingLeastSquares::Copy(Neighbourhood& near) const
{
  const std::size_t groups = near.Groups.Count();
  if (groups * SampleGroups::Size > near.Capacity)
  {
    near.Capacity = 2 * groups * SampleGroups::Size;
    near.Memory.resize(NumberOfRows * near.Capacity);
  }
  const double limit = (this->R + near.Margin) * (this->R + near.Margin);
  std::size_t count = 0;
  for (std::size_t i = 0; i < groups * SampleGroups::Size; ++i)
  {
    const double* const sample =
      near.Groups.Groups()[i / SampleGroups::Size] + i % SampleGroups::Size;
    Real3 q;
    for (std::size_t row = 0; row < FirstRoom; ++row)
    {
      near.Row(row)[count] = sample[row * SampleGroups::Size];
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      q[axis] = near.Row(axis)[count];
    }
    const Real3 away = Difference(q, near.Centre);
    // Written always and counted only if near: no branch to guess wrong.
    count += Dot(away, away) < limit ? 1 : 0;
  }
  near.Count = static_cast<std::int32_t>(count);
}

SurfaceValue MovingLeastSquares::Evaluate(const Real3& x, int order, Neighbourhood& near) const
{
  return this->Kind == SurfaceDefinition::AmentaKil ? this->EvaluateAmentaKil(x, order, near)
                                                    : this->EvaluateUnbiased(x, order, near);
}

/** UnbiasedSurface.h says what it is. */
SurfaceValue MovingLeastSquares::EvaluateUnbiased(
  const Real3& x, int order, Neighbourhood& near) const
{
  near.Room.resize(std::max(near.Room.size(), near.Groups.Count() * RoomOfGroup));
  const UnbiasedValue value = sb::EvaluateUnbiased(x, order,
    { near.Groups.Groups(), near.Groups.Count(), this->IsUneven(), 1.0 / (this->R * this->R),
      near.Room.data() });
  SurfaceValue f;
  if (value.Neighbours < FewestNeighbours)
  {
    return f;
  }
  f.IsNear = true;
  f.Width =
    this->IsUneven() ? 1.0 / (ReachOfUnbiased * std::sqrt(value.MeanInverseSquaredReach)) : this->H;
  f.Where = Judge(value.Agreement, value.Mean, value.Normal, f.Width);
  f.Value = value.Value;
  f.Gradient = value.Gradient;
  f.Hessian = value.Hessian;
  return f;
}

/** F = g = sum th (2 u - c u^3) with u = d . n and c = 2 / h^2 (the gradient of Eq. 4 along n). */
SurfaceValue MovingLeastSquares::EvaluateAmentaKil(
  const Real3& x, int order, Neighbourhood& near) const
{
  const double* const rows[6] = { near.Row(0), near.Row(1), near.Row(2), near.Row(3), near.Row(4),
    near.Row(5) };
  const GaussianWeight weight{ 1.0 / (this->H * this->H), this->R * this->R };
  const GaussianSamples samples{ x, rows, near.Row(FirstRoom), static_cast<std::size_t>(near.Count),
    -weight.InverseSquaredWidth };
  const NormalSums sums = samples.SumNormals(weight, order);
  SurfaceValue f;
  if (sums.Neighbours < FewestNeighbours)
  {
    return f;
  }
  const NormalField field(sums.N, sums.NB);
  const Real3 mean = Scaled(sums.B, 1.0 / sums.W);
  const double height = Dot(mean, field.Unit);
  f.IsNear = true;
  f.Width = this->H;
  f.Where = Judge(field.Length / sums.W, mean, field.Unit, this->H);
  if (std::abs(height) > OneOverRootThree * this->H)
  {
    // Beyond its reach the sign of g says nothing; that of the height still does.
    f.Where = f.Where == Support::Defined ? Support::Far : f.Where;
    f.Value = height;
    f.Gradient = field.Unit;
    return f;
  }
  const EnergySums energy = samples.SumEnergy(field.Unit);
  const double ratio = energy.G / sums.W;
  const Real3 wb = Scaled(sums.B, 2.0 * samples.Slope);
  if (order > 0)
  {
    const Real3 turn = TransposeTimes(field.Derivative, energy.D);
    for (std::size_t a = 0; a < 3; ++a)
    {
      f.Gradient[a] = energy.Steep[a] + energy.S * field.Unit[a] + turn[a];
    }
  }
  if (order > 1)
  {
    f.Hessian = samples.SumHessian(field, field.Contraction(energy.D));
    field.AddContracted(energy.D, sums.NB, f.Hessian);
    for (std::size_t r = 0; r < 3; ++r)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        f.Hessian[r][c] += energy.S * (field.Derivative[r][c] + field.Derivative[c][r]);
      }
    }
    f.Hessian = HessianOfQuotient(sums.W, ratio, wb,
      sums.Spread.PlusDiagonal(2.0 * samples.Slope * sums.W), f.Gradient, f.Hessian);
  }
  f.Gradient = GradientOfQuotient(sums.W, ratio, wb, f.Gradient);
  f.Value = 0.5 * ratio;
  return f;
}

SurfaceValue MovingLeastSquares::Project(Real3& x, Neighbourhood& near) const
{
  const Real3 start = x;
  const SurfaceValue reached = this->Kind == SurfaceDefinition::AmentaKil
    ? this->ProjectByEnergy(x, near)
    : this->ProjectByNewton(x, near);
  if (!reached.IsNear)
  {
    x = start;
  }
  return reached;
}

SurfaceValue MovingLeastSquares::ProjectByNewton(Real3& x, Neighbourhood& near) const
{
  const Real3 start = x;
  const double margin = MarginOfIterations * this->NarrowWidth();
  this->Gather(x, margin, near);
  for (int iteration = 0; iteration < 40; ++iteration)
  {
    if (Length(Difference(x, near.Centre)) > near.Margin)
    {
      this->Gather(x, margin, near);
    }
    const SurfaceValue f = this->Evaluate(x, 1, near);
    const double steepness = Dot(f.Gradient, f.Gradient);
    if (!f.IsNear || !(steepness > 0.0))
    {
      return {};
    }
    const double length = std::abs(f.Value) / std::sqrt(steepness);
    const double most = 0.5 * f.Width;
    const double damping = length > most ? most / length : 1.0;
    x = PlusScaled(x, -damping * f.Value / steepness, f.Gradient);
    if (Length(Difference(x, start)) > f.Width)
    {
      return {};
    }
    if (length < LastStep * f.Width) // and quadratic convergence has squared it by now
    {
      return f;
    }
  }
  return {};
}

/** From x to the least energy on the line along n(x), section 3.1 of Yang and Qian. */
bool MovingLeastSquares::StepToLeastEnergy(Real3& x, Neighbourhood& near, double& step) const
{
  const GaussianWeight weight{ 1.0 / (this->H * this->H), this->R * this->R };
  const std::size_t count = static_cast<std::size_t>(near.Count);
  double* const heights = near.Row(FirstRoom);
  double* const squares = near.Row(FirstRoom + 1);
  Real3 n{};
  for (std::size_t i = 0; i < count; ++i)
  {
    const Real3 d{ x[0] - near.Row(0)[i], x[1] - near.Row(1)[i], x[2] - near.Row(2)[i] };
    squares[i] = Dot(d, d);
    const double th = weight.At(squares[i]);
    n = PlusScaled(n, th, { near.Row(3)[i], near.Row(4)[i], near.Row(5)[i] });
  }
  const double length = Length(n);
  if (!(length > 0.0))
  {
    return false;
  }
  n = Scaled(n, 1.0 / length);
  for (std::size_t i = 0; i < count; ++i)
  {
    heights[i] = (x[0] - near.Row(0)[i]) * n[0] + (x[1] - near.Row(1)[i]) * n[1] +
      (x[2] - near.Row(2)[i]) * n[2];
  }
  const double c = 2.0 * weight.InverseSquaredWidth;
  double t = 0.0;
  for (int iteration = 0; iteration < 30; ++iteration)
  {
    double first = 0.0, second = 0.0;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double th = weight.At(squares[i] + t * (2.0 * heights[i] + t));
      const double u = heights[i] + t;
      const double u2 = u * u;
      first += th * u * (2.0 - c * u2);
      second += th * (2.0 - 5.0 * c * u2 + c * c * u2 * u2);
    }
    // Where the energy is not convex, a step downhill.
    const double newton = second > 0.0 ? -first / second : (first > 0.0 ? -0.25 : 0.25) * this->H;
    const double bounded = std::clamp(newton, -0.5 * this->H, 0.5 * this->H);
    t += bounded;
    if (!(std::abs(t) <= this->H))
    {
      return false;
    }
    if (std::abs(bounded) < 1e-6 * this->H) // and the next one would be its square
    {
      break;
    }
  }
  x = PlusScaled(x, t, n);
  step = t;
  return true;
}

SurfaceValue MovingLeastSquares::ProjectByEnergy(Real3& x, Neighbourhood& near) const
{
  const Real3 start = x;
  this->Gather(x, MarginOfIterations * this->H, near);
  for (int iteration = 0; iteration < 100; ++iteration)
  {
    if (Length(Difference(x, near.Centre)) > near.Margin)
    {
      this->Gather(x, MarginOfIterations * this->H, near);
    }
    double step = 0.0;
    if (near.Count < FewestNeighbours || !this->StepToLeastEnergy(x, near, step) ||
      Length(Difference(x, start)) > this->H)
    {
      return {};
    }
    if (std::abs(step) < 1e-9 * this->H)
    {
      return this->Evaluate(x, 1, near);
    }
  }
  return {};
}

double MovingLeastSquares::DistanceToSamples(const Real3& x, Real3* gradient) const
{
  constexpr int most = 8;
  PointTree::Neighbour found[most];
  const int count = this->Tree->Nearest(x, most, found);
  if (count == 0)
  {
    return 0.0;
  }
  double side = 0.0;
  for (int i = 0; i < count; ++i)
  {
    side +=
      Dot(Difference(x, this->Tree->Point(found[i].Index)), this->SampleNormal(found[i].Index));
  }
  const double distance = std::sqrt(found[0].SquaredDistance);
  const double sign = side < 0.0 ? -1.0 : 1.0;
  if (gradient)
  {
    *gradient = distance > 0.0
      ? Scaled(Difference(x, this->Tree->Point(found[0].Index)), sign / distance)
      : this->SampleNormal(found[0].Index);
  }
  return sign * distance;
}

SurfaceCurvature CurvatureOf(const SurfaceValue& value)
{
  SurfaceCurvature curvature;
  const double steepness = Length(value.Gradient);
  if (!(steepness > 0.0))
  {
    return curvature;
  }
  const Real3 n = Scaled(value.Gradient, 1.0 / steepness);
  const std::size_t axis = std::abs(n[0]) <= std::abs(n[1]) && std::abs(n[0]) <= std::abs(n[2]) ? 0
    : std::abs(n[1]) <= std::abs(n[2])                                                          ? 1
                                                                                                : 2;
  Real3 u{};
  u[axis] = 1.0;
  u = WithoutPartAlong(u, n);
  u = Scaled(u, 1.0 / Length(u));
  const Real3 v = Cross(n, u);
  const double uu = Dot(u, Times(value.Hessian, u)) / steepness;
  const double uv = Dot(u, Times(value.Hessian, v)) / steepness;
  const double vv = Dot(v, Times(value.Hessian, v)) / steepness;
  const double mean = 0.5 * (uu + vv);
  const double spread = std::sqrt(0.25 * (uu - vv) * (uu - vv) + uv * uv);
  curvature.Maximum = mean + spread;
  curvature.Minimum = mean - spread;
  return curvature;
}

double SectionCurvature(const SurfaceValue& value, const Real3& planeNormal)
{
  const Real3 inPlane = WithoutPartAlong(value.Gradient, planeNormal);
  const double steepness = Length(inPlane);
  if (!(steepness > 0.0))
  {
    return 0.0;
  }
  const Real3 tangent = Scaled(Cross(planeNormal, inPlane), 1.0 / steepness);
  return -Dot(tangent, Times(value.Hessian, tangent)) / steepness;
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AffineFit.h"

#include "SymmetricEigen.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sb
{
namespace
{

constexpr std::int64_t mostSamples = 50000; // more do not make twelve numbers better
constexpr int mostRounds = 60;
constexpr double rounding = 1e-15;

/** Pairs of points, about the middle of each list, so that nothing is lost far from the origin. */
struct Pairs
{
  std::vector<Real3> From;
  std::vector<Real3> To;
  Real3 MiddleFrom{};
  Real3 MiddleTo{};
  double SizeFrom = 0.0; ///< the largest distance from the middle
  double SizeTo = 0.0;
};

Real3 PointAt(const double* points, std::int64_t i)
{
  return { points[3 * i], points[3 * i + 1], points[3 * i + 2] };
}

Pairs SampledPairs(const double* from, const double* to, std::int64_t count)
{
  Pairs pairs;
  const std::int64_t step = (count + mostSamples - 1) / mostSamples;
  for (std::int64_t i = 0; i < count; i += step)
  {
    pairs.From.push_back(PointAt(from, i));
    pairs.To.push_back(PointAt(to, i));
  }
  const double share = 1.0 / static_cast<double>(pairs.From.size());
  for (std::size_t i = 0; i < pairs.From.size(); ++i)
  {
    pairs.MiddleFrom = PlusScaled(pairs.MiddleFrom, share, pairs.From[i]);
    pairs.MiddleTo = PlusScaled(pairs.MiddleTo, share, pairs.To[i]);
  }
  for (std::size_t i = 0; i < pairs.From.size(); ++i)
  {
    pairs.From[i] = Difference(pairs.From[i], pairs.MiddleFrom);
    pairs.To[i] = Difference(pairs.To[i], pairs.MiddleTo);
    pairs.SizeFrom = std::max(pairs.SizeFrom, Length(pairs.From[i]));
    pairs.SizeTo = std::max(pairs.SizeTo, Length(pairs.To[i]));
  }
  return pairs;
}

double ErrorOf(const AffineMap& map, const Real3& from, const Real3& to)
{
  return Length(Difference(map.Apply(from), to));
}

/** The matrix that takes the directions of `spread` to `images`; directions in which the points do
 * not spread are completed. */
Real3x3 MatrixOf(const Real3x3& spread, const Real3x3& images)
{
  constexpr double flat = 1e-16; // a square: thinner than 1e-8 of the length
  const SymmetricEigen axes(spread);
  Real3x3 image{}; // of each axis
  std::size_t known = 3;
  for (std::size_t k = 3; k-- > 0 && axes.Values[k] > flat * axes.Values[2];)
  {
    known = k;
    image[k] = Scaled(Times(images, axes.Vectors[k]), 1.0 / axes.Values[k]);
  }
  if (known == 1)
  {
    const Real3 across = Cross(image[1], image[2]);
    const double area = Length(across);
    const bool turned = Dot(Cross(axes.Vectors[1], axes.Vectors[2]), axes.Vectors[0]) < 0.0;
    image[0] = area > 0.0 ? Scaled(across, (turned ? -1.0 : 1.0) / std::sqrt(area)) : Real3{};
  }
  Real3x3 matrix{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    for (std::size_t row = 0; row < 3; ++row)
    {
      matrix[row] = PlusScaled(matrix[row], image[k][row], axes.Vectors[k]);
    }
  }
  return matrix;
}

/** The map with the smallest weighted sum of squares. */
AffineMap WeightedFit(const Pairs& pairs, const std::vector<double>& weights)
{
  double sum = 0.0;
  Real3 middleFrom{};
  Real3 middleTo{};
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    sum += weights[i];
    middleFrom = PlusScaled(middleFrom, weights[i], pairs.From[i]);
    middleTo = PlusScaled(middleTo, weights[i], pairs.To[i]);
  }
  middleFrom = Scaled(middleFrom, 1.0 / sum);
  middleTo = Scaled(middleTo, 1.0 / sum);
  Real3x3 spread{};
  Real3x3 images{};
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const Real3 from = Difference(pairs.From[i], middleFrom);
    const Real3 to = Difference(pairs.To[i], middleTo);
    for (std::size_t row = 0; row < 3; ++row)
    {
      spread[row] = PlusScaled(spread[row], weights[i] * from[row], from);
      images[row] = PlusScaled(images[row], weights[i] * to[row], from);
    }
  }
  AffineMap map;
  map.Matrix = MatrixOf(spread, images);
  map.Offset = Difference(middleTo, Times(map.Matrix, middleFrom));
  return map;
}

/** Points count by the inverse of their error, which makes the sum of errors the smallest. The
 * error that counts as none shrinks from round to round, so that the first rounds do not stick to
 * whichever points come first. */
AffineMap SmallestSumFit(const Pairs& pairs)
{
  const double least = rounding * pairs.SizeTo;
  std::vector<double> weights(pairs.From.size(), 1.0);
  AffineMap map = WeightedFit(pairs, weights);
  double floor = pairs.SizeTo;
  for (int round = 0; round < mostRounds && floor > least; ++round)
  {
    floor = std::max(least, 0.4 * floor);
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      weights[i] = floor / std::max(floor, ErrorOf(map, pairs.From[i], pairs.To[i]));
    }
    map = WeightedFit(pairs, weights);
  }
  return map;
}

double MedianError(const AffineMap& map, const Pairs& pairs)
{
  std::vector<double> errors(pairs.From.size());
  for (std::size_t i = 0; i < errors.size(); ++i)
  {
    errors[i] = ErrorOf(map, pairs.From[i], pairs.To[i]);
  }
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

} // namespace

AffineFit FitAffineMap(const double* from, const double* to, std::int64_t count)
{
  AffineFit fit;
  if (count <= 0)
  {
    return fit;
  }
  const Pairs pairs = SampledPairs(from, to, count);
  AffineMap found = SmallestSumFit(pairs);
  AffineMap unmoved;
  unmoved.Offset = Difference(pairs.MiddleFrom, pairs.MiddleTo);
  const double noise = 16.0 * rounding * (pairs.SizeTo + Length(pairs.MiddleTo));
  fit.IsIdentity = MedianError(unmoved, pairs) <= 4.0 * MedianError(found, pairs) + noise;
  if (!fit.IsIdentity)
  {
    found.Offset = PlusScaled(found.Offset, 1.0, pairs.MiddleTo);
    found.Offset = Difference(found.Offset, Times(found.Matrix, pairs.MiddleFrom));
    fit.Map = found;
  }
  for (std::int64_t i = 0; i < count; ++i)
  {
    const double error = ErrorOf(fit.Map, PointAt(from, i), PointAt(to, i));
    fit.MeanError += error / static_cast<double>(count);
    fit.LargestError = std::max(fit.LargestError, error);
  }
  return fit;
}

} // namespace sb

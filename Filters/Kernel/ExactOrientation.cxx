// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ExactOrientation.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace sb
{
namespace
{

constexpr double Epsilon = 0x1p-53;
constexpr double FilterBound = (7.0 + 56.0 * Epsilon) * Epsilon;

int SignOf(double value) { return (value > 0.0) - (value < 0.0); }

/** a + b = sum + error (Knuth). */
void TwoSum(double a, double b, double& sum, double& error)
{
  sum = a + b;
  const double bPart = sum - a;
  error = (a - (sum - bPart)) + (b - bPart);
}

/** a * b = product + error (Dekker; without a fused multiply-add, which not every machine has). */
void TwoProduct(double a, double b, double& product, double& error)
{
  constexpr double splitter = 0x1p27 + 1.0;
  product = a * b;
  const double aWide = splitter * a;
  const double aHigh = aWide - (aWide - a);
  const double aLow = a - aHigh;
  const double bWide = splitter * b;
  const double bHigh = bWide - (bWide - b);
  const double bLow = b - bHigh;
  error = aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow);
}

/** An exact sum of doubles that do not overlap, smallest first; room for the 24 products of three
 * that the determinant has. */
class Expansion
{
public:
  void Add(double term)
  {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Size; ++i)
    {
      double error = 0.0;
      TwoSum(term, this->Parts[i], term, error);
      if (error != 0.0)
      {
        this->Parts[kept++] = error;
      }
    }
    if (term != 0.0)
    {
      this->Parts[kept++] = term;
    }
    this->Size = kept;
  }

  /** Add x * y * z. */
  void AddProduct(double x, double y, double z)
  {
    double high = 0.0;
    double low = 0.0;
    TwoProduct(x, y, high, low);
    for (const double part : { low, high })
    {
      double product = 0.0;
      double error = 0.0;
      TwoProduct(part, z, product, error);
      this->Add(error);
      this->Add(product);
    }
  }

  int Sign() const { return this->Size == 0 ? 0 : SignOf(this->Parts[this->Size - 1]); }

private:
  std::array<double, 100> Parts{};
  std::size_t Size = 0;
};

/** Add sign * det(a, b, c). */
void AddDeterminant(
  Expansion& sum, double sign, const Vector3& a, const Vector3& b, const Vector3& c)
{
  sum.AddProduct(sign * a.X, b.Y, c.Z);
  sum.AddProduct(sign * a.Y, b.Z, c.X);
  sum.AddProduct(sign * a.Z, b.X, c.Y);
  sum.AddProduct(-sign * a.X, b.Z, c.Y);
  sum.AddProduct(-sign * a.Y, b.X, c.Z);
  sum.AddProduct(-sign * a.Z, b.Y, c.X);
}

/** det(a - d, b - d, c - d) = det(a, b, c) - det(d, b, c) - det(a, d, c) - det(a, b, d). */
int ExactSign(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  Expansion sum;
  AddDeterminant(sum, 1.0, a, b, c);
  AddDeterminant(sum, -1.0, d, b, c);
  AddDeterminant(sum, -1.0, a, d, c);
  AddDeterminant(sum, -1.0, a, b, d);
  return sum.Sign();
}

} // namespace

int SideOfTriangle(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& point)
{
  // A point in front sees the corners turn left: det(a - p, b - p, c - p) is negative.
  const Vector3 u = a - point;
  const Vector3 v = b - point;
  const Vector3 w = c - point;
  const double vxwy = v.X * w.Y;
  const double wxvy = w.X * v.Y;
  const double wxuy = w.X * u.Y;
  const double uxwy = u.X * w.Y;
  const double uxvy = u.X * v.Y;
  const double vxuy = v.X * u.Y;
  const double determinant = u.Z * (vxwy - wxvy) + v.Z * (wxuy - uxwy) + w.Z * (uxvy - vxuy);
  const double size = (std::fabs(vxwy) + std::fabs(wxvy)) * std::fabs(u.Z) +
    (std::fabs(wxuy) + std::fabs(uxwy)) * std::fabs(v.Z) +
    (std::fabs(uxvy) + std::fabs(vxuy)) * std::fabs(w.Z);
  if (std::fabs(determinant) > FilterBound * size)
  {
    return -SignOf(determinant);
  }
  return -ExactSign(a, b, c, point);
}

} // namespace sb

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file MovingLeastSquares.h
 * @brief The surface that a cloud of points with normals defines by moving least squares, as the
 * zero set of a function with gradient and Hessian in closed form.
 *
 * With samples q with normals v, d = x - q, a weight th(|d|^2) of width h, N = sum th v and
 * n = N / |N|, there are two definitions.
 *
 * AmentaKil, that of Amenta and Kil (2004) and of Yang and Qian (2009), Eq. 2 to 5: the extrema of
 * the energy e(y) = sum th(y) (n . (y - q))^2 along n, where g(x) = n . grad e vanishes. The weight
 * is exp(-|d|^2 / h^2). The surface lies h^2 / 2 times the mean curvature inside of what was
 * sampled, and g has two more zero sheets at a distance of about h, so that its sign says inside or
 * outside only up to h / sqrt(3) from the surface.
 *
 * Unbiased, the default: the mean of n . (weighted mean of d) and of the weighted mean of v . d.
 * The first lies inside of a sphere by as much as the second lies outside, and for points on a
 * sphere the mean is exact for every h and every placement of the points; UnbiasedSurface.h says
 * with which n. It has one zero sheet, and as it is close to a distance, one step of Newton's
 * method nearly reaches it. The weight (1 - |d|^2 / R^2)^3 with R = 2 h ends at R by itself and
 * costs no exponential, and is the lowest of such powers whose curvatures are continuous: higher
 * ones need more samples for the same average.
 * Here samples may have widths of their own, so that each reaches as far as its neighbours are,
 * however the density of the cloud varies.
 *
 * Both are handed out divided by twice the sum of the weights, and so are a length: the zero set
 * and the curvatures of its sections are those of Eq. 5. The value is negative behind the normals.
 */
#ifndef sb_MovingLeastSquares_h
#define sb_MovingLeastSquares_h

#include "PointTree.h"
#include "Real3.h"
#include "SampleGroups.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace sb
{

enum class SurfaceDefinition
{
  Unbiased,
  AmentaKil
};

/** What the samples say about a place. */
enum class Support : std::uint8_t
{
  Defined = 0,
  Far = 1, ///< too few samples near it
  Border = 2, ///< beyond the border of an open scan, or in a hole: the samples lie on one side
  Contradicting =
    3 ///< the normals near it cancel: two sheets closer than the width, or bad normals
};

struct SurfaceValue
{
  Support Where = Support::Far;
  bool IsNear = false; ///< enough samples for the value to mean something; if not, all below is 0
  double Value = 0.0;
  Real3 Gradient{};
  Real3x3 Hessian{};
  double Width = 0.0; ///< h there, if it is near
};

class MovingLeastSquares
{
public:
  /**
   * @param normals unit vectors, three doubles for each point of the tree's input
   * @param width h, positive
   * @param widths of each sample, in the order of the tree, if they are not all the same. Only the
   * unbiased surface takes them; `width` is then the typical one.
   */
  MovingLeastSquares(std::shared_ptr<const PointTree> tree, const double* normals,
    SurfaceDefinition definition, double width, const std::vector<double>& widths = {});

  /** The samples near a place: memory of one thread, to use again and again. */
  class Neighbourhood
  {
    friend class MovingLeastSquares;
    SampleGroups::Nearby Groups;
    Real3 Centre{};
    double Margin = 0.0;
    std::uint64_t Of = 0; ///< number of the surface
    Real3 Middle{}; ///< of the places around which the tree was looked up last
    double Around = 0.0; ///< how far around it
    std::vector<double> Room;
    // For AmentaKil, the samples themselves: rows of Capacity, q and v, then room.
    std::int32_t Count = 0;
    std::vector<double> Memory;
    std::size_t Capacity = 0;
    double* Row(std::size_t row) { return this->Memory.data() + row * this->Capacity; }
  };

  /** Look up what matters for many places that will follow, up to `radius` from the middle. */
  void Surround(const Real3& middle, double radius, Neighbourhood& near) const;

  /** Gather the samples that matter for places up to `margin` from x. */
  void Gather(const Real3& x, double margin, Neighbourhood& near) const;

  /**
   * The function at x, and with `order` 1 its gradient, with 2 its Hessian as well. The
   * neighbourhood must have been gathered for it.
   */
  SurfaceValue Evaluate(const Real3& x, int order, Neighbourhood& near) const;

  /** The same, gathering if the neighbourhood does not do for x. */
  SurfaceValue EvaluateNear(const Real3& x, int order, Neighbourhood& near) const
  {
    if (near.Of != this->Number || !(Length(Difference(x, near.Centre)) <= near.Margin))
    {
      this->Gather(x, 0.0, near);
    }
    return this->Evaluate(x, order, near);
  }

  /** The same, gathering first. */
  SurfaceValue EvaluateAt(const Real3& x, int order, Neighbourhood& near) const
  {
    this->Gather(x, 0.0, near);
    return this->Evaluate(x, order, near);
  }

  /**
   * Move x onto the surface: for AmentaKil by their iteration (a line search for the least energy
   * along n, again and again), for Unbiased by Newton steps along the gradient. A place that is far
   * or would have to be moved by more than the width stays as it is.
   * @return the function at the place reached, with its gradient; Far if it stayed.
   */
  SurfaceValue Project(Real3& x, Neighbourhood& near) const;

  /**
   * The distance from x to the nearest sample, negative behind the samples that are nearest: the
   * answer where the function has none.
   */
  double DistanceToSamples(const Real3& x, Real3* gradient) const;

  /** h; if samples have widths of their own, the typical one. */
  double Width() const { return this->H; }

  /** The width that all but a hundredth of the samples have: what steps have to be measured by. */
  double NarrowWidth() const { return this->IsUneven() ? this->Narrow : this->H; }

  /** How far the sample reaches that reaches farthest. */
  double Reach() const { return this->R; }

  /** The width of the sample that reaches farthest. */
  double LargestWidth() const { return this->MostWidth; }

  /** Whether samples have widths of their own. */
  bool IsUneven() const { return this->Groups->IsUneven(); }

  /** How far the i-th sample of the tree reaches. */
  double ReachOf(std::int32_t i) const
  {
    return this->IsUneven() ? 1.0 / std::sqrt(this->Groups->Of(i, 6)) : this->R;
  }

  /** The width of the i-th sample of the tree. */
  double WidthOf(std::int32_t i) const { return this->ReachOf(i) / this->R * this->MostWidth; }

  SurfaceDefinition Definition() const { return this->Kind; }
  const PointTree& Samples() const { return *this->Tree; }
  Real3 SampleNormal(std::int32_t i) const
  {
    return { this->Groups->Of(i, 3), this->Groups->Of(i, 4), this->Groups->Of(i, 5) };
  }

private:
  SurfaceValue EvaluateUnbiased(const Real3& x, int order, Neighbourhood& near) const;
  SurfaceValue EvaluateAmentaKil(const Real3& x, int order, Neighbourhood& near) const;
  std::vector<double> TakeWidths(const std::vector<double>& widths);
  void Copy(Neighbourhood& near) const;
  SurfaceValue ProjectByNewton(Real3& x, Neighbourhood& near) const;
  SurfaceValue ProjectByEnergy(Real3& x, Neighbourhood& near) const;
  bool StepToLeastEnergy(Real3& x, Neighbourhood& near, double& step) const;

  std::shared_ptr<const PointTree> Tree;
  std::uint64_t Number;
  SurfaceDefinition Kind;
  double H;
  double R;
  double Narrow = 0.0;
  double MostWidth = 0.0;
  std::unique_ptr<const SampleGroups> Groups;
};

/** Curvatures of a surface where its defining function has these derivatives. A sphere with its
 * normals outwards has 1 / radius. */
struct SurfaceCurvature
{
  double Maximum = 0.0;
  double Minimum = 0.0;
};
SurfaceCurvature CurvatureOf(const SurfaceValue& value);

/**
 * The curvature of the section of the surface with a plane, Yang and Qian (2009), Eq. 8, written
 * without turning the plane into the xy plane. Positive if the curve bends towards the gradient; 0
 * where the plane touches the surface.
 * @param planeNormal a unit vector
 */
double SectionCurvature(const SurfaceValue& value, const Real3& planeNormal);

} // namespace sb

#endif

// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WeightedQuotient.h
 * @brief The derivatives of F / (2 W) from those of F and of the sum of the weights, W.
 */
#ifndef sb_WeightedQuotient_h
#define sb_WeightedQuotient_h

#include "Real3.h"

#include <cstddef>

namespace sb
{

/** @param ratio F / W */
inline Real3 GradientOfQuotient(double w, double ratio, const Real3& wb, const Real3& gradient)
{
  return Scaled(PlusScaled(gradient, -ratio, wb), 0.5 / w);
}

/** @param gradient of F, as @p hessian */
inline Real3x3 HessianOfQuotient(double w, double ratio, const Real3& wb, const Real3x3& wbc,
  const Real3& gradient, const Real3x3& hessian)
{
  Real3x3 result;
  for (std::size_t b = 0; b < 3; ++b)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      result[b][c] = 0.5 / w *
        (hessian[b][c] - (gradient[b] * wb[c] + gradient[c] * wb[b]) / w - ratio * wbc[b][c] +
          2.0 * ratio * wb[b] * wb[c] / w);
    }
  }
  return result;
}

} // namespace sb

#endif

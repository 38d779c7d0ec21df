// SPDX-FileCopyrightText: Copyright (c) SurfaceBooleans developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file SymmetricEigen.h
 * @brief Eigenvalues and eigenvectors of a symmetric matrix of three by three, by Jacobi's
 * rotations: slower than a formula, and accurate for any matrix.
 */
#ifndef sb_SymmetricEigen_h
#define sb_SymmetricEigen_h

#include "Real3.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace sb
{

struct SymmetricEigen
{
  Real3 Values; ///< smallest first
  Real3x3 Vectors; ///< row i is the unit vector of value i

  explicit SymmetricEigen(Real3x3 m)
    : Vectors{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } }
  {
    constexpr int mostSweeps = 30; // half a dozen are enough for doubles
    for (int sweep = 0; sweep < mostSweeps; ++sweep)
    {
      const double off = m[0][1] * m[0][1] + m[0][2] * m[0][2] + m[1][2] * m[1][2];
      const double on = m[0][0] * m[0][0] + m[1][1] * m[1][1] + m[2][2] * m[2][2];
      if (!(off > 1e-32 * on))
      {
        break;
      }
      this->Rotate(m, 0, 1);
      this->Rotate(m, 0, 2);
      this->Rotate(m, 1, 2);
    }
    this->Values = { m[0][0], m[1][1], m[2][2] };
    this->Order(0, 1);
    this->Order(1, 2);
    this->Order(0, 1);
  }

private:
  /** The rotation of the axes p and q that makes m[p][q] vanish (Golub and Van Loan, 8.5.2). */
  void Rotate(Real3x3& m, std::size_t p, std::size_t q)
  {
    if (m[p][q] == 0.0)
    {
      return;
    }
    const double tau = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
    const double t = (tau >= 0.0 ? 1.0 : -1.0) / (std::abs(tau) + std::sqrt(1.0 + tau * tau));
    const double c = 1.0 / std::sqrt(1.0 + t * t);
    const double s = t * c;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double kp = m[k][p];
      const double kq = m[k][q];
      m[k][p] = c * kp - s * kq;
      m[k][q] = s * kp + c * kq;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double pk = m[p][k];
      const double qk = m[q][k];
      m[p][k] = c * pk - s * qk;
      m[q][k] = s * pk + c * qk;
      const double vp = this->Vectors[p][k];
      const double vq = this->Vectors[q][k];
      this->Vectors[p][k] = c * vp - s * vq;
      this->Vectors[q][k] = s * vp + c * vq;
    }
    m[p][q] = m[q][p] = 0.0;
  }

  void Order(std::size_t i, std::size_t j)
  {
    if (this->Values[j] < this->Values[i])
    {
      std::swap(this->Values[i], this->Values[j]);
      std::swap(this->Vectors[i], this->Vectors[j]);
    }
  }
};

} // namespace sb

#endif

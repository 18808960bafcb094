// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace ruc
{
/**
 * Irregular solid harmonics
 *
 *     I_lm = (l - m)! r^(-l-1) P_l^m(cos theta) e^(i m phi),   0 <= m <= l,
 *
 * without the sign (-1)^m in P_l^m, so that I_00 = 1 / r. Those of -m are (-1)^m conj I_lm. With
 * the weights n_lm of HarmonicWeight
 *
 *     sum over m of n_lm Re(conj I_lm(r) I_lm(s)) = (r s)^(-l-1) P_l(cos of the angle of r and s),
 *
 * so that |I_lm| <= n_lm^(-1/2) r^(-l-1).
 */
constexpr int GreatestDegree = 14;

/** The place of l, m in an array, which counts l = 0 in. */
constexpr int HarmonicPlace(int l, int m)
{
  return l * (l + 1) / 2 + m;
}
/** The number of harmonics up to a degree. */
constexpr int HarmonicCount(int degree)
{
  return HarmonicPlace(degree + 1, 0);
}

/** n_lm = (2 - delta_m0) / ((l - m)! (l + m)!) */
constexpr double HarmonicWeight(int l, int m)
{
  double weight = m > 0 ? 2.0 : 1.0;
  for (int k = 2; k <= l - m; ++k)
  {
    weight /= k;
  }
  for (int k = 2; k <= l + m; ++k)
  {
    weight /= k;
  }
  return weight;
}

/**
 * Puts the real and imaginary parts of I_lm up to a degree into `real` and `imaginary`. `inverse`
 * is 1 / r. A Number is a double or a vector of them; it is always inlined, so that it is compiled
 * for the instruction set of its caller.
 */
template <class Number>
[[gnu::always_inline]] inline void FindHarmonics(int degree, const Number& dx, const Number& dy,
  const Number& dz, const Number& inverse, Number* real, Number* imaginary)
{
  const Number square = inverse * inverse;
  const Number x = dx * square, y = dy * square, z = dz * square;
  real[0] = inverse;
  imaginary[0] = inverse * 0.0;
  for (int m = 0; m <= degree; ++m)
  {
    int here = HarmonicPlace(m, m);
    if (m > 0)
    {
      const int from = HarmonicPlace(m - 1, m - 1);
      const double factor = 2.0 * m - 1.0;
      real[here] = factor * (x * real[from] - y * imaginary[from]);
      imaginary[here] = factor * (x * imaginary[from] + y * real[from]);
    }
    for (int l = m + 1; l <= degree; ++l)
    {
      // I_lm = [(2l - 1) z I_(l-1)m - ((l - 1)^2 - m^2) I_(l-2)m] / r^2
      const int next = here + l;
      const double factor = 2.0 * l - 1.0, before = (l - 1.0) * (l - 1.0) - m * m;
      real[next] = factor * z * real[here];
      imaginary[next] = factor * z * imaginary[here];
      if (l > m + 1)
      {
        real[next] -= before * square * real[here - l + 1];
        imaginary[next] -= before * square * imaginary[here - l + 1];
      }
      here = next;
    }
  }
}
}

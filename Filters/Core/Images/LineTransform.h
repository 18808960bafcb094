// SPDX-FileCopyrightText: Copyright (c) Representative Unit Cell plugin developers
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace ruc
{
/**
 * Discrete Fourier transforms of lines of n complex numbers, of which Lanes are done at a time.
 *
 * Real and imaginary parts are kept apart, and number j of lane l stands at j Lanes + l. Every lane
 * has the same operations in the same order, so its result does not depend on the others. The
 * method is Stockham's, with factors up to 13; a length with a larger prime factor is done by
 * Bluestein's, as a convolution of a longer length.
 */
class LineTransform
{
public:
  static constexpr int Lanes = 8;

  /** `size` is n, at least 1. */
  explicit LineTransform(int size);

  int Size() const { return this->Length; }

  /** How many numbers the work space of Forward must have. */
  std::size_t WorkSize() const;

  /**
   * Replaces the numbers x_j of every lane by X_k = sum over j of x_j exp(-2 pi i j k / n). The
   * inverse, not divided by n, is the same with real and imaginary parts exchanged:
   * Forward(imaginary, real, work). `work` is of one thread.
   */
  void Forward(double* real, double* imaginary, double* work) const;

  /** Returns the least length >= `least` that has no prime factors but 2, 3, 5 and 7. */
  static int FastLength(int least);

  /** A factor of n: its butterflies stand `Stride` numbers apart and there are `Count` of them. */
  struct Stage
  {
    int Factor, Count, Stride;
    // exp(-2 pi i j r / (Factor Count)) at j Factor + r
    std::vector<double> Cosine, Sine;
    // exp(-2 pi i r / Factor)
    std::vector<double> RootCosine, RootSine;
  };

private:
  void Convolve(double* real, double* imaginary, double* work) const;

  int Length;
  std::vector<Stage> Stages; // empty with Bluestein's method
  // Bluestein's method: the transform of the longer length, exp(-i pi j^2 / n), and the transform
  // of its conjugate over the longer length
  std::unique_ptr<LineTransform> Longer;
  std::vector<double> ChirpCosine, ChirpSine, KernelReal, KernelImaginary;
};
}

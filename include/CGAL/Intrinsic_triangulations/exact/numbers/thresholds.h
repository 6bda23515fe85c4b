// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief has all numbers that exact decisions depend on and that no theorem sets, each with what was
measured.
*/
struct thresholds {
  /*!
  \brief Pairs of terms that a proof in the field multiplies at most.

  A pair takes one to three microseconds. The value of a diamond takes about twelve products of
  numbers with up to 2^k terms for k independent square roots: 1.5 seconds for k = 8, ten for k = 9,
  which is the last one that this lets through. Sums of few roots go on beyond. On CGAL's data set
  all values that come here are rational; over cylinders (`Prism_in_field_proof`) k is at most 6.
  */
  static constexpr std::size_t pairs_of_terms = std::size_t(1) << 22;

  /*!
  \brief Precision up to which a value is computed that no proof has got through; then it is taken
  for zero, and counted as probably zero.

  No value of the data set comes here. Values of doubles that are not zero
  have been seen down to 2^-1000, where a coordinate is that small.
  */
  static constexpr unsigned probable_bits = 2048;

  /// Input faces whose numbers of many bits are remembered: a face of 256 bits takes 400 bytes, of
  /// 8,192 four kilobytes.
  static constexpr std::size_t remembered_faces = std::size_t(1) << 16;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief has all numbers that affect exact decisions and follow from no theorem, each with its
measurement.
*/
struct thresholds {
  /*!
  \brief Maximal number of pairs of terms that a proof in the field multiplies.

  A pair takes one to three microseconds. The value of a diamond takes about twelve products of
  numbers with up to 2^k terms for k independent square roots: 1.5 seconds for k = 8, ten for k = 9,
  the last one within this bound. Sums of few roots go on beyond. On CGAL's data set all values of
  this step are rational; over cylinders (`Prism_in_field_proof`) k is at most 6.
  */
  static constexpr std::size_t pairs_of_terms = std::size_t(1) << 22;

  /*!
  \brief Precision up to which a value is computed if all proofs fail; then it is assumed to be
  zero, and counted as probably zero.

  No value of the data set reaches it. Values that are not zero occurred down to 2^-1000, for a
  coordinate of that size.
  */
  static constexpr unsigned probable_bits = 2048;

  /// Number of input faces whose numbers of many bits are stored: a face of 256 bits takes 400
  /// bytes, of 8,192 four kilobytes.
  static constexpr std::size_t remembered_faces = std::size_t(1) << 16;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_NUMBERS_THRESHOLDS_H

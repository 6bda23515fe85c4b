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
  \brief Maximal cost of a proof by images in finite fields that a value is zero: the number of
  triangles that are computed, four images at a time.

  One takes half a microsecond. A value over n triangles with k independent square roots takes about
  12 n 2^k, for coordinates of 53 bits: the limit is at k = 13, 0.9 seconds. Coefficients took as
  long for k = 4 and 27 seconds for k = 7, where these take 8 milliseconds.
  */
  static constexpr double image_steps = 0x1.8p21;
  /// The same for all proofs of a surface together that cost more than `few_image_steps`: two
  /// seconds, and more for each of its faces, about what flips take.
  static constexpr double all_image_steps = 0x1p22;
  /// What each face of a surface adds to `all_image_steps`.
  static constexpr double image_steps_of_face = 0x1p5;
  /// Cost of a proof that is not counted: two milliseconds.
  static constexpr double few_image_steps = 0x1p12;

  /*!
  \brief Maximal cost of products in a proof by coefficients, for repeated flips: the sum of
  products of lengths of coefficients, in words.

  A pair of words takes about ten nanoseconds, for the greatest common divisor.
  */
  static constexpr std::size_t words_of_coefficients = std::size_t(1) << 26;
  /// The same over cylinders and prisms, where coefficients are few: sums of roots have no others.
  static constexpr std::size_t words_over_prisms = std::size_t(1) << 22;

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

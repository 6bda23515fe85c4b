// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PREDICATE_STATISTICS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PREDICATE_STATISTICS_H

#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>

#include <array>
#include <cstdint>
#include <map>

namespace CGAL::Intrinsic_triangulations {

/// What was asked of a rung.
struct Rung_statistics {
  std::uint64_t asked = 0;   ///< questions
  std::uint64_t decided = 0; ///< signs that it found, zeros included
  std::uint64_t zeros = 0;   ///< zeros that it proved
  double seconds = 0;        ///< its time; not measured for `Rung::integers`, which takes none
};

/*!
\brief counts how predicates were decided.
*/
struct Predicate_statistics {
  /// Edges that were tested for the Delaunay property.
  std::uint64_t checks = 0;
  /// Predicates that the floating point filter could not decide.
  std::uint64_t filter_failures = 0;
  /// Predicates that proofs in integers, of two input faces or in a plane, found not to be zero.
  std::uint64_t integer = 0;
  /// Predicates found not to be zero, by number of bits: 53 (doubles, unfolded anew from the
  /// input), 106, 256, 512, ...
  std::map<unsigned, std::uint64_t> escalations;
  /// Faces and weights computed for an insertion or a query, by number of bits; 53: doubles.
  std::map<unsigned, std::uint64_t> sharpenings;
  /// Predicates proven to be zero, by any step of the ladder.
  std::uint64_t certified_zero = 0;
  /// Predicates assumed to be zero without proof, since all proofs failed and
  /// `thresholds::probable_bits` bits show no sign.
  std::uint64_t probable_zero = 0;
  /// The rungs of the ladder in their order.
  std::array<Rung_statistics, number_of_rungs> rungs{};
  /// Predicates left open by intervals without further steps.
  std::uint64_t undecided = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PREDICATE_STATISTICS_H

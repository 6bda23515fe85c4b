// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_ANSWER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_ANSWER_H

namespace CGAL::Intrinsic_triangulations {

/// What is known of a value.
enum class Zero_answer {
  zero,         ///< it is zero, proven
  not_zero,     ///< it is not zero, proven
  probably_zero ///< it vanishes modulo several primes near 2^62
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_ZERO_ANSWER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_REFINE_PARTITION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_REFINE_PARTITION_H

#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Minimises an automaton: finds the coarsest partition of its states, finer than
the given one, in which letters take classes to classes (Hopcroft 1971). \param
label the class of each state to begin with \param inverses for each letter, the
state from which it leads to a state, or `none`: each letter is a partial
bijection \return the class of each state, from 0 \complexity O(n log n) for
each letter
*/
std::vector<std::uint32_t> refine_partition(const std::vector<std::uint32_t>& label,
                                            std::span<const std::vector<std::uint32_t>> inverses);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_REFINE_PARTITION_H

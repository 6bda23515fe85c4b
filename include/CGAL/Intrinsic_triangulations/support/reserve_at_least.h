// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RESERVE_AT_LEAST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RESERVE_AT_LEAST_H

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief makes sure that values can be added until there are so many, without allocating memory then.

`reserve()` may reserve just as much, and would move all values for each new one. This function at
least doubles the memory.
\complexity constant, amortized over the elements
*/
template <std::movable T>
void reserve_at_least(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) values.reserve(std::max(size, 2 * values.capacity()));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_SUPPORT_RESERVE_AT_LEAST_H

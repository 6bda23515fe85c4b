// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TEST_REMOVAL_ARCHETYPES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TEST_REMOVAL_ARCHETYPES_H

#include <CGAL/Intrinsic_simplification/simplification/removal_costs.h>

#include <span>

/*!
\file
Models of `RemovalCost` that can do nothing else: they cannot be copied, made without arguments, or
changed where they need not be.
*/

namespace archetypes {

namespace IT = CGAL::Intrinsic_triangulations;

/// The same cost for all vertices.
struct Removal_cost {
  explicit Removal_cost(int) {}
  Removal_cost(Removal_cost&&) = default;
  Removal_cost& operator=(Removal_cost&&) = delete;
  float operator()(const IT::Removal_candidate&) { return 1; }
};

/// The same, with a memory.
struct Remembering_cost {
  explicit Remembering_cost(int) {}
  Remembering_cost(Remembering_cost&&) = default;
  Remembering_cost& operator=(Remembering_cost&&) = delete;
  float operator()(const IT::Removal_candidate&, std::span<const IT::Removal_neighbor>) const {
    return 1;
  }
  void remove(const IT::Removal_candidate&, std::span<const IT::Removal_neighbor>) {}
};

} // namespace archetypes

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TEST_REMOVAL_ARCHETYPES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_CONSTRAINED_EDGES_H
#define TEST_INTRINSIC_TRIANGULATIONS_CONSTRAINED_EDGES_H

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstdint>
#include <map>

namespace constrained_edges {

using Edge_map = std::map<std::uint32_t, bool>;

/// An edge map that grows with the triangulation.
template <class T>
struct Constraints {
  using key_type = typename T::edge_descriptor;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;
  const T* t;
  Edge_map* is_constrained;
  friend bool get(const Constraints& m, key_type e) {
    const auto found = m.is_constrained->find(m.t->index(e));
    return found != m.is_constrained->end() && found->second;
  }
  friend void put(const Constraints& m, key_type e, bool value) {
    (*m.is_constrained)[m.t->index(e)] = value;
  }
};

/// Lengths of the edges of a map, summed.
template <class T>
double total_length(const T& t, const Constraints<T>& m) {
  double sum = 0;
  for (const auto e : edges(t.mesh()))
    if (get(m, e)) sum += std::sqrt(t.squared_length(e));
  return sum;
}

} // namespace constrained_edges

#endif // TEST_INTRINSIC_TRIANGULATIONS_CONSTRAINED_EDGES_H

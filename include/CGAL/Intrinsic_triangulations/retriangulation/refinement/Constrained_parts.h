// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_PARTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Knows which edges a property map constrains; gives the parts of those that are split what it says of them, if it is writable.
template <class Triangulation, class Map>
class Constrained_parts {
  using Value = typename boost::property_traits<Map>::value_type;
  static constexpr bool is_writable =
      std::is_convertible_v<typename boost::property_traits<Map>::category,
                            boost::writable_property_map_tag>;

public:
  // keeps the values of all edges
  Constrained_parts(const Triangulation& t, const Map& map) : map_(map) {
    if constexpr (is_writable) {
      values_.resize(t.numbers().edge_capacity(t.mesh()));
      for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
        values_[t.index(e)] = get(map_, e);
    }
  }

  // tells of each edge, by number, whether it is constrained; empty: none is
  std::vector<char> marks(const Triangulation& t) const {
    using Edge = typename Triangulation::edge_descriptor;
    std::vector<char> result;
    if constexpr (!std::is_same_v<Map, Static_boolean_property_map<Edge, false>>) {
      result.resize(t.numbers().edge_capacity(t.mesh()), 0);
      for (const Edge e : edges(t.mesh())) result[t.index(e)] = get(map_, e) ? 1 : 0;
    }
    return result;
  }

  // `whole(e)` is the edge that edge e is a part of, or `Gluing::none`
  template <class Whole>
  void write(const Triangulation& t, const Whole& whole) const {
    if constexpr (is_writable)
      for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
        const std::uint32_t w = whole(t.index(e));
        put(map_, e, w == Gluing::none ? Value() : static_cast<Value>(values_[w]));
      }
  }

private:
  Map map_;
  std::vector<Value> values_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_PARTS_H

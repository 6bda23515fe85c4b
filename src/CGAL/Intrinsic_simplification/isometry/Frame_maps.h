// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FRAME_MAPS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FRAME_MAPS_H

#include <CGAL/Intrinsic_simplification/isometry/Plane_charts.h>

#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names maps between the frames of faces: those across edges at the start, and words of them. Maps of
a chart to itself have one name for each value; of other words, letters cancel that are inverse to
each other.
*/
class Frame_maps {
public:
  using Map = std::uint32_t;
  static constexpr Map identity = 0;

  Frame_maps() = default;
  // \param charts must outlive this object
  Frame_maps(std::uint32_t number_of_halfedges, const Plane_charts& charts)
      : number_at_start_(number_of_halfedges), charts_(&charts) {}

  // The map across a halfedge at the start, to the frame of its own face.
  static Map across(std::uint32_t halfedge) { return halfedge + 1; }
  bool is_at_start(Map m) const { return m <= number_at_start_; }
  static std::uint32_t halfedge(Map m) { return m - 1; }

  Map motion(const Plane_motion& m);
  // first b, then a
  Map composed(Map a, Map b);
  Map inverse(Map a) const {
    return a == identity ? a : is_at_start(a) ? across(halfedge(a) ^ 1U) : node(a).inverse;
  }

  // Of a map that is not at the start: its motion, or null; and what it is composed of otherwise.
  const Plane_motion* motion_of(Map m) const {
    return node(m).motion == none ? nullptr : &motions_[node(m).motion];
  }
  std::pair<Map, Map> factors(Map m) const { return {node(m).first, node(m).second}; }

private:
  static constexpr std::uint32_t none = Plane_charts::none;
  struct Node {
    std::uint32_t motion;
    Map first, second, inverse;
  };
  const Node& node(Map m) const { return nodes_[m - 1 - number_at_start_]; }
  bool is_word(Map m) const { return !is_at_start(m) && node(m).motion == none; }
  const Plane_motion* motion_or_null(Map m) const {
    return is_at_start(m) ? nullptr : motion_of(m);
  }
  Map add(const Node& n) {
    nodes_.push_back(n);
    return number_at_start_ + static_cast<Map>(nodes_.size());
  }
  Map word(Map a, Map b);

  std::uint32_t number_at_start_ = 0;
  const Plane_charts* charts_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<Plane_motion> motions_;
  std::map<Plane_motion, Map> known_motions_;
  std::unordered_map<std::uint64_t, Map> known_; // by factors
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_FRAME_MAPS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_FRAME_MAPS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_FRAME_MAPS_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_charts.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names maps between the frames of faces: those across edges at the start, motions of a chart, and
words of these letters. Letters that are inverse to each other cancel, and motions that follow each
other are one: so maps that come back are found to be the identity, and words stay short.
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

  // The motion of a map that is not at the start; null if the map is a word. A point takes the last
  // letter of a word first.
  const Plane_motion* motion_of(Map m) const {
    return node(m).motion == none ? nullptr : &motions_[node(m).motion];
  }
  // The same for any map; null also at the start.
  const Plane_motion* motion_or_null(Map m) const {
    return is_at_start(m) ? nullptr : motion_of(m);
  }
  const std::vector<Map>& letters(Map word) const { return node(word).letters; }
  std::size_t number_of_letters(Map m) const {
    return m == identity ? 0 : is_at_start(m) || motion_of(m) != nullptr ? 1 : letters(m).size();
  }
  // the map that a point takes first, and the rest. \pre it is not the identity
  Map first_letter(Map m) const { return number_of_letters(m) > 1 ? letters(m).back() : m; }
  Map without_first_letter(Map m) { return composed(m, inverse(first_letter(m))); }

private:
  static constexpr std::uint32_t none = Plane_charts::none;
  struct Node {
    std::uint32_t motion;
    Map inverse;
    std::vector<Map> letters;
  };
  const Node& node(Map m) const { return nodes_[m - 1 - number_at_start_]; }
  Map add(Node n) {
    nodes_.push_back(std::move(n));
    return number_at_start_ + static_cast<Map>(nodes_.size());
  }
  void set_inverses(Map a, Map b);
  void append(std::vector<Map>& word, Map m);
  Map word(const std::vector<Map>& letters);

  std::uint32_t number_at_start_ = 0;
  const Plane_charts* charts_ = nullptr;
  std::vector<Node> nodes_;
  std::vector<Plane_motion> motions_;
  std::map<Plane_motion, Map> known_motions_;
  std::map<std::vector<Map>, Map> known_words_;
  std::unordered_map<std::uint64_t, Map> known_; // by factors
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_FRAME_MAPS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Piece_gluer::Piece_gluer(const Common_subdivision& s) : s_(s), face_(s.corner.size()) {
  for (std::uint32_t f = 0; f < s.number_of_faces(); ++f)
    std::fill(face_.begin() + s.face_begin[f], face_.begin() + s.face_begin[f + 1], f);
  first_.assign(intrinsic_edge_bound(s) + 1, 0);
  for (const Common_subdivision::Crossing& c : s.crossings) ++first_[c.on_intrinsic.edge + 1];
  for (std::size_t e = 1; e < first_.size(); ++e) first_[e] += first_[e - 1];
  std::vector<std::uint32_t> at = first_; // crossings of an edge have numbers one after another
  for (std::size_t i = s.crossings.size(); i-- > 0;)
    at[s.crossings[i].on_intrinsic.edge] = static_cast<std::uint32_t>(s.vertices.size() + i);
  first_ = std::move(at);
}

// The place of a side among those of its intrinsic edge, along the first halfedge of the edge.
std::uint32_t Piece_gluer::place_along(std::uint32_t c) const {
  const bool is_forward = s_.intrinsic_halfedge[c] % 2 == 0;
  const std::uint32_t start = is_forward ? s_.corner[c] : s_.corner[next(c)];
  if (start < s_.vertices.size()) return 0;
  return 1 + start - first_[s_.intrinsic_halfedge[c] / 2];
}

Piece_gluer::Key Piece_gluer::key(std::uint32_t c) const {
  constexpr std::uint32_t none = Common_subdivision::none;
  if (s_.side[c].intrinsic_edge != none)
    return {none, s_.side[c].intrinsic_edge, place_along(c), none, none};
  const auto ends = std::minmax(s_.corner[c], s_.corner[next(c)]);
  return {s_.intrinsic_face[face_[c]], s_.side[c].input_edge, none, ends.first, ends.second};
}

std::vector<std::uint32_t> Piece_gluer::run() const {
  std::vector<std::pair<Key, std::uint32_t>> keys;
  keys.reserve(s_.corner.size());
  for (std::uint32_t c = 0; c < s_.corner.size(); ++c) keys.emplace_back(key(c), c);
  std::sort(keys.begin(), keys.end());
  std::vector<std::uint32_t> glue(s_.corner.size(), Common_subdivision::none);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    if (keys[i].first != keys[i - 1].first) continue;
    glue[keys[i].second] = keys[i - 1].second;
    glue[keys[i - 1].second] = keys[i].second;
  }
  return glue;
}

} // namespace CGAL::Intrinsic_triangulations::internal

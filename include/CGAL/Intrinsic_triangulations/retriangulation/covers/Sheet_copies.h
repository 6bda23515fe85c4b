// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edge.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a triangulation may know the places of inserted vertices on its input.
template <class Triangulation>
concept Knows_places = Triangulation::has_correspondence && requires(const Triangulation& t) {
  t.places();
};

// Finds the copies of inserted vertices on a cover, and the edges over seams. Where nobody knows the places of vertices, there
// are none.
template <class Triangulation>
class Sheet_copies {
public:
  explicit Sheet_copies(const Triangulation&) {}
  static bool exist() { return false; }
  static bool is_seam(std::uint32_t) { return false; }
  static std::vector<Surface_point> missing(std::uint32_t) { return {}; }
  static void join(const std::vector<std::uint32_t>&) {}
  static std::vector<std::uint32_t> take(std::uint32_t vertex) { return {vertex}; }
  template <class Session>
  static std::uint64_t restore_seams(Session&) {
    return 0;
  }
};

// Neither are there any on surfaces that are no covers.
template <Knows_places Triangulation>
class Sheet_copies<Triangulation> {
  using View = Intrinsic_view<Triangulation>;

public:
  explicit Sheet_copies(const Triangulation& t) : t_(t) {
    if (t.input().names().sheets < 2 || t.places() == nullptr) return;
    const Sheets sheets(t.input());
    if (!sheets.is_cover()) return;
    sheets_.emplace(sheets);
    for (std::uint32_t e = 0; e < t.input().number_of_edges(); ++e)
      is_seam_.push_back(sheets_->is_seam(e) ? 1 : 0);
    find_copies();
  }

  // whether vertices have copies, and their places are known: a flip of an edge that would be crossed too often ends that
  bool exist() const { return sheets_.has_value() && places() != nullptr; }

  // Flips away the edges that cross a seam, as a rule all of them. \return how many flips that took
  template <class Session>
  std::uint64_t restore_seams(Session& session) {
    std::uint64_t flips = 0;
    for (std::uint32_t e = 0; e < is_seam_.size() && exist(); ++e)
      if (is_seam_[e] != 0) restore_input_edge(t_, session, *places(), 2 * e, flips);
    return flips;
  }

  // whether an intrinsic edge runs along a seam
  bool is_seam(std::uint32_t edge) const {
    if (!exist()) return false;
    const std::uint32_t x = along(2 * edge);
    return x != Gluing::none && is_seam_[x / 2] != 0;
  }

  // the places of the copies of a vertex that are still to be inserted
  std::vector<Surface_point> missing(std::uint32_t vertex) const {
    return exist() ? sheets_->others(places()->location(vertex)) : std::vector<Surface_point>();
  }

  // Where a place of the input is now: on the side of the halfedge, if that runs along the edge on which the place is.
  std::optional<Surface_point> locate(const Surface_point& place) const {
    if (!exist()) return std::nullopt;
    const auto p =
        Intrinsic_locator<Triangulation, Integer_coordinates>(t_, *places()).locate(place);
    if (!p) return std::nullopt;
    Surface_point q = p->point;
    if (place.weights[2] == 0)
      for (int k = 0; k < 3; ++k, q = turned(q))
        if (along(q.halfedge) / 2 == place.halfedge / 2 && q.weights[2] < nearness) {
          const double sum = q.weights[0] + q.weights[1];
          return Surface_point{q.halfedge, {1 - q.weights[1] / sum, q.weights[1] / sum, 0}};
        }
    return inside(q);
  }

  // the point beyond the nearest side of its face, if it is so near that rounding may have moved it across
  std::optional<Surface_point> across(Surface_point p) const {
    const View view(t_);
    for (int k = 0; k < 3; ++k, p = turned(p))
      if (p.weights[2] < nearness && !view.is_border(p.halfedge ^ 1U))
        return inside({p.halfedge ^ 1U, {p.weights[1], p.weights[0], 0}});
    return std::nullopt;
  }

  // notes that vertices are copies of each other
  void join(const std::vector<std::uint32_t>& vertices) {
    const auto all = std::make_shared<const std::vector<std::uint32_t>>(vertices);
    for (const std::uint32_t v : vertices) copies_[v] = all;
  }
  // returns a vertex and its copies, and forgets them
  std::vector<std::uint32_t> take(std::uint32_t vertex) {
    const auto found = copies_.find(vertex);
    if (found == copies_.end()) return {vertex};
    const auto all = found->second;
    for (const std::uint32_t v : *all) copies_.erase(v);
    return *all;
  }

private:
  static constexpr double nearness = 0x1p-20;

  // asked each time, as they may be given up
  const Integer_coordinates* places() const { return t_.places(); }

  // those of an earlier refinement
  void find_copies() {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_row;
    for (const typename Triangulation::vertex_descriptor v : vertices(t_.mesh()))
      if (t_.is_inserted(v)) by_row[t_.input_vertex(v)].push_back(t_.index(v));
    for (const auto& [row, copies] : by_row) join(copies);
  }

  std::uint32_t along(std::uint32_t h) const {
    const Integer_coordinates& c = *places();
    return c.normal_coordinate(h / 2) >= 0 ? Gluing::none : c.fans().halfedge(c.roundabout(h));
  }

  Surface_point turned(const Surface_point& p) const {
    return {View(t_).next(p.halfedge), {p.weights[1], p.weights[2], p.weights[0]}};
  }

  // not on a side: that would split it
  static Surface_point inside(Surface_point p) {
    for (double& w : p.weights) w = (std::max(w, 0.) + 0x1p-40) / (1 + 3 * 0x1p-40);
    return p;
  }

  const Triangulation& t_;
  std::optional<Sheets> sheets_;
  std::vector<char> is_seam_; // of each edge of the input
  // one list for all of them
  std::unordered_map<std::uint32_t, std::shared_ptr<const std::vector<std::uint32_t>>> copies_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H

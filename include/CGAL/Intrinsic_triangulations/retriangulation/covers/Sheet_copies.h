// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Intrinsic_locator.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/covers/restore_input_edges.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the copies of inserted vertices on a cover, and the edges over seams. Without stored places
// of vertices there are none.
template <class Triangulation>
class Sheet_copies {
public:
  explicit Sheet_copies(const Triangulation&) {}
  static bool exist() { return false; }
  static bool is_seam(std::uint32_t) { return false; }
  static std::vector<Surface_point> missing(std::uint32_t) { return {}; }
  template <class Is_segment>
  static bool has_room(const Surface_point&, double, const Is_segment&) {
    return true;
  }
  static void note(std::uint32_t) {}
  static void forget(std::uint32_t) {}
  static void join(const std::vector<std::uint32_t>&) {}
  static std::vector<std::uint32_t> take(std::uint32_t vertex) { return {vertex}; }
  template <class Session>
  static std::uint64_t restore_seams(Session&, const std::vector<char>&) {
    return 0;
  }
};

// Surfaces that are not covers have no copies.
template <Knows_places Triangulation>
class Sheet_copies<Triangulation> {
  using View = Intrinsic_view<Triangulation>;

public:
  explicit Sheet_copies(const Triangulation& t) : t_(t) {
    if (!t.input().names().is_cover() || t.places() == nullptr) return;
    const Sheets sheets(t.input());
    if (!sheets.is_cover()) return;
    sheets_.emplace(sheets);
    is_seam_ = sheets_->wide_seams();
    find_copies();
  }

  // whether vertices have copies with known places: a flip of an edge with too many crossings ends
  // that
  bool exist() const { return sheets_.has_value() && places() != nullptr; }

  // Flips away the edges that cross a seam, usually all of them, except where one that is to be
  // kept, by its number, crosses it. \return how many flips that took
  template <class Session>
  std::uint64_t restore_seams(Session& session, const std::vector<char>& is_kept) {
    if (!exist()) return 0;
    Input_edge_restorer restore(t_, session, *places(), is_kept);
    for (std::uint32_t e = 0; e < is_seam_.size() && exist(); ++e)
      if (is_seam_[e] != 0) restore(2 * e);
    return restore.flips();
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

  // Whether a copy of a vertex, before its insertion, keeps a given squared distance from the
  // vertices of its face and of the neighbouring faces, but not beyond segments.
  template <class Is_segment>
  bool has_room(const Surface_point& place, double distance, const Is_segment& is_segment) const {
    const std::vector<Surface_point> found = locate(place);
    return found.empty() || keeps_distance(found.front(), distance, is_segment);
  }

  // notes a vertex that was inserted, if it is on a seam
  void note(std::uint32_t vertex) {
    if (!exist()) return;
    const Surface_point p = places()->location(vertex);
    if (is_on_seam(p)) on_seam_[{p.halfedge / 2, parameter(p)}] = vertex;
  }

  // forgets a vertex that is to be removed
  void forget(std::uint32_t vertex) {
    if (!exist()) return;
    const Surface_point p = places()->location(vertex);
    if (is_on_seam(p)) on_seam_.erase({p.halfedge / 2, parameter(p)});
  }

  // Finds a place of the input on the triangulation: on an edge if one runs along the input edge of
  // the place. Away from seams, rounding may move it to a neighbouring face: the faces beyond the
  // sides follow, the nearest first.
  std::vector<Surface_point> locate(const Surface_point& place) const {
    if (!exist()) return {};
    if (const auto p = locate_on_seam(place)) return {*p};
    const auto p =
        Intrinsic_locator<Triangulation, Integer_coordinates>(t_, *places()).locate(place);
    if (!p) return {};
    std::vector<Surface_point> result{in_or_on(p->point, place)};
    std::array<Surface_point, 3> sides{p->point, turned(p->point), turned(turned(p->point))};
    std::sort(sides.begin(), sides.end(), [](const Surface_point& a, const Surface_point& b) {
      return a.weights[2] < b.weights[2];
    });
    for (const Surface_point& q : sides) {
      if (!Triangulation::Metric::is_exact && q.weights[2] >= nearness)
        break; // no later check would refuse a face far from the place
      if (const std::uint32_t o = q.halfedge ^ 1U; !View(t_).is_border(o))
        result.push_back(in_or_on({o, {q.weights[1], q.weights[0], 0}}, place));
    }
    return result;
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
  // Weight up to which a point is taken to be on a side: far above rounding. With 2^-50 and with
  // 2^-4 tufted covers of the data set are refined alike.
  static constexpr double nearness = 0x1p-20;
  // an edge and the parameter along its even halfedge
  using Place_on_edge = std::pair<std::uint32_t, double>;

  // read each time, since they may be dropped
  const Integer_coordinates* places() const { return t_.places(); }

  // those of an earlier refinement
  void find_copies() {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> by_row;
    for (const typename Triangulation::vertex_descriptor v : vertices(t_.mesh()))
      if (t_.is_inserted(v)) {
        by_row[t_.input_vertex(v)].push_back(t_.index(v));
        note(t_.index(v));
      }
    for (const auto& [row, copies] : by_row) join(copies);
  }

  bool is_on_seam(const Surface_point& place) const {
    return place.weights[2] == 0 && is_seam_[place.halfedge / 2] != 0;
  }
  static double parameter(const Surface_point& p) { return p.weights[p.halfedge % 2 == 0 ? 1 : 0]; }

  // By the order of vertices on the seam, without rounding; nothing if the place is not on a seam,
  // or edges cross the seam.
  std::optional<Surface_point> locate_on_seam(const Surface_point& place) const {
    if (!is_on_seam(place)) return std::nullopt;
    const std::uint32_t edge = place.halfedge / 2;
    const double at = parameter(place);
    const auto after = on_seam_.upper_bound({edge, at});
    const bool is_last = after == on_seam_.end() || after->first.first != edge;
    std::uint32_t vertex = t_.input().source(2 * edge);
    double begin = 0, end = is_last ? 1 : after->first.second;
    if (after != on_seam_.begin())
      if (const auto before = std::prev(after); before->first.first == edge) {
        begin = before->first.second;
        vertex = before->second;
      }
    const auto start = find_curve(View(t_), *places(), vertex, 2 * edge);
    if (!start || start->index >= 0) return std::nullopt;
    const double w = (at - begin) / (end - begin);
    return Surface_point{start->halfedge, {1 - w, w, 0}};
  }

  template <class Is_segment>
  bool keeps_distance(Surface_point p, double distance, const Is_segment& is_segment) const {
    for (int k = 0; k < 3; ++k, p = turned(p)) {
      const Geodesic_face face(View(t_), p.halfedge);
      const Plane_vector<double> at{p.weights[1] * face.length[0] - p.weights[2] * face.edge[2][0],
                                    -p.weights[2] * face.edge[2][1]};
      if (dot(at, at) < distance) return false;
      const std::uint32_t o = p.halfedge ^ 1U;
      if (is_segment(o)) continue;
      // turned by half a turn about the middle of the side
      const Geodesic_face beside(View(t_), o);
      const double x = face.length[0] + beside.edge[2][0] - at[0], y = beside.edge[2][1] - at[1];
      if (x * x + y * y < distance) return false;
    }
    return true;
  }

  std::uint32_t along(std::uint32_t h) const {
    const Integer_coordinates& c = *places();
    return c.normal_coordinate(h / 2) >= 0 ? Gluing::none : c.fans().halfedge(c.roundabout(h));
  }

  Surface_point turned(const Surface_point& p) const {
    return {View(t_).next(p.halfedge), {p.weights[1], p.weights[2], p.weights[0]}};
  }

  // on a side along the input edge of the place, if the point is near it, else inside
  Surface_point in_or_on(Surface_point q, const Surface_point& place) const {
    if (place.weights[2] != 0) return inside(q);
    for (int k = 0; k < 3; ++k, q = turned(q))
      if (along(q.halfedge) / 2 == place.halfedge / 2 && q.weights[2] < nearness) {
        const double sum = q.weights[0] + q.weights[1];
        return {q.halfedge, {1 - q.weights[1] / sum, q.weights[1] / sum, 0}};
      }
    return inside(q);
  }

  // not on a side: that would split it
  static Surface_point inside(Surface_point p) {
    for (double& w : p.weights) w = (std::max(w, 0.) + 0x1p-40) / (1 + 3 * 0x1p-40);
    return p;
  }

  const Triangulation& t_;
  std::optional<Sheets> sheets_;
  std::vector<char> is_seam_; // of each edge of the input: the wide ones
  std::map<Place_on_edge, std::uint32_t> on_seam_;
  // one list for all of them
  std::unordered_map<std::uint32_t, std::shared_ptr<const std::vector<std::uint32_t>>> copies_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_COVERS_SHEET_COPIES_H

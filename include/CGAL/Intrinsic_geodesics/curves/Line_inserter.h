// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H

#include <CGAL/Intrinsic_geodesics/curves/Growing_paths.h>
#include <CGAL/Intrinsic_geodesics/curves/Line_progress.h>
#include <CGAL/Intrinsic_geodesics/curves/Split_crossed_edges.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Turns straight lines into paths of edges. A line starts at a vertex. Edges that it crosses are
// flipped away or split; an edge joins the new vertex to the vertex before. There the line goes on
// at its angle with the edge, over the changed triangulation: it may cross edges again, and earlier
// lines. Edges of these are always split.
// \tparam Crossed decides which edges may be flipped, by `may_flip(e)`, and whether others may be
//   split; it turns a line that crosses edges into a path of edges, by `edges_along(crossed)`:
//   halfedges in order, each from its end on the right of the line to that on the left
template <class Triangulation, class Crossed = Split_crossed_edges<Triangulation>>
class Line_inserter {
  using View = Accurate_view<Triangulation>;
  using Walk = Geodesic_walk<View>;
  using Split = typename Growing_paths<Triangulation>::Split;
  using Session = typename Triangulation::Session;
  using Weights = std::array<double, 3>;
  using Halfedges = std::vector<typename Triangulation::halfedge_descriptor>;

public:
  explicit Line_inserter(Triangulation& t, Crossed crossed = {})
      : t_(t), view_(t), crossed_edges_(std::move(crossed)) {}

  // The paths so far.
  const Growing_paths<Triangulation>& paths() const { return paths_; }
  Growing_paths<Triangulation>& paths() { return paths_; }

  // Finds or inserts the vertex where a line starts; `d` becomes the direction there.
  Move_status start(const Surface_point& p, const Plane_vector<double>& direction,
                    Corner_direction& d) {
    const Geodesic_face face(view_, p.halfedge);
    unsigned k = 0; // a weight that is zero becomes the last
    while (k < 2 && p.weights[(k + 2) % 3] != 0) ++k;
    const Surface_point q{face.side[k],
                          {p.weights[k], p.weights[(k + 1) % 3], p.weights[(k + 2) % 3]}};
    const Plane_vector<double> v = face.relative_to(k, direction);
    if (q.weights[2] != 0) return start_in_face(q, v, d);
    if (q.weights[0] != 0 && q.weights[1] != 0) return start_on_edge(q, v, d);
    d = at_corner(Walk(view_, p, direction)); // a line that is blocked has no length
    return Move_status::done;
  }

  // Turns a line of given length, in scaled units, into a path. It ends at vertex
  // `target`, if given, which must be near its end. Also `not_traceable` if it crosses an edge that
  // may not be split.
  Move_status go(Corner_direction d, double length, std::uint32_t target = Gluing::none) {
    const double total = length;
    const bool has_target = target != Gluing::none;
    Line_progress progress(total);
    for (; progress.may_go_on(length); progress.enter_face()) {
      if (!has_target && length <= 0x1p-40 * total) return Move_status::done;
      if (!turn(view_, d, rounding)) return Move_status::border;
      Walk walk(view_, d);
      const typename Walk::Exit e =
          cross_flippable(walk, target, length, nearness * total, progress);
      if (is_at_target_) return Move_status::done;
      const bool on_border = view_.is_border(walk.halfedge(e) ^ 1U);
      double error = on_border ? rounding * total : tolerance(walk, e);
      if (has_target) error = std::min(error, nearness_at_end * total); // of a line in a needle
      const bool ends = length <= e.distance + error;
      if (has_target && (ends || is_at_vertex(walk, e)) &&
          reaches(walk, target, length, nearness_at_end * total))
        return Move_status::done;
      if (ends)
        return has_target ? reach_beyond(walk, target, length, nearness_at_end * total)
                          : finish(walk.point(e, std::min(length, e.distance)));
      length -= e.distance;
      const Move_status s = pass(walk, e, has_target, d);
      if (s == Move_status::border && !has_target && length <= rounding * total)
        return Move_status::done;
      if (s != Move_status::done) return s;
    }
    return Move_status::not_traceable;
  }

private:
  // Bound for rounding of angles, and of parts of a line, at its ends.
  static constexpr double rounding = 0x1p-26;
  // The part of a line by which it may miss its target.
  static constexpr double nearness = 0x1p-16;
  // The same at its end. Rounding in larger faces that are thin has moved its ends by 2^-12 of it.
  static constexpr double nearness_at_end = 0x1p-10;

  // the halfedge before h in its face
  std::uint32_t last(std::uint32_t h) const { return view_.next(view_.next(h)); }

  // Smaller distances from edges and vertices, near a side of that length, count as zero. The bound
  // exceeds the error of located points of the input, which grows along a line. Closer to a vertex,
  // edges are so short that their directions are lost.
  static double tolerance(double length) { return 0x1p-31 * length; }
  static double tolerance(const Walk& walk, const typename Walk::Exit& e) {
    return tolerance(walk.face().length[e.side]);
  }

  // The direction of a walk at the vertex where it starts.
  static Corner_direction at_corner(const Walk& walk) {
    return {walk.face().side[0], std::atan2(walk.direction()[1], walk.direction()[0])};
  }

  // A direction from the vertex of a split by its angle from the direction of the edge, in (-pi,
  // pi]: relative to the longer part, since rounding turns it less.
  static Corner_direction from_split(const Split& s, double parameter, double angle) {
    if (parameter < 0.5) return {s.to_target, angle};
    return {s.to_source, angle > 0 ? angle - std::numbers::pi : angle + std::numbers::pi};
  }

  // ---- the start

  Move_status start_on_edge(const Surface_point& p, const Plane_vector<double>& v,
                            Corner_direction& d) {
    const Split s = paths_.split(t_, p.halfedge, p.weights[1]);
    d = from_split(s, p.weights[1], std::atan2(v[1], v[0]));
    return s.status;
  }

  Move_status start_in_face(const Surface_point& p, const Plane_vector<double>& v,
                            Corner_direction& d) {
    const Geodesic_face face(view_, p.halfedge);
    std::array<Plane_vector<double>, 3> corner;
    for (unsigned k = 0; k < 3; ++k) corner[k] = face.to_corner(p.weights, k);
    const auto length = [](const Plane_vector<double>& c) { return dot(c, c); };
    const auto k = static_cast<unsigned>(
        std::max_element(corner.begin(), corner.end(),
                         [&](const auto& a, const auto& b) { return length(a) < length(b); }) -
        corner.begin());
    const Move_status status =
        Session(t_).insert_vertex(t_.numbers().halfedge_at(p.halfedge), p.weights).status;
    if (status == Move_status::done)
      d = {last(face.side[k]), std::atan2(cross(corner[k], v), dot(corner[k], v))};
    return status;
  }

  // ---- on the way

  // Crosses edges that may be flipped, up to one that may not, a vertex, or the end of the line.
  // Returns the way out of the last face.
  typename Walk::Exit cross_flippable(Walk& walk, std::uint32_t target, double& length,
                                      double distance, Line_progress& progress) {
    crossed_.clear();
    for (;; progress.enter_face()) {
      const typename Walk::Exit e = walk.exit();
      is_at_target_ = target != Gluing::none && reaches(walk, target, length, distance);
      const std::uint32_t h = walk.halfedge(e);
      if (is_at_target_ || !progress.may_go_on(length) || length <= e.distance ||
          is_at_vertex(walk, e) || view_.is_border(h ^ 1U) || !may_flip(h / 2))
        return e;
      length -= e.distance;
      crossed_.push_back(h);
      walk.cross(e);
    }
  }
  bool may_flip(std::uint32_t e) const { return crossed_edges_.may_flip(e) && !paths_.has_edge(e); }
  static bool is_at_vertex(const Walk& walk, const typename Walk::Exit& e) {
    const double length = walk.face().length[e.side];
    return length * std::min(e.source_weight, e.target_weight) <= tolerance(length);
  }

  // Goes to the exit of the face; `d` becomes the direction there. A line along the border may pass
  // vertices on it.
  Move_status pass(Walk& walk, const typename Walk::Exit& e, bool may_follow_border,
                   Corner_direction& d) {
    const std::uint32_t h = walk.halfedge(e);
    if (is_at_vertex(walk, e)) {
      const unsigned corner = e.target_weight <= e.source_weight ? e.side : (e.side + 1) % 3;
      Walk beyond = walk; // before edges are flipped
      const bool is_inside = beyond.pass_vertex(corner);
      append_line_to(walk, corner);
      if (is_inside) d = at_corner(beyond);
      const bool goes_on =
          is_inside || (may_follow_border && is_straight_at(paths_.last() ^ 1U, d));
      return goes_on ? Move_status::done : Move_status::border;
    }
    if (view_.is_border(h ^ 1U)) return Move_status::border;
    if (!Crossed::may_split) return Move_status::not_traceable;
    walk.cross(e); // into the frame of the other halfedge, whose direction is the opposite one
    const double angle = std::atan2(walk.direction()[1], walk.direction()[0]) - std::numbers::pi;
    const Split s = paths_.split(t_, h, e.target_weight);
    if (s.status != Move_status::done) return s.status;
    if (crossed_.empty())
      append(s.to_apex ^ 1U);
    else
      append_line();
    d = from_split(s, e.target_weight, angle);
    return Move_status::done;
  }

  void append(std::uint32_t h) { paths_.append(h); }
  // A line that ends at the vertex opposite of the last edge that it crosses.
  void append_line() {
    Halfedges crossed;
    for (const std::uint32_t h : crossed_) crossed.push_back(t_.numbers().halfedge_at(h));
    for (const auto h : crossed_edges_.edges_along(crossed)) append_edge(t_.numbers().halfedge(h));
  }
  // An edge, or the way through vertices that rounding moved off it: so lines that touch share all
  // these vertices. Ends at vertex `target` if that is one of them. Returns whether it does.
  bool append_edge(std::uint32_t h, std::uint32_t target = Gluing::none) {
    for (const std::uint32_t g : {h, h ^ 1U}) {
      if (!crossed_edges_.may_flip(h / 2) || view_.is_border(g) || !is_at_apex(g)) continue;
      return append_edge(g == h ? last(g) ^ 1U : view_.next(g), target) ||
             append_edge(g == h ? view_.next(g) ^ 1U : last(g), target);
    }
    append(h);
    return view_.source(h ^ 1U) == target;
  }
  bool is_at_apex(std::uint32_t h) const {
    const Geodesic_face face(view_, h);
    const double l = face.length[0], x = -face.edge[2][0], distance = 0x1p-36 * l;
    return -face.edge[2][1] <= distance && x > distance && l - x > distance;
  }
  // A line that ends at a corner of the face where it is.
  void append_line_to(const Walk& walk, unsigned corner) {
    const auto& side = walk.face().side;
    if (crossed_.empty()) return (void)append_edge(corner == 1 ? side[0] : side[2] ^ 1U);
    if (corner != 2) { // an end of edges that are then not crossed
      const bool is_left = corner == 0;
      std::uint32_t h = Gluing::none;
      do {
        h = crossed_.back();
        crossed_.pop_back();
      } while (!crossed_.empty() && shares_end(crossed_.back(), h, is_left));
      if (crossed_.empty()) return (void)append_edge(is_left ? view_.next(h) ^ 1U : last(h));
    }
    append_line();
  }
  // whether two consecutive crossed edges share their end on the left, or on the right
  bool shares_end(std::uint32_t g, std::uint32_t h, bool is_left) const {
    return (is_left ? last(g ^ 1U) : view_.next(g ^ 1U)) == h;
  }

  // Whether a line that came along halfedge `back` may go on straight at a vertex of the border.
  bool is_straight_at(std::uint32_t back, Corner_direction& d) const {
    for (const double angle : {std::numbers::pi, -std::numbers::pi}) {
      d = {back, angle};
      if (turn(view_, d, rounding)) return true;
    }
    return false;
  }

  // ---- the end

  // Whether a line ends near a vertex of the face, up to a distance; then it goes there.
  bool reaches(const Walk& walk, std::uint32_t target, double length, double distance) {
    for (unsigned k = crossed_.empty() ? 1 : 0; k < 3; ++k) {
      if (view_.source(walk.face().side[k]) != target) continue;
      const Plane_vector<double> corner = walk.relative_corner(k);
      const double error = std::hypot(corner[0] - length, corner[1]);
      if (!(error <= distance + rounding_in(walk.face()))) continue;
      append_line_to(walk, k);
      return true;
    }
    return false;
  }

  // The same if the line ends within rounding of a side, and the vertex is beyond.
  Move_status reach_beyond(const Walk& walk, std::uint32_t target, double length, double distance) {
    const auto& side = walk.face().side;
    for (unsigned k = 0; k < 3; ++k) {
      if (!(distance_from_side(walk, k, length) <= distance + rounding_in(walk.face()))) continue;
      if (!crossed_.empty() && k != 0 && !view_.is_border(side[k] ^ 1U) && may_flip(side[k] / 2) &&
          view_.source(last(side[k] ^ 1U)) == target) {
        crossed_.push_back(side[k]);
        append_line();
        return Move_status::done;
      }
      if (crossed_.empty() && k != 1 && append_edge(k == 0 ? side[0] : side[2] ^ 1U, target))
        return Move_status::done;
    }
    return Move_status::not_traceable;
  }
  // Places in a face have errors of some units in the last place of its longest side, which may be
  // much longer than a line: about a needle.
  static double rounding_in(const Geodesic_face& face) {
    return 0x1p-48 * *std::max_element(face.length.begin(), face.length.end());
  }
  // of the end of a line
  static double distance_from_side(const Walk& walk, unsigned k, double length) {
    const Plane_vector<double> a = walk.relative_corner(k), b = walk.relative_corner((k + 1) % 3);
    return std::abs((b[0] - a[0]) * a[1] - (b[1] - a[1]) * (a[0] - length)) / walk.face().length[k];
  }

  // Ends in the face of a corner where the line comes from.
  Move_status finish(const Surface_point& end) {
    const Geodesic_face face(view_, end.halfedge);
    const Weights w = without_rounding(face, end.weights);
    const auto& side = face.side;
    if (w[1] == 0 && w[2] == 0) return Move_status::done;
    if (w[0] == 0 && (w[1] == 0 || w[2] == 0)) {
      append(w[2] == 0 ? side[0] : side[2] ^ 1U);
      return Move_status::done;
    }
    if (w[0] != 0 && w[1] != 0 && w[2] != 0) {
      const Move_status status =
          Session(t_).insert_vertex(t_.numbers().halfedge_at(side[0]), w).status;
      if (status == Move_status::done) append(last(side[0]) ^ 1U);
      return status;
    }
    const unsigned k = w[0] == 0 ? 1 : w[2] == 0 ? 0 : 2; // the side
    const Split s = paths_.split(t_, side[k], w[(k + 1) % 3]);
    if (s.status == Move_status::done)
      append((k == 0 ? s.to_source : k == 1 ? s.to_apex : s.to_target) ^ 1U);
    return s.status;
  }

  Weights without_rounding(const Geodesic_face& face, Weights w) const {
    const double twice_area = view_.quadruple_area(view_.face(face.side[0])) / 2;
    double sum = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const double side = face.length[(k + 1) % 3]; // opposite of the corner
      if (w[k] * twice_area <= side * tolerance(side)) w[k] = 0;
      sum += w[k];
    }
    for (double& x : w) x /= sum;
    return w;
  }

  Triangulation& t_;
  View view_;
  Crossed crossed_edges_;
  Growing_paths<Triangulation> paths_;
  std::vector<std::uint32_t> crossed_; // by the line since the last vertex
  bool is_at_target_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H

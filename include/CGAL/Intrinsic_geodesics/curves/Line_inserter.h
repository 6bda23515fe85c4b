// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H

#include <CGAL/Intrinsic_geodesics/curves/Growing_paths.h>
#include <CGAL/Intrinsic_geodesics/curves/Line_progress.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Turns straight lines into paths of edges. A line starts at a vertex. Edges that it crosses are
// flipped away or split; an edge joins the new vertex to the vertex before. There the line goes on
// at its angle with the edge, over the changed triangulation: it may cross edges again, and earlier
// lines. Edges of these are always split.
// \tparam Log `Flip_log`: edges are flipped, except those of earlier lines; `void`: all are split
// \tparam splits whether edges may be split
template <class Triangulation, class Log = void, bool splits = true>
class Line_inserter {
  using View = Accurate_view<Triangulation>;
  using Walk = Geodesic_walk<View>;
  using Split = typename Growing_paths<Triangulation>::Split;
  static constexpr bool flips = !std::is_void_v<Log>;
  static_assert(!flips || std::is_same_v<Log, Flip_log<Triangulation>>);

public:
  // \param log remembers flips, if nothing is split
  explicit Line_inserter(Triangulation& t, Log* log = nullptr) : t_(t), view_(t), log_(log) {}

  // The paths so far.
  const Growing_paths<Triangulation>& paths() const { return paths_; }
  Growing_paths<Triangulation>& paths() { return paths_; }

  // Turns a line of given length, in scaled units, into a path to vertex `target`, which must be
  // near its end. Also `not_traceable` if it crosses an edge that may not be split.
  Move_status go(Corner_direction d, double length, std::uint32_t target) {
    const double total = length;
    Line_progress progress(total);
    for (; progress.may_go_on(length); progress.enter_face()) {
      if (!turn(view_, d, rounding)) return Move_status::border;
      Walk walk(view_, d);
      const typename Walk::Exit e =
          cross_flippable(walk, target, length, nearness * total, progress);
      if (is_at_target_) return Move_status::done;
      const bool on_border = view_.is_border(walk.halfedge(e) ^ 1U);
      const double error = std::min(on_border ? rounding * total : tolerance(walk, e),
                                    nearness_at_end * total); // of a line in a needle
      const bool ends = length <= e.distance + error;
      if ((ends || is_at_vertex(walk, e)) && reaches(walk, target, length, nearness_at_end * total))
        return Move_status::done;
      if (ends) return reach_beyond(walk, target, length, nearness_at_end * total);
      length -= e.distance;
      const Move_status s = pass(walk, e, d);
      if (s != Move_status::done) return s;
    }
    return Move_status::not_traceable;
  }

private:
  // Bound for rounding of angles, and of parts of a line, at its ends: the root of 2^-52, which is
  // the error of angles near 0 and pi that are found from lengths.
  static constexpr double rounding = 0x1p-26;
  // The part of a line by which it may miss its target. Of 4,600 random polylines on the data set,
  // also stretched by 100, 97 fail in exact arithmetic, with 2^-10 96, with 2^-26 112, with 0 378.
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

  // ---- on the way

  // Crosses edges that may be flipped, up to one that may not, a vertex, or the end of the line.
  // Returns the way out of the last face.
  typename Walk::Exit cross_flippable(Walk& walk, std::uint32_t target, double& length,
                                      double distance, Line_progress& progress) {
    crossed_.clear();
    for (;; progress.enter_face()) {
      const typename Walk::Exit e = walk.exit();
      is_at_target_ = reaches(walk, target, length, distance);
      const std::uint32_t h = walk.halfedge(e);
      if (is_at_target_ || !progress.may_go_on(length) || length <= e.distance ||
          is_at_vertex(walk, e) || view_.is_border(h ^ 1U) || !may_flip(h / 2))
        return e;
      length -= e.distance;
      crossed_.push_back(h);
      walk.cross(e);
    }
  }
  bool may_flip(std::uint32_t e) const { return flips && !paths_.has_edge(e); }
  static bool is_at_vertex(const Walk& walk, const typename Walk::Exit& e) {
    const double length = walk.face().length[e.side];
    return length * std::min(e.source_weight, e.target_weight) <= tolerance(length);
  }

  // Goes to the exit of the face; `d` becomes the direction there. A line along the border may pass
  // vertices on it.
  Move_status pass(Walk& walk, const typename Walk::Exit& e, Corner_direction& d) {
    const std::uint32_t h = walk.halfedge(e);
    if (is_at_vertex(walk, e)) {
      const unsigned corner = e.target_weight <= e.source_weight ? e.side : (e.side + 1) % 3;
      Walk beyond = walk; // before edges are flipped
      const bool is_inside = beyond.pass_vertex(corner);
      append_line_to(walk, corner);
      if (is_inside) d = at_corner(beyond);
      const bool goes_on = is_inside || is_straight_at(paths_.last() ^ 1U, d);
      return goes_on ? Move_status::done : Move_status::border;
    }
    if (view_.is_border(h ^ 1U)) return Move_status::border;
    if (!splits) return Move_status::not_traceable;
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
  // A line that ends at the vertex opposite of the last edge that it crosses: without flips none
  // crosses an edge between vertices. One that passes
  // through a face twice becomes the chain of edges on its left.
  void append_line() {
    if constexpr (flips) {
      std::vector<typename Triangulation::halfedge_descriptor> crossed;
      for (const std::uint32_t h : crossed_) crossed.push_back(t_.numbers().halfedge_at(h));
      typename Triangulation::Session session(t_);
      Segment_flipper<Triangulation> flip(t_, session, log_);
      Shortening_result counts;
      const std::uint64_t most =
          pass_faces_once(t_, std::array{crossed}) ? std::numeric_limits<std::uint64_t>::max() : 0;
      for (const auto h : flip(crossed, most, counts, [](auto) {}))
        append_edge(t_.numbers().halfedge(h));
    }
  }
  // An edge, or the way through vertices that rounding moved off it: so lines that touch share all
  // these vertices. Ends at vertex `target` if that is one of them. Returns whether it does.
  bool append_edge(std::uint32_t h, std::uint32_t target = Gluing::none) {
    for (const std::uint32_t g : {h, h ^ 1U}) {
      if (!flips || view_.is_border(g) || !is_at_apex(g)) continue;
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

  Triangulation& t_;
  View view_;
  Log* log_;
  Growing_paths<Triangulation> paths_;
  std::vector<std::uint32_t> crossed_; // by the line since the last vertex
  bool is_at_target_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_LINE_INSERTER_H

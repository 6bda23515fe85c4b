// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_LINE_INSERTER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_LINE_INSERTER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Accurate_view.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Path_record.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Makes straight lines paths of edges. A line starts at a vertex and leaves the face through the side opposite of it; the
// vertex that splits this side is joined to the one before by an edge. There the line goes on at the angle that it makes with
// the side, over what has become of the triangulation: it may come across edges again, and across itself.
template <class Triangulation>
class Line_inserter {
  using View = Accurate_view<Triangulation>;
  using Walk = Geodesic_walk<View>;
  using Session = typename Triangulation::Session;
  using Weights = std::array<double, 3>;

public:
  explicit Line_inserter(Triangulation& t) : t_(t), view_(t) {}

  // The halfedges so far.
  std::vector<typename Triangulation::halfedge_descriptor> path() const {
    std::vector<typename Triangulation::halfedge_descriptor> result;
    for (const std::uint32_t h : path_.halfedges()) result.push_back(t_.numbers().halfedge_at(h));
    return result;
  }

  // Inserts a vertex where a line starts, unless there is one; `d` becomes the direction of the line there.
  Move_status start(const Surface_point& p, const Planar_vector<double>& direction,
                    Corner_direction& d) {
    const Geodesic_face face(view_, p.halfedge);
    unsigned k = 0; // a weight that is zero becomes the last
    while (k < 2 && p.weights[(k + 2) % 3] != 0) ++k;
    const Surface_point q{face.side[k],
                          {p.weights[k], p.weights[(k + 1) % 3], p.weights[(k + 2) % 3]}};
    const Planar_vector<double> v = face.relative_to(k, direction);
    if (q.weights[2] != 0) return start_in_face(q, v, d);
    if (q.weights[0] != 0 && q.weights[1] != 0) return start_on_edge(q, v, d);
    d = at_corner(Walk(view_, p, direction)); // a line that is blocked has no length
    return Move_status::done;
  }

  // Makes a line of a length, in units of the triangulation, a path. It ends at vertex `target`, if one is given, which must be near
  // its end.
  Move_status go(Corner_direction d, double length, std::uint32_t target = Gluing::none) {
    const double total = length;
    const bool has_target = target != Gluing::none;
    for (std::size_t faces = 0; faces < maximum_faces; ++faces) {
      if (!has_target && length <= 0x1p-40 * total) return Move_status::done;
      if (!turn(view_, d, rounding)) return Move_status::border;
      Walk walk(view_, d);
      if (has_target && reaches(walk, target, length, rounding * total)) return Move_status::done;
      const typename Walk::Exit e = walk.exit();
      const bool on_border = view_.is_border(walk.halfedge(e) ^ 1U);
      if (length <= e.distance + (on_border ? rounding * total : tolerance(walk, e)))
        return has_target ? Move_status::not_traceable
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
  static constexpr std::size_t maximum_faces = std::size_t{1} << 22U;
  // Angles, and parts of a line, that are taken for rounding at its ends.
  static constexpr double rounding = 0x1p-26;

  // A vertex on an edge, and the halfedges from it to the ends of the edge, and to the apex of the face in which it was split.
  struct Split {
    Move_status status;
    std::uint32_t to_source, to_target, to_apex;
  };

  // splits the edge of a halfedge that has a face
  Split split(std::uint32_t h, double parameter) {
    const bool on_border = view_.is_border(h ^ 1U);
    const Move_status status =
        Session(t_).split_edge(t_.numbers().halfedge_at(h), parameter).status;
    if (status != Move_status::done) return {status, h, h, h};
    Split s{status, h ^ 1U, 0, 0};
    if (on_border) { // h is the first half
      s.to_apex = view_.next(h);
      s.to_target = view_.next(s.to_apex ^ 1U);
    } else { // h was flipped, and runs from the vertex to the apex of the other face
      s.to_source = view_.next(h ^ 1U);
      s.to_target = last(h) ^ 1U;
      s.to_apex = next_around_source(view_, s.to_target);
      // h has come in between if the edge has this face on both sides
      if (s.to_apex / 2 == h / 2) s.to_apex = next_around_source(view_, s.to_apex);
    }
    if (h % 2 == 0)
      path_.split(h / 2, s.to_source ^ 1U, s.to_target);
    else
      path_.split(h / 2, s.to_target ^ 1U, s.to_source);
    return s;
  }

  // the halfedge before h in its face
  std::uint32_t last(std::uint32_t h) const { return view_.next(view_.next(h)); }

  // The distance from edges and vertices that is taken for none, near a side of a length: more than the error with which
  // points of the input are located, which grows along a line. Beside a vertex that is missed by less, edges are so short that
  // directions are lost.
  static double tolerance(double length) { return 0x1p-31 * length; }
  static double tolerance(const Walk& walk, const typename Walk::Exit& e) {
    return tolerance(walk.face().length[e.side]);
  }

  // The direction of a walk at the vertex where it starts.
  static Corner_direction at_corner(const Walk& walk) {
    return {walk.face().side[0], std::atan2(walk.direction()[1], walk.direction()[0])};
  }

  // A direction from the vertex of a split by its angle from the direction of the edge, in (-pi, pi]: told from the longer
  // part, which rounding has turned less.
  static Corner_direction from_split(const Split& s, double parameter, double angle) {
    if (parameter < 0.5) return {s.to_target, angle};
    return {s.to_source, angle > 0 ? angle - std::numbers::pi : angle + std::numbers::pi};
  }

  // ---- the start

  Move_status start_on_edge(const Surface_point& p, const Planar_vector<double>& v,
                            Corner_direction& d) {
    const Split s = split(p.halfedge, p.weights[1]);
    d = from_split(s, p.weights[1], std::atan2(v[1], v[0]));
    return s.status;
  }

  Move_status start_in_face(const Surface_point& p, const Planar_vector<double>& v,
                            Corner_direction& d) {
    const Geodesic_face face(view_, p.halfedge);
    std::array<Planar_vector<double>, 3> corner;
    for (unsigned k = 0; k < 3; ++k) corner[k] = face.to_corner(p.weights, k);
    const auto length = [](const Planar_vector<double>& c) { return planar_dot(c, c); };
    const auto k = static_cast<unsigned>(
        std::max_element(corner.begin(), corner.end(),
                         [&](const auto& a, const auto& b) { return length(a) < length(b); }) -
        corner.begin());
    const Move_status status =
        Session(t_).insert_vertex(t_.numbers().halfedge_at(p.halfedge), p.weights).status;
    if (status == Move_status::done)
      d = {last(face.side[k]), std::atan2(Intrinsic_triangulations::planar_cross(corner[k], v),
                                          planar_dot(corner[k], v))};
    return status;
  }

  // ---- on the way

  // Goes to the exit of the face; `d` becomes the direction there. A line that runs along the border may pass vertices on it.
  Move_status pass(Walk& walk, const typename Walk::Exit& e, bool may_follow_border,
                   Corner_direction& d) {
    const std::array<std::uint32_t, 3> side = walk.face().side;
    const double length = walk.face().length[e.side];
    if (length * std::min(e.source_weight, e.target_weight) <= tolerance(length)) {
      const bool is_at_source = e.target_weight <= e.source_weight;
      const std::uint32_t h = is_at_source ? side[0] : side[2] ^ 1U;
      path_.append(h);
      if (walk.pass_vertex(is_at_source ? 1 : 2)) {
        d = at_corner(walk);
        return Move_status::done;
      }
      return may_follow_border && is_straight_at(h ^ 1U, d) ? Move_status::done
                                                            : Move_status::border;
    }
    if (view_.is_border(side[1] ^ 1U)) return Move_status::border;
    walk.cross(e); // into the frame of the other halfedge, whose direction is the opposite one
    const double angle = std::atan2(walk.direction()[1], walk.direction()[0]) - std::numbers::pi;
    const Split s = split(side[1], e.target_weight);
    if (s.status != Move_status::done) return s.status;
    path_.append(s.to_apex ^ 1U);
    d = from_split(s, e.target_weight, angle);
    return Move_status::done;
  }

  // Whether a line that has come along halfedge `back` may go on straight at a vertex of the border.
  bool is_straight_at(std::uint32_t back, Corner_direction& d) const {
    for (const double angle : {std::numbers::pi, -std::numbers::pi}) {
      d = {back, angle};
      if (turn(view_, d, rounding)) return true;
    }
    return false;
  }

  // ---- the end

  // Whether a line that starts at a corner ends near a vertex of the face, up to a distance; it becomes a side then.
  bool reaches(const Walk& walk, std::uint32_t target, double length, double distance) {
    const Geodesic_face& face = walk.face();
    const Planar_vector<double> end{length * walk.direction()[0], length * walk.direction()[1]};
    for (unsigned k = 1; k < 3; ++k) {
      const Planar_vector<double> corner = face.to_corner({1, 0, 0}, k);
      if (view_.source(face.side[k]) != target ||
          !(std::hypot(corner[0] - end[0], corner[1] - end[1]) <= distance))
        continue;
      path_.append(k == 1 ? face.side[0] : face.side[2] ^ 1U);
      return true;
    }
    return false;
  }

  // Ends in the face of a corner where the line comes from.
  Move_status finish(const Surface_point& end) {
    const Geodesic_face face(view_, end.halfedge);
    const Weights w = without_rounding(face, end.weights);
    const auto& side = face.side;
    if (w[1] == 0 && w[2] == 0) return Move_status::done;
    if (w[0] == 0 && (w[1] == 0 || w[2] == 0)) {
      path_.append(w[2] == 0 ? side[0] : side[2] ^ 1U);
      return Move_status::done;
    }
    if (w[0] != 0 && w[1] != 0 && w[2] != 0) {
      const Move_status status =
          Session(t_).insert_vertex(t_.numbers().halfedge_at(side[0]), w).status;
      if (status == Move_status::done) path_.append(last(side[0]) ^ 1U);
      return status;
    }
    const unsigned k = w[0] == 0 ? 1 : w[2] == 0 ? 0 : 2; // the side
    const Split s = split(side[k], w[(k + 1) % 3]);
    if (s.status == Move_status::done)
      path_.append((k == 0 ? s.to_source : k == 1 ? s.to_apex : s.to_target) ^ 1U);
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
  Path_record path_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_CURVES_LINE_INSERTER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H
#define CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/spread_windows.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The last straight piece of the shortest path to a vertex. Its directions are angles from the
// first corner of a vertex, as the field has it: flips do not change them.
struct Last_piece {
  std::uint32_t from = Gluing::none; // the vertex where it begins
  double departure = 0;              // its direction there
  double arrival = 0;                // the direction back, where it ends
  double length = 0;
};

// The direction of a vector in the frame of a corner. It also ends for a corner in another fan of a
// nonmanifold vertex, but is meaningless there.
inline double direction_at_vertex(const Corner_table& table, std::uint32_t corner,
                                  Plane_vector<double> d) {
  double angle = std::atan2(std::max(d.y, 0.0), d.x);
  const std::uint32_t first = table.first_corner[table.corners[corner].origin];
  for (std::uint32_t c = first; c != corner && c != Gluing::none;) {
    angle += std::atan2(table.corners[c].sine, table.corners[c].cosine);
    c = table.turn_left(c);
    if (c == first) break;
  }
  return angle;
}

// Finds the last piece of a shortest path; `from` is `Gluing::none` without a path, and at the
// source.
inline Last_piece last_piece(const Distance_field& field, std::uint32_t v) {
  const Arrival& a = field.vertices[v].arrival;
  if (a.kind != Arrival::Kind::straight) return {};
  const Traced_back path = trace_back(field, v, 1);
  if (path.status != Status::done) return {};
  const std::uint32_t start = path.places.back().side;
  const Plane_vector<double>& d = path.departure;
  return {
      field.table.corners[start].origin, direction_at_vertex(field.table, start, d),
      direction_at_vertex(field.table, a.corner(), field.turned_to(a.corner(), a.image, a.side)),
      std::hypot(d.x, d.y)};
}

// How a tree reaches a vertex.
struct Branch {
  double length = std::numeric_limits<double>::infinity(); // of its path
  // the last halfedge of its path; none at the source, and without a path
  std::uint32_t halfedge = Gluing::none;
};

// Makes shortest paths from a source edges, the nearest vertex first.
//
// Windows give the last straight piece of each path. It begins at a vertex of the tree, at an angle
// from the edge of the tree there; flips make it an edge. Shortest paths do not cross, so no edge
// of the tree blocks it.
//
// Windows are doubles. So the traits decide whether each path is a geodesic where it leaves the
// tree. If it is not, edges are flipped out of the wedge there, as in `shorten_curves()`; then the
// shortest way to the vertex becomes the path. No other edge of the tree is in that wedge, since
// its own wedge would be smaller. So edges of the tree are never flipped; with doubles, a wedge
// that seems to contain one stays.
//
// If rounding loses a piece, existing edges join the vertex to the tree, and the path is
// straightened. The vertex waits if no edge leads to the tree yet. Every flip shortens a way to it,
// and there are finitely many geodesic edges below a length.
template <class Triangulation>
class Geodesic_tree_builder {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;
  using View = Intrinsic_view<Triangulation>;
  static constexpr std::uint32_t none = Gluing::none;
  // Ways to a vertex that are not shorter. With five, trees of the data set are the same.
  static constexpr unsigned most_futile = 100;

public:
  Geodesic_tree_builder(const Triangulation& t, Session& session)
      : t_(t), view_(t), session_(session), flip_wedge_(t, session, nullptr),
        flip_to_segment_(t, session), branches_(t.numbers().vertex_capacity(t.mesh())),
        references_(branches_.size()) {}

  // `go_on(result)` is called now and then
  template <class Go_on>
  void run(Vertex source, std::uint64_t cap, const Go_on& go_on) {
    cap_ = cap;
    Distance_field field(corner_table(t_));
    field.table.next_copy.clear(); // edges do not lead from one copy of a vertex to another
    const std::uint32_t root = t_.index(source);
    Propagation_limits limits;
    limits.windows = field.default_cap();
    const Status s = session_.suspended([&] {
      const auto progress = [&](std::uint64_t, double) { return go_on(result_); };
      Propagation_memory memory;
      return spread_windows(field, {{{root, 0}}, {}}, limits, memory, progress).first;
    });
    if (s == Status::cancelled) result_.status = s;
    branches_[root].length = 0;
    if (const std::uint32_t corner = field.table.first_corner[root]; corner != none)
      references_[root].halfedge = halfedge_of_corner(t_, corner);
    join_all(source, field, go_on);
    if (result_.status == Status::done && lacks_way()) result_.status = Status::stalled;
  }

  // by numbers of vertices, in the units of the input
  std::vector<Branch> branches() const {
    std::vector<Branch> result = branches_;
    for (Branch& b : result) b.length = std::ldexp(b.length, -t_.metric().scale_exponent());
    return result;
  }
  const Shortening_result& result() const { return result_; }

private:
  // a halfedge from a vertex, and its direction as of a `Last_piece`
  struct Reference {
    std::uint32_t halfedge = none;
    double direction = 0;
  };

  Halfedge halfedge_at(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }
  bool has_way(std::uint32_t v) const { return std::isfinite(branches_[v].length); }
  bool is_in_tree(std::uint32_t h) const {
    return branches_[view_.target(h)].halfedge == h ||
           branches_[view_.source(h)].halfedge == (h ^ 1U);
  }

  // Vertices without a way wait until others have one.
  template <class Go_on>
  void join_all(Vertex source, const Distance_field& field, const Go_on& go_on) {
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
    std::vector<std::uint32_t> waiting;
    for (const Vertex v : vertices(t_.mesh()))
      if (v != source && halfedge(v, t_.mesh()) != null) waiting.push_back(t_.index(v));
    std::stable_sort(waiting.begin(), waiting.end(), [&](std::uint32_t v, std::uint32_t w) {
      return field.vertices[v].distance < field.vertices[w].distance;
    });
    for (unsigned idle = 0; idle < most_futile && !waiting.empty();) {
      const std::size_t before = waiting.size();
      const std::uint64_t flips = result_.flips;
      std::erase_if(waiting, [&](std::uint32_t v) {
        return goes_on(go_on) && join(v, last_piece(field, v));
      });
      if (waiting.size() < before) continue;
      if (flips == result_.flips || result_.status != Status::done) return;
      ++idle;
    }
  }
  template <class Go_on>
  bool goes_on(const Go_on& go_on) {
    if (result_.status == Status::done && (steps_++ & 0x3ffU) == 0 &&
        !session_.suspended([&] { return go_on(result_); }))
      result_.status = Status::cancelled;
    return result_.status == Status::done;
  }

  // Makes a way to a vertex. False if there is none.
  bool join(std::uint32_t v, const Last_piece& piece) {
    const std::uint32_t segment = insert(v, piece);
    double last = HUGE_VAL;
    for (unsigned futile = 0; futile < most_futile && result_.status == Status::done;) {
      const std::vector<Branch> ways = ways_to(v);
      const std::uint64_t flips = result_.flips;
      for (const Branch& way : ways) {
        // with inexact traits, where no flip helps it is straight up to rounding
        if (is_straight(way.halfedge) ||
            (!Triangulation::Metric::is_exact && flips == result_.flips)) {
          branches_[v] = way;
          note_directions(v, piece, segment);
          return true;
        }
        if (flips != result_.flips) break;
      }
      if (flips == result_.flips) return false;
      if (!(ways.front().length < last)) ++futile;
      last = ways.front().length;
    }
    return false;
  }

  // Makes the last piece of a path an edge, or the chain beside it where rounding prevents that.
  // Returns the halfedge to the vertex, none if it is lost.
  std::uint32_t insert(std::uint32_t v, const Last_piece& piece) {
    if (piece.from == none) return none;
    const Reference& r = references_[piece.from];
    if (r.halfedge == none || view_.source(r.halfedge) != piece.from) return none;
    const Geodesic_to_target line = session_.suspended([&] {
      const Geodesic_walk<View> walk(view_, {r.halfedge, piece.departure - r.direction});
      return trace_to_target(view_, walk, Geodesic_target::at_vertex(v), piece.length, strip_);
    });
    if (!line.is_reached) return none;
    if (strip_.empty()) return line.along;
    std::vector<Halfedge> crossed;
    for (const Strip_side& s : strip_) {
      if (is_in_tree(s.halfedge)) return none;
      crossed.push_back(halfedge_at(s.halfedge));
    }
    if (!pass_faces_once(t_, std::array{crossed})) return none;
    const auto way = flip_to_segment_(crossed, cap_ - result_.flips, result_, [](Halfedge) {});
    if (result_.flips >= cap_) result_.status = Status::cap;
    return t_.numbers().halfedge(way.back());
  }

  // those by an edge from the tree, the shortest first
  std::vector<Branch> ways_to(std::uint32_t v) const {
    std::vector<Branch> result;
    for_each_outgoing(t_.numbers().vertex_at(v), t_.mesh(), [&](Halfedge g) {
      const std::uint32_t h = t_.numbers().halfedge(g) ^ 1U, u = view_.source(h);
      if (has_way(u))
        result.push_back(
            {branches_[u].length + std::sqrt(t_.metric().approximate_squared_length(h / 2)), h});
    });
    std::sort(result.begin(), result.end(),
              [](const Branch& a, const Branch& b) { return a.length < b.length; });
    return result;
  }

  // whether the path goes on straight from the tree along h; if not, edges are flipped
  bool is_straight(std::uint32_t h) {
    const auto& mesh = t_.mesh();
    const std::uint32_t last = branches_[view_.source(h)].halfedge;
    if (last == none) return true;
    const Halfedge in = halfedge_at(last), out = halfedge_at(h);
    for (const bool is_left : {true, false}) {
      const Halfedge from = is_left ? in : opposite(out, mesh);
      const Halfedge to = is_left ? out : opposite(in, mesh);
      Wedge wedge;
      if (!find_wedge(t_, from, to, wedge,
                      [&](Halfedge g) { return !is_in_tree(t_.numbers().halfedge(g)); }))
        continue;
      ++result_.wedge_checks;
      const Comparison_result c = compare_to_pi(session_, from, to, wedge);
      if (c == EQUAL) ++result_.exact_ties;
      if (c != SMALLER) continue;
      ++result_.shortenings;
      if (!flip_wedge_(opposite(in, mesh), out, is_left, cap_ - result_.flips, result_,
                       [](Halfedge) {}))
        result_.status = Status::cap;
      return false;
    }
    return true;
  }

  // The edge of the tree to a vertex is that of the last piece, or beside it. An edge of the tree
  // stays, unlike the first reference at the source.
  void note_directions(std::uint32_t v, const Last_piece& piece, std::uint32_t segment) {
    if (segment == none || view_.target(segment) != v) return;
    const std::uint32_t h = branches_[v].halfedge;
    references_[v] = {h ^ 1U, piece.arrival + angle_between(segment ^ 1U, h ^ 1U)};
    if (h == segment && view_.source(h) == piece.from && branches_[piece.from].halfedge == none)
      references_[piece.from] = {h, piece.departure};
  }
  // from one halfedge of a vertex to another, negative if only clockwise steps reach it
  double angle_between(std::uint32_t from, std::uint32_t to) const {
    double sum = 0;
    std::uint32_t h = from;
    while (h != to && !view_.is_border(h)) {
      sum += angle_at_source(view_, h);
      h = next_around_source(view_, h);
      if (h == from) break;
    }
    if (h == to) return sum;
    for (h = from, sum = 0; h != to && !view_.is_border(h ^ 1U);) {
      h = view_.next(h ^ 1U);
      sum -= angle_at_source(view_, h);
      if (h == from) break;
    }
    return sum;
  }

  // whether a vertex next to the tree is not in it, since all ways to it seem bent
  bool lacks_way() const {
    const auto all = halfedges(t_.mesh());
    return std::any_of(all.begin(), all.end(), [&](Halfedge h) {
      return has_way(t_.index(source(h, t_.mesh()))) && !has_way(t_.index(target(h, t_.mesh())));
    });
  }

  const Triangulation& t_;
  View view_;
  Session& session_;
  Wedge_flipper<Triangulation> flip_wedge_;
  Segment_flipper<Triangulation> flip_to_segment_;
  std::vector<Branch> branches_; // per vertex, in scaled units
  std::vector<Reference> references_;
  std::vector<Strip_side> strip_;
  Shortening_result result_;
  std::uint64_t cap_ = 0, steps_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H

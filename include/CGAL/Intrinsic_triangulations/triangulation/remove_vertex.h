// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REMOVE_VERTEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REMOVE_VERTEX_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Flip_log.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/*!
Removes an inserted vertex: flips edges away from it until it has three, on the border one inside.

The faces around the vertex develop into a polygon that is star-shaped about it. A triangulation of
the polygon without the vertex has two ears at least, of which one does not contain the vertex
inside: the edge to its tip can be flipped. On the border the ears at both ends of the straight side
are not counted. A flip leaves a face of zero area only if the vertex is on the segment between two
neighbours and has at most two others; that face is removed with the vertex. Every flip takes an
edge away from the vertex, hence the loop ends; edges from the vertex to itself can end it too
early.
*/
template <class Triangulation>
class Vertex_remover {
  using Mesh = typename Triangulation::Mesh;
  using Session = typename Triangulation::Session;
  using Traits = boost::graph_traits<Mesh>;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  Vertex_remover(Triangulation& t, Session& session, Vertex v)
      : t_(t), session_(session), mesh_(t.mesh()), v_(v) {}
  Vertex_remover(const Vertex_remover&) = delete;
  Vertex_remover& operator=(const Vertex_remover&) = delete;
  // takes flips back if the vertex was not removed
  ~Vertex_remover() { log_.undo(session_); }

  Move_status remove() {
    find_edges();
    develop();
    for (;; find_edges()) {
      if (edges_.size() == 3 && !has_loop()) break;
      if (flip_an_edge()) continue;
      const Halfedge straight = edges_.size() == 4 ? straight_edge() : Traits::null_halfedge();
      if (straight == Traits::null_halfedge() || log_.flip_by(session_, straight, [&] {
            return session_.flip_to_zero_area(straight);
          }) != Move_status::done)
        return Move_status::not_removable;
    }
    const Move_status s = is_border_
                              ? session_.remove_border_vertex(opposite(edges_.front(), mesh_))
                              : session_.remove_degree_three_vertex(next(edges_.front(), mesh_));
    if (s == Move_status::done) log_.clear();
    return s;
  }

private:
  struct Candidate {
    double power;   // of the vertex with respect to the circle about the ear, negative inside
    double quality; // least new area by squared length
    Halfedge edge;
  };
  // where the other end of an edge from the vertex is, that being at the origin
  struct Place {
    std::uint32_t edge;
    Plane_vector<double> position;
  };

  // the halfedges from the vertex, counterclockwise; on the border the first has no face on its
  // right
  void find_edges() {
    edges_.clear();
    for_each_outgoing(v_, mesh_, [this](Halfedge h) { edges_.push_back(h); });
    is_border_ = is_border(opposite(edges_.front(), mesh_));
    // the face of the last edge's left side is that of the first one's right side
    if (is_border_) std::rotate(edges_.begin(), edges_.end() - 1, edges_.end());
  }

  bool is_border(Halfedge h) const { return face(h, mesh_) == Traits::null_face(); }

  bool has_loop() const {
    for (const Halfedge h : edges_)
      if (target(h, mesh_) == v_) return true;
    return false;
  }

  // whether a flip takes an end of the edge away from the vertex, and puts none there
  bool is_candidate(Halfedge h) const {
    const Halfedge o = opposite(h, mesh_);
    return !is_border(h) && !is_border(o) && face(h, mesh_) != face(o, mesh_) &&
           target(next(h, mesh_), mesh_) != v_ && target(next(o, mesh_), mesh_) != v_;
  }

  Diamond_values<double> values(Halfedge h) const {
    const Diamond d = t_.diamond(h);
    const auto& m = t_.metric();
    return {m.approximate_squared_length(d.ij), m.approximate_squared_length(d.jk),
            m.approximate_squared_length(d.ki), m.approximate_squared_length(d.im),
            m.approximate_squared_length(d.mj), m.approximate_quadruple_area(d.f),
            m.approximate_quadruple_area(d.g)};
  }

  // Flips the edge whose ear has the circle that contains the vertex the least. Where the faces
  // about the vertex are Delaunay, so are the ears cut off in this order: none is flipped again
  // (Devillers, On deletion in Delaunay triangulations, 1999). Other orders make thin faces on the
  // way, whose flips let rounding grow exponentially. The power of i with respect to the circle
  // about jmk is -(q_f a_g + q_g a_f) / (2 a_jmk).
  bool flip_an_edge() {
    candidates_.clear();
    for (const Halfedge h : edges_) {
      if (!is_candidate(h)) continue;
      const Diamond_values<double> d = values(h);
      const Flipped_values<double> n = flipped(d);
      const double power = n.area_f > 0 ? -Delaunay_expression()(d) / n.area_f
                                        : -std::numeric_limits<double>::infinity();
      candidates_.push_back({power, std::min(n.area_f, n.area_g) / n.km, h});
    }
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.power > b.power || (a.power == b.power && a.quality > b.quality);
    });
    for (const Candidate& c : candidates_) {
      // two of four edges may be collinear, up to rounding
      if (!Triangulation::Metric::is_exact && c.quality < doubtful_quality && edges_.size() == 4 &&
          !is_border_ && straight_edge() != Traits::null_halfedge())
        return false;
      const std::array<Plane_vector<double>, 3> kmj = ear(c.edge);
      // whether it is Delaunay or not: a zero area, up to rounding, is removed with the vertex
      const auto flip = [&] { return session_.flip_non_delaunay_edge(c.edge); };
      if (session_.flip_status(c.edge) != Move_status::done ||
          log_.flip_by(session_, c.edge, flip) != Move_status::done)
        continue;
      correct(c.edge, kmj);
      return true;
    }
    return false;
  }

  // ---- with floating point numbers

  // If each ear used values from the one before, rounding would grow exponentially with their
  // number. So the star is laid out in the plane once, where errors only add up, and gives all
  // values.
  static constexpr bool is_corrected = std::is_same_v<typename Triangulation::FT, double>;

  void develop() {
    if constexpr (is_corrected) {
      if (edges_.size() <= 4 || has_loop()) return;
      Plane_vector<double> direction{1, 0};
      for_each_outgoing(v_, mesh_, [&](Halfedge h) {
        const std::uint32_t e = t_.index(edge(h, mesh_));
        const double length = std::sqrt(t_.metric().approximate_squared_length(e));
        places_.push_back({e, length * direction});
        if (is_border(h)) return;
        const Halfedge n = next(h, mesh_), l = next(n, mesh_);
        const auto squared = [this](Halfedge g) {
          return t_.metric().approximate_squared_length(t_.index(edge(g, mesh_)));
        };
        const Plane_vector<double> z{
            twice_inner_product(squared(h), squared(n), squared(l)),
            t_.metric().approximate_quadruple_area(t_.index(face(h, mesh_)))};
        direction = direction * z / std::hypot(z.x, z.y);
      });
    }
  }

  Plane_vector<double> place(Halfedge h) const {
    const std::uint32_t e = t_.index(edge(h, mesh_));
    return std::find_if(places_.begin(), places_.end(), [e](const Place& p) { return p.edge == e; })
        ->position;
  }

  // the corners of the ear that the flip of an edge from the vertex cuts off, the vertex being i
  std::array<Plane_vector<double>, 3> ear(Halfedge h) const {
    if (places_.empty()) return {};
    return {place(next(next(h, mesh_), mesh_)), place(next(opposite(h, mesh_), mesh_)), place(h)};
  }

  void correct(Halfedge h, const std::array<Plane_vector<double>, 3>& kmj) {
    if constexpr (is_corrected) {
      if (places_.empty()) return;
      const auto& [k, m, j] = kmj;
      const Plane_vector<double> km = m - k;
      const Flipped_values<double> n{dot(km, km), 2 * cross(km, j - k), 2 * cross(m, k)};
      if (n.km > 0 && n.area_f > 0 && n.area_g > 0) session_.correct_values(h, n);
    }
  }

  // an edge to whose sides the vertex has a straight angle
  Halfedge straight_edge() {
    for (const Halfedge h : edges_)
      if (is_candidate(h) && is_straight(h)) return h;
    return Traits::null_halfedge();
  }

  bool is_straight(Halfedge h) {
    const Diamond d = t_.diamond(h);
    if constexpr (Triangulation::Metric::is_exact) {
      return t_.sign(d, Convexity_at_source_expression()) == ZERO &&
             t_.sign(d, Convexity_at_target_expression()) == POSITIVE;
    } else {
      const Diamond_values<double> v = values(h);
      const Flipped_values<double> n = flipped(v);
      return n.area_f > 0 && std::abs(n.area_g) <= straight_tolerance * (v.area_f + v.area_g);
    }
  }

  // Both numbers are for rounded metrics alone: an exact one decides by signs, without tolerance.
  // Relative area that a face with a straight angle has by rounding after many moves: areas are
  // roots, and that of 2^-52 is 1.5e-8. A face that is thinner in truth goes as a straight one: the
  // lengths of the rim stay, and only the area that the face had is lost.
  static constexpr double straight_tolerance = 1e-7;
  // Area by squared side of a face that may be such a one. If it is none, `straight_edge()` finds
  // no straight angle, and only time is lost.
  static constexpr double doubtful_quality = 1e-9;

  Triangulation& t_;
  Session& session_;
  const Mesh& mesh_;
  Vertex v_;
  bool is_border_ = false;
  std::vector<Halfedge> edges_;
  std::vector<Candidate> candidates_;
  Flip_log<Triangulation> log_;
  std::vector<Place> places_;
};

/// removes an inserted vertex, see `Intrinsic_triangulation::remove_vertex()`
template <class Triangulation>
Move_status remove_vertex(Triangulation& t, typename Triangulation::Session& session,
                          typename Triangulation::vertex_descriptor v) {
  return Vertex_remover<Triangulation>(t, session, v).remove();
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_REMOVE_VERTEX_H

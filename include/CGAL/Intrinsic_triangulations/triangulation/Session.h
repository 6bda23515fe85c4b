// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SESSION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SESSION_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_inserter.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/remove_vertex.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <array>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides many predicates on a triangulation in one floating point environment.

During its lifetime the rounding mode may differ from the default: call other code through
`suspended()`.
\tparam Triangulation an instance of `Intrinsic_triangulation`
*/
template <class Triangulation>
class Predicate_session {
  using Mesh = typename Triangulation::Mesh;

public:
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// Edge of the mesh.
  using edge_descriptor = typename Triangulation::edge_descriptor;

  /// opens a session on `t`, which must outlive it.
  explicit Predicate_session(const Triangulation& t) : t_(t) {}

  /// see `Intrinsic_triangulation::is_locally_delaunay()`
  BOOST_FORCEINLINE bool is_locally_delaunay(halfedge_descriptor h) const {
    return combinatorial_flip_status(h) != Move_status::done ||
           t_.is_locally_delaunay(t_.diamond(h));
  }
  /// see `Intrinsic_triangulation::delaunay_sign()`
  Sign delaunay_sign(halfedge_descriptor h) const { return t_.delaunay_sign(t_.diamond(h)); }
  /// see `Intrinsic_triangulation::flip_status()`
  Move_status flip_status(halfedge_descriptor h) const {
    const Move_status s = combinatorial_flip_status(h);
    if (s != Move_status::done) return s;
    return t_.is_flippable(t_.diamond(h)) ? Move_status::done : Move_status::not_convex;
  }
  /*!
  \brief returns the cotangent weight of an edge: half the sum of the cotangents of the angles
  opposite it (Eq. 4 of the course), one of them on the border.

  With exact traits it is zero exactly where the opposite angles sum to pi, and never negative
  on a locally Delaunay edge; where stored values are not accurate enough, it is the double
  nearest to the exact weight, or one within a tolerance beyond the default. Dimensionless.
  \param e an edge
  \param tolerance with exact traits, the greatest error of the weight of an edge between two faces,
  relative to itself or to min(1, E), where E is the least Dirichlet energy in the two faces of
  functions that change by one along the edge; statistics of many edges need less than the default
  \pre the faces at the edge have an area
  */
  double cotangent_weight(edge_descriptor e, double tolerance = Enclosed_values::weight_tolerance)
      const requires EuclideanMetric<typename Triangulation::Metric> {
    const auto null = boost::graph_traits<Mesh>::null_face();
    halfedge_descriptor h = halfedge(e, t_.mesh());
    if (face(h, t_.mesh()) == null) h = opposite(h, t_.mesh());
    if (face(opposite(h, t_.mesh()), t_.mesh()) != null)
      return t_.cotangent_weight(t_.diamond(h), tolerance);
    const halfedge_descriptor jk = next(h, t_.mesh()), ki = next(jk, t_.mesh());
    const auto number = [this](halfedge_descriptor g) { return t_.numbers().halfedge(g) / 2; };
    return t_.metric().cotangent_weight(number(h), number(jk), number(ki),
                                        t_.index(face(h, t_.mesh())));
  }
  /*!
  \brief compares an angle with pi: that at the target of `h` between `h` and `g`, on the left of
  `h`.
  \param h a halfedge
  \param g a halfedge from the target of `h`; the opposite of `h`: the angle is all about the vertex
  \pre no border is in between
  \complexity linear in the number of faces in between, quadratic if it is nearly pi or beyond
  */
  Comparison_result compare_angle_to_pi(halfedge_descriptor h, halfedge_descriptor g)
      const requires internal::Decides_signs<typename Triangulation::Metric> {
    internal::Wedge wedge;
    internal::find_wedge(t_, h, g, wedge);
    return compare_angle_to_pi(wedge);
  }
  /// \cond
  Comparison_result compare_angle_to_pi(const internal::Wedge& wedge)
      const requires internal::Decides_signs<typename Triangulation::Metric> {
    if constexpr (internal::Has_enclosures<typename Triangulation::Metric>)
      if (const auto c = internal::certain_comparison_to_pi(t_.metric(), wedge)) return *c;
    return internal::compare_wedge_to_pi(wedge, [&](const auto& faces, const auto& expression) {
      using Expression = std::decay_t<decltype(expression)>;
      if constexpr (std::is_same_v<Expression, Wedge_sine_expression>)
        if (faces.size() == 2)
          return t_.sign(internal::diamond_of_corners(faces[0], faces[1]),
                         Convexity_at_source_expression());
      return t_.sign(faces, expression);
    });
  }
  /// \endcond
  /// returns the sign of the area of the face of a halfedge: positive in a triangulation, unless
  /// rounding has turned faces over.
  Sign orientation(halfedge_descriptor h)
      const requires internal::Decides_signs<typename Triangulation::Metric> {
    const Indexed_face f = internal::indexed_face_from(t_, h);
    return t_.sign(std::span(&f, 1), [](const auto& v) { return v.front().quadruple_area; });
  }
  /// calls a function in the default floating point environment.
  template <class Function>
  auto suspended(Function f) const {
    const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
    return f();
  }

private:
  Move_status combinatorial_flip_status(halfedge_descriptor h) const {
    const auto null = boost::graph_traits<Mesh>::null_face();
    const auto f = face(h, t_.mesh()), g = face(opposite(h, t_.mesh()), t_.mesh());
    if (f == null || g == null) return Move_status::border;
    return f == g ? Move_status::same_face : Move_status::done;
  }

  const Triangulation& t_;
  [[no_unique_address]] typename Triangulation::Metric::Scope scope_;
};

/*!
\brief decides many predicates and makes many moves in one floating point environment.
\tparam Triangulation an instance of `Intrinsic_triangulation`
*/
template <class Triangulation>
class Move_session : public Predicate_session<Triangulation> {
  using Base = Predicate_session<Triangulation>;
  using Mesh = typename Triangulation::Mesh;
  using Graph_traits = boost::graph_traits<Mesh>;
  using Mover = internal::Mover<Triangulation>;

public:
  /// Vertex of the mesh.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// The result of an insertion.
  using Insertion = typename Triangulation::Insertion;

  /// opens a session on `t`, which must outlive it.
  explicit Move_session(Triangulation& t) : Base(t), t_(t) {}

  /// see `Intrinsic_triangulation::flip_edge()`
  Move_status flip_edge(halfedge_descriptor h) {
    const Move_status s = this->flip_status(h);
    return s == Move_status::done ? Mover(t_).flip_consistently(h) : s;
  }
  /// flips a flippable edge. \pre `flip_status(h)` is `done`
  Move_status flip_convex_edge(halfedge_descriptor h) { return Mover(t_).flip_consistently(h); }
  /// The old values of a flip, see `undo_flip()`.
  using Before_flip = internal::Before_flip<Triangulation>;
  /// returns what a flip of an edge with two faces will replace.
  Before_flip before_flip(halfedge_descriptor h)
      const requires internal::Remembers_flips<typename Triangulation::Metric> {
    return Mover(t_).before_flip(h);
  }
  /*!
  \brief takes back a flip, which cannot fail: restores connectivity, metric and correspondence.
  \param h the halfedge that was flipped
  \param before what `before_flip(h)` returned before that
  \pre all moves since have been taken back
  */
  void undo_flip(halfedge_descriptor h, Before_flip before) noexcept requires
      internal::Remembers_flips<typename Triangulation::Metric> {
    Mover(t_).undo_flip(h, std::move(before));
  }
  /// flips an edge that is not locally Delaunay and therefore flippable; if the metric stores
  /// nothing, rounding may have turned faces over: these are refused, so that algorithms end.
  /// \pre `!is_locally_delaunay(h)`
  BOOST_FORCEINLINE Move_status flip_non_delaunay_edge(halfedge_descriptor h) {
    if constexpr (internal::Stores_nothing<typename Triangulation::Metric>)
      if (!t_.metric().has_only_positive_areas() &&
          (this->orientation(h) != POSITIVE ||
           this->orientation(opposite(h, t_.mesh())) != POSITIVE))
        return Move_status::not_convex;
    return Mover(t_).flip(h, [this](const Diamond& d) { return t_.metric().compute_flip(d); });
  }
  /// see `Intrinsic_triangulation::insert_vertex()`
  Insertion insert_vertex(halfedge_descriptor h, const std::array<double, 3>& weights) requires
      RefinableMetric<typename Triangulation::Metric> {
    const std::optional<Place> p = place(h, weights);
    return p ? insert(*p) : Insertion{Move_status::weights};
  }
  /*!
  \brief inserts a vertex at a known place of the input, such as a copy of another place on a cover.
  \param h a halfedge of the face
  \param weights see `insert_vertex()`: approximations
  \param on_input the place, which defines the vertex: on an edge, if a weight is zero
  \return see `insert_vertex()`: `not_traceable` if the place is not in the face
  */
  Insertion insert_copy(halfedge_descriptor h, const std::array<double, 3>& weights,
                        const Surface_point& on_input) requires
      RefinableMetric<typename Triangulation::Metric> {
    const std::optional<Place> p = place(h, weights);
    return p ? insert(*p, on_input) : Insertion{Move_status::weights};
  }
  /// see `Intrinsic_triangulation::split_edge()`
  Insertion split_edge(halfedge_descriptor h,
                       double parameter) requires RefinableMetric<typename Triangulation::Metric> {
    if (face(h, t_.mesh()) == Graph_traits::null_face())
      return insert_vertex(opposite(h, t_.mesh()), {parameter, 1 - parameter, 0});
    return insert_vertex(h, {1 - parameter, parameter, 0});
  }
  /// see `Intrinsic_triangulation::remove_vertex()`
  Move_status
  remove_vertex(vertex_descriptor v) requires RefinableMetric<typename Triangulation::Metric> {
    if (!t_.is_inserted(v)) return Move_status::not_inserted;
    return internal::remove_vertex(t_, *this, v);
  }
  /// see `Intrinsic_triangulation::reposition_vertex()`
  Insertion reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                              const std::array<double, 3>& weights) requires
      RefinableMetric<typename Triangulation::Metric> {
    if (!t_.is_inserted(v)) return {Move_status::not_inserted};
    const std::optional<Place> p = place(h, weights);
    if (!p) return {Move_status::weights};
    if (move_in_star(v, *p)) return {Move_status::done, v};
    internal::Vertex_inserter<Triangulation> inserter(t_);
    const Insertion n = inserter.insert(p->h, p->weights, std::nullopt);
    if (n.status != Move_status::done) return n;
    const Move_status s = remove_vertex(v);
    if (s != Move_status::done) return {s};
    inserter.keep();
    return n;
  }
  /*!
  \brief flips the edge from a vertex with a straight angle, which leaves a face of zero area there.
  Call `remove_degree_three_vertex()` next.
  \pre the diamond is a triangle with the source of `h` on a side
  */
  Move_status flip_to_zero_area(halfedge_descriptor h) requires
      EuclideanMetric<typename Triangulation::Metric> {
    return Mover(t_).flip_to_zero_area(h);
  }
  /*!
  \brief removes an inserted vertex that has three edges.
  \param h the side opposite the vertex of one of its faces, which will be the remaining face
  \return `done`, or `not_removable` and nothing has changed
  */
  Move_status remove_degree_three_vertex(halfedge_descriptor h) requires
      RefinableMetric<typename Triangulation::Metric> {
    return Mover(t_).remove_from_face(h);
  }
  /*!
  \brief removes an inserted vertex of the border that has three edges.
  \param h the halfedge to the vertex along the border that has a face
  \return `done`, or `not_removable` and nothing has changed
  */
  Move_status remove_border_vertex(halfedge_descriptor h) requires
      RefinableMetric<typename Triangulation::Metric> {
    return Mover(t_).remove_from_border(h);
  }
  /*!
  \brief replaces the rounded length of an edge and areas of its faces.

  For inexact arithmetic: more accurate values, for instance from a layout of many faces at once,
  keep errors from growing.
  \param h the edge
  \param values its squared length and the quadruple areas of its left and right face, in scaled
  units
  */
  void correct_values(
      halfedge_descriptor h,
      typename Triangulation::Metric::Flipped values) requires(!Triangulation::Metric::is_exact) {
    t_.metric_.store_flip(t_.diamond(h), std::move(values));
  }

private:
  // where a vertex is inserted; on the edge of the halfedge if the last weight is zero
  struct Place {
    halfedge_descriptor h;
    std::array<double, 3> weights;
  };

  std::optional<Place> place(halfedge_descriptor h, const std::array<double, 3>& weights) const {
    const std::optional<std::array<double, 3>> w = representable_weights(weights);
    if (!w || face(h, t_.mesh()) == Graph_traits::null_face()) return std::nullopt;
    Place p{h, *w};
    while (p.weights[2] != 0 && (p.weights[0] == 0 || p.weights[1] == 0))
      p = {next(p.h, t_.mesh()), {p.weights[1], p.weights[2], p.weights[0]}};
    return p;
  }

  Insertion insert(const Place& p, const std::optional<Surface_point>& on_input = {}) {
    internal::Vertex_inserter<Triangulation> inserter(t_);
    const Insertion n = inserter.insert(p.h, p.weights, on_input);
    if (n.status == Move_status::done) inserter.keep();
    return n;
  }

  // Moves a vertex to a place in one of its faces from which all corners of its star are visible;
  // only the values of its edges and faces change. The correspondence must support it.
  bool move_in_star(vertex_descriptor v, Place p) {
    if constexpr (Mover::moves_in_star) {
      for (int k = 0; k < 3 && source(p.h, t_.mesh()) != v; ++k)
        p = {next(p.h, t_.mesh()), {p.weights[1], p.weights[2], p.weights[0]}};
      if (source(p.h, t_.mesh()) != v) return false;
      const std::optional<Whole_star> s = internal::whole_star(p.h, t_.mesh(), t_.numbers());
      return s && Mover(t_).move_in_star(*s, {t_.numbers().halfedge(p.h), p.weights, t_.index(v)});
    } else {
      return false;
    }
  }

  Triangulation& t_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_SESSION_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/remove_vertex.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief owns an intrinsic triangulation: connectivity, metric and correspondence, and the elementary
moves, which alone change them.

The triangulation is a Delta-complex: an edge may join a vertex to itself, a face may be glued to
itself, and edges must never be looked up by their end vertices. It numbers its vertices as it finds
fast (see `input_vertex()`); flips change neither the number nor the set of vertices, edges and faces.

Predicates and moves are members for single calls. Many of them in a row run faster in a `Session`.

\tparam Mesh_ a model of `MutableDeltaComplex`: `Gluing_map`, `CGAL::Surface_mesh`,
  `CGAL::Polyhedron_3` (with ids), OpenMesh meshes
\tparam Traits_ a model of `IntrinsicTriangulationTraits`: `Exact_euclidean_traits`,
  `Euclidean_traits<FT>`
\tparam Correspondence_ a model of `IntrinsicCorrespondence`
\cgalModels{IntrinsicTriangulation}
*/
template <MutableDeltaComplex Mesh_ = Gluing_map,
          IntrinsicTriangulationTraits Traits_ = Exact_euclidean_traits,
          class Correspondence_ = No_correspondence>
class Intrinsic_triangulation {
public:
  /// Connectivity.
  using Mesh = Mesh_;
  /// Arithmetic.
  using Traits = Traits_;
  /// Observer of the moves.
  using Correspondence = Correspondence_;
  /// Number type of stored values.
  using FT = typename Traits::FT;
  /// Stores the values and decides.
  using Metric = typename Traits::Metric;
  /// Vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  /// Edge of the mesh.
  using edge_descriptor = typename boost::graph_traits<Mesh>::edge_descriptor;
  /// Face of the mesh.
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

  /// What became of an insertion.
  struct Insertion {
    /// `done`, or why nothing was inserted.
    Move_status status;
    /// The new vertex.
    vertex_descriptor vertex = boost::graph_traits<Mesh>::null_vertex();
  };

  /*!
  \brief decides many predicates and makes many moves in one floating point environment.

  While a session lives, the rounding mode may differ from the default: code of others is to be
  called through `suspended()`.
  */
  class Session {
  public:
    /// opens a session on `t`, which must outlive it.
    explicit Session(Intrinsic_triangulation& t) : t_(t) {}
    /// see `Intrinsic_triangulation::is_locally_delaunay()`
    bool is_locally_delaunay(halfedge_descriptor h) const {
      const face_descriptor null = boost::graph_traits<Mesh>::null_face();
      const face_descriptor f = face(h, t_.mesh_), g = face(opposite(h, t_.mesh_), t_.mesh_);
      return f == null || g == null || f == g || t_.metric_.is_locally_delaunay(t_.diamond(h));
    }
    /// see `Intrinsic_triangulation::delaunay_sign()`
    Sign delaunay_sign(halfedge_descriptor h) const {
      return t_.metric_.sign(t_.diamond(h), Delaunay_expression());
    }
    /// see `Intrinsic_triangulation::flip_status()`
    Move_status flip_status(halfedge_descriptor h) const {
      const Move_status s = t_.combinatorial_flip_status(h);
      if (s != Move_status::done) return s;
      const Diamond d = t_.diamond(h);
      const bool convex = t_.metric_.sign(d, Convexity_at_source_expression()) == POSITIVE &&
                          t_.metric_.sign(d, Convexity_at_target_expression()) == POSITIVE;
      return convex ? Move_status::done : Move_status::not_convex;
    }
    /// see `Intrinsic_triangulation::flip_edge()`
    Move_status flip_edge(halfedge_descriptor h) {
      const Move_status s = flip_status(h);
      return s == Move_status::done ? t_.flip(h) : s;
    }
    /// flips an edge that is known not to be locally Delaunay, which implies that it can be
    /// flipped. \pre `!is_locally_delaunay(h)`
    Move_status flip_non_delaunay_edge(halfedge_descriptor h) { return t_.flip(h); }
    /// see `Intrinsic_triangulation::insert_vertex()`
    Insertion insert_vertex(halfedge_descriptor h, const std::array<double, 3>& weights) {
      const std::optional<Place> p = place(h, weights);
      return p ? t_.insert(p->h, p->weights) : Insertion{Move_status::weights};
    }
    /// see `Intrinsic_triangulation::split_edge()`
    Insertion split_edge(halfedge_descriptor h, double parameter) {
      if (face(h, t_.mesh_) == boost::graph_traits<Mesh>::null_face())
        return insert_vertex(opposite(h, t_.mesh_), {parameter, 1 - parameter, 0});
      return insert_vertex(h, {1 - parameter, parameter, 0});
    }
    /// see `Intrinsic_triangulation::remove_vertex()`
    Move_status remove_vertex(vertex_descriptor v) {
      if (!t_.is_inserted(v)) return Move_status::not_inserted;
      return internal::remove_vertex(t_, *this, v);
    }
    /// see `Intrinsic_triangulation::reposition_vertex()`
    Insertion reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                                const std::array<double, 3>& weights) {
      if (!t_.is_inserted(v)) return {Move_status::not_inserted};
      const std::optional<Place> p = place(h, weights);
      if (!p) return {Move_status::weights};
      const Insertion n = t_.insert(p->h, p->weights);
      if (n.status != Move_status::done) return n;
      const Move_status s = remove_vertex(v);
      if (s == Move_status::done) return n;
      t_.undo_insertion(p->h, p->weights);
      return {s};
    }
    /*!
    \brief flips the edge from a vertex with a straight angle, which leaves a face of zero area there;
    to be followed by `remove_degree_three_vertex()`.
    \pre the diamond is a triangle with the source of `h` on a side
    */
    Move_status flip_to_zero_area(halfedge_descriptor h) { return t_.flip(h, true); }
    /*!
    \brief removes an inserted vertex that has three edges.
    \param h the side opposite the vertex of one of its faces, which will be the remaining face
    \return `done`, or `not_removable` and nothing has changed
    */
    Move_status remove_degree_three_vertex(halfedge_descriptor h) { return t_.remove_from_face(h); }
    /*!
    \brief removes an inserted vertex of the border that has three edges.
    \param h the halfedge to the vertex along the border that has a face
    \return `done`, or `not_removable` and nothing has changed
    */
    Move_status remove_border_vertex(halfedge_descriptor h) { return t_.remove_from_border(h); }
    /*!
    \brief returns the cotangent weight of an edge: half the sum of the cotangents of the angles
    opposite it (Eq. 4 of the course), one of them on the border.

    With exact traits it is zero exactly where the opposite angles sum to pi, and never negative
    on a locally Delaunay edge. Dimensionless.
    \pre the faces at the edge have an area
    */
    double cotangent_weight(edge_descriptor e) const {
      const face_descriptor null = boost::graph_traits<Mesh>::null_face();
      halfedge_descriptor h = halfedge(e, t_.mesh_);
      if (face(h, t_.mesh_) == null) h = opposite(h, t_.mesh_);
      if (face(opposite(h, t_.mesh_), t_.mesh_) != null)
        return t_.metric_.cotangent_weight(t_.diamond(h));
      const halfedge_descriptor jk = next(h, t_.mesh_), ki = next(jk, t_.mesh_);
      return t_.metric_.cotangent_weight(t_.number_.halfedge(h) / 2, t_.number_.halfedge(jk) / 2,
                                         t_.number_.halfedge(ki) / 2,
                                         t_.number_.face(face(h, t_.mesh_)));
    }
    /// calls a function in the default floating point environment.
    template <class Function>
    auto suspended(Function f) const {
      const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
      return f();
    }

  private:
    // where a vertex is inserted; on the edge of the halfedge if the last weight is zero
    struct Place {
      halfedge_descriptor h;
      std::array<double, 3> weights;
    };

    std::optional<Place> place(halfedge_descriptor h, const std::array<double, 3>& weights) const {
      const std::optional<std::array<double, 3>> w = representable_weights(weights);
      if (!w || face(h, t_.mesh_) == boost::graph_traits<Mesh>::null_face()) return std::nullopt;
      Place p{h, *w};
      while (p.weights[2] != 0 && (p.weights[0] == 0 || p.weights[1] == 0))
        p = {next(p.h, t_.mesh_), {p.weights[1], p.weights[2], p.weights[0]}};
      return p;
    }

    Intrinsic_triangulation& t_;
    [[no_unique_address]] typename Metric::Scope scope_;
  };

  /*!
  \brief builds the triangulation of an input.

  Polygonal faces are triangulated, a bad numbering is improved, degenerate faces are treated as
  the input asks; `report()` says what was done. The connectivity is a copy: the input is not kept.
  \param input see `Intrinsic_input`: a mesh, a triangle soup, or a gluing with squared lengths
  \throws Invalid_input
  \complexity linear
  */
  explicit Intrinsic_triangulation(Intrinsic_input input)
      : Intrinsic_triangulation(internal::prepare<Metric>(std::move(input))) {}

  /*!
  \brief builds the triangulation of a mesh in space.
  \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
  \throws Invalid_input
  \complexity linear
  */
  template <class FaceGraph>
    requires(!std::is_same_v<FaceGraph, Intrinsic_input> &&
             !std::is_same_v<FaceGraph, Intrinsic_triangulation>)
  explicit Intrinsic_triangulation(const FaceGraph& mesh,
                                   Mollification mollification = Mollification::automatic)
      : Intrinsic_triangulation(Intrinsic_input(mesh, mollification)) {}

  /*!
  \brief restores a triangulation from its parts, as they were written to a file.
  \param map the connectivity, with the numbers that the other parts use
  \param metric values for its edges and faces
  \param renumbering the way back to the numbers of the input
  \param report what was done to the input
  \param input_vertices how many vertices are those of the input, which come first; the others were
  inserted
  \pre there is no correspondence, or no vertex was inserted
  */
  Intrinsic_triangulation(Gluing_map map, Metric metric, Renumbering renumbering,
                          const Input_report& report, std::uint32_t input_vertices)
      : mesh_(mesh_from_gluing_map<Mesh>(std::move(map))), number_(mesh_),
        metric_(std::move(metric)), renumbering_(std::move(renumbering)), report_(report),
        input_vertices_(input_vertices) {
    correspondence_.start(*this);
  }

  /// restores a triangulation in which no vertex was inserted, see above.
  Intrinsic_triangulation(Gluing_map map, Metric metric, Renumbering renumbering,
                          const Input_report& report)
      : Intrinsic_triangulation(std::move(map), std::move(metric), std::move(renumbering), report,
                                0) {
    input_vertices_ = static_cast<std::uint32_t>(num_vertices(mesh_));
  }

  /// copies everything; elements keep their numbers.
  Intrinsic_triangulation(const Intrinsic_triangulation& other)
      : mesh_(other.mesh_), number_(mesh_, other.number_, other.mesh_), metric_(other.metric_),
        correspondence_(other.correspondence_), renumbering_(other.renumbering_),
        report_(other.report_), input_vertices_(other.input_vertices_) {}
  /// moves everything; elements keep their numbers.
  Intrinsic_triangulation(Intrinsic_triangulation&& other)
      : mesh_(std::move(other.mesh_)), number_(mesh_, other.number_, other.mesh_),
        metric_(std::move(other.metric_)), correspondence_(std::move(other.correspondence_)),
        renumbering_(std::move(other.renumbering_)), report_(other.report_),
        input_vertices_(other.input_vertices_) {}
  /// assigns everything; elements keep their numbers.
  Intrinsic_triangulation& operator=(Intrinsic_triangulation other) {
    mesh_ = std::move(other.mesh_);
    number_ =
        Mesh_adaptor<Mesh>(mesh_, other.number_, other.mesh_); // as descriptors may be pointers
    metric_ = std::move(other.metric_);
    correspondence_ = std::move(other.correspondence_);
    renumbering_ = std::move(other.renumbering_);
    report_ = other.report_;
    input_vertices_ = other.input_vertices_;
    return *this;
  }

  /// returns the connectivity.
  const Mesh& mesh() const { return mesh_; }
  /// returns the metric.
  const Metric& metric() const { return metric_; }
  /// returns the metric, whose predicates may sharpen stored values.
  Metric& metric() { return metric_; }
  /// returns the correspondence.
  const Correspondence& correspondence() const { return correspondence_; }
  /// returns the numbers of the elements of the mesh, and the elements with given numbers.
  const Mesh_adaptor<Mesh>& numbers() const { return number_; }
  /// returns what was done to the input.
  const Input_report& report() const { return report_; }

  /// returns the number that vertex `v` has in the input, in the order of iteration there; of an
  /// inserted vertex, one that follows those. It is the row of `v` in all matrices of operators.
  std::uint32_t input_vertex(vertex_descriptor v) const {
    const std::uint32_t i = number_.vertex(v);
    return i < renumbering_.input_vertex.size() ? renumbering_.input_vertex[i] : i;
  }
  /// returns how the numbering of vertices and faces before the first move differs from the input's.
  const Renumbering& renumbering() const { return renumbering_; }

  /// returns the number of a vertex: from 0, unchanged by moves.
  std::uint32_t index(vertex_descriptor v) const { return number_.vertex(v); }
  /// tells whether a vertex was inserted: it is not one of the input.
  bool is_inserted(vertex_descriptor v) const { return index(v) >= input_vertices_; }
  /// returns the number of vertices of the input, which come before inserted ones.
  std::uint32_t number_of_input_vertices() const { return input_vertices_; }
  /// returns the number of an edge: from 0, dense, unchanged by flips.
  std::uint32_t index(edge_descriptor e) const { return number_.halfedge(halfedge(e, mesh_)) / 2; }
  /// returns the number of a face: from 0, dense, unchanged by flips.
  std::uint32_t index(face_descriptor f) const { return number_.face(f); }

  /// returns the squared length of an edge as a double, in the units of the input.
  double squared_length(edge_descriptor e) const {
    return std::ldexp(metric_.approximate_squared_length(index(e)), -2 * metric_.scale_exponent());
  }
  /// returns the area of a face as a double, in the units of the input.
  double area(face_descriptor f) const {
    return std::ldexp(metric_.approximate_quadruple_area(index(f)),
                      -2 * metric_.scale_exponent() - 2);
  }

  /*!
  \brief indexes the faces at an edge and their sides.
  \pre both sides of the edge have a face
  */
  Diamond diamond(halfedge_descriptor h) const {
    const halfedge_descriptor o = opposite(h, mesh_);
    const halfedge_descriptor jk = next(h, mesh_), im = next(o, mesh_);
    return {number_.halfedge(h) / 2,
            number_.halfedge(jk) / 2,
            number_.halfedge(next(jk, mesh_)) / 2,
            number_.halfedge(im) / 2,
            number_.halfedge(next(im, mesh_)) / 2,
            number_.face(face(h, mesh_)),
            number_.face(face(o, mesh_))};
  }

  /*!
  \brief tells whether the angles opposite an edge sum to at most pi.

  True on the border and where both sides of the edge are in one face (§4.2 of the course).
  */
  bool is_locally_delaunay(halfedge_descriptor h) { return Session(*this).is_locally_delaunay(h); }

  /*!
  \brief returns the sign of pi minus the angles opposite an edge; zero: the diamond is cocircular.
  \pre both sides of the edge have a face
  */
  Sign delaunay_sign(halfedge_descriptor h) { return Session(*this).delaunay_sign(h); }

  /// tells whether an edge can be flipped, and if not, why: `done` means that it can.
  Move_status flip_status(halfedge_descriptor h) { return Session(*this).flip_status(h); }

  /*!
  \brief flips an edge: `h` turns clockwise, as by `CGAL::Euler::flip_edge()`.
  \return `done`, or why the edge cannot be flipped; nothing has changed then
  */
  Move_status flip_edge(halfedge_descriptor h) { return Session(*this).flip_edge(h); }

  /*!
  \brief inserts a vertex in a face, or on an edge if one weight is zero.

  The weights are rounded to multiples of 2^-52, see `representable_weights()`, which then define the
  point exactly. A vertex on an edge splits the edge; one on an edge that runs along an input edge
  splits that too.
  \param h a halfedge of the face
  \param weights barycentric coordinates: of the source of `h`, its target, the third corner
  \return the new vertex, or why there is none; nothing has changed then
  \complexity constant, and that of the correspondence
  */
  Insertion insert_vertex(halfedge_descriptor h, const std::array<double, 3>& weights) {
    return Session(*this).insert_vertex(h, weights);
  }

  /*!
  \brief inserts a vertex on an edge.
  \param h a halfedge of the edge
  \param parameter 0 at the source of `h`, 1 at its target
  \return see `insert_vertex()`
  */
  Insertion split_edge(halfedge_descriptor h, double parameter) {
    return Session(*this).split_edge(h, parameter);
  }

  /*!
  \brief removes a vertex that was inserted: edges are flipped away from it first.
  \return `done`, or why it cannot be removed; nothing has changed then but the direction of halfedges
  */
  Move_status remove_vertex(vertex_descriptor v) { return Session(*this).remove_vertex(v); }

  /*!
  \brief moves a vertex that was inserted: inserts one at its new place and removes the old one.
  \param v the vertex
  \param h a halfedge of the face of the new place
  \param weights see `insert_vertex()`
  \return the new vertex, or why nothing has changed
  */
  Insertion reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                              const std::array<double, 3>& weights) {
    return Session(*this).reposition_vertex(v, h, weights);
  }

private:
  explicit Intrinsic_triangulation(internal::Prepared_input<Metric>&& p)
      : mesh_(mesh_from_gluing_map<Mesh>(std::move(p.mesh))), number_(mesh_),
        metric_(std::move(p.metric)), renumbering_(std::move(p.renumbering)), report_(p.report) {
    input_vertices_ = static_cast<std::uint32_t>(num_vertices(mesh_));
    correspondence_.start(*this);
  }

  Move_status combinatorial_flip_status(halfedge_descriptor h) const {
    const face_descriptor null = boost::graph_traits<Mesh>::null_face();
    const face_descriptor f = face(h, mesh_), g = face(opposite(h, mesh_), mesh_);
    if (f == null || g == null) return Move_status::border;
    return f == g ? Move_status::same_face : Move_status::done;
  }

  // the one order of every move: compute, notify, change connectivity and metric, notify
  Move_status flip(halfedge_descriptor h, bool to_zero_area = false) {
    const Diamond d = diamond(h);
    const std::uint32_t number = number_.halfedge(h);
    const auto values =
        to_zero_area ? metric_.compute_flip_to_zero_area(d) : metric_.compute_flip(d);
    if (!values) return Move_status::arithmetic;
    if (!correspondence_.before_flip(*this, number)) return Move_status::crossings;
    CGAL::Euler::flip_edge(h, mesh_);
    metric_.store_flip(d, *values);
    correspondence_.after_flip(*this, number);
    return Move_status::done;
  }

  Insertion insert_in_face(halfedge_descriptor h, const std::array<double, 3>& weights) {
    const std::uint32_t number = number_.halfedge(h);
    if (!correspondence_.before_insert_in_face(*this, number, weights))
      return {Move_status::not_traceable};
    const vertex_descriptor v = split_face(h, mesh_, number_);
    if (!metric_.insert_in_face(star(h), weights)) {
      remove_degree_3_vertex(h, mesh_, number_);
      return {Move_status::arithmetic};
    }
    correspondence_.after_insert_in_face(*this, number);
    return {Move_status::done, v};
  }

  bool is_on_border(halfedge_descriptor h) const {
    return face(opposite(h, mesh_), mesh_) == boost::graph_traits<Mesh>::null_face();
  }

  Insertion insert(halfedge_descriptor h, const std::array<double, 3>& weights) {
    return weights[2] == 0 ? insert_on_edge(h, weights) : insert_in_face(h, weights);
  }

  // takes back what `insert()` did last
  void undo_insertion(halfedge_descriptor h, const std::array<double, 3>& weights) {
    if (weights[2] == 0 && is_on_border(h)) {
      remove_from_border(h);
      return;
    }
    if (weights[2] == 0) // four flips are the identity; the vertex is a source, then a target
      if (flip(h, true) != Move_status::done || flip(h) != Move_status::done ||
          flip(opposite(h, mesh_), true) != Move_status::done)
        return;
    remove_from_face(h);
  }

  // inside: a vertex in the face, at distance zero from the edge, which is flipped away
  Insertion insert_on_edge(halfedge_descriptor h, const std::array<double, 3>& weights) {
    if (is_on_border(h)) return insert_on_border(h, weights[1]);
    const Insertion n = insert_in_face(h, weights);
    if (n.status != Move_status::done) return n;
    const Move_status s = flip(h);
    if (s == Move_status::done) return n;
    remove_from_face(h);
    return {s};
  }

  Insertion insert_on_border(halfedge_descriptor h, double parameter) {
    const std::uint32_t number = number_.halfedge(h);
    if (!correspondence_.before_insert_in_border_edge(*this, number, parameter))
      return {Move_status::not_traceable};
    const vertex_descriptor v = split_border_edge(h, mesh_, number_);
    if (!metric_.insert_in_border_edge(border_star(h), parameter)) {
      CGAL::Intrinsic_triangulations::remove_border_vertex(h, mesh_, number_);
      return {Move_status::arithmetic};
    }
    correspondence_.after_insert_in_border_edge(*this, number);
    return {Move_status::done, v};
  }

  Move_status remove_from_face(halfedge_descriptor h) {
    const std::uint32_t number = number_.halfedge(h);
    if (!correspondence_.before_remove(*this, number)) return Move_status::not_removable;
    metric_.remove_from_face(star(h));
    remove_degree_3_vertex(h, mesh_, number_);
    correspondence_.after_remove(*this, number);
    return Move_status::done;
  }

  Move_status remove_from_border(halfedge_descriptor h) {
    const std::uint32_t number = number_.halfedge(h);
    if (!correspondence_.before_remove_from_border(*this, number))
      return Move_status::not_removable;
    metric_.remove_from_border_edge(border_star(h));
    CGAL::Intrinsic_triangulations::remove_border_vertex(h, mesh_, number_);
    correspondence_.after_remove_from_border(*this, number);
    return Move_status::done;
  }

  std::uint32_t edge_number(halfedge_descriptor h) const { return number_.halfedge(h) / 2; }
  std::uint32_t face_number(halfedge_descriptor h) const { return number_.face(face(h, mesh_)); }

  // of the vertex opposite h
  Vertex_star star(halfedge_descriptor h) const {
    const halfedge_descriptor jp = next(h, mesh_), pi = next(jp, mesh_);
    const halfedge_descriptor jk = next(opposite(jp, mesh_), mesh_), kp = next(jk, mesh_);
    const halfedge_descriptor ki = next(opposite(kp, mesh_), mesh_);
    return {{edge_number(h), edge_number(jk), edge_number(ki)},
            {edge_number(pi), edge_number(jp), edge_number(kp)},
            {face_number(h), face_number(jk), face_number(ki)}};
  }

  // of the target of h
  Border_star border_star(halfedge_descriptor h) const {
    const halfedge_descriptor pk = next(h, mesh_), ki = next(pk, mesh_);
    const halfedge_descriptor pj = next(opposite(pk, mesh_), mesh_), jk = next(pj, mesh_);
    return {edge_number(h),  edge_number(pj), edge_number(jk), edge_number(ki),
            edge_number(pk), face_number(h),  face_number(pj)};
  }

  Mesh mesh_;
  Mesh_adaptor<Mesh> number_;
  Metric metric_;
  [[no_unique_address]] Correspondence correspondence_;
  Renumbering renumbering_;
  Input_report report_;
  std::uint32_t input_vertices_ = 0; // their numbers come before those of inserted vertices
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATION_H

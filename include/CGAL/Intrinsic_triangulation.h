// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/deciding/Decider.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Session.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <array>
#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
template <class Triangulation>
class Intrinsic_triangulation_writer;
} // namespace internal

/*!
\brief owns an intrinsic triangulation: connectivity, metric and correspondence. Only its elementary
moves change them.

The triangulation is a Delta-complex: an edge may join a vertex to itself, a face may be glued to
itself, and end vertices do not identify an edge. Vertices are numbered for speed (see
`input_vertex()`); flips keep all vertices, edges and faces, with their numbers.

Members make single predicate calls and moves. Many calls in a row run faster in a `Session`.

\tparam Mesh_ a model of `MutableDeltaComplex`: `Gluing_map`, `CGAL::Surface_mesh`,
  `CGAL::Polyhedron_3` (with ids), OpenMesh meshes
\tparam Traits_ a model of `IntrinsicTriangulationTraits`: `Exact_euclidean_traits`,
  `Euclidean_traits<FT>`
\tparam Correspondence_ a model of `IntrinsicCorrespondence`
\cgalModels{RefinableTriangulation}
*/
template <internal::Owned_mesh Mesh_ = Gluing_map,
          internal::Deciding_traits Traits_ = Exact_euclidean_traits,
          std::default_initializable Correspondence_ = No_correspondence>
class Intrinsic_triangulation
    : public Metric_values<Intrinsic_triangulation<Mesh_, Traits_, Correspondence_>, Mesh_,
                           typename Traits_::Metric> {
public:
  using Mesh = Mesh_;                     ///< Connectivity.
  using Traits = Traits_;                 ///< Arithmetic.
  using Correspondence = Correspondence_; ///< Observer of the moves.
  /// Whether there is a correspondence.
  static constexpr bool has_correspondence = !std::is_same_v<Correspondence, No_correspondence>;
  /// The part of the input that it keeps.
  using Kept_input = std::conditional_t<has_correspondence, Input, Input_definition>;
  using FT = typename Traits::FT;         ///< Number type of stored values.
  using Metric = typename Traits::Metric; ///< Stores values; decides, or tells what is certain.
  /// Vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  /// Edge of the mesh.
  using edge_descriptor = typename boost::graph_traits<Mesh>::edge_descriptor;
  /// Face of the mesh.
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

  using Metric_values<Intrinsic_triangulation, Mesh, Metric>::is_locally_delaunay;
  using Metric_values<Intrinsic_triangulation, Mesh, Metric>::delaunay_sign;

  using Const_session = Predicate_session<Intrinsic_triangulation>; ///< decides many predicates
  using Session = Move_session<Intrinsic_triangulation>;            ///< makes many moves, too
  /// Result of an insertion: a `Move_status` and the new vertex.
  struct Insertion {
    Move_status status; ///< `done`, or why nothing was inserted.
    vertex_descriptor vertex = boost::graph_traits<Mesh>::null_vertex(); ///< The new vertex.
  };

  /*!
  \brief builds the triangulation of an input.

  It triangulates polygonal faces, improves a bad numbering, and treats degenerate faces by the
  options of the input; `report()` says what was done.
  \param input see `Intrinsic_input`: a mesh, a triangle soup, or a gluing with squared lengths
  \throws Invalid_input
  \complexity linear
  */
  explicit Intrinsic_triangulation(Intrinsic_input input)
      : Intrinsic_triangulation(internal::prepare<Metric, Kept_input>(std::move(input))) {}

  /*!
  \brief builds the triangulation of a mesh in space.
  \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
  \throws Invalid_input
  \complexity linear
  */
  template <class FaceGraph>
    requires internal::Surface_in_space<FaceGraph>
  explicit Intrinsic_triangulation(const FaceGraph& mesh,
                                   Mollification mollification = Mollification::automatic)
      : Intrinsic_triangulation(Intrinsic_input(mesh, mollification)) {}
  CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_INPUT(Intrinsic_triangulation)

  /// restores a triangulation from its parts, as they were written to a file.
  /// \param map the connectivity, with the numbers that the other parts use
  /// \param metric values for its edges and faces
  /// \param input what it was built from; all other vertices are inserted ones
  /// \pre there is no correspondence, or `map` is the connectivity of `input`
  Intrinsic_triangulation(Gluing_map map, Metric metric, std::shared_ptr<const Kept_input> input);

  /// restores a triangulation, possibly with inserted vertices, from its parts.
  /// \param map, metric, input see the other constructor
  /// \param coordinates how `map` lies on `input`, from which the correspondence is restored
  Intrinsic_triangulation(Gluing_map map, Metric metric, std::shared_ptr<const Input> input,
                          const Integer_coordinates& coordinates) requires
      RestorableCorrespondence<Correspondence_, Intrinsic_triangulation>
      : input_(std::move(input)),
        numbered_(mesh_from_gluing_map<Mesh>(std::move(map))),
        metric_(std::move(metric)) {
    with_observers([&](auto&... observers) { (observers.restore(*this, coordinates), ...); });
  }

  /// takes input, connectivity and the numbers of its elements from another triangulation.
  /// \param t, metric, coordinates see the other constructors
  template <class Triangulation>
  Intrinsic_triangulation(const Triangulation& t, Metric metric,
                          const Integer_coordinates& coordinates) requires
      RestorableCorrespondence<Correspondence_, Intrinsic_triangulation>
      : input_(t.shared_input()), numbered_(t.mesh(), t.numbers()), metric_(std::move(metric)) {
    with_observers([&](auto&... observers) { (observers.restore(*this, coordinates), ...); });
  }

  /// copies everything but the input, which is shared; elements keep their numbers.
  Intrinsic_triangulation(const Intrinsic_triangulation&) = default;
  /// moves everything; elements keep their numbers.
  Intrinsic_triangulation(Intrinsic_triangulation&&) = default;
  /// assigns everything; elements keep their numbers.
  Intrinsic_triangulation& operator=(const Intrinsic_triangulation& other) {
    return *this = Intrinsic_triangulation(other);
  }
  /// assigns everything; elements keep their numbers.
  Intrinsic_triangulation& operator=(Intrinsic_triangulation&&) = default;

  /// returns the connectivity.
  const Mesh& mesh() const { return numbered_.mesh; }
  /// returns the metric.
  const Metric& metric() const { return metric_; }
  /// returns the correspondence.
  const Correspondence& correspondence() const { return correspondence_; }
  /// returns the numbers of the elements of the mesh, and the elements with given numbers.
  const Mesh_adaptor<Mesh>& numbers() const { return numbered_.numbers; }
  /// returns the surface that the triangulation was built from; without correspondence, only its
  /// definition.
  const Kept_input& input() const { return *input_; }
  /// returns the same, to be shared.
  const std::shared_ptr<const Kept_input>& shared_input() const { return input_; }
  /// returns what was done to the input.
  const Input_report& report() const { return input_->report(); }

  /// returns the number of vertex `v` in the iteration order of the input; inserted vertices follow
  /// without gaps, so that removing one renumbers those after it. This number is the row of `v` in
  /// all matrices of operators. On a cover, copies of one vertex share its row; copies of inserted
  /// vertices only if `places()` stores their places.
  std::uint32_t input_vertex(vertex_descriptor v) const {
    return is_inserted(v) ? rows_.row(index(v), *this) : input_->names().row(index(v));
  }
  /// returns the number of rows of matrices, one per vertex.
  std::uint32_t number_of_vertices() const { return rows_.number_of_rows(*this); }

  /// returns coordinates that store the places of inserted vertices on `input()`, or null.
  const Integer_coordinates* places() const { return places_.on_input(*this); }

  /// returns the number of a vertex: from 0, unchanged by moves.
  std::uint32_t index(vertex_descriptor v) const { return numbers().vertex(v); }
  /// tells whether a vertex was inserted: it is not one of the input.
  bool is_inserted(vertex_descriptor v) const { return index(v) >= input_->number_of_vertices(); }
  /// returns the number of an edge: from 0, dense, unchanged by flips.
  std::uint32_t index(edge_descriptor e) const {
    return numbers().halfedge(halfedge(e, mesh())) / 2;
  }
  /// returns the number of a face: from 0, dense, unchanged by flips.
  std::uint32_t index(face_descriptor f) const { return numbers().face(f); }

  /*!
  \brief indexes the faces at an edge and their sides.
  \pre both sides of the edge have a face
  */
  Diamond diamond(halfedge_descriptor h) const {
    return internal::diamond_of(h, mesh(), numbers());
  }

  /// returns what decides predicates: the metric, or an object that asks it first and decides the
  /// rest from the input, see `Exact_ladder`. Bind it to `const auto&`: it refers to the
  /// triangulation. \pre a session is live
  decltype(auto) decider() const {
    if constexpr (internal::Answers_if_certain<Metric>)
      return internal::Decider<Intrinsic_triangulation, Places>(*this, places_, exact_memory_);
    else
      return metric();
  }

  /*!
  \brief tells whether the angles opposite an edge sum to at most pi.

  True on the border and where both sides of the edge are in one face (§4.2 of the course).
  */
  bool is_locally_delaunay(halfedge_descriptor h) const {
    return Const_session(*this).is_locally_delaunay(h);
  }

  /*!
  \brief returns the sign of pi minus the angles opposite an edge; zero: the diamond is cocircular.
  \pre both sides of the edge have a face
  */
  Sign delaunay_sign(halfedge_descriptor h) const { return Const_session(*this).delaunay_sign(h); }

  /// tells whether an edge can be flipped, and if not, why: `done` means that it can.
  Move_status flip_status(halfedge_descriptor h) const {
    return Const_session(*this).flip_status(h);
  }

  /*!
  \brief flips an edge: `h` turns clockwise, as by `CGAL::Euler::flip_edge()`.
  \return `done`, or why the edge cannot be flipped; nothing has changed then
  */
  Move_status flip_edge(halfedge_descriptor h) { return Session(*this).flip_edge(h); }

  /// sets the factors by which vertices scale the metric, at first one: moves horocycles.
  /// \param factors, rests per row, see `input_vertex()`, a positive number, and what rounding took
  /// from it or nothing; their sums define the metric exactly \complexity linear
  /// \throws Invalid_input if their number is another one, or naming a vertex with a wrong factor
  void
  scale_vertices(std::span<const double> factors,
                 std::span<const double> rests = {}) requires internal::Scales_vertices<Metric> {
    internal::Mover<Intrinsic_triangulation>(*this).scale_vertices(factors, rests);
  }

  /*!
  \brief inserts a vertex in a face, or on an edge if one weight is zero.

  With exact traits, the point is rounded to barycentric coordinates in an input face that are
  multiples of 2^-52; these define it exactly. Otherwise the weights are rounded, see
  `representable_weights()`. A vertex on an edge splits the edge; one on an edge that runs along an
  input edge splits that too.
  \param h a halfedge of the face
  \param weights barycentric coordinates: of the source of `h`, its target, the third corner
  \return the new vertex, or why there is none; nothing has changed then
  \complexity constant, and that of the correspondence
  */
  Insertion insert_vertex(halfedge_descriptor h,
                          const std::array<double, 3>& weights) requires RefinableMetric<Metric> {
    return Session(*this).insert_vertex(h, weights);
  }

  /*!
  \brief inserts a vertex on an edge.
  \param h a halfedge of the edge
  \param parameter 0 at the source of `h`, 1 at its target
  \return see `insert_vertex()`
  */
  Insertion split_edge(halfedge_descriptor h, double parameter) requires RefinableMetric<Metric> {
    return Session(*this).split_edge(h, parameter);
  }

  /*!
  \brief removes a vertex that was inserted: edges are flipped away from it first.
  \return `done`, or why it cannot be removed; nothing has changed then
  */
  Move_status remove_vertex(vertex_descriptor v) requires RefinableMetric<Metric> {
    return Session(*this).remove_vertex(v);
  }

  /*!
  \brief moves a vertex that was inserted: inserts one at its new place and removes the old one; or
  changes lengths only (Eq. 8), if it stays in its star, the metric is a `Euclidean_metric`, and
  there is no correspondence.
  \param v the vertex
  \param h a halfedge of the face of the new place
  \param weights see `insert_vertex()`
  \return the new vertex, which may be the old one, or why nothing has changed
  */
  Insertion
  reposition_vertex(vertex_descriptor v, halfedge_descriptor h,
                    const std::array<double, 3>& weights) requires RefinableMetric<Metric> {
    return Session(*this).reposition_vertex(v, h, weights);
  }

private:
  /// \cond
  friend class internal::Mover<Intrinsic_triangulation>;
  friend class internal::Intrinsic_triangulation_writer<Intrinsic_triangulation>;
  friend Session;
  /// \endcond

  using Places = internal::Places_of<Intrinsic_triangulation, Metric>;

  // Calls a function with all observers, in the order in which they are asked about moves and told.
  template <class Function>
  auto with_observers(const Function& f) {
    return f(places_, exact_memory_, rows_, correspondence_);
  }

  explicit Intrinsic_triangulation(internal::Prepared_input<Metric, Kept_input>&& p)
      : Intrinsic_triangulation(std::move(p.mesh), std::move(p.metric), std::move(p.input)) {}

  std::shared_ptr<const Kept_input> input_;
  internal::Mesh_with_numbers<Mesh> numbered_;
  Metric metric_;
  [[no_unique_address]] Correspondence correspondence_;
  [[no_unique_address]] Places places_;
  [[no_unique_address]] mutable internal::Memory_of<Metric> exact_memory_; // a cache
  internal::Vertex_rows<Integer_coordinates> rows_;
};

template <internal::Owned_mesh M, internal::Deciding_traits T, std::default_initializable C>
Intrinsic_triangulation<M, T, C>::Intrinsic_triangulation(Gluing_map map, Metric metric,
                                                          std::shared_ptr<const Kept_input> input)
    : input_(std::move(input)), numbered_(mesh_from_gluing_map<Mesh>(std::move(map))),
      metric_(std::move(metric)) {
  internal::expect_correspondence<Correspondence, Intrinsic_triangulation>();
  with_observers([&](auto&... observers) { (observers.start(*this), ...); });
}

} // namespace CGAL::Intrinsic_triangulations

#ifdef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/compiled.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATION_H

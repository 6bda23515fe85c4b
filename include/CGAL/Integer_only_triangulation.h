// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTEGER_ONLY_TRIANGULATION_H
#define CGAL_INTEGER_ONLY_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_geometry.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is an intrinsic triangulation without a metric of its own: connectivity, integer coordinates
and the input, from which each predicate rebuilds what it needs (ch. 7 of the course: "truly
integer-only").

Integers alone find the input triangles over which the diamond of an edge lies (see
`Diamond_unfolder`), and intervals unfold them. If the sign stays open, the same triangles decide
exactly (see `Exact_ladder`). Lengths and flips are not stored, so that errors do not add up.

With exact traits, predicates read values that earlier moves computed; here they read only integers.
Hence this class checks a triangulation independently of the arithmetic that made it: see
`certify_delaunay()`.

The only move is a flip, but the given integer coordinates may have inserted vertices. These lie
where `Integer_coordinates::location()` says. With exact traits that place defines them; other
arithmetic agrees with it up to rounding, and areas of that size may be negative.

A flip is refused (`Move_status::crossings`) if the new edge has more than
`Diamond_unfolder::maximal_crossings`; `flip_to_delaunay()` counts it as refused.

\tparam Mesh_ a model of `MutableDeltaComplex`
\cgalModels{IntrinsicTriangulation}
*/
template <MutableDeltaComplex Mesh_ = Gluing_map>
class Integer_only_triangulation {
public:
  /// Connectivity.
  using Mesh = Mesh_;
  /// Observer of the moves; stores all geometry.
  using Correspondence = Integer_coordinates;
  /// Number type of the filter.
  using FT = Interval_nt<false>;
  /// Tells algorithms that predicates are exact.
  struct Metric {
    /// Algorithms end without a cap.
    static constexpr bool is_exact = true;
  };
  /// Vertex of the mesh.
  using vertex_descriptor = typename boost::graph_traits<Mesh>::vertex_descriptor;
  /// Halfedge of the mesh.
  using halfedge_descriptor = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  /// Edge of the mesh.
  using edge_descriptor = typename boost::graph_traits<Mesh>::edge_descriptor;
  /// Face of the mesh.
  using face_descriptor = typename boost::graph_traits<Mesh>::face_descriptor;

  /// decides many predicates in one floating point environment; see `Predicate_session`.
  class Const_session {
  public:
    /// opens a session on `t`, which must outlive it.
    explicit Const_session(const Integer_only_triangulation& t) : t_(t) {}
    /// tells whether the angles opposite an edge sum to at most pi.
    bool is_locally_delaunay(halfedge_descriptor h) const {
      const face_descriptor null = boost::graph_traits<Mesh>::null_face();
      const face_descriptor f = face(h, t_.mesh_), g = face(opposite(h, t_.mesh_), t_.mesh_);
      if (f == null || g == null || f == g) return true;
      return t_.geometry().is_locally_delaunay(t_.diamond(h));
    }
    /// returns the sign of pi minus the angles opposite an edge.
    /// \pre the edge has two faces
    Sign delaunay_sign(halfedge_descriptor h) const {
      return t_.geometry().sign(t_.diamond(h), Delaunay_expression());
    }
    /// returns the sign of the area of the face of a halfedge: positive in a triangulation.
    Sign orientation(halfedge_descriptor h) const {
      return t_.geometry().orientation(t_.indexed_face(h));
    }
    /// tells whether an edge runs straight over the input, as the edges of a triangulation do; see
    /// `Integer_geometry::is_straight()`.
    bool is_straight(halfedge_descriptor h) const {
      if (face(h, t_.mesh_) == boost::graph_traits<Mesh>::null_face()) h = opposite(h, t_.mesh_);
      if (t_.correspondence_.normal_coordinate(t_.number_.halfedge(h) / 2) <= 0)
        return true; // in one face, or along its side
      return t_.geometry().is_straight(t_.indexed_face(h));
    }
    /// compares an angle with pi as `Predicate_session` does. \pre no border is in between
    Comparison_result compare_angle_to_pi(halfedge_descriptor h, halfedge_descriptor g) const {
      return t_.compare_angle_to_pi(h, g);
    }
    /// tells whether an edge can be flipped, and if not, why.
    Move_status flip_status(halfedge_descriptor h) const {
      const face_descriptor null = boost::graph_traits<Mesh>::null_face();
      const face_descriptor f = face(h, t_.mesh_), g = face(opposite(h, t_.mesh_), t_.mesh_);
      if (f == null || g == null) return Move_status::border;
      if (f == g) return Move_status::same_face;
      const Diamond d = t_.diamond(h);
      Geometry geometry = t_.geometry();
      const bool convex = geometry.sign(d, Convexity_at_source_expression()) == POSITIVE &&
                          geometry.sign(d, Convexity_at_target_expression()) == POSITIVE;
      return convex ? Move_status::done : Move_status::not_convex;
    }
    /// returns intervals of the values of the diamond of an edge with two faces, in scaled units.
    Diamond_values<FT> diamond_values(halfedge_descriptor h) const {
      return t_.geometry().values(t_.diamond(h));
    }
    /// calls a function in the default floating point environment.
    template <class Function>
    auto suspended(Function f) const {
      const Protect_FPU_rounding<true> nearest(CGAL_FE_TONEAREST);
      return f();
    }

  private:
    const Integer_only_triangulation& t_;
    Protect_FPU_rounding<true> scope_;
  };

  /// makes many calls in one floating point environment; see `Move_session`.
  class Session : public Const_session {
  public:
    /// opens a session on `t`, which must outlive it.
    explicit Session(Integer_only_triangulation& t) : Const_session(t), t_(t) {}
    /// flips an edge.
    /// \return `done`, or why the edge cannot be flipped; nothing has changed then
    Move_status flip_edge(halfedge_descriptor h) {
      const Move_status s = this->flip_status(h);
      return s == Move_status::done ? t_.flip(h) : s;
    }
    /*!
    \brief flips an edge that is not locally Delaunay.

    Its diamond is convex if both faces have positive areas, as in a triangulation. Another
    arithmetic may have turned faces over: then the edge is refused, so that flipping ends.
    \pre `!is_locally_delaunay(h)`
    */
    Move_status flip_non_delaunay_edge(halfedge_descriptor h) {
      if (!t_.has_only_positive_areas_ && (this->orientation(h) != POSITIVE ||
                                           this->orientation(opposite(h, t_.mesh_)) != POSITIVE))
        return Move_status::not_convex;
      return t_.flip(h);
    }

  private:
    Integer_only_triangulation& t_;
  };

  /*!
  \brief builds the triangulation of an input.
  \param input see `Intrinsic_input`
  \throws Invalid_input also if an edge has no length: mollify then
  \complexity linear
  */
  explicit Integer_only_triangulation(Intrinsic_input input)
      : Integer_only_triangulation(
            internal::prepare<Exact_euclidean_metric, Input>(std::move(input))) {}

  /// builds the triangulation of a mesh in space; see above.
  /// \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
  template <internal::Surface_in_space FaceGraph>
  explicit Integer_only_triangulation(const FaceGraph& mesh,
                                      Mollification mollification = Mollification::automatic)
      : Integer_only_triangulation(Intrinsic_input(mesh, mollification)) {}
  CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_INPUT(Integer_only_triangulation)

  /*!
  \brief takes connectivity, input, and where edges run on the input from a triangulation in any
  arithmetic; ignores its metric and the history of its moves.
  \tparam Traits the arithmetic
  \tparam Correspondence says where edges run, see `common_subdivision()`
  \throws Invalid_input if an edge of the input has no length, a vertex was inserted nearer to a
  corner than 2^-52, or `Input::is_defined_by_metric()` is false
  \throws std::length_error if an edge has more than `Diamond_unfolder::maximal_crossings`
  \complexity linear
  */
  template <IntrinsicTriangulationTraits Traits, internal::Answers_queries Correspondence>
  explicit Integer_only_triangulation(
      const Intrinsic_triangulation<Mesh, Traits, Correspondence>& t)
      : mesh_(t.mesh()), number_(mesh_, t.numbers(), t.mesh()),
        correspondence_(internal::queries(t).curves()),
        input_((check_input(t.input()), t.shared_input())) {
    check_coordinates(*this);
    correspondence_.keep_crossings(*this);
  }

  /// copies everything; elements keep their numbers.
  Integer_only_triangulation(const Integer_only_triangulation& other)
      : mesh_(other.mesh_), number_(mesh_, other.number_, other.mesh_),
        correspondence_(other.correspondence_), input_(other.input_), memory_(other.memory_),
        statistics_(other.statistics_), has_only_positive_areas_(other.has_only_positive_areas_) {}
  Integer_only_triangulation& operator=(const Integer_only_triangulation&) = delete;

  /// returns the connectivity.
  const Mesh& mesh() const { return mesh_; }
  /// returns the correspondence.
  const Integer_coordinates& correspondence() const { return correspondence_; }
  /// returns the numbers of the elements of the mesh, and the elements with given numbers.
  const Mesh_adaptor<Mesh>& numbers() const { return number_; }
  /// returns the input, which defines all geometry exactly.
  const Input& input() const { return *input_; }
  /// returns the input, to be shared.
  const std::shared_ptr<const Input>& shared_input() const { return input_; }
  /// returns what was done to the input.
  const Input_report& report() const { return input().report(); }
  /// returns how predicates were decided, which may be reset.
  Predicate_statistics& statistics() const { return statistics_; }
  /// returns the number of a vertex.
  std::uint32_t index(vertex_descriptor v) const { return number_.vertex(v); }
  /// returns the number of an edge.
  std::uint32_t index(edge_descriptor e) const { return number_.halfedge(halfedge(e, mesh_)) / 2; }
  /// returns the number of a face.
  std::uint32_t index(face_descriptor f) const { return number_.face(f); }

private:
  using Geometry = Integer_geometry<Integer_only_triangulation>;

  explicit Integer_only_triangulation(internal::Prepared_input<Exact_euclidean_metric, Input>&& p)
      : mesh_(mesh_from_gluing_map<Mesh>(std::move(p.mesh))), number_(mesh_),
        input_(std::move(p.input)), has_only_positive_areas_(true) {
    check_lengths(*input_);
    correspondence_.start(*this);
  }

  // nothing can be unfolded across an edge without length
  static void check_lengths(const Input& input) {
    const Protect_FPU_rounding<true> upward;
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
      for (unsigned k = 0; k < 3; ++k)
        if (input.metric().squared_length<FT>(f, k).sup() <= 0)
          throw Invalid_input(Element_kind::face, f,
                              "face " + std::to_string(f) +
                                  " has a side without length; build with mollification");
  }

  static void check_input(const Input& input) {
    if (!input.is_defined_by_metric())
      throw Invalid_input(Element_kind::none, 0,
                          "the input does not tell the lengths of its faces exactly; build the "
                          "triangulation from the mesh");
    check_lengths(input);
  }

  static void check_coordinates(const Integer_only_triangulation& t) {
    const Integer_coordinates& c = t.correspondence_;
    for (const edge_descriptor e : edges(t.mesh_))
      if (c.normal_coordinate(t.index(e)) > Diamond_unfolder::maximal_crossings)
        throw std::length_error("edge " + std::to_string(t.index(e)) +
                                " crosses more input edges than can be unfolded");
    for (const vertex_descriptor v : vertices(t.mesh_))
      if (c.is_inserted(t.index(v)) && !representable_weights(c.location(t.index(v)).weights))
        throw Invalid_input(Element_kind::vertex, t.index(v),
                            "vertex " + std::to_string(t.index(v)) +
                                " has weights that are not multiples of 2^-52");
  }

  Move_status flip(halfedge_descriptor h) {
    const Flip move = internal::flip_record(h, mesh_, number_);
    if (!correspondence_.before(*this, move) ||
        correspondence_.flipped_coordinate() > Diamond_unfolder::maximal_crossings)
      return Move_status::crossings;
    CGAL::Euler::flip_edge(h, mesh_);
    correspondence_.after(*this, move);
    memory_.after(move);
    return Move_status::done;
  }

  Geometry geometry() const { return {*this, memory_, statistics_}; }

  Diamond diamond(halfedge_descriptor h) const { return internal::diamond_of(h, mesh_, number_); }
  Indexed_face indexed_face(halfedge_descriptor h) const {
    const halfedge_descriptor n = next(h, mesh_);
    return {
        number_.face(face(h, mesh_)),
        {number_.halfedge(h) / 2, number_.halfedge(n) / 2, number_.halfedge(next(n, mesh_)) / 2}};
  }

  static Face_values<double> midpoints(const Face_values<FT>& v) {
    const auto& [l, a] = v;
    return {{CGAL::to_double(l[0]), CGAL::to_double(l[1]), CGAL::to_double(l[2])},
            CGAL::to_double(a)};
  }

  Comparison_result compare_angle_to_pi(halfedge_descriptor h, halfedge_descriptor g) const {
    internal::Wedge wedge;
    Geometry geometry = this->geometry();
    const auto values = [&](halfedge_descriptor, const Indexed_face& f) {
      return midpoints(geometry.values(std::span(&f, 1)).front());
    };
    internal::find_wedge(*this, h, g, wedge, values, [](halfedge_descriptor) { return true; });
    return internal::compare_wedge_to_pi(wedge, [&](const auto& faces, const auto& expression) {
      using Expression = std::decay_t<decltype(expression)>;
      if constexpr (std::is_same_v<Expression, Wedge_sine_expression>)
        if (faces.size() == 2)
          return geometry.sign(internal::diamond_of_corners(faces[0], faces[1]),
                               Convexity_at_source_expression());
      return geometry.sign_of_faces(faces, expression);
    });
  }

  Mesh mesh_;
  Mesh_adaptor<Mesh> number_;
  Integer_coordinates correspondence_;
  std::shared_ptr<const Input> input_;
  // working memory of predicates, and how they decided
  mutable typename Geometry::Memory memory_;
  mutable Predicate_statistics statistics_;
  bool has_only_positive_areas_ = false; // false: unknown
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTEGER_ONLY_TRIANGULATION_H

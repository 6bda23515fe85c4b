// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTEGER_ONLY_TRIANGULATION_H
#define CGAL_INTEGER_ONLY_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Integer_only_traits.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/// represents by integers where edges run, as long as all of them can be unfolded.
class Unfoldable_coordinates : public Integer_coordinates {
public:
  using Integer_coordinates::before;
  /// announces a flip. \return whether the new edge has at most
  /// `Diamond_unfolder::maximal_crossings`
  template <class Triangulation>
  bool before(const Triangulation& t, const Flip& move) const {
    return Integer_coordinates::before(t, move) &&
           flipped_coordinate() <= Diamond_unfolder::maximal_crossings;
  }
};

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
class Integer_only_triangulation
    : public Intrinsic_triangulation<Mesh_, Integer_only_traits, Unfoldable_coordinates> {
  using Base = Intrinsic_triangulation<Mesh_, Integer_only_traits, Unfoldable_coordinates>;
  using Prepared = internal::Prepared_input<Exact_euclidean_metric, Input>;

public:
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
      const Intrinsic_triangulation<Mesh_, Traits, Correspondence>& t)
      : Base(t, Integer_only_metric(checked(t.input()), false), internal::queries(t).curves()) {
    check_coordinates(*this);
    this->correspondence().keep_crossings(*this);
  }

private:
  explicit Integer_only_triangulation(Prepared&& p)
      : Base(std::move(p.mesh), Integer_only_metric(checked(*p.input), true), p.input) {}

  // The definition of an input by which triangles can be unfolded: none is across an edge without
  // length.
  static const Input_metric& checked(const Input& input) {
    if (!input.is_defined_by_metric())
      throw Invalid_input(Element_kind::none, 0,
                          "the input does not tell the lengths of its faces exactly; build the "
                          "triangulation from the mesh");
    const Protect_FPU_rounding<true> upward;
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
      for (unsigned k = 0; k < 3; ++k)
        if (input.metric().squared_length<Interval_nt<false>>(f, k).sup() <= 0)
          throw Invalid_input(Element_kind::face, f,
                              "face " + std::to_string(f) +
                                  " has a side without length; build with mollification");
    return input.metric();
  }

  static void check_coordinates(const Base& t) {
    const Integer_coordinates& c = t.correspondence();
    for (const auto e : edges(t.mesh()))
      if (c.normal_coordinate(t.index(e)) > Diamond_unfolder::maximal_crossings)
        throw std::length_error("edge " + std::to_string(t.index(e)) +
                                " crosses more input edges than can be unfolded");
    for (const auto v : vertices(t.mesh()))
      if (c.is_inserted(t.index(v)) && !representable_weights(c.location(t.index(v)).weights))
        throw Invalid_input(Element_kind::vertex, t.index(v),
                            "vertex " + std::to_string(t.index(v)) +
                                " has weights that are not multiples of 2^-52");
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTEGER_ONLY_TRIANGULATION_H

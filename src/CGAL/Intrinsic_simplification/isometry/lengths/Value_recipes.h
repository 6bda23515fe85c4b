// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_RECIPES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_RECIPES_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Length_chain.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_table.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names the squared lengths of the edges and the quadruple areas of the faces of a triangulation, and
computes each in any precision, and in the field of the square roots of the input: not by repeated
flips, but from unfolded input triangles.
*/
class Value_recipes {
public:
  // Number of a value: first the edges of the triangulation, then its faces.
  using Id = std::uint32_t;
  // Values of a diamond, in the order of `Diamond_values`.
  using Diamond_ids = std::array<Id, 7>;

  explicit Value_recipes(const Corresponding_triangulation& t)
      : t_(t), view_(t), number_of_edges_(t.mesh().number_of_edges()),
        number_of_values_(number_of_edges_ + t.mesh().number_of_faces()) {}
  Value_recipes(const Value_recipes&) = delete;
  Value_recipes& operator=(const Value_recipes&) = delete;

  const Corresponding_triangulation& triangulation() const { return t_; }
  const Input_metric& metric() const { return t_.input().metric(); }

  Id length_of_edge(std::uint32_t e) const { return e; }
  Id area_of_face(std::uint32_t f) const { return number_of_edges_ + f; }
  bool is_length_of_edge(Id id) const { return id < number_of_edges_; }
  Id number_of_values() const { return number_of_values_; }

  // whether an edge of the triangulation runs along an input edge
  bool is_along_input(std::uint32_t edge) const {
    return t_.correspondence().normal_coordinate(edge) < 0;
  }
  // The strip of input triangles under an edge of the triangulation; nothing if
  // the edge runs along an input edge.
  const Unfolded_diamond* strip(std::uint32_t edge) const;
  // The side of an input face along which an edge of the triangulation runs.
  // \pre it does
  Face_side input_side_of(std::uint32_t edge) const;

  // The chain of input triangles under an edge; nothing if they are not in a row.
  std::optional<Length_chain> chain(std::uint32_t edge) const;

  // Values, each computed once.
  template <class FT>
  class Evaluation;

private:
  std::uint32_t side_with_face(std::uint32_t edge) const {
    return view_.is_border(2 * edge) ? 2 * edge + 1 : 2 * edge;
  }
  void expect_few_crossings(std::uint32_t edge) const;
  const Unfolded_diamond& face(std::uint32_t f) const;

  const Corresponding_triangulation& t_;
  Intrinsic_view<Corresponding_triangulation> view_;
  std::uint32_t number_of_edges_, number_of_values_;
  mutable Diamond_unfolder unfolder_;
};

/*
Computes values in one number type: `Ball`s, with rounding to the nearest, or
numbers of a `Square_root_field`.
*/
template <class FT>
class Value_recipes::Evaluation {
public:
  // \param field that of square roots, for its numbers
  explicit Evaluation(const Value_recipes& recipes, Square_root_field* field = nullptr)
      : recipes_(&recipes), field_(field) {}

  // \throws Undecidable if edges cross too many triangles
  // \throws std::length_error if numbers of the field are too long
  const FT& operator()(Id id) {
    const FT* known = values_.find(id);
    return known != nullptr ? *known : values_.add(id, computed(id));
  }

private:
  FT computed(Id id) {
    if (!recipes_->is_length_of_edge(id))
      return with_faces([&](const auto& faces) {
        return recipes_->face(id - recipes_->number_of_edges_).template values<FT>(faces).area_f;
      });
    if (const Unfolded_diamond* strip = recipes_->strip(id))
      return with_faces(
          [&](const auto& faces) -> FT { return strip->template squared_length<FT>(faces); });
    const Face_side side = recipes_->input_side_of(id);
    if constexpr (std::is_same_v<FT, Square_root_field::Number>)
      return FT(recipes_->metric().squared_length<Gmpq>(side.face, side.slot));
    else
      return Input_side_values<FT>(recipes_->metric()).squared_length(side);
  }

  // calls a function with a functor from an input face to its values
  template <class Function>
  FT with_faces(const Function& f) {
    if constexpr (std::is_same_v<FT, Square_root_field::Number>)
      return f([&](std::uint32_t face) -> const Square_root_field::Face& {
        return field_->face(recipes_->metric(), face);
      });
    else
      return f(faces_.of(recipes_->metric()));
  }

  struct Nothing {};
  using Faces = std::conditional_t<std::is_same_v<FT, Square_root_field::Number>, Nothing,
                                   Input_face_intervals<FT>>;

  const Value_recipes* recipes_;
  Square_root_field* field_;
  Value_table<FT> values_;
  [[no_unique_address]] Faces faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_VALUE_RECIPES_H

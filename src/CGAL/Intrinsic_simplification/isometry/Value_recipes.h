// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_VALUE_RECIPES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_VALUE_RECIPES_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Names the squared lengths and quadruple areas that moves make of those of a
triangulation, and remembers how they follow from each other. So each can be
computed in any precision, and in the field of the square roots of the input.

Values of the triangulation itself are not computed by repeated flips, but from
unfolded input triangles.
*/
class Value_recipes {
public:
  // Number of a value: first the edges of the triangulation, then its faces,
  // then three for each move.
  using Id = std::uint32_t;
  // Values of a diamond, in the order of `Diamond_values`.
  using Diamond_ids = std::array<Id, 7>;

  explicit Value_recipes(const Corresponding_triangulation& t)
      : t_(t), view_(t), number_of_edges_(t.mesh().number_of_edges()),
        number_of_leaves_(number_of_edges_ + t.mesh().number_of_faces()) {}
  Value_recipes(const Value_recipes&) = delete;
  Value_recipes& operator=(const Value_recipes&) = delete;

  const Corresponding_triangulation& triangulation() const { return t_; }
  const Input_metric& metric() const { return t_.input().metric(); }

  Id length_of_edge(std::uint32_t e) const { return e; }
  Id area_of_face(std::uint32_t f) const { return number_of_edges_ + f; }
  bool is_length_of_edge(Id id) const { return id < number_of_edges_; }

  // The values of a flip: of the new edge, the left face, the right face.
  std::array<Id, 3> flip(const Diamond_ids& d) { return add({Kind::flip, d}); }
  // The area of three faces that become one.
  Id sum_of_areas(Id f, Id g, Id k) { return add({Kind::sum, {f, g, k, 0, 0, 0, 0}})[1]; }
  // The squared length and the area that the removal of a border vertex makes,
  // by the diamond of its inner edge.
  std::pair<Id, Id> straighten(const Diamond_ids& d) {
    const auto [length, area, none] = add({Kind::straighten, d});
    return {length, area};
  }

  // The strip of input triangles under an edge of the triangulation; nothing if
  // the edge runs along an input edge.
  const Unfolded_diamond* strip(std::uint32_t edge) const;
  // The side of an input face along which an edge of the triangulation runs.
  // \pre it does
  Face_side input_side_of(std::uint32_t edge) const;

  // Values, each computed once.
  template <class FT>
  class Evaluation;

private:
  enum class Kind : std::uint8_t { flip, sum, straighten };
  struct Move {
    Kind kind;
    Diamond_ids from;
    std::size_t number_of_operands() const { return kind == Kind::sum ? 3 : 7; }
  };

  std::array<Id, 3> add(const Move& move) {
    const Id first = number_of_leaves_ + 3 * static_cast<Id>(moves_.size());
    moves_.push_back(move);
    return {first, first + 1, first + 2};
  }
  std::uint32_t side_with_face(std::uint32_t edge) const {
    return view_.is_border(2 * edge) ? 2 * edge + 1 : 2 * edge;
  }
  void expect_few_crossings(std::uint32_t edge) const;
  const Unfolded_diamond& face(std::uint32_t f) const;

  const Corresponding_triangulation& t_;
  Intrinsic_view<Corresponding_triangulation> view_;
  std::uint32_t number_of_edges_, number_of_leaves_;
  std::vector<Move> moves_;
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
    if (const auto known = values_.find(id); known != values_.end()) return known->second;
    stack_.assign(1, id);
    while (!stack_.empty()) compute_next();
    return values_.at(id);
  }

  Diamond_values<FT> operator()(const Diamond_ids& d) {
    for (const Id id : d) (*this)(id);
    const auto at = [this](Id id) -> const FT& { return values_.at(id); };
    return {at(d[0]), at(d[1]), at(d[2]), at(d[3]), at(d[4]), at(d[5]), at(d[6])};
  }

  void clear() { values_.clear(); }

private:
  // the value on top of the stack, if those that it follows from are known;
  // else puts these there
  void compute_next() {
    const Id id = stack_.back();
    if (values_.count(id) != 0) return stack_.pop_back();
    if (id < recipes_->number_of_leaves_) {
      values_.emplace(id, leaf(id));
      return stack_.pop_back();
    }
    const std::uint32_t number = (id - recipes_->number_of_leaves_) / 3;
    const Move& move = recipes_->moves_[number];
    const std::size_t before = stack_.size();
    for (std::size_t k = 0; k < move.number_of_operands(); ++k)
      if (values_.count(move.from[k]) == 0) stack_.push_back(move.from[k]);
    if (stack_.size() != before) return;
    store(move, recipes_->number_of_leaves_ + 3 * number);
    stack_.pop_back();
  }

  void store(const Move& move, Id first) {
    const auto at = [&](std::size_t k) -> const FT& { return values_.at(move.from[k]); };
    if (move.kind == Kind::sum) {
      values_.emplace(first + 1, at(0) + at(1) + at(2));
      return;
    }
    const Diamond_values<FT> d{at(0), at(1), at(2), at(3), at(4), at(5), at(6)};
    if (move.kind == Kind::straighten) {
      const FT area = d.area_f + d.area_g;
      values_.emplace(first, flipped(d).km);
      values_.emplace(first + 1, area);
      return;
    }
    const Flipped_values<FT> n = flipped(d);
    values_.emplace(first, n.km);
    values_.emplace(first + 1, n.area_f);
    values_.emplace(first + 2, n.area_g);
  }

  FT leaf(Id id) {
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
  std::unordered_map<Id, FT> values_;
  std::vector<Id> stack_;
  [[no_unique_address]] Faces faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_VALUE_RECIPES_H

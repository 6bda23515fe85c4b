// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief remembers what a `History_evaluator` has computed: what each flip made.
\tparam FT a model of `Field`
*/
template <class FT>
class History_values {
public:
  /// returns the number of flips of which values are remembered, or were until they were forgotten.
  std::size_t size() const { return values_.size(); }
  /// tells whether that is zero.
  bool empty() const { return values_.empty(); }
  /// tells whether the values of a flip are remembered.
  bool contains(std::uint32_t flip) const { return flip < place_.size() && place_[flip] != 0; }
  /// returns what a flip made. \pre it is remembered
  const Flipped_values<FT>& at(std::uint32_t flip) const { return values_[place_[flip] - 1]; }
  /// remembers what a flip made. \pre it is not remembered
  void insert(std::uint32_t flip, const Flipped_values<FT>& values) {
    if (flip >= place_.size()) place_.resize(std::size_t{flip} + 1, 0);
    values_.push_back(values);
    place_[flip] = static_cast<std::uint32_t>(values_.size());
  }
  /// forgets what a flip made, if it is remembered.
  void erase(std::uint32_t flip) {
    if (contains(flip)) place_[flip] = 0;
  }
  /// makes room for so many flips.
  void reserve(std::size_t flips) { values_.reserve(flips); }
  /// forgets everything.
  void clear() {
    values_.clear();
    std::fill(place_.begin(), place_.end(), 0);
  }

private:
  std::vector<std::uint32_t> place_; // of each flip: its number in `values_` and one, or zero
  std::vector<Flipped_values<FT>> values_;
};

/*!
\brief evaluates versions of faces from the input, in the arithmetic of `FT`.

Ancestors are evaluated in the order of the flips: nothing recurses, however deep the history.
\tparam FT a model of `Field`
\tparam Input_values a functor from the number of an input face to a pair of the squared lengths of its slots and
its quadruple area, or to a reference to it; or a type with members `squared_length()`, of a side, and `quadruple_area()`,
of a face
*/
template <class FT, class Input_values>
class History_evaluator {
public:
  /// constructs an evaluator over values computed before; all three must outlive it.
  History_evaluator(const Flip_history& history, const Input_values& input,
                    History_values<FT>& values)
      : history_(history), input_(input), values_(values) {}

  /*!
  \brief evaluates faces, each from a side on.
  \complexity linear in the number of ancestors not evaluated yet
  */
  std::vector<Face_values<FT>> faces(const std::vector<Flip_history::Side>& sides) {
    evaluate_ancestors(sides, std::numeric_limits<std::size_t>::max());
    std::vector<Face_values<FT>> result;
    for (const Side& s : sides) result.push_back(face(s));
    return result;
  }

  /// evaluates the diamond between two sides, if no more than `most` ancestors are not evaluated yet; nothing is allocated if
  /// all are.
  std::optional<Diamond_values<FT>> diamond(Flip_history::Side left, Flip_history::Side right,
                                            std::size_t most) {
    if (!is_evaluated(left.face) || !is_evaluated(right.face))
      if (!evaluate_ancestors({left, right}, most)) return std::nullopt;
    return gather(left, right);
  }

private:
  using Side = Flip_history::Side;

  bool is_evaluated(std::uint32_t version) const {
    return history_.is_input(version) || values_.contains(history_.flip_of(version));
  }

  bool evaluate_ancestors(const std::vector<Side>& sides, std::size_t most) {
    std::vector<std::uint32_t> versions;
    for (const Side& s : sides) versions.push_back(s.face);
    const auto is_known = [this](std::uint32_t n) { return values_.contains(n); };
    const auto flips = history_.ancestors(std::move(versions), is_known, most);
    if (flips.size() > most) return false;
    for (const std::uint32_t n : flips)
      values_.insert(n, flipped(gather(history_.left_parent(n), history_.right_parent(n))));
    return true;
  }

  Face_values<FT> face(Side s) {
    return {{length(s), length({s.face, (s.slot + 1) % 3}), length({s.face, (s.slot + 2) % 3})},
            area(s.face)};
  }

  Diamond_values<FT> gather(Side l, Side r) { return diamond_values(face(l), face(r)); }

  FT length(Side s) const {
    const Side o = history_.origin(s);
    if (history_.is_input(o.face)) {
      if constexpr (by_side)
        return input_.squared_length(o);
      else
        return input_(o.face).first[o.slot];
    }
    return values_.at(history_.flip_of(o.face)).km;
  }

  FT area(std::uint32_t version) const {
    if (history_.is_input(version)) {
      if constexpr (by_side)
        return input_.quadruple_area(version);
      else
        return input_(version).second;
    }
    const std::uint32_t n = history_.flip_of(version);
    const Flipped_values<FT>& values = values_.at(n);
    return version == history_.left_version(n) ? values.area_f : values.area_g;
  }

  static constexpr bool by_side = requires(const Input_values& x, Side s) { x.squared_length(s); };

  const Flip_history& history_;
  const Input_values& input_;
  History_values<FT>& values_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H

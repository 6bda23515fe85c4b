// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_HISTORY_EVALUATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_HISTORY_EVALUATOR_H

#include <CGAL/Intrinsic_triangulations/metric/Diamond.h>
#include <CGAL/Intrinsic_triangulations/metric/Flip_history.h>

#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief remembers what a `History_evaluator` has computed.
\tparam FT a model of `Field`
*/
template <class FT>
struct History_values {
  /// Squared lengths of the slots of a face, and its quadruple area.
  using Face_values = std::pair<std::array<FT, 3>, FT>;

  /// What each flip made.
  std::unordered_map<std::uint32_t, Flipped_values<FT>> flips;
  /// Input faces.
  std::unordered_map<std::uint32_t, Face_values> inputs;

  /// returns the number of values that are remembered.
  std::size_t size() const { return flips.size() + inputs.size(); }
};

/*!
\brief evaluates versions of faces from the input, in the arithmetic of `FT`.

Ancestors are evaluated in the order of their flips: nothing recurses, however deep the history.
\tparam FT a model of `Field`
\tparam Input_values a functor from the number of an input face to `History_values::Face_values`
*/
template <class FT, class Input_values>
class History_evaluator {
public:
  /// constructs an evaluator over values computed before; all three must outlive it.
  History_evaluator(const Flip_history& history, const Input_values& input,
                    History_values<FT>& values)
      : history_(history), input_(input), values_(values) {}

  /*!
  \brief evaluates the diamond between two sides that are glued together.
  \complexity linear in the number of ancestors not evaluated yet
  */
  Diamond_values<FT> diamond(Flip_history::Side left, Flip_history::Side right) {
    evaluate_ancestors(left.version, right.version);
    return gather(left, right);
  }

private:
  using Side = Flip_history::Side;

  void evaluate_ancestors(std::uint32_t a, std::uint32_t b) {
    const auto is_known = [this](std::uint32_t n) { return values_.flips.count(n) != 0; };
    for (const std::uint32_t n : history_.ancestors(a, b, is_known))
      values_.flips.emplace(n, flipped(gather(history_.left_parent(n), history_.right_parent(n))));
  }

  Diamond_values<FT> gather(Side l, Side r) {
    return {length(l),
            length({l.version, (l.slot + 1) % 3}),
            length({l.version, (l.slot + 2) % 3}),
            length({r.version, (r.slot + 1) % 3}),
            length({r.version, (r.slot + 2) % 3}),
            area(l.version),
            area(r.version)};
  }

  const FT& length(Side s) {
    const Side o = history_.origin(s);
    if (!history_.is_input(o.version)) return values_.flips.at(history_.flip_of(o.version)).km;
    return input(o.version).first[o.slot];
  }

  const FT& area(std::uint32_t version) {
    if (history_.is_input(version)) return input(version).second;
    const std::uint32_t n = history_.flip_of(version);
    const Flipped_values<FT>& values = values_.flips.at(n);
    return version == history_.left_version(n) ? values.area_f : values.area_g;
  }

  const typename History_values<FT>::Face_values& input(std::uint32_t f) {
    auto it = values_.inputs.find(f);
    if (it == values_.inputs.end()) it = values_.inputs.emplace(f, input_(f)).first;
    return it->second;
  }

  const Flip_history& history_;
  const Input_values& input_;
  History_values<FT>& values_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_HISTORY_EVALUATOR_H

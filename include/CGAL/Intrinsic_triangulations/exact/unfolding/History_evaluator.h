// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>

#include <array>
#include <cstddef>
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
  using Input_face = std::pair<std::array<FT, 3>, FT>;

  /// What each flip made.
  std::unordered_map<std::uint32_t, Flipped_values<FT>> flips;
  /// What each insertion or removal of a vertex made, by its first node.
  std::unordered_map<std::uint32_t, Vertex_move_values<FT>> moves;

  /// returns the number of values that are remembered.
  std::size_t size() const { return flips.size() + moves.size(); }
};

/*!
\brief evaluates versions of faces from the input, in the arithmetic of `FT`.

Ancestors are evaluated in the order of the moves: nothing recurses, however deep the history.
\tparam FT a model of `Field`
\tparam Input_values a functor from the number of an input face to its `History_values::Input_face`, or to a
reference to it
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
    evaluate_ancestors({left.face, right.face});
    return gather(left, right);
  }

  /*!
  \brief evaluates faces, each from a side on.
  \complexity linear in the number of ancestors not evaluated yet
  */
  std::vector<Face_values<FT>> faces(const std::vector<Flip_history::Side>& sides) {
    std::vector<std::uint32_t> versions;
    for (const Side& s : sides) versions.push_back(s.face);
    evaluate_ancestors(std::move(versions));
    std::vector<Face_values<FT>> result;
    for (const Side& s : sides) result.push_back(face(s));
    return result;
  }

private:
  using Side = Flip_history::Side;

  void evaluate_ancestors(std::vector<std::uint32_t> versions) {
    const auto is_known = [this](std::uint32_t n) {
      return (history_.is_flip(n) ? values_.flips.count(n) : values_.moves.count(n)) != 0;
    };
    for (const std::uint32_t n : history_.ancestors(std::move(versions), is_known))
      if (history_.is_flip(n))
        values_.flips.emplace(n,
                              flipped(gather(history_.left_parent(n), history_.right_parent(n))));
      else
        values_.moves.emplace(n, evaluate(history_.vertex_move(n)));
  }

  Vertex_move_values<FT> evaluate(const Flip_history::Vertex_move& m) {
    using Kind = Flip_history::Vertex_move::Kind;
    switch (m.kind) {
    case Kind::insert_in_face:
      return inserted_in_face(face(m.parents[0]), m.weights);
    case Kind::insert_in_border_edge:
      return inserted_in_border_edge(face(m.parents[0]), m.weights[1]);
    case Kind::remove_from_face:
      return removed_from_face(area(m.parents[0].face), area(m.parents[1].face),
                               area(m.parents[2].face));
    case Kind::remove_from_border_edge:
      break;
    }
    return removed_from_border_edge(gather(m.parents[0], m.parents[1]));
  }

  Face_values<FT> face(Side s) {
    return {{length(s), length({s.face, (s.slot + 1) % 3}), length({s.face, (s.slot + 2) % 3})},
            area(s.face)};
  }

  Diamond_values<FT> gather(Side l, Side r) { return diamond_values(face(l), face(r)); }

  FT length(Side s) const {
    const Side o = history_.origin(s);
    if (history_.is_input(o.face)) return input_(o.face).first[o.slot];
    const std::uint32_t n = history_.node_of(o.face);
    if (history_.is_flip(n)) return values_.flips.at(n).km;
    return values_.moves.at(n).squared_lengths[history_.made_length(o)];
  }

  FT area(std::uint32_t version) const {
    if (history_.is_input(version)) return input_(version).second;
    const std::uint32_t n = history_.node_of(version), k = version - history_.left_version(n);
    if (!history_.is_flip(n)) return values_.moves.at(n).quadruple_areas[k];
    const Flipped_values<FT>& values = values_.flips.at(n);
    return k == 0 ? values.area_f : values.area_g;
  }

  const Flip_history& history_;
  const Input_values& input_;
  History_values<FT>& values_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_HISTORY_EVALUATOR_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPEATED_FLIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPEATED_FLIPS_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Input_side_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief repeats flips in balls, each once as a rule, as long as they are not too many in sum.
\tparam FT a `Ball`; rounding is to the nearest
*/
template <class FT>
class Repeated_flips {
public:
  /*!
  \brief encloses the values of the diamond between two sides.
  \param input the input, always the same
  \param history the flips since, always the same but for new ones
  \param left, right the sides
  \param most how many flips may have been repeated by then in sum
  \return nothing if there would be more
  */
  std::optional<Diamond_values<FT>> diamond(const Input_metric& input, const Flip_history& history,
                                            Flip_history::Side left, Flip_history::Side right,
                                            std::size_t most) {
    if (number_ > most) return std::nullopt;
    if (values_.size() > maximal_memory) values_.clear();
    if (values_.empty())
      values_.reserve(std::min({most, std::size_t{history.number_of_flips()}, maximal_memory}));
    const Input_side_values<FT> sides(input);
    const std::size_t known = values_.size();
    const auto d = History_evaluator<FT, Input_side_values<FT>>(history, sides, values_)
                       .diamond(left, right, most - number_);
    number_ += d ? values_.size() - known : most;
    return d;
  }

  /// counts something as costly as one flip.
  void count() { ++number_; }

  /// forgets what is remembered of a flip that is undone, the last one.
  void forget(std::uint32_t flip) { values_.erase(flip); }

private:
  static constexpr std::size_t maximal_memory = 1U << 20; // flips, of about a hundred bytes each

  History_values<FT> values_;
  std::size_t number_ = 0; // repeated so far, or looked for in vain
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPEATED_FLIPS_H

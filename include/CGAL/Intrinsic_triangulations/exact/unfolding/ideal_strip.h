// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_IDEAL_STRIP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_IDEAL_STRIP_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Penner_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>

#include <concepts>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes lambda lengths from the start of an edge to all points of the strip of input
triangles through which the edge runs.

`lambda_at_apex()` steps from triangle to triangle. All terms are positive: after n triangles, the
relative error is at most about 4 n roundings, and rational values have heights that are linear in
n. No flip before has any influence.
\tparam FT a model of `FieldNumber`
\tparam Lambda a functor from a side of an input face and a number k to the lambda length of the
  k-th side from there on, in `FT`
\param strip see `Diamond_unfolder::strip()`
\param lambda the functor
\param at set to the values, by point; at the end of the edge, the lambda length of the edge
\return the lambda length of the edge
\complexity linear
*/
template <FieldNumber FT, std::invocable<const Face_side&, unsigned> Lambda>
FT lambdas_along_strip(const Unfolded_diamond& strip, const Lambda& lambda, std::vector<FT>& at) {
  using Triangle = Unfolded_diamond::Triangle;
  const auto& first = strip.triangles[0];
  const std::uint32_t start = strip.point(0);
  at.clear();
  for (unsigned k = 0; k < 3; ++k) // side k joins corners k and k + 1
    at.push_back(first.point[k] == start             ? FT(0)
                 : first.point[(k + 1) % 3] == start ? lambda(first.side, k)
                                                     : lambda(first.side, (k + 2) % 3));
  strip.triangles.carry(at, [&](const Triangle& t, const FT& from, const FT& to) {
    return lambda_at_apex<FT>(from, to, lambda(t.side, 0), lambda(t.side, 1), lambda(t.side, 2));
  });
  return at[strip.point(1)];
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_IDEAL_STRIP_H

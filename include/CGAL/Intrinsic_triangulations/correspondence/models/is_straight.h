// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IS_STRAIGHT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IS_STRAIGHT_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether an edge runs straight over the input, as the edges of a triangulation do: the ends of
// each curve that it crosses lie on its two sides, where its triangles are unfolded. Normal
// coordinates describe curves up to bending; this tests whether the straight one is among them.
// Linear in the number of input triangles that are unfolded.
// \tparam Triangulation stores integers only; its scope is live
template <class Triangulation>
bool is_straight(const Triangulation& t, typename Triangulation::halfedge_descriptor h) {
  using FT = Interval_nt<false>;
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  if (face(h, t.mesh()) == null) h = opposite(h, t.mesh());
  const Indexed_face side = indexed_face_from(t, h);
  if (t.correspondence().normal_coordinate(side.edges[0]) <= 0)
    return true; // in one face, or along its side
  const auto& decider = t.decider();
  Unfolded_diamond strip = decider.strip(side);
  const auto z = strip.positions<FT>(decider.intervals());
  const auto i = strip.position(0, z), ij = strip.position(1, z) - i;
  for (std::uint32_t n = 1; n < strip.size(); ++n) {
    const auto &ends = strip.triangles[n].point, &last = strip.triangles[n - 1].point;
    for (const std::uint32_t end : {0U, 1U}) { // on the left, and on the right
      if (n > 1 && ends[end] == last[end]) continue;
      std::optional<Sign> s = certain_sign(cross(ij, z[ends[end]] - i));
      strip.corners[2] = {n, end};
      if (!s) {
        ++t.metric().statistics().filter_failures;
        Diamond_values<FT> values;
        s = decider.exact_sign_on(strip, recorded(Left_area_expression()), values);
      }
      if (*s != (end == 0 ? POSITIVE : NEGATIVE)) return false;
    }
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_IS_STRAIGHT_H

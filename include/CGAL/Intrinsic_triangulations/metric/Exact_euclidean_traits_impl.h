// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Exact_euclidean_metric::sharpen(std::span<const Indexed_face> faces) const {
  const auto is_narrow = [this](const Indexed_face& f) { return Enclosed_values::is_narrow(f); };
  std::vector<Indexed_face> wide(faces.begin(), faces.end());
  std::erase_if(wide, is_narrow);
  for (const unsigned bits : precisions) {
    if (wide.empty()) return;
    statistics().sharpenings[bits] += wide.size();
    refine(wide, geometry_.enclosures(wide, bits));
    std::erase_if(wide, is_narrow);
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void
Exact_euclidean_metric::sharpen_length(const Indexed_face& face) const {
  for (const unsigned bits : precisions) {
    if (is_narrow(face.edges[0])) return;
    ++statistics().sharpenings[bits];
    refine_length(face.edges[0], geometry_.first_squared_length(face, bits));
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE double
Exact_euclidean_metric::cotangent_weight(const Diamond& d) const {
  if (const std::optional<double> weight = stored_weight(d)) return *weight;
  const auto known = signs_.find(d.ij);
  if (!known || known->sign != ZERO)
    if (const std::optional<double> weight = geometry_.weight_by_flips(d)) return *weight;
  if (sign(d, Delaunay_expression()) == ZERO) return 0;
  return geometry_.nonzero_weight(d);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Enclosed_values
Exact_euclidean_metric::enclose(const Input& input) {
  const Scope scope;
  return {Intrinsic_triangulations::squared_lengths<FT>(input.metric(), input.mesh()),
          Intrinsic_triangulations::quadruple_areas<FT>(input.metric())};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_euclidean_metric::exact_sign(
    const Diamond& d, const Recorded_diamond_expression& expression) const {
  const bool is_remembered = expression.zero_meaning() == Zero_meaning::cocircular;
  ++statistics().filter_failures;
  std::uint64_t& probable = statistics().probable_zero;
  if (is_remembered)
    if (const auto known = signs_.find(d.ij)) {
      if (known->sign == ZERO) ++(known->is_probable ? probable : statistics().certified_zero);
      return known->sign;
    }
  const std::uint64_t before = probable;
  Diamond_values<FT> better = enclosure(d);
  const Sign s = geometry_.sign(d, expression, better);
  refine(d, better);
  if (is_remembered) signs_.remember(d.ij, {s, probable != before});
  return s;
}

// not within the loop that flips
CGAL_INTRINSIC_TRIANGULATIONS_INLINE BOOST_NOINLINE Sign
Exact_euclidean_metric::exact_delaunay_sign(const Diamond& d) const {
  return exact_sign(d, recorded(Delaunay_expression()));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_euclidean_metric::exact_sign(
    std::span<const Indexed_face> faces, std::vector<Face_values<FT>>& values,
    const Recorded_face_expression& expression) const {
  ++statistics().filter_failures;
  const Sign s = geometry_.sign(faces, expression, values);
  refine(faces, values);
  return s;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_EXACT_EUCLIDEAN_TRAITS_IMPL_H

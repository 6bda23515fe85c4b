// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASUREDTRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASUREDTRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <concepts>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for what measures a triangulation, and assembles matrices on it.

Syntax of \ref ::MeasuredTriangulation, where its meaning is described.
*/
template <class Triangulation>
concept MeasuredTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    internal::Has_approximate_values<Triangulation> && internal::Has_matrix_rows<Triangulation> &&
    std::constructible_from<typename Triangulation::Const_session, const Triangulation&> &&
    requires(const Triangulation& t, const typename Triangulation::Const_session& c,
             typename Triangulation::edge_descriptor e, typename Triangulation::face_descriptor f,
             std::uint32_t i) {
  { t.metric().is_degenerate(i) } -> std::same_as<bool>;
  { t.squared_length(e) } -> std::same_as<double>;
  { c.cotangent_weight(e) } -> std::same_as<double>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_MEASUREDTRIANGULATION_H

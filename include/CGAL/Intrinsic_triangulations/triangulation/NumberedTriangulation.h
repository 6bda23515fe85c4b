// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_NUMBEREDTRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_NUMBEREDTRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <concepts>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for elements that have numbers, values by number, and names on the input: a triangulation that `Intrinsic_view`
can read.

Syntax of \ref ::NumberedTriangulation, where its meaning is described.
*/
template <class Triangulation>
concept NumberedTriangulation = internal::Has_triangulated_mesh<Triangulation> &&
    internal::Has_approximate_values<Triangulation> && internal::Has_matrix_rows<Triangulation> &&
    requires(const Triangulation& t, typename Triangulation::vertex_descriptor v,
             typename Triangulation::halfedge_descriptor h,
             typename Triangulation::face_descriptor f, std::uint32_t i) {
  { t.is_inserted(v) } -> std::same_as<bool>;
  { t.numbers().vertex(v) } -> std::same_as<std::uint32_t>;
  { t.numbers().halfedge(h) } -> std::same_as<std::uint32_t>;
  { t.numbers().face(f) } -> std::same_as<std::uint32_t>;
  { t.numbers().vertex_at(i) } -> std::same_as<typename Triangulation::vertex_descriptor>;
  { t.numbers().halfedge_at(i) } -> std::same_as<typename Triangulation::halfedge_descriptor>;
  { t.numbers().face_at(i) } -> std::same_as<typename Triangulation::face_descriptor>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_NUMBEREDTRIANGULATION_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_WHOLE_FACES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_WHOLE_FACES_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Triangles in space with all vertices: those of the polyhedron, and removed ones on its faces.
struct Whole_faces {
  Space_points points;
  std::vector<std::array<std::uint32_t, 3>> faces;
};

// Puts removed vertices back: faces and edges that they lie on are split.
// \param left the vertices of the polyhedron, by their numbers in the result
Whole_faces put_back(const Metric_triangles& t, const Space_points& points,
                     const std::vector<std::uint32_t>& left);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_WHOLE_FACES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_REMOVE_FLAT_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_REMOVE_FLAT_H

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Removes the vertices whose curvature is at most `within` there, see `Flat_vertex_removal`.
// Numbers of vertices stay; see `Metric_triangles::compress()`.
// \return whether all could be removed
bool remove_flat(Metric_triangles& t, const std::vector<double>& within, Embedding_run& run);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_REMOVE_FLAT_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DECREASE_CURVATURES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DECREASE_CURVATURES_H

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <array>
#include <cstdint>
#include <functional>

namespace CGAL::Intrinsic_triangulations::internal {

// Pyramids that are convex along all edges, and how far their curvatures have decreased.
struct Glued_pyramids {
  Metric_triangles triangles;
  Apex_radii radii;
  double curvature_left = 1;
};

/*
Starts with an apex far away, where the curvatures of the radii are nearly those of the surface, and
decreases them together, until hardly anything is left. The Jacobian is regular all the way, but at
0 any translation of the apex is left.
\param is_found is called after each step, and returns whether to stop
\return `done`, `stopped` by `is_found`, `stalled`, `cap` or `cancelled`
*/
Status decrease_curvatures(Glued_pyramids& p, Embedding_run& run,
                           const std::function<bool(const Glued_pyramids&)>& is_found);

/*
Decreases curvatures that are nearly 0 to their rounding. A translation of the apex changes none of
them, to first order. So three radii stay, whose directions are independent: forces along the radii
by the curvatures are in balance, and where all others are 0, so are those three.
*/
void close_pyramids(Glued_pyramids& p, const std::array<std::uint32_t, 3>& fixed,
                    Embedding_run& run);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_DECREASE_CURVATURES_H

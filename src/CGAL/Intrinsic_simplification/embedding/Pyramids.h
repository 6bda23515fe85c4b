// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>

#include <Eigen/SparseCore>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Pyramids over all triangles, which meet in one apex: given are the radii, the distances of the
vertices from it. They are glued around each radius, where a curvature is left: a full turn less the
dihedral angles there. All formulas are those of Bobenko and Izmestiev, "Alexandrov's theorem,
weighted Delaunay triangulations, and mixed volumes" (2008).
*/
struct Pyramids {
  // The foot of the apex is at this signed distance from each halfedge, to its left.
  std::vector<double> foot;
  std::vector<double> height;    // of each pyramid
  std::vector<double> curvature; // around each radius

  // \return whether all pyramids exist
  bool build(const Metric_triangles& t, const std::vector<double>& radii);
  // the derivatives of curvatures by radii, symmetric
  Eigen::SparseMatrix<double> derivatives(const Metric_triangles& t,
                                          const std::vector<double>& radii) const;
};

// Flips until no edge is concave: until the triangles are Delaunay for weights, which are the
// squares of the radii.
// \return whether that was possible; else there are no convex pyramids with these radii
bool flip_to_convex(Metric_triangles& t, const std::vector<double>& radii);
// The same where only the edges of some halfedges may be concave.
bool flip_to_convex(Metric_triangles& t, const std::vector<double>& radii,
                    std::vector<std::uint32_t> queue);

double area_of(const Metric_triangles& t);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H

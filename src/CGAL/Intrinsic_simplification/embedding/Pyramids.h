// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

using Vertex_weights = std::vector<Double_double>;

// The distances of vertices from an apex. The square of each is the sum of one number and a weight:
// far away, squares are alike but for weights, on which it depends which edges are convex.
struct Apex_radii {
  double base = 1;
  Vertex_weights weights;

  Double_double squared(std::uint32_t v) const { return Double_double(base) + weights[v]; }
  double operator[](std::uint32_t v) const { return std::sqrt(squared(v).to_double()); }
  // gives the mean weight to the base
  void balance();
};

/*
Pyramids over all triangles, which meet in one apex: given are the radii, the distances of the
vertices from it. They are glued around each radius, where a curvature is left: a full turn less the
dihedral angles there. All formulas are those of Bobenko and Izmestiev, "Alexandrov's theorem,
weighted Delaunay triangulations, and mixed volumes" (2008).

Where the surface is nearly flat, its curvature is split in two parts that are smaller still: what
is left and what is lost. Both are arguments of products of complex numbers with 106 bits.
*/
struct Pyramids {
  // The foot of the apex is at this signed distance from each halfedge, to its left.
  std::vector<double> foot;
  std::vector<double> height;    // of each pyramid
  std::vector<double> curvature; // around each radius
  std::vector<double> lost;      // of the curvature of the surface at each vertex

  // \return whether all pyramids exist
  bool build(const Metric_triangles& t, const Apex_radii& radii);
  // the derivatives of curvatures by radii, symmetric
  Eigen::SparseMatrix<double> derivatives(const Metric_triangles& t, const Apex_radii& radii) const;
  // the derivatives of curvatures by the base of radii: sums of the former that cancel far away
  Eigen::VectorXd derivatives_by_base(const Metric_triangles& t, const Apex_radii& radii) const;

private:
  // What derivatives at an edge have in common: the derivative of the curvature at one end by the
  // radius to the other one; of the angle at the apex; and of the inverse radii.
  struct Edge_terms {
    double weight, one_less_cosine, inverse_difference;
  };
  Edge_terms terms(const Metric_triangles& t, const Apex_radii& radii, std::uint32_t h) const;
};

// Flips until no edge is concave: until the triangles are Delaunay for weights, which are the
// squares of the radii, up to one number that all have in common.
// \return whether that was possible; else there are no convex pyramids with these radii
bool flip_to_convex(Metric_triangles& t, const Vertex_weights& weights);
// The same where only the edges of some halfedges may be concave.
bool flip_to_convex(Metric_triangles& t, const Vertex_weights& weights,
                    std::vector<std::uint32_t> queue);

double area_of(const Metric_triangles& t);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_PYRAMIDS_H

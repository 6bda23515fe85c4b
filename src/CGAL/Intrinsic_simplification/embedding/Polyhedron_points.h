// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_POLYHEDRON_POINTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_POLYHEDRON_POINTS_H

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

// Places the vertices about the apex, one after another over neighbouring pyramids.
Precise_points lay_out_pyramids(const Glued_pyramids& p);

// Three vertices whose directions from the apex, the origin, are far from a plane.
std::array<std::uint32_t, 3> independent_directions(const Space_points& points);

// What `fit_lengths()` has found.
enum class Fit : std::uint8_t {
  none,    // no points with these lengths
  lengths, // lengths are right up to rounding, but edges are concave
  convex   // no edge is concave
};

// Moves the points until all edges have their lengths, and flips edges that are concave then.
// \param within an edge is concave if it is so by more than this distance
Fit fit_lengths(Metric_triangles& t, Precise_points& points, double within, Embedding_run& run);

// The other corners of the two triangles at h, as seen from its source: its target, the apex of its
// face, and that of the face across.
std::array<Precise_point, 3> diamond_from(const Metric_triangles& t, const Precise_points& points,
                                          std::uint32_t h);

// The height of the next vertex across h over the face of h; positive if the edge is concave.
double height_across(const Metric_triangles& t, const Precise_points& points, std::uint32_t h);

// the mean of the points
Eigen::Vector3d centre_of(const Space_points& points);

// the greatest distance from the centre to a point, twice: between the diameter and twice of it
double extent_of(const Space_points& points);
double extent_of(const Precise_points& points);

// the greatest difference between a distance of points and the length of an edge
double greatest_error(const Metric_triangles& t, const Space_points& points);

// Proves what can be proven about points that fit the lengths. The run may end it.
Convexity_certificate certify_polyhedron(const Metric_triangles& t, const Precise_points& points,
                                         Embedding_run& run);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_POLYHEDRON_POINTS_H

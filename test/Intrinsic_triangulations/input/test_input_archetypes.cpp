// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "input_archetypes.h"
#include "triangulation_archetypes.h"

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

using Numbers = archetypes::Range<archetypes::Converts_to_number>;
using Points = archetypes::Range<archetypes::Point_in_space>;
using Faces = archetypes::Range<Numbers>;

static_assert(IT::TriangleRange<archetypes::Triangles>);
static_assert(!IT::TriangleRange<archetypes::Range<archetypes::Triple>>); // of unknown size
static_assert(IT::PointRange<Points>);
static_assert(IT::PointRange<std::vector<std::array<double, 3>>>);
static_assert(!IT::PointRange<Numbers>);
static_assert(IT::FaceRange<Faces>);
static_assert(!IT::FaceRange<Points>);
static_assert(IT::ReadableFaceGraph<archetypes::Readable_mesh>);
static_assert(!IT::WritableFaceGraph<archetypes::Readable_mesh>);
static_assert(IT::WritableFaceGraph<archetypes::Writable_mesh>);
static_assert(!IT::MutableDeltaComplex<archetypes::Writable_mesh>); // without numbers
static_assert(IT::TriangulationWithMetric<archetypes::Measured_triangulation>);
static_assert(!IT::TriangulationWithMetric<IT::Gluing_map>);
static_assert(IT::ScalableSurface<archetypes::Measured_triangulation>);
static_assert(IT::ScalableSurface<IT::Intrinsic_input>);
static_assert(IT::ScalableSurface<archetypes::Readable_mesh>);
static_assert(!IT::ScalableSurface<IT::Triangle_soup>);
static_assert(IT::VertexFactors<archetypes::Vertex_factors, IT::Gluing_map>);
static_assert(IT::FaceNorm<archetypes::Face_norm, IT::Gluing_map, IT::Unscaled_vector>);
static_assert(IT::ConnectedTriangulation<archetypes::Measured_and_numbered_triangulation>);
static_assert(!IT::ConnectedTriangulation<archetypes::Measured_triangulation>);
static_assert(!IT::ConnectedTriangulation<archetypes::Numbered_triangulation>);
static_assert(IT::QueriedTriangulation<archetypes::Corresponding_triangulation>);
static_assert(!IT::QueriedTriangulation<archetypes::Numbered_triangulation>);
static_assert(IT::NumberedTriangles<archetypes::Numbered_triangles>);
static_assert(!IT::NumberedComplex<archetypes::Numbered_triangles>);
static_assert(IT::NormalCoordinates<archetypes::Normal_coordinates>);
static_assert(!IT::CurveCoordinates<archetypes::Normal_coordinates>);

namespace {

// The boundary of a tetrahedron.
const archetypes::Triangles& triangles() {
  static const archetypes::Triangles t(
      {archetypes::Triple({0, 1, 2}), archetypes::Triple({0, 3, 1}), archetypes::Triple({1, 3, 2}),
       archetypes::Triple({2, 3, 0})});
  return t;
}
IT::Gluing_map tetrahedron() { return IT::Gluing_map(IT::gluing_from_triangles(4, triangles())); }

} // namespace

TEST(InputArchetypes, ranges_are_enough_for_arrays) {
  EXPECT_EQ(IT::euler_characteristic(tetrahedron()), 2);
  const Points points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const IT::Triangle_soup soup = IT::triangle_soup(points, Faces({Numbers({{0}, {1}, {2}})}));
  EXPECT_EQ(soup.triangles.size(), 1U);
}

TEST(InputArchetypes, face_graphs_are_enough_to_read_and_to_build) {
  const IT::Gluing_map read =
      IT::gluing_map_from_face_graph(archetypes::Readable_mesh(tetrahedron()));
  EXPECT_EQ(read.number_of_edges(), 6U);
  archetypes::Writable_mesh built;
  IT::copy_gluing_map(read, built);
  EXPECT_EQ(num_faces(built), 4U);
}

TEST(InputArchetypes, factors_and_norms_are_enough_to_scale) {
  const IT::Intrinsic_input input(tetrahedron(), std::vector<double>(6, 1));
  archetypes::Wrapped all(input);
  const archetypes::Measured_triangulation t(all);
  EXPECT_EQ(IT::scale_conformally(t, archetypes::Vertex_factors()).input.squared_lengths,
            IT::scale_conformally(all, archetypes::Vertex_factors()).input.squared_lengths);
  EXPECT_EQ(IT::scale_by_norm(t, archetypes::Face_norm()).input.squared_lengths,
            IT::scale_by_norm(all, archetypes::Face_norm()).input.squared_lengths);
}

TEST(InputArchetypes, numbers_are_enough_to_follow_curves) {
  const IT::Gluing_map map = tetrahedron();
  const archetypes::Numbered_triangles faces{map};
  archetypes::Normal_coordinates n{std::vector<IT::Normal_coordinate>(6, 0)};
  n.n[map.next({0}).index / 2] = 1; // one curve, across the side opposite the source of 0
  std::size_t crossings = 0;
  const IT::Curve_end start{0, 0};
  const IT::Curve_end end = IT::follow_curve(faces, n, IT::first_crossing(faces, n, start),
                                             [&](const IT::Curve_crossing&) { ++crossings; });
  EXPECT_EQ(crossings, 1U);
  EXPECT_EQ(IT::sides_of_face(faces, end.halfedge)[1] / 2, map.next({0}).index / 2);
}

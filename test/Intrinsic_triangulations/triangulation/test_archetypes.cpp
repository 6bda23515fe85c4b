// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangulation_archetypes.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/reaction_diffusion.h>
#include <CGAL/Intrinsic_operators/operators/residual_indicators.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/centres.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/signpost_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_tessellation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/dijkstra_ball.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/locate_circumcenter.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "archetypes.h"
#include "mesh_types.h"

#include <CGAL/boost/graph/generators.h>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

using Exact = IT::Intrinsic_triangulation<>;
using Inexact = IT::Intrinsic_triangulation<Surface_mesh, IT::Euclidean_traits<double>>;
using With_signposts =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, IT::Signposts>;
using Without_insertions = IT::Intrinsic_triangulation<IT::Gluing_map, archetypes::Traits>;
using Integer_only = IT::Integer_only_triangulation<>;
using Hyperbolic = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>>;

// ---- RefinableMetric

static_assert(IT::RefinableMetric<IT::Exact_euclidean_metric>);
static_assert(IT::RefinableMetric<IT::Euclidean_metric<double>>);
static_assert(!IT::RefinableMetric<archetypes::Metric>);
static_assert(IT::internal::Has_enclosures<IT::Exact_euclidean_metric>);
static_assert(!IT::internal::Measures_insertions<IT::Exact_euclidean_metric>);
static_assert(IT::internal::Measures_insertions<IT::Euclidean_metric<double>>);
static_assert(!IT::internal::Has_enclosures<IT::Euclidean_metric<double>>);
static_assert(!IT::RefinableMetric<double>);

// ---- NumberedComplex

static_assert(IT::NumberedComplex<archetypes::Complex>);
static_assert(IT::NumberedComplex<IT::Input>);
static_assert(IT::NumberedComplex<IT::Intrinsic_view<Exact>>);
static_assert(!IT::NumberedComplex<IT::Gluing_map>);
static_assert(!IT::NumberedComplex<Exact>);

// ---- CurveCoordinates

static_assert(IT::CurveCoordinates<archetypes::Curves>);
static_assert(IT::CurveCoordinates<IT::Integer_coordinates>);
static_assert(IT::CurveCoordinates<IT::Explicit_crossings>);
static_assert(!IT::CurveCoordinates<IT::Signposts>);
static_assert(!IT::CurveCoordinates<IT::No_correspondence>);

// ---- SignpostDirections

static_assert(IT::SignpostDirections<archetypes::Directions>);
static_assert(IT::SignpostDirections<IT::Signposts>);
static_assert(!IT::SignpostDirections<IT::Integer_coordinates>);

// ---- MeasuredTriangulation

static_assert(IT::MeasuredTriangulation<archetypes::Measured_triangulation>);
static_assert(IT::MeasuredTriangulation<Exact>);
static_assert(IT::MeasuredTriangulation<Inexact>);
static_assert(IT::MeasuredTriangulation<Without_insertions>);
static_assert(!IT::MeasuredTriangulation<Integer_only>);
static_assert(!IT::MeasuredTriangulation<archetypes::Triangulation>);

// ---- IndexedTriangulation

static_assert(IT::IndexedTriangulation<archetypes::Indexed_triangulation>);
static_assert(IT::IndexedTriangulation<Exact>);
static_assert(IT::IndexedTriangulation<Hyperbolic>);
static_assert(!IT::IndexedTriangulation<archetypes::Measured_triangulation>);

// ---- NumberedTriangulation

static_assert(IT::NumberedTriangulation<archetypes::Numbered_triangulation>);
static_assert(IT::NumberedTriangulation<Exact>);
static_assert(IT::NumberedTriangulation<Inexact>);
static_assert(!IT::NumberedTriangulation<Integer_only>);
static_assert(!IT::NumberedTriangulation<Hyperbolic>);
static_assert(!IT::NumberedTriangulation<archetypes::Indexed_triangulation>);
static_assert(!IT::NumberedTriangulation<archetypes::Measured_triangulation>);

// ---- RefinableTriangulation

static_assert(IT::RefinableTriangulation<archetypes::Refinable_triangulation>);
static_assert(IT::RefinableTriangulation<Exact>);
static_assert(IT::RefinableTriangulation<Inexact>);
static_assert(IT::RefinableTriangulation<With_signposts>);
static_assert(!IT::RefinableTriangulation<Without_insertions>);
static_assert(!IT::RefinableTriangulation<Integer_only>);

// ---- GeodesicTriangulation

static_assert(IT::GeodesicTriangulation<archetypes::Geodesic_triangulation>);
static_assert(IT::GeodesicTriangulation<Exact>);
static_assert(IT::GeodesicTriangulation<Inexact>);
static_assert(IT::GeodesicTriangulation<With_signposts>);
static_assert(!IT::GeodesicTriangulation<Integer_only>);
static_assert(!IT::GeodesicTriangulation<archetypes::Refinable_triangulation>);

// ---- CorrespondingTriangulation

static_assert(IT::CorrespondingTriangulation<archetypes::Corresponding_triangulation>);
static_assert(IT::CorrespondingTriangulation<IT::Corresponding_triangulation>);
static_assert(IT::CorrespondingTriangulation<With_signposts>);
static_assert(!IT::CorrespondingTriangulation<Exact>);
static_assert(!IT::CorrespondingTriangulation<archetypes::Numbered_triangulation>);
static_assert(!IT::CorrespondingTriangulation<Integer_only>);

// ---- the archetypes are enough for the algorithms, which do with them what they do with what these wrap

namespace {

Surface_mesh icosahedron() {
  Surface_mesh mesh;
  CGAL::make_icosahedron<Surface_mesh, Surface_mesh::Point>(mesh);
  return mesh;
}

archetypes::Wrapped refined(const Surface_mesh& mesh) {
  archetypes::Wrapped t(mesh);
  IT::delaunay_refine(t, IT::parameters::maximum_edge_length(0.7));
  return t;
}

Eigen::VectorXd alternating(Eigen::Index size) {
  Eigen::VectorXd v(size);
  for (Eigen::Index i = 0; i < size; ++i) v[i] = i % 2 == 0 ? 1 : -1;
  return v;
}

} // namespace

TEST(Archetypes, measured_triangulation_is_enough_for_shapes_and_operators) {
  archetypes::Wrapped all = refined(icosahedron());
  const archetypes::Measured_triangulation t(all);
  EXPECT_EQ(IT::measure_quality(t).minimum_angle, IT::measure_quality(all).minimum_angle);
  EXPECT_EQ(IT::odt_energy(t), IT::odt_energy(all));
  EXPECT_EQ(IT::total_area(t), IT::total_area(all));
  for (const auto v : vertices(t.mesh()))
    EXPECT_EQ(IT::gaussian_curvature(t, v), IT::gaussian_curvature(all, v));
  for (const auto e : edges(t.mesh()))
    EXPECT_EQ(IT::cotangent_weight(t, e), IT::cotangent_weight(all, e));
  const auto mass = IT::galerkin_mass_matrix(t);
  EXPECT_EQ((mass - IT::galerkin_mass_matrix(all)).norm(), 0);
  EXPECT_EQ((IT::lumped_mass_matrix(t) - IT::lumped_mass_matrix(all)).norm(), 0);
  EXPECT_EQ((IT::cotangent_laplacian(t) - IT::cotangent_laplacian(all)).norm(), 0);
  const IT::Reaction_diffusion equation{1, 2};
  const Eigen::VectorXd f = alternating(mass.rows());
  const Eigen::VectorXd u = IT::solve_reaction_diffusion(t, equation, mass * f);
  EXPECT_EQ(u, IT::solve_reaction_diffusion(all, equation, mass * f));
  EXPECT_EQ(IT::residual_indicators(t, equation, u, f, IT::Error_norm::energy),
            IT::residual_indicators(all, equation, u, f, IT::Error_norm::energy));
  EXPECT_EQ(IT::harmonic_green_function(t, 0), IT::harmonic_green_function(all, 0));
  EXPECT_EQ(IT::short_time_heat_kernel(t, 0, 0.1), IT::short_time_heat_kernel(all, 0, 0.1));
}

TEST(Archetypes, measured_and_numbered_triangulation_is_enough_for_vectors) {
  archetypes::Wrapped all = refined(icosahedron());
  const archetypes::Measured_and_numbered_triangulation t(all);
  EXPECT_EQ(IT::transport_along_halfedges(t), IT::transport_along_halfedges(all));
  EXPECT_EQ((IT::connection_laplacian(t, 4) - IT::connection_laplacian(all, 4)).norm(), 0);
  const auto vectors = [](const auto& x) {
    const IT::Vector_heat_method heat(x);
    const auto v = x.numbers().vertex_at(0);
    IT::Tangent_field result = heat.transport(v, {1, 2});
    for (const auto& z : heat.logarithmic_map(v)) result.push_back(z);
    return result;
  };
  EXPECT_EQ(vectors(t), vectors(all));
  // without the places of inserted vertices no chord bounds their logarithms by heat from below
  const IT::Vector_heat_method heat(t);
  const IT::Vector_heat_method heat_of_all(all);
  const IT::Surface_point p{0, {0.5, 0.25, 0.25}}, q{8, {0.2, 0.4, 0.4}};
  EXPECT_NEAR(IT::karcher_mean(heat, {{p, 1}, {q, 1}}).residual,
              IT::karcher_mean(heat_of_all, {{p, 1}, {q, 1}}).residual, 0.01);
  EXPECT_EQ(IT::voronoi_centres(heat, {p, q}, IT::parameters::maximum_rounds(3)).status,
            IT::voronoi_centres(heat_of_all, {p, q}, IT::parameters::maximum_rounds(3)).status);
  const IT::Direction_field field = IT::smoothest_direction_field(t, 4);
  EXPECT_EQ(field.powers, IT::smoothest_direction_field(all, 4).powers);
  EXPECT_EQ(IT::singularities(t, field).index, IT::singularities(all, field).index);
  EXPECT_EQ(IT::directions_along_path(t, {*halfedges(t.mesh()).begin()}).size(), 2U);
}

TEST(Archetypes, refinable_triangulation_is_enough_for_what_moves_vertices) {
  const Surface_mesh mesh = icosahedron();
  archetypes::Wrapped all(mesh), hidden(mesh);
  archetypes::Refinable_triangulation t(hidden);
  const auto length = IT::parameters::maximum_edge_length(0.7);
  EXPECT_EQ(IT::delaunay_refine(t, length).counts.circumcenters,
            IT::delaunay_refine(all, length).counts.circumcenters);
  EXPECT_EQ(IT::odt_optimize(t).energy_after, IT::odt_optimize(all).energy_after);
  const auto ones = [](const auto& x) {
    return std::vector<double>(x.numbers().face_capacity(x.mesh()), 1);
  };
  const auto rounds = IT::parameters::maximum_rounds(2);
  EXPECT_EQ(IT::adaptive_refine(t, ones, rounds).rounds.size(),
            IT::adaptive_refine(all, ones, rounds).rounds.size());
  EXPECT_GT(num_vertices(t.mesh()), num_vertices(mesh));
  EXPECT_EQ(num_vertices(t.mesh()), num_vertices(all.mesh()));
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  EXPECT_TRUE(IT::is_delaunay(t));
  Surface_mesh cells;
  const IT::Delaunay_tessellation tessellation = IT::delaunay_tessellation(t, cells);
  EXPECT_EQ(tessellation.number_of_cells, num_faces(cells));
}

TEST(Archetypes, geodesic_triangulation_is_enough_for_curves) {
  const Surface_mesh mesh = icosahedron();
  archetypes::Wrapped all(mesh), hidden(mesh);
  archetypes::Geodesic_triangulation t(hidden);
  const auto shortened = [](auto& x) {
    using T = std::remove_reference_t<decltype(x)>;
    const auto vertex = [&](std::uint32_t i) { return x.numbers().vertex_at(i); };
    IT::Curve_network<T> network(x);
    IT::Flip_log<T> log;
    network.add_path(IT::Edge_path_finder<T>(x)(vertex(0), vertex(3)));
    EXPECT_EQ(IT::shorten_curves(network, log).status, IT::Status::done);
    EXPECT_TRUE(IT::is_geodesic(network).is_geodesic());
    const double length = network.length();
    network.clear();
    typename T::Session session(x);
    log.undo(session);
    return length;
  };
  EXPECT_EQ(shortened(t), shortened(all));
}

TEST(Archetypes, numbered_triangulation_is_enough_for_places_and_transfer) {
  const Surface_mesh mesh = icosahedron();
  archetypes::Wrapped all = refined(mesh);
  const archetypes::Numbered_triangulation t(all);
  const IT::Common_subdivision s = IT::common_subdivision(all);
  const IT::Surface_point p{0, {0.5, 0.25, 0.25}};
  EXPECT_EQ(IT::surface_point(t, IT::face_location(t, p)).weights,
            IT::surface_point(all, IT::face_location(all, p)).weights);
  const auto place = IT::face_location(t, p, mesh);
  EXPECT_EQ(IT::surface_point(t, place, mesh).weights, IT::surface_point(all, place, mesh).weights);
  EXPECT_EQ(IT::point_in_space(t, p, mesh), IT::point_in_space(all, p, mesh));
  EXPECT_EQ(IT::trace_geodesic(t, p, {1, 0}, 0.5).length,
            IT::trace_geodesic(all, p, {1, 0}, 0.5).length);
  EXPECT_EQ(IT::subdivision_areas(t, s), IT::subdivision_areas(all, s));
  EXPECT_EQ((IT::subdivision_mass_matrix(t, s) - IT::subdivision_mass_matrix(all, s)).norm(), 0);
  const Eigen::VectorXd f = alternating(s.number_of_intrinsic_vertices);
  const Eigen::VectorXd g = IT::L2_transfer(t, s)(f);
  EXPECT_EQ(g, IT::L2_transfer(all, s)(f));
  EXPECT_EQ(IT::L2_distance(t, s, f, g), IT::L2_distance(all, s, f, g));
  EXPECT_EQ(IT::copy_to_input(t, f), IT::copy_to_input(all, f));
  const IT::Face_vector_transfer vectors(t, s);
  archetypes::Wrapped unchanged(mesh);
  const archetypes::Numbered_triangulation u(unchanged);
  const auto marked = IT::constrained_input_edges(
      u, mesh, CGAL::Static_boolean_property_map<Surface_mesh::Edge_index, true>());
  for (const auto e : edges(u.mesh())) EXPECT_TRUE(get(marked, e));
}

TEST(Archetypes, corresponding_triangulation_is_enough_for_queries) {
  const Surface_mesh mesh = icosahedron();
  archetypes::Wrapped all = refined(mesh);
  const archetypes::Corresponding_triangulation t(all);
  const IT::Surface_point p{0, {0.5, 0.25, 0.25}};
  const std::optional<IT::Surface_point> q = IT::locate_on_input(t, p);
  ASSERT_TRUE(q);
  EXPECT_EQ(q->weights, IT::locate_on_input(all, p)->weights);
  EXPECT_EQ(IT::locate_on_intrinsic(t, *q)->weights, IT::locate_on_intrinsic(all, *q)->weights);
  EXPECT_EQ(IT::tangent_to_input(t, {p, {1, 0}})->vector,
            IT::tangent_to_input(all, {p, {1, 0}})->vector);
  EXPECT_EQ(IT::tangent_to_intrinsic(t, {*q, {1, 0}})->vector,
            IT::tangent_to_intrinsic(all, {*q, {1, 0}})->vector);
  EXPECT_EQ(IT::trace_geodesic_on_input(t, *q, {1, 0}, 0.5).length,
            IT::trace_geodesic_on_input(all, *q, {1, 0}, 0.5).length);
  for (const auto e : edges(t.mesh()))
    EXPECT_EQ(IT::polyline(t, IT::trace_edge(t, e), mesh),
              IT::polyline(all, IT::trace_edge(all, e), mesh));
  EXPECT_EQ(IT::trace_input_edge(t, 0).points.size(), IT::trace_input_edge(all, 0).points.size());
  const IT::Common_subdivision s = IT::common_subdivision(t);
  EXPECT_EQ(s.number_of_faces(), IT::common_subdivision(all).number_of_faces());
  const Eigen::VectorXd g = alternating(static_cast<Eigen::Index>(num_vertices(mesh)));
  EXPECT_EQ(IT::copy_to_intrinsic(t, g), IT::copy_to_intrinsic(all, g));
  const IT::Tangent_field field(t.number_of_vertices(), {1, 0});
  EXPECT_EQ(IT::vectors_in_space(t, field, mesh), IT::vectors_in_space(all, field, mesh));
  const IT::Tangent_field on_mesh = IT::tangent_field_to_input(t, field, mesh);
  EXPECT_EQ(on_mesh, IT::tangent_field_to_input(all, field, mesh));
  EXPECT_EQ(IT::tangent_field_to_intrinsic(t, on_mesh, mesh),
            IT::tangent_field_to_intrinsic(all, on_mesh, mesh));
  EXPECT_EQ(IT::tangent_field_to_intrinsic(t, IT::tangent_field_to_input(t, field)).size(),
            field.size());
  EXPECT_EQ(IT::vectors_in_space(t, field, s, mesh), IT::vectors_in_space(all, field, s, mesh));
}

TEST(Archetypes, directions_are_enough_to_trace_edges_and_to_find_integers) {
  With_signposts t(icosahedron());
  IT::delaunay_refine(t, IT::parameters::maximum_edge_length(0.7));
  const archetypes::Directions directions(t.correspondence());
  EXPECT_EQ(IT::trace_edges(t, directions).begin, IT::trace_edges(t, t.correspondence()).begin);
  const auto a = IT::integer_coordinates(t, directions),
             b = IT::integer_coordinates(t, t.correspondence());
  ASSERT_EQ(a.number_of_edges(), b.number_of_edges());
  for (std::uint32_t e = 0; e < a.number_of_edges(); ++e)
    EXPECT_EQ(a.normal_coordinate(e), b.normal_coordinate(e));
}

TEST(Archetypes, curve_coordinates_and_complexes_are_enough_for_what_follows_curves_and_geodesics) {
  archetypes::Wrapped all = refined(icosahedron());
  const archetypes::Curves curves(all.correspondence());
  const archetypes::Indexed_triangulation indexed(all);
  const IT::Edge_crossings crossings = IT::edge_crossings(indexed, curves);
  EXPECT_EQ(crossings.begin, IT::edge_crossings(all, all.correspondence()).begin);
  const IT::Crossing_parameters places = IT::crossing_parameters(all, curves, crossings);
  EXPECT_EQ(places.on_intrinsic,
            IT::crossing_parameters(all, all.correspondence(), crossings).on_intrinsic);
  const archetypes::Complex complex(all.input());
  std::vector<IT::Geodesic_crossing> geodesic;
  const auto end =
      IT::internal::trace_geodesic(complex, {0, {0.5, 0.25, 0.25}}, {1, 0}, 0.5, geodesic);
  EXPECT_NEAR(end.length, 0.5, 1e-12);
  EXPECT_FALSE(IT::internal::dijkstra_ball(complex, 0, 2).empty());
  const auto nothing = [](std::uint32_t) { return false; };
  EXPECT_EQ(IT::locate_circumcenter(complex, 0, nothing).kind,
            IT::Located_circumcenter::Kind::point);
}

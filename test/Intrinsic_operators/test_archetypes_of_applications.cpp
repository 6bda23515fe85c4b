// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "triangulation_archetypes.h"

#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_operators/elements/crouzeix_raviart.h>
#include <CGAL/Intrinsic_operators/operators/hodge_stars.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include "archetypes.h"
#include "mesh_types.h"
#include "meshes.h"
#include "surface_mesh.h"

#include <CGAL/boost/graph/generators.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

// The concepts list all that applications require of a triangulation: archetypes have nothing else,
// and get the results of the triangulation that they wrap.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Rows = std::vector<std::uint32_t>;

archetypes::Wrapped refined_icosahedron() {
  Surface_mesh mesh;
  CGAL::make_icosahedron<Surface_mesh, Surface_mesh::Point>(mesh);
  archetypes::Wrapped t(mesh);
  IT::delaunay_refine(t, IT::parameters::maximum_edge_length(0.7));
  return t;
}

archetypes::Wrapped sheet() {
  archetypes::Wrapped t(meshes::rough_grid(6, 4).input());
  IT::flip_to_delaunay(t);
  return t;
}

Eigen::MatrixXd some_values(Eigen::Index rows) {
  Eigen::MatrixXd m(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) m.row(i) << std::sin(double(i)), 0.25 * double(i % 5), 1;
  return m;
}

} // namespace

TEST(Archetypes_of_applications, measured_and_numbered_triangulation_is_enough_for_distances) {
  archetypes::Wrapped all(meshes::potato(2, 5).input()); // no place of an inserted vertex is known
  IT::flip_to_delaunay(all);
  const archetypes::Measured_and_numbered_triangulation t(all);
  const auto distances = [](const auto& x) {
    IT::Heat_distance heat(x, IT::parameters::time_factor(2));
    IT::Signed_heat_distance sides(x);
    const auto v = x.numbers().vertex_at(0);
    const auto h = x.numbers().halfedge_at(0);
    const IT::Surface_point p{0, {0.5, 0.25, 0.25}}, q{0, {0.2, 0.4, 0.4}};
    Eigen::MatrixXd d(x.number_of_vertices(), 6);
    d << heat.distances(v), heat.distances(h), heat.distances(p),
        heat.distances(IT::Polyline_source{{p, q}}), sides.distances(h),
        sides.distances(IT::Polyline_source{{p, q}});
    return d;
  };
  const Eigen::MatrixXd d = distances(t);
  EXPECT_EQ(d, distances(all));
  EXPECT_TRUE(d.allFinite());
  EXPECT_GT(d.col(0).maxCoeff(), 1);
}

TEST(Archetypes_of_applications, measured_and_numbered_triangulation_is_enough_for_maps) {
  archetypes::Wrapped all = sheet();
  const archetypes::Measured_and_numbered_triangulation t(all);
  const auto maps = [](const auto& x) {
    Eigen::MatrixXd m(x.number_of_vertices(), 8);
    const auto square = IT::polygonal_border(x, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    m << IT::harmonic_map(x), IT::harmonic_map(x, square), IT::least_squares_conformal_map(x),
        IT::spectral_conformal_map(x);
    return m;
  };
  const Eigen::MatrixXd m = maps(t);
  EXPECT_EQ(m, maps(all));
  EXPECT_EQ((IT::conformal_energy(t) - IT::conformal_energy(all)).norm(), 0);
  const archetypes::Numbered_triangulation numbered(all);
  const Eigen::MatrixX2d uv = m.leftCols(2);
  EXPECT_TRUE(IT::certify_map(numbered, uv).is_injective());
  EXPECT_EQ(IT::measure_distortion(numbered, uv).mean_quasi_conformal,
            IT::measure_distortion(all, uv).mean_quasi_conformal);
  EXPECT_EQ(IT::circular_border(numbered).positions, IT::circular_border(all).positions);
}

TEST(Archetypes_of_applications, refinable_triangulation_is_enough_for_injective_maps) {
  // in a triangle, faces with all corners on a side are split
  archetypes::Wrapped first = sheet(), second = sheet();
  archetypes::Refinable_triangulation t(first);
  const auto map = [](auto& x) {
    return IT::injective_harmonic_map(x, IT::polygonal_border(x, {{0, 0}, {1, 0}, {0, 1}}));
  };
  const IT::Injective_map m = map(t), expected = map(second);
  EXPECT_GT(m.inserted, 0U);
  EXPECT_EQ(m.inserted, expected.inserted);
  EXPECT_EQ(m.status, expected.status);
  EXPECT_EQ(m.uv, expected.uv);
}

TEST(Archetypes_of_applications, measured_triangulation_is_enough_for_editing) {
  archetypes::Wrapped all = refined_icosahedron();
  const archetypes::Measured_triangulation t(all);
  const Rows handles{0, 3, 5};
  const Eigen::MatrixXd moves = some_values(3);
  const auto edited = [&](const auto& x) {
    Eigen::MatrixXd m(x.number_of_vertices(), 10);
    m << IT::Surface_deformation(x, handles).displacements(moves),
        IT::Surface_deformation(x, handles, IT::Deformation_energy::harmonic).displacements(moves),
        IT::interpolate_harmonically(x, handles, moves.col(0)),
        IT::Heat_flow(x, 0.1).step(some_values(x.number_of_vertices()));
    return m;
  };
  const Eigen::MatrixXd m = edited(t);
  EXPECT_EQ(m, edited(all));
  EXPECT_TRUE(m.allFinite());
  const Eigen::MatrixXd at_handles = m(std::vector<int>{0, 3, 5}, std::vector<int>{0, 1, 2});
  EXPECT_EQ(at_handles, moves);
}

TEST(Archetypes_of_applications, measured_and_numbered_triangulation_is_enough_for_vectors) {
  archetypes::Wrapped all = refined_icosahedron();
  const archetypes::Measured_and_numbered_triangulation t(all);
  const auto vectors = [](const auto& x) {
    const IT::Vector_heat_method heat(x);
    using Logarithm = std::vector<std::complex<double>>;
    const auto v = x.numbers().vertex_at(0);
    const IT::Surface_point p{0, {0.5, 0.25, 0.25}}, q{8, {0.2, 0.4, 0.4}};
    IT::Tangent_field all_of = heat.transport({p, {1, 2}});
    const auto add = [&](const Logarithm& more) {
      all_of.insert(all_of.end(), more.begin(), more.end());
    };
    add(heat.logarithmic_map(v, IT::Logarithm_method::polar));
    const Logarithm log = heat.logarithmic_map(p);
    add(log);
    all_of.push_back(heat.logarithm_at(log, p, q));
    for (const double y : heat.extend_scalars({{v, 2.0}})) all_of.push_back(y);
    add(IT::aligned_direction_field(x, 2, IT::Tangent_field(x.number_of_vertices(), {1, 0}), 1)
            .directions());
    return all_of;
  };
  const auto of_archetype = vectors(t), of_all = vectors(all);
  ASSERT_EQ(of_archetype.size(), of_all.size());
  const std::size_t n = all.number_of_vertices(); // after transport, polar logarithms
  for (std::size_t i = 0; i < of_all.size(); ++i) {
    ASSERT_TRUE(std::isfinite(std::abs(of_all[i]))) << i;
    if (i >= n && i < 2 * n) { // no places of inserted vertices: no chord bounds them from below
      EXPECT_GE(std::abs(of_all[i]), std::abs(of_archetype[i])) << i;
      EXPECT_LE(std::abs(of_all[i] * std::conj(of_archetype[i])) -
                    std::real(of_all[i] * std::conj(of_archetype[i])),
                1e-14)
          << i;
    } else {
      EXPECT_EQ(of_archetype[i], of_all[i]) << i;
    }
  }
  const archetypes::Numbered_triangulation numbered(all);
  const auto v = all.numbers().vertex_at(0);
  EXPECT_EQ(IT::exponential_map(numbered, v, {0.3, 0.2}).length,
            IT::exponential_map(all, v, {0.3, 0.2}).length);
  EXPECT_EQ(IT::tangent_vector(numbered, v, {0.3, 0.2}).vector,
            IT::tangent_vector(all, v, {0.3, 0.2}).vector);
}

TEST(Archetypes_of_applications, corresponding_triangulation_is_enough_for_principal_directions) {
  const Surface_mesh mesh = meshes::surface_mesh<Surface_mesh>(meshes::potato(2, 5));
  archetypes::Wrapped all(mesh);
  IT::flip_to_delaunay(all);
  const archetypes::Corresponding_triangulation t(all);
  EXPECT_EQ(IT::principal_directions(t, mesh), IT::principal_directions(all, mesh));
}

TEST(Archetypes_of_applications, measured_triangulation_is_enough_for_forms) {
  archetypes::Wrapped all = refined_icosahedron();
  const archetypes::Measured_triangulation t(all);
  EXPECT_EQ(IT::hodge_star_0(t), IT::hodge_star_0(all));
  EXPECT_EQ(IT::hodge_star_1(t), IT::hodge_star_1(all));
  EXPECT_EQ(IT::hodge_star_2(t), IT::hodge_star_2(all));
  EXPECT_EQ((IT::exterior_derivative_0(t) - IT::exterior_derivative_0(all)).norm(), 0);
  EXPECT_EQ((IT::exterior_derivative_1(t) - IT::exterior_derivative_1(all)).norm(), 0);
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

// The same new lengths for every type of mesh.

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Gluing_map;
using IT::Tensor_norm;
using IT::Triangle_inequality;

namespace {

using Vector = std::array<double, 3>;
using Planar = IT::Unscaled_vector;

using properties::expect_near;

template <class Mesh>
class Scale_metric_of : public ::testing::Test {};
TYPED_TEST_SUITE(Scale_metric_of, All_meshes);

const auto smooth = [](const Vector& p) { return std::sin(p[0] + 2 * p[1]) + 0.3 * p[2]; };

TYPED_TEST(Scale_metric_of, this_type_of_mesh_is_the_same_as_of_a_gluing_with_points) {
  const meshes::Mesh m = meshes::potato(2, 6);
  const auto point = [&m](Gluing_map::Vertex v) { return m.points[v.index]; };
  const Tensor_norm g = Tensor_norm::from_stretches({1, 3}, 1.25, 1);
  const auto spatial = [](auto, const Vector& v) { return meshes::norm({1.5 * v[0], v[1], v[2]}); };
  const auto repair = IT::parameters::triangle_inequality(Triangle_inequality::repair).margin(1e-3);
  const auto conformal = IT::scale_conformally(
      m.input(), [&](auto v) { return smooth(point(v)); }, repair);
  const auto planar = IT::scale_by_norm(
      m.input(), [&](auto, const Planar& v) { return g(v); }, repair);
  const auto space = IT::scale_by_norm_in_space(m.input(), spatial, repair);
  if constexpr (!std::is_same_v<TypeParam, Gluing_map>) {
    const TypeParam mesh = meshes::mesh_of<TypeParam>(m);
    using Vertex = typename boost::graph_traits<TypeParam>::vertex_descriptor;
    using Face = typename boost::graph_traits<TypeParam>::face_descriptor;
    using Adaptor = IT::Mesh_adaptor<TypeParam>;
    const auto u = [&](Vertex v) {
      return smooth(Adaptor::coordinates(get(Adaptor::point_map(mesh), v)));
    };
    EXPECT_EQ(IT::scale_conformally(mesh, u, repair).input.squared_lengths,
              conformal.input.squared_lengths);
    EXPECT_EQ(IT::scale_by_norm(
                  mesh, [&](Face, const Planar& v) { return g(v); }, repair)
                  .input.squared_lengths,
              planar.input.squared_lengths);
    EXPECT_EQ(IT::scale_by_norm_in_space(mesh, spatial, repair).input.squared_lengths,
              space.input.squared_lengths);
  }
  // triangulations on this type of mesh: from lengths that are rounded
  using T = IT::Intrinsic_triangulation<TypeParam, IT::Euclidean_traits<double>>;
  const T t(m.input());
  using Vertex = typename T::vertex_descriptor;
  const auto u = [&](Vertex v) { return smooth(m.points[t.input_vertex(v)]); };
  expect_near(IT::scale_conformally(t, u, repair).input.squared_lengths,
              conformal.input.squared_lengths, 1e-13);
  expect_near(IT::scale_by_norm(
                  t, [&](auto, const Planar& v) { return g(v); }, repair)
                  .input.squared_lengths,
              planar.input.squared_lengths, 1e-13);
}

} // namespace

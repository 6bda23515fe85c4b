// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_types.h"
#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <vector>

// The same flips on every type of mesh, as what is flipped and as the input.

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Mesh>
class Delaunay_on : public ::testing::Test {};
TYPED_TEST_SUITE(Delaunay_on, All_meshes);

std::vector<meshes::Mesh> shapes() {
  return {meshes::box(2, 1, 2), meshes::sheared_grid(5, 6, 3), meshes::rough_grid(6, 1),
          meshes::potato(2, 2), meshes::folded_lattice(4, 4, 1)};
}

TYPED_TEST(Delaunay_on, this_type_of_mesh_is_the_same_as_on_a_gluing_map) {
  for (const meshes::Mesh& m : shapes()) {
    IT::Intrinsic_triangulation<> expected(m.input());
    IT::Intrinsic_triangulation<TypeParam> t(m.input());
    const auto flips = IT::flip_to_delaunay(expected).flips;
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, flips);
    EXPECT_EQ(properties::tessellation(t), properties::tessellation(expected));
    EXPECT_EQ(properties::laplacian(t), properties::laplacian(expected));
  }
}

TYPED_TEST(Delaunay_on, this_type_of_mesh_as_input_is_the_same) {
  if constexpr (!std::is_same_v<TypeParam, IT::Gluing_map>)
    for (const meshes::Mesh& m : shapes()) {
      const TypeParam mesh = meshes::mesh_of<TypeParam>(m);
      IT::Intrinsic_triangulation<> expected(m.input()), t(mesh);
      IT::flip_to_delaunay(expected);
      IT::flip_to_delaunay(t);
      EXPECT_EQ(properties::tessellation(t), properties::tessellation(expected));
      EXPECT_EQ(properties::laplacian(t), properties::laplacian(expected));
    }
}

// OpenMesh's own reader and CGAL's point map of OpenMesh meshes round to float.
TEST(Delaunay_on_OpenMesh, reads_files_in_full) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "doubles.off";
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const meshes::Mesh m = meshes::rough_grid(9, seed);
    std::ofstream file(path);
    file.precision(17);
    file << "OFF\n" << m.points.size() << ' ' << m.triangles.size() << " 0\n";
    for (const auto& p : m.points) file << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& f : m.triangles) file << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << '\n';
    file.close();
    const IT::Triangle_soup soup = IT::read_triangle_soup(path);
    OpenMesh_triangles mesh;
    std::vector<OpenMesh_triangles::VertexHandle> v;
    for (const auto& p : soup.points) v.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
    for (const auto& f : soup.triangles) mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
    const IT::Intrinsic_input input(mesh);
    for (std::size_t i = 0; i < v.size(); ++i)
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(mesh.point(v[i])[c], m.points[i][c]) << "seed " << seed;
        EXPECT_EQ(input.points[i][c], m.points[i][c]) << "seed " << seed;
      }
    IT::Intrinsic_triangulation<> expected(m.input());
    IT::Intrinsic_triangulation<OpenMesh_triangles> t(mesh);
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, IT::flip_to_delaunay(expected).flips);
    // edges have other numbers, so that flips come in another order and lengths are rounded
    // differently
    SCOPED_TRACE(seed);
    properties::expect_same_tessellation(properties::tessellation(t),
                                         properties::tessellation(expected), 1e-13);
  }
  std::filesystem::remove(path);
}

} // namespace

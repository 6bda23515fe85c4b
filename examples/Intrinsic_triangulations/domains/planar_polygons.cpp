// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes bent polygons planar: a saddle of quadrilaterals, whose Laplacian is as symmetric as the
// saddle.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

// four quadrilaterals around vertex 4: z = x y
Mesh saddle() {
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (const int y : {-1, 0, 1})
    for (const int x : {-1, 0, 1}) v.push_back(mesh.add_vertex({1.0 * x, 1.0 * y, 1.0 * x * y}));
  for (const std::size_t i : {0U, 1U, 3U, 4U}) mesh.add_face(v[i], v[i + 1], v[i + 4], v[i + 3]);
  return mesh;
}

int main() {
  const Mesh mesh = saddle();
  //! [planar]
  Triangulation t(
      IT::Intrinsic_input(mesh, IT::Mollification::automatic, IT::Nonplanar_polygons::planar));
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  const IT::Polygon_report& report = t.input().planar_polygons().report;
  std::cout << report.flattened << " quadrilaterals became planar, angles changed by at most "
            << report.largest_angle_change << '\n';
  //! [planar]

  //! [positions]
  // where the vertices of the subdivision are: on the curved quadrilaterals between their sides
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const std::vector<std::array<double, 3>> points = IT::positions(s, mesh, t.input());
  //! [positions]
  std::cout << points.size() << " vertices\n";
  bool is_symmetric = true; // symmetries exchange vertices 1 and 3, 5 and 7, 1 and 7, 3 and 5
  for (const int v : {3, 5, 7})
    is_symmetric = is_symmetric && std::abs(laplacian.coeff(4, v) - laplacian.coeff(4, 1)) < 1e-12;
  return is_symmetric && report.flattened == 4 && report.kept == 0 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds triangulations from matrices of points and of triples of vertices, and from triples and
// lengths.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  // two faces are a flat quadrilateral with its long diagonal, the two others leave its plane
  Eigen::MatrixX3d V(5, 3);
  Eigen::MatrixX3i F(4, 3);
  V << -4, 0, 0, 4, 0, 0, 0, 1, 0, 0, -1, 0, 5, 3, 2;
  F << 0, 1, 2, 1, 0, 3, 2, 1, 4, 1, 3, 4;

  //! [arrays]
  IT::Triangle_soup soup;
  for (const auto& v : V.rowwise()) soup.points.push_back({v[0], v[1], v[2]});
  for (const auto& f : F.rowwise())
    soup.triangles.push_back({static_cast<std::uint32_t>(f[0]), static_cast<std::uint32_t>(f[1]),
                              static_cast<std::uint32_t>(f[2])});

  IT::Intrinsic_triangulation<> t(soup); // throws Invalid_input if faces do not fit together
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t); // rows as in V
  //! [arrays]
  std::cout << result.flips << " flips\n" << Eigen::MatrixXd(laplacian) << '\n';

  // a tetrahedron, whose edge of vertices 0 and 1 is longer than any in space can be
  const std::array<std::array<double, 4>, 4> length{
      {{0, 3.5, 2, 2}, {3.5, 0, 2, 2}, {2, 2, 0, 2}, {2, 2, 2, 0}}};
  //! [lengths]
  const std::vector<std::array<std::uint32_t, 3>> triangles{
      {0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  const IT::Gluing_map gluing(IT::gluing_from_triangles(4, triangles));
  std::vector<double> squared_lengths; // in the order of edges(gluing)
  for (const auto e : edges(gluing)) {
    const double l = length[source(e, gluing).index][target(e, gluing).index];
    squared_lengths.push_back(l * l);
  }
  IT::Intrinsic_triangulation<> tetrahedron(IT::Intrinsic_input(gluing, squared_lengths));
  //! [lengths]
  const IT::Flip_to_delaunay_result flips = IT::flip_to_delaunay(tetrahedron);
  std::cout << "tetrahedron: " << flips.flips << " flips, "
            << IT::check_delaunay(tetrahedron).cocircular_edges.size() << " ties\n";
  return result.flips == 1 && IT::is_delaunay(t) && IT::is_delaunay(tetrahedron) ? 0 : 1;
}

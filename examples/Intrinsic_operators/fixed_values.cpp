// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the harmonic function exp(x) cos(y) on a square of needles from its values on the border: on the mesh, and on the intrinsic
// refinement of it. Solving is one statement.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

Eigen::VectorXd truth(const Eigen::MatrixX2d& points) {
  return points.col(0).array().exp() * points.col(1).array().cos();
}

// the greatest error inside, if values on the border are right
double error(const Triangulation& t, const Eigen::MatrixX2d& corners) {
  const Eigen::MatrixX2d points = IT::copy_to_intrinsic(t, corners); // of inserted vertices too
  //! [solve]
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  std::vector<std::uint32_t> border; // rows of vertices
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh())) border.push_back(t.input_vertex(target(h, t.mesh())));
  Eigen::VectorXd values(border.size());
  for (std::size_t i = 0; i < border.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = truth(points)[border[i]];

  const Eigen::VectorXd u = IT::solve_with_fixed_values(
      laplacian, Eigen::VectorXd::Zero(laplacian.rows()), border, values);
  //! [solve]
  return (u - truth(points)).lpNorm<Eigen::Infinity>();
}

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) / 4, y = static_cast<double>(j) / 64;
    return Point(x, y + x / 3, 0);
  };
  CGAL::make_grid(4, 64, mesh, corner, true);
  Eigen::MatrixX2d corners(mesh.number_of_vertices(), 2);
  for (const Mesh::Vertex_index v : mesh.vertices())
    corners.row(v) << mesh.point(v).x(), mesh.point(v).y();

  Triangulation t(mesh);
  const double before = error(t, corners);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30).maximum_edge_length(1. / 32));
  const double after = error(t, corners);
  std::cout << "greatest error on the mesh: " << before << ", on the refinement: " << after << '\n';
  return after < before / 4 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem on a mesh of needles and on its intrinsic refinement, takes the second solution back
// to the mesh, and compares both with the truth: u = cos(pi x) cos(pi y) on a square, without flux at
// the border. Refining, solving, and the nearest function on the mesh are three statements.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/IterativeLinearSolvers>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

Eigen::VectorXd truth(const Eigen::MatrixX2d& points) {
  return (std::numbers::pi * points.array()).cos().rowwise().prod();
}

//! [solve]
// -div grad u = f with mean zero, where f is given at the vertices
Eigen::VectorXd solve_poisson(Triangulation& t, const Eigen::VectorXd& f) {
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> mass = IT::galerkin_mass_matrix(t);
  Eigen::VectorXd load = mass * f;
  load.array() -= load.mean(); // what rounding and interpolation left: constants are the kernel
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> cg(laplacian);
  Eigen::VectorXd u = cg.solve(load);
  u.array() -= (mass * u).sum() / mass.sum();
  return u;
}
//! [solve]

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) {
    return Point(static_cast<double>(i) / 4, static_cast<double>(j) / 64, 0);
  };
  CGAL::make_grid(4, 64, mesh, corner, true);
  Eigen::MatrixX2d points(mesh.number_of_vertices(), 2);
  for (const Mesh::Vertex_index v : mesh.vertices())
    points.row(v) << mesh.point(v).x(), mesh.point(v).y();
  const double eigenvalue = 2 * std::numbers::pi * std::numbers::pi;

  Triangulation coarse(mesh);
  const Eigen::VectorXd u_coarse = solve_poisson(coarse, eigenvalue * truth(points));
  //! [refine]
  const auto f = [&](const Triangulation& t) -> Eigen::VectorXd { // the right side, at all vertices
    return eigenvalue * truth(IT::copy_to_intrinsic(t, points));  // coordinates are linear: exact
  };
  Triangulation fine(mesh);
  IT::delaunay_refine(fine, IT::parameters::minimum_angle(30).maximum_edge_length(1. / 32));
  const Eigen::VectorXd u_fine = solve_poisson(fine, f(fine));
  const Eigen::VectorXd nearest = IT::L2_transfer(fine, IT::common_subdivision(fine))(u_fine);
  //! [refine]
  const Eigen::VectorXd copied = IT::copy_to_input(fine, u_fine);
  const auto error = [&](const Eigen::VectorXd& u) {
    return (u - truth(points)).lpNorm<Eigen::Infinity>();
  };
  std::cout << points.rows() << " vertices, refined " << u_fine.size()
            << "\ngreatest error at vertices of the mesh\n  solved on the mesh:       "
            << error(u_coarse) << "\n  solved on the refinement: " << error(copied)
            << ", nearest function " << error(nearest) << '\n';
  return error(copied) < error(u_coarse) / 4 && error(nearest) < error(u_coarse) ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves -Laplace u + u = f on a square with linear and with quadratic elements, and evaluates the
// quadratic solution at points.

#include <CGAL/Intrinsic_operators/elements/quadratic.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

double solution(const Kernel::Point_3& p) {
  return std::cos(std::numbers::pi * p.x()) * std::cos(std::numbers::pi * p.y());
}

int main() {
  Mesh mesh;
  CGAL::make_grid(
      16, 16, mesh,
      [](std::size_t i, std::size_t j) {
        return Kernel::Point_3(static_cast<double>(i) / 16, static_cast<double>(j) / 16, 0);
      },
      true);
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);

  //! [solve]
  const Eigen::SparseMatrix<double> mass = IT::quadratic_mass_matrix(t);
  Eigen::VectorXd f(mass.rows()); // a value per vertex, and after them one per midpoint of an edge
  const auto point = [&](auto v) { return mesh.point(Mesh::Vertex_index(t.input_vertex(v))); };
  for (const auto v : vertices(t.mesh())) f[t.input_vertex(v)] = solution(point(v));
  for (const auto e : edges(t.mesh()))
    f[static_cast<Eigen::Index>(t.number_of_vertices() + t.index(e))] =
        solution(CGAL::midpoint(point(source(halfedge(e, t.mesh()), t.mesh())),
                                point(target(halfedge(e, t.mesh()), t.mesh()))));
  f *= 2 * std::numbers::pi * std::numbers::pi + 1;
  const Eigen::VectorXd u =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(IT::quadratic_laplacian(t) + mass)
          .solve(mass * f);
  const double at_centre = // of a face of the mesh
      IT::quadratic_value(t, u, *IT::locate_on_intrinsic(t, {0, {1. / 3, 1. / 3, 1. / 3}}));
  //! [solve]

  const Eigen::SparseMatrix<double> linear_mass = IT::galerkin_mass_matrix(t);
  const Eigen::VectorXd linear =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(IT::cotangent_laplacian(t) + linear_mass)
          .solve(linear_mass * f.head(linear_mass.rows()));
  double error = 0, linear_error = 0;
  for (const auto v : vertices(t.mesh())) {
    error = std::max(error, std::abs(u[t.input_vertex(v)] - solution(point(v))));
    linear_error = std::max(linear_error, std::abs(linear[t.input_vertex(v)] - solution(point(v))));
  }
  std::cout << "greatest error at vertices: " << linear_error << " with linear elements, " << error
            << " with quadratic ones, whose value at the centre of a face is " << at_centre << '\n';
  return error < linear_error / 10 ? 0 : 1;
}

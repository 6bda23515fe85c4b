// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a surface coarse, proves by how much lengths change, solves there, and takes the solution
// back.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_simplification.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  constexpr int n = 30;
  Mesh mesh;
  CGAL::make_grid(
      n, n, mesh,
      [](int x, int y) { return Mesh::Point(x, y, std::sin(0.3 * x) * std::cos(0.25 * y)); }, true);

  //! [simplify]
  IT::Simplify_options options;
  options.stretch = 1.1; // no length changes by more than a tenth
  const IT::Simplification coarse = IT::simplify(mesh, options);
  std::cout << coarse.kept.size() << " of " << num_vertices(mesh) << " vertices are left; "
            << "lengths are multiplied by " << coarse.stretch.lower << " to "
            << coarse.stretch.upper << '\n';
  //! [simplify]

  //! [solve]
  const IT::Corresponding_triangulation t(coarse.surface); // as of any other surface
  const Eigen::SparseMatrix<double> stiffness = IT::cotangent_laplacian(t),
                                    mass = IT::lumped_mass_matrix(t);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stiffness + mass);
  const Eigen::VectorXd on_coarse = solver.solve(mass * Eigen::VectorXd::Ones(mass.rows()));
  const Eigen::VectorXd on_fine = IT::prolongation(coarse) * on_coarse; // by fine vertices
  //! [solve]

  std::cout << "the constant solution is " << on_fine.minCoeff() << " to " << on_fine.maxCoeff()
            << '\n';
  return coarse.stretch.upper <= 1.1 && std::abs(on_fine.maxCoeff() - 1) < 1e-9 ? 0 : 1;
}

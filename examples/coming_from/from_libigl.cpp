// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What programs do with matrices V and F by libigl: Laplacians, lengths, distances, solutions,
// frequencies, maps to the plane.

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <Eigen/Core>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  constexpr int m = 6, n = 40; // a sheet that is bent, cut into thin faces
  Eigen::MatrixX3d V((m + 1) * (n + 1), 3);
  Eigen::MatrixX3i F(2 * m * n, 3);
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) V.row(i * (n + 1) + j) << i, 0.1 * j + 0.4 * i, std::sin(0.3 * i);
  for (int i = 0, f = 0; i < m; ++i)
    for (int j = 0; j < n; ++j, f += 2) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      F.row(f) << a, b, b + 1;
      F.row(f + 1) << a, b + 1, a + 1;
    }

  //! [laplacian]
  const IT::Triangle_soup soup = IT::triangle_soup(V.rowwise(), F.rowwise());
  IT::Intrinsic_triangulation<> t(soup);
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> L = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> M = IT::lumped_mass_matrix(t);
  //! [laplacian]

  //! [lengths]
  Eigen::MatrixX3i F_new(F.rows(), 3);
  Eigen::MatrixX3d l(F.rows(), 3); // opposite the corners
  Eigen::Index row = 0;
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh())) {
      F_new(row, k) = static_cast<int>(t.input_vertex(source(h, t.mesh())));
      l(row, k) = t.length(edge(next(h, t.mesh()), t.mesh()));
    }
    ++row;
  }
  //! [lengths]

  //! [vertex]
  const auto vertex = [&](std::uint32_t i) { return IT::vertex_of_row(t, i); };
  //! [vertex]
  //! [heat]
  IT::Heat_distance heat(t); // factors once
  const Eigen::VectorXd d = heat.distances(vertex(0));
  //! [heat]
  //! [exact]
  const IT::Polyhedral_distance distance(t, vertex(0));
  const std::vector<double> exact = distance.distances(); // a value per row of V
  //! [exact]

  //! [fixed]
  const std::vector<std::uint32_t> b{0, n, m * (n + 1)};
  const Eigen::Vector3d bc(0, 1, 2);
  const Eigen::VectorXd u = IT::solve_with_fixed_values(L, Eigen::VectorXd::Zero(L.rows()), b, bc);
  //! [fixed]
  //! [eigen]
  const IT::Eigenpairs pairs = IT::smallest_eigenpairs(L, M, 5);
  //! [eigen]
  //! [maps]
  const Eigen::MatrixX2d to_disk = IT::harmonic_map(t);
  const Eigen::MatrixX2d conformal = IT::least_squares_conformal_map(t);
  //! [maps]

  const Eigen::Map<const Eigen::VectorXd> true_distance(exact.data(), d.size());
  const double error = (d - true_distance).cwiseAbs().mean() / d.maxCoeff();
  const double trace_of_lengths = l.rowwise().sum().sum();
  std::cout << "distances differ by " << error << ", the second frequency is " << pairs.values[1]
            << ", values reach " << u.maxCoeff() << ", sides sum to " << trace_of_lengths
            << ", maps have " << to_disk.rows() + conformal.rows() << " rows\n";
  return error < 0.05 && F_new.maxCoeff() == V.rows() - 1 && u.maxCoeff() <= 2 ? 0 : 1;
}

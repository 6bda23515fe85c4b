// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines three faces that meet at an edge, and lets heat flow from one to the others.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

int main() {
  const std::vector<std::array<double, 3>> points{
      {0, 0, 0}, {4, 0, 0}, {2, 3, 0}, {2, 0, 3}, {2, -2, -2}};
  const std::vector<std::array<int, 3>> faces{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};

  //! [refine]
  Triangulation t(IT::make_domain(IT::triangle_soup(points, faces)).input);
  IT::delaunay_refine(t, IT::parameters::maximum_edge_length(0.2));

  // matrices have a row per point, whatever the number of its copies
  const Eigen::SparseMatrix<double> mass = IT::lumped_mass_matrix(t);
  const Eigen::VectorXd start = Eigen::VectorXd::Unit(t.number_of_vertices(), 2); // heat at a tip
  const Eigen::SparseMatrix<double> step = mass + 0.5 * IT::cotangent_laplacian(t);
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(step);
  const Eigen::VectorXd temperature = solver.solve(start); // after time 0.5
  //! [refine]

  const double heat = (mass * temperature).sum();
  std::cout << t.number_of_vertices() << " points, " << num_vertices(t.mesh()) << " vertices\n"
            << "at the tips: " << temperature.segment<3>(2).transpose() << "; heat " << heat
            << '\n';
  const bool is_kept = std::abs(heat - 1) < 1e-9 && temperature.minCoeff() > 0;
  return is_kept && t.number_of_vertices() < num_vertices(t.mesh()) ? 0 : 1;
}

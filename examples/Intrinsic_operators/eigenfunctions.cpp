// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Frequencies of a square drum from a mesh of needles, on the mesh and on an intrinsic refinement of it: pi^2 (p^2 + q^2).

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/solvers/eigenpairs.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

template <class Triangulation>
Eigen::VectorXd frequencies(const Triangulation& t) {
  //! [eigen]
  const IT::Eigenpairs pairs =
      IT::smallest_eigenpairs(IT::cotangent_laplacian(t), IT::galerkin_mass_matrix(t), 6);
  return pairs.values; // pairs.vectors has the functions
  //! [eigen]
}

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) / 8, y = static_cast<double>(j) / 100;
    return CGAL::Simple_cartesian<double>::Point_3(x, y, 0);
  };
  CGAL::make_grid(8, 100, mesh, corner, true);
  IT::Corresponding_triangulation t(mesh);
  const Eigen::VectorXd on_mesh = frequencies(t);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30));
  const Eigen::VectorXd refined = frequencies(t);

  constexpr double truth[] = {0, 1, 1, 2, 4, 4}; // times pi^2
  double before = 0, after = 0;
  for (Eigen::Index k = 0; k < 6; ++k) {
    const double wanted = truth[k] * std::numbers::pi * std::numbers::pi;
    before = std::max(before, std::abs(on_mesh[k] - wanted));
    after = std::max(after, std::abs(refined[k] - wanted));
  }
  std::cout << "greatest error on the mesh " << before << ", on the refinement " << after << '\n';
  return after < before ? 0 : 1;
}

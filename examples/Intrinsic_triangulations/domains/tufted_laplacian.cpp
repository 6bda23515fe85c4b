// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds a Laplacian on faces that do not form a manifold: three meet at an edge, and a border edge faces an
// obtuse angle.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <array>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  //! [domain]
  const std::vector<std::array<double, 3>> points{{0, 0, 0}, {4, 0, 0},   {2, 1, 0},
                                                  {2, 0, 1}, {1, -2, -1}, {5, -2, -1}};
  const std::vector<std::vector<int>> faces{{0, 1, 2}, {0, 1, 3}, {0, 1, 5, 4}}; // polygons, too

  IT::Domain domain = IT::make_domain(IT::triangle_soup(points, faces));
  std::cout << domain.report.reason << '\n'; // edge (0, 1) has 3 faces (0, 1, 2)
  IT::Intrinsic_triangulation<> t(std::move(domain.input));
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t); // a row per point
  //! [domain]
  std::cout << laplacian.rows() << " rows\n";
  bool is_good = domain.report.kind == IT::Domain_kind::tufted_cover && laplacian.rows() == 6;
  for (int c = 0; c < laplacian.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, c); i; ++i)
      is_good = is_good && (i.row() == c || i.value() <= 0); // no weight is negative

  //! [asked]
  // a mesh with border: as it is, and as a surface without border that covers it twice
  const std::vector<std::array<int, 3>> obtuse{{0, 1, 2}};
  const IT::Triangle_soup soup = IT::triangle_soup(points, obtuse);
  IT::Intrinsic_triangulation<> one(soup);
  IT::Intrinsic_triangulation<> both(IT::make_domain(soup, IT::Domain_kind::tufted_cover).input);
  IT::flip_to_delaunay(both);
  const double weight = -IT::cotangent_laplacian(one).coeff(0, 1);         // -3/8
  const double tufted_weight = -IT::cotangent_laplacian(both).coeff(0, 1); // 0
  //! [asked]
  std::cout << weight << ' ' << tufted_weight << '\n';
  return is_good && weight < 0 && tufted_weight == 0 ? 0 : 1;
}

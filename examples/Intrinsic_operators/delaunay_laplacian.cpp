// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a mesh with bad triangles to its intrinsic Delaunay triangulation and compares Laplacians, which are one
// statement each.

//! [include]
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
//! [include]

// smallest weight of an edge: negative weights break the maximum principle
double smallest_weight(const Eigen::SparseMatrix<double>& laplacian) {
  double smallest = 0;
  for (int k = 0; k < laplacian.outerSize(); ++k)
    for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, k); i; ++i)
      if (i.row() != i.col()) smallest = std::min(smallest, -i.value());
  return smallest;
}

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }
  //! [delaunay]
  IT::Intrinsic_triangulation<> triangulation(mesh); // exact predicates, connectivity of its own
  std::cout << "smallest weight before: " << smallest_weight(IT::cotangent_laplacian(triangulation))
            << '\n';

  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(triangulation);

  // rows and columns are numbered like the vertices of the input mesh
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(triangulation);
  //! [delaunay]
  std::cout << "flips: " << result.flips
            << "\nsmallest weight after: " << smallest_weight(laplacian) << '\n';
  return smallest_weight(laplacian) < 0; // never: the triangulation is Delaunay, exactly
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Computes a function on the intrinsic Delaunay triangulation of a mesh with bad triangles, and takes it
// back to the mesh: copied at vertices, and nearest in the L2 norm.

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/SparseCholesky>

#include <cmath>
#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }
  Triangulation triangulation(mesh);
  IT::flip_to_delaunay(triangulation);

  // heat that starts at vertex 0, after a short time
  const Eigen::SparseMatrix<double> mass = IT::galerkin_mass_matrix(triangulation);
  const double time = 1e-3 * mass.sum();
  const Eigen::SparseMatrix<double> implicit_step =
      mass + time * IT::cotangent_laplacian(triangulation);
  const Eigen::VectorXd start = Eigen::VectorXd::Unit(mass.rows(), 0);
  const Eigen::VectorXd heat = Eigen::SimplicialLDLT(implicit_step).solve(start);

  //! [transfer]
  const IT::Common_subdivision subdivision = IT::common_subdivision(triangulation);
  const Eigen::VectorXd copied = IT::copy_to_input(triangulation, heat);
  const IT::L2_transfer transfer(triangulation,
                                 subdivision); // factored for any number of functions
  const Eigen::VectorXd nearest = transfer(heat);
  //! [transfer]

  const double error_copied = IT::L2_distance(triangulation, subdivision, heat, copied);
  const double error_nearest = IT::L2_distance(triangulation, subdivision, heat, nearest);
  const double norm = std::sqrt(heat.dot(mass * heat));
  std::cout << "relative distance to the function on the intrinsic triangulation"
            << "\n  copied:  " << error_copied / norm << "\n  nearest: " << error_nearest / norm
            << "\nintegral: " << (mass * heat).sum()
            << "\n  of nearest: " << (transfer.mass_matrix() * nearest).sum() << '\n';
  return error_nearest > error_copied + 1e-12 * norm; // never: it is the nearest
}

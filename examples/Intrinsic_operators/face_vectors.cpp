// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the gradient of a harmonic function on the intrinsic Delaunay triangulation of a mesh, as
// vectors on faces and as a discrete
// differential form, and takes the vectors back to the faces of the mesh.

#include <CGAL/Intrinsic_operators/operators/Face_gradient.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/hodge_stars.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

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
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const Eigen::SparseMatrix<double> l = IT::cotangent_laplacian(t);
  const std::array<std::uint32_t, 2> ends{0, static_cast<std::uint32_t>(mesh.num_vertices() / 2)};
  const Eigen::VectorXd u =
      IT::solve_with_fixed_values(l, Eigen::VectorXd::Zero(l.rows()), ends, Eigen::Vector2d(0, 1));

  //! [gradient]
  const IT::Face_gradient operators(t);
  const Eigen::VectorXcd gradient = operators.gradient(u); // a vector per intrinsic face
  const Eigen::VectorXd divergence = operators.divergence(gradient);
  const Eigen::VectorXd form = IT::exterior_derivative_0(t) * u; // a value per intrinsic edge
  const double energy = form.dot(IT::hodge_star_1(t).cwiseProduct(form));
  //! [gradient]

  //! [forms]
  const Eigen::VectorXd curl = // of the form about each face, by its area: zero
      IT::hodge_star_2(t).cwiseProduct(IT::exterior_derivative_1(t) * form);
  const Eigen::VectorXd laplacian = // at each vertex, by its area
      (IT::exterior_derivative_0(t).transpose() * IT::hodge_star_1(t).cwiseProduct(form))
          .cwiseQuotient(IT::hodge_star_0(t));
  const Eigen::VectorXd curl_of_vectors = operators.curl(gradient); // zero inside
  //! [forms]

  //! [transfer]
  const IT::Face_vector_transfer transfer(t, IT::common_subdivision(t));
  const std::vector<std::complex<double>> on_mesh =
      transfer.to_input({gradient.begin(), gradient.end()}); // a vector per face of the mesh
  //! [transfer]

  double energy_of_vectors = 0;
  for (std::size_t f = 0; f < static_cast<std::size_t>(operators.number_of_faces()); ++f)
    energy_of_vectors += operators.area(f) * std::norm(gradient[static_cast<Eigen::Index>(f)]);
  double greatest = 0;
  for (const std::complex<double>& v : on_mesh) greatest = std::max(greatest, std::abs(v));
  std::cout << "Dirichlet energy: " << energy << ", of the vectors: " << energy_of_vectors
            << "\nsources: " << divergence[0] << " at vertex 0"
            << "\ngreatest gradient on the mesh: " << greatest
            << "\ngreatest curl: " << curl.cwiseAbs().maxCoeff()
            << ", of the vectors at vertex 0: " << curl_of_vectors[0]
            << "\nLaplacian at vertex 0: " << laplacian[0] << '\n';
  return std::abs(energy - energy_of_vectors) > 1e-9 * energy;
}

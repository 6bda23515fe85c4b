// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a Poisson problem with given values along two geodesics, over a triangulation that was refined around them: they run
// across faces of the mesh, which stays as it is.
// Usage: values_on_curves [MESH.off]

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Fixed_values_solver.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  const auto vertex = [&](std::size_t quarter) {
    const Mesh::Vertex_index v(static_cast<std::uint32_t>(quarter * (num_vertices(mesh) - 1) / 4));
    return IT::vertex_on_intrinsic(t, v, mesh);
  };

  //! [refine]
  IT::Curve_network<Triangulation> network(t);
  IT::Edge_path_finder<Triangulation> shortest(t);
  network.add_path(shortest(vertex(0), vertex(1)));
  network.add_path(shortest(vertex(2), vertex(3)));
  IT::shorten_curves(network);
  std::cout << "curves of length " << network.length(0) << " and " << network.length(1) << '\n';

  const auto labels = IT::curve_labels(network); // of edges: 1 and 2 along the curves, else 0
  IT::delaunay_refine(
      t, IT::parameters::minimum_angle(25).conforming(true).edge_is_constrained_map(labels));
  //! [refine]

  //! [solve]
  std::vector<std::uint32_t> rows; // of vertices on the curves
  std::vector<double> given;       // 0 along the first one, 1 along the second one
  for (const auto h : halfedges(t.mesh()))
    if (const std::uint32_t label = get(labels, edge(h, t.mesh())); label != 0) {
      rows.push_back(t.input_vertex(target(h, t.mesh())));
      given.push_back(label - 1);
    }
  const Eigen::VectorXd values =
      Eigen::VectorXd::Map(given.data(), static_cast<Eigen::Index>(given.size()));
  const Eigen::SparseMatrix<double> laplacian = IT::cotangent_laplacian(t);
  const Eigen::VectorXd u =
      IT::solve_with_fixed_values(laplacian, Eigen::VectorXd::Zero(laplacian.rows()), rows, values);
  //! [solve]

  // all edges are Delaunay, so that no value is beyond those on the curves
  std::cout << num_vertices(t.mesh()) << " vertices, values from " << u.minCoeff() << " to "
            << u.maxCoeff() << '\n';
  return u.minCoeff() > -1e-9 && u.maxCoeff() < 1 + 1e-9 && IT::is_delaunay(t) ? 0 : 1;
}

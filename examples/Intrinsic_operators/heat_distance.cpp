// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the distances from a vertex by the flow of heat: on the mesh, on its Delaunay triangulation, on a refinement of that.

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

double mean_error(const IT::Corresponding_triangulation& t, const Mesh& mesh) {
  //! [distance]
  const auto source = IT::vertex_on_intrinsic(t, *mesh.vertices().begin(), mesh);
  IT::Heat_distance heat(t); // factors; after that, distances from any sources are fast
  const Eigen::VectorXd d = heat.distances(source).head(mesh.number_of_vertices());
  //! [distance]
  const std::vector<double> exact = IT::Polyhedral_distance(t, source).distances();
  return (d - Eigen::Map<const Eigen::VectorXd>(exact.data(), d.size())).cwiseAbs().mean() /
         d.mean();
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh);
  const double as_is = mean_error(t, mesh);
  //! [refine]
  IT::flip_to_delaunay(t);
  const double delaunay = mean_error(t, mesh);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(2));
  //! [refine]
  const double refined = mean_error(t, mesh);
  std::cout << "mean error: " << as_is << ", Delaunay " << delaunay << ", refined " << refined
            << '\n';
  return refined < delaunay && delaunay < as_is ? 0 : 1;
}

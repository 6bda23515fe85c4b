// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the smoothest field of crosses on a mesh, and counts its singularities: exactly.

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  //! [field]
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const IT::Direction_field crosses = IT::smoothest_direction_field(t, 4);
  const auto vectors = IT::vectors_in_space(t, crosses.directions(), mesh); // one arm of each

  const auto singularities = IT::singularities(t, crosses);
  std::ptrdiff_t expected = 4 * IT::euler_characteristic(t.mesh());
  for (const auto& [halfedge, turns] : singularities.turns) expected += turns;
  //! [field]

  //! [along]
  const auto path = IT::Edge_path_finder(t)(IT::vertex_of_row(t, 0), IT::vertex_of_row(t, 40));
  const IT::Direction_field along =
      IT::smoothest_direction_field(t, 4, IT::directions_along_path(t, path));
  //! [along]
  std::size_t count = 0;
  for (const int i : singularities.index) count += i != 0 ? 1 : 0;
  std::cout << vectors.size() << " crosses with " << count
            << " singularities, the sum of indices is " << singularities.sum()
            << ", as it must be: " << expected << "; along a path of " << path.size()
            << " edges the sum is " << IT::singularities(t, along).sum() << '\n';
  return singularities.sum() == expected ? 0 : 1;
}

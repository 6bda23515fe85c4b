// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a CGAL::Surface_mesh to its intrinsic Delaunay triangulation, and reads the result by the
// vertices of the mesh, with property maps.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }
  //! [triangulate]
  IT::Intrinsic_triangulation<Mesh> t(mesh); // Mesh: what is flipped is a Surface_mesh too, a copy
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  //! [triangulate]

  //! [read]
  // vertices may be numbered otherwise than in the mesh: input_vertex() is the way back
  auto degree = mesh.add_property_map<Mesh::Vertex_index, int>("v:intrinsic_degree", 0).first;
  double longest = 0;
  for (const Mesh::Edge_index e : t.mesh().edges()) {
    for (const Mesh::Vertex_index v : {t.mesh().vertex(e, 0), t.mesh().vertex(e, 1)})
      ++degree[Mesh::Vertex_index(t.input_vertex(v))];
    longest = std::max(longest, std::sqrt(t.squared_length(e)));
  }
  //! [read]

  int sum = 0, greatest = 0;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    sum += degree[v];
    greatest = std::max(greatest, degree[v]);
  }
  std::cout << result.flips << " flips\nlongest edge: " << longest
            << "\ngreatest degree of a vertex: " << greatest << '\n';
  return IT::is_delaunay(t) && sum == 2 * static_cast<int>(mesh.number_of_edges()) ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a part to Delaunay and joins the faces that lie in one circle: the result does not depend
// on how rectangles were cut. Usage: delaunay_tessellation [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstddef>
#include <iostream>
#include <map>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Intrinsic_triangulation<> t(mesh);
  IT::flip_to_delaunay(t);

  //! [tessellation]
  Mesh cells; // vertices are those of the mesh, in the same order
  const IT::Delaunay_tessellation tessellation = IT::delaunay_tessellation(t, cells);
  std::map<std::size_t, std::size_t> number_by_degree;
  for (const auto f : faces(cells)) ++number_by_degree[degree(f, cells)];
  //! [tessellation]

  std::cout << num_faces(t.mesh()) << " faces make " << tessellation.number_of_cells << " cells:";
  for (const auto& [sides, number] : number_by_degree)
    std::cout << ' ' << number << " with " << sides << " sides";
  std::cout << '\n';
  const std::size_t ties = num_edges(t.mesh()) - num_edges(cells);
  return num_faces(t.mesh()) - num_faces(cells) == ties ? 0 : 1; // an edge less, a face less
}

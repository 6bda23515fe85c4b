// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: nearest_sources [MESH.off [OUT.vtp]]
// A sample of vertices far from each other, which of them is the nearest to each vertex, and their
// cells.

#include <CGAL/Intrinsic_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const IT::Corresponding_triangulation t(mesh);

  //! [farthest]
  IT::Polyhedral_distance distance(t, *vertices(t.mesh()).begin());
  const auto sample = IT::farthest_points(distance, 9); // now there are ten sources
  std::cout << "all vertices are within " << sample.radius << " of the sources\n";
  //! [farthest]

  //! [nearest]
  std::vector<std::size_t> sizes(distance.number_of_sources());
  for (const auto v : vertices(t.mesh())) ++sizes[distance.nearest_source(v)];
  //! [nearest]
  for (const std::size_t n : sizes) std::cout << n << " vertices\n";

  //! [cells]
  const IT::Voronoi_cells cells = IT::voronoi_cells(distance, IT::parameters::tolerance(1e-3));
  for (const double area : cells.areas) std::cout << "area " << area << '\n';
  const std::vector<IT::Polyline> lines = IT::polylines(t, cells, mesh); // between cells
  //! [cells]
  std::cout << lines.size() << " lines, " << cells.junctions.size() << " junctions\n";
  if (argc > 2) IT::write_polylines(argv[2], lines, "boundary");
  return lines.empty() ? 1 : 0;
}

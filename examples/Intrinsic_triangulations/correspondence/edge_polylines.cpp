// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws an edge of the intrinsic triangulation on the mesh, and says where an edge of the mesh
// crosses the intrinsic triangulation: two statements each. Usage: edge_polylines [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

double length(const std::vector<Point>& polyline) {
  double sum = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(polyline[i - 1], polyline[i]));
  return sum;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);

  double difference = 0;
  std::size_t crossings = 0, of_mesh = 0;
  for (const auto e : edges(t.mesh())) {
    //! [intrinsic]
    const IT::Edge_path path = IT::trace_edge(t, e);
    const std::vector<Point> points = IT::polyline(t, path, mesh); // from end to end
    //! [intrinsic]
    crossings += points.size() - 2;
    difference =
        std::max(difference, std::abs(length(points) / std::sqrt(t.squared_length(e)) - 1));
  }
  for (const auto e : edges(mesh)) {
    //! [input]
    const IT::Edge_path path = IT::trace_input_edge(t, e, mesh); // its places on both
    const std::vector<Point> points = IT::polyline(t, path, mesh);
    //! [input]
    of_mesh += points.size() - 2;
  }
  std::cout << "intrinsic edges cross edges of the mesh " << crossings << " times, and are crossed "
            << of_mesh << " times\nlengths in space differ from those of edges by " << difference
            << " of themselves\n";
  return crossings == of_mesh && difference < 1e-9 ? 0 : 1;
}

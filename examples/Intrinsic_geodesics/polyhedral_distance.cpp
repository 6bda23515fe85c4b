// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds the exact distances of all vertices of a mesh from one of them, and a shortest path to the farthest. Then the distance
// of two points of a torus that lies nowhere in space. Usage: polyhedral_distance [MESH.off [VERTEX]]

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_shortest_path.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

// A torus of two triangles: the parallelogram spanned by (1, 0) and (3, 1), of which opposite sides are one.
double distance_on_torus() {
  IT::Gluing gluing;
  gluing.number_of_vertices = 1;
  gluing.origin = {0, 0, 0, 0, 0, 0};
  gluing.glue = {3, 4, 5, 0, 1, 2};
  const IT::Intrinsic_triangulation<> torus(
      IT::Intrinsic_input(IT::Gluing_map(gluing), std::vector<double>{1, 10, 17}));
  // from the only vertex to the middle of the longest side, that is to (2, 1/2), which is (0, 1/2) as well
  const IT::Polyhedral_distance distance(torus, *vertices(torus.mesh()).begin());
  double farthest = 0;
  for (const auto e : edges(torus.mesh())) {
    const IT::Surface_point middle{torus.numbers().halfedge(halfedge(e, torus.mesh())),
                                   {0.5, 0.5, 0}};
    farthest = std::max(farthest, distance.distance(middle));
  }
  return farthest;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const auto source = static_cast<std::uint32_t>(argc > 2 ? std::stoul(argv[2]) : 0);

  //! [distance]
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  auto from = *vertices(t.mesh()).begin(), to = from;
  for (const auto v : vertices(t.mesh()))
    if (t.input_vertex(v) == source) from = v;
  const IT::Polyhedral_distance distance(t, from);
  for (const auto v : vertices(t.mesh()))
    if (distance.distance(v) > distance.distance(to)) to = v;
  const IT::Shortest_path path = distance.shortest_path(to);
  //! [distance]

  //! [path]
  const std::vector<Point> line = IT::polyline(t, path, mesh); // in the faces of the mesh
  //! [path]

  //! [point]
  // face 12 of the mesh, weights from the source of its halfedge on; t has other faces
  const IT::Face_location<Mesh> place(Mesh::Face_index(12), {0.2, 0.3, 0.5});
  const IT::Polyhedral_distance from_point(t, *IT::locate_on_intrinsic(t, place, mesh));
  const Mesh::Vertex_index corner = mesh.source(mesh.halfedge(place.first));
  const double to_corner = from_point.distance(IT::vertex_on_intrinsic(t, corner, mesh));
  //! [point]
  std::cout << "a corner of face 12 is " << to_corner << " from the point in it\n";
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
  std::cout << "vertex " << t.input_vertex(to) << " is the farthest: " << path.length << ", across "
            << path.points.size() - 2 << " edges; " << distance.number_of_windows() << " windows\n";
  const double on_torus = distance_on_torus();
  std::cout << "midpoints of edges of the torus are no farther than " << on_torus << '\n';
  return std::abs(length / path.length - 1) < 1e-10 && std::abs(on_torus - std::sqrt(0.5)) < 1e-15
             ? 0
             : 1;
}

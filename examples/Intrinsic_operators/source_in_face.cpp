// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds distances from a point in a face of the mesh, in one statement.

#include <CGAL/Intrinsic_operators/distance/distances_on_mesh.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh("data/part.off", mesh)) return 1;
  //! [place]
  // the point in face 12 with these weights of its corners, from the source of its halfedge on, as
  // in CGAL's Face_location; a vertex is Place::at_vertex(7)
  const IT::Found_distances found = IT::distances(mesh, {IT::Place::in_face(12, {0.2, 0.3, 0.5})});
  //! [place]

  // A segment in a face is the shortest path in space, so it is the shortest on the surface.
  const auto h = mesh.halfedge(Mesh::Face_index(12)); // corners are listed from its source on
  const Mesh::Vertex_index corners[] = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
  const auto p = CGAL::barycenter(mesh.point(corners[0]), 0.2, mesh.point(corners[1]), 0.3,
                                  mesh.point(corners[2]), 0.5);
  double error = 0;
  for (const auto v : corners)
    error = std::max(
        error, std::abs(found.by_row[v] - std::sqrt(CGAL::squared_distance(p, mesh.point(v)))));
  std::cout << "farthest vertex: " << *std::max_element(found.by_row.begin(), found.by_row.end())
            << "; the corners of the face are right up to " << error << '\n';
  return error < 1e-12 ? 0 : 1;
}

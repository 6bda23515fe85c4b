// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes tangent vectors from the mesh to the intrinsic triangulation, each in the frame of the face
// there, and goes straight along them on both: the ends are the same place. Usage: tangent_vectors
// [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);

  double apart = 0;
  std::size_t count = 0;
  for (const Mesh::Face_index f : faces(mesh)) {
    //! [tangent]
    // at the middle of a face, of length 1, to the left of halfedge(f, mesh)
    const IT::Surface_point middle = IT::surface_point(t, {f, {1. / 3, 1. / 3, 1. / 3}}, mesh);
    const IT::Tangent_vector v{middle, {0, 1}};
    const auto there = IT::tangent_to_intrinsic(t, v); // a point, and the vector in the frame there
    //! [tangent]
    if (!there) return 1; // by `Signposts` only

    const double length = 1;
    //! [straight]
    const IT::Geodesic on_mesh = IT::trace_geodesic_on_input(t, v.point, v.vector, length);
    const IT::Geodesic on_t = IT::trace_geodesic(t, there->point, there->vector, length);
    const auto end = IT::locate_on_input(t, on_t.points.back());
    //! [straight]
    if (!end || on_mesh.status != IT::Status::done) continue;
    apart = std::max(apart, std::sqrt(CGAL::squared_distance(
                                IT::point_in_space(t, *end, mesh),
                                IT::point_in_space(t, on_mesh.points.back(), mesh))));
    ++count;
  }
  std::cout << count
            << " vectors; ends on the mesh and on the intrinsic triangulation differ by at most "
            << apart << '\n';
  return count > 0 && apart < 1e-6 ? 0 : 1;
}

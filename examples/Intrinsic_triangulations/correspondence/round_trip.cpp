// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes points of a mesh to its intrinsic triangulation and back, and prints how far they end from
// where they started: one statement to build, three for a point. Usage: round_trip [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh); // exact, with integer coordinates
  IT::flip_to_delaunay(t);
  t.insert_vertex(*halfedges(t.mesh()).begin(), {0.2, 0.3, 0.5});

  double greatest = 0, size = 0;
  std::size_t count = 0, lost = 0;
  for (const Mesh::Face_index f : faces(mesh)) {
    const PMP::Face_location<Mesh, double> place{f, {0.5, 0.25, 0.25}}; // on the mesh
    //! [round_trip]
    const auto there = IT::locate_on_intrinsic(t, place, mesh); // a face of t.mesh(), and weights
    const auto back = there ? IT::locate_on_input(t, *there, mesh) : std::nullopt;
    const Point end = PMP::construct_point(back.value_or(place), mesh);
    //! [round_trip]
    const Point start = PMP::construct_point(place, mesh);
    greatest = std::max(greatest, std::sqrt(CGAL::squared_distance(start, end)));
    size = std::max({size, std::abs(start.x()), std::abs(start.y()), std::abs(start.z())});
    ++count;
    if (!back) ++lost; // by `Signposts` only
  }
  std::cout << count << " points there and back, " << lost
            << " lost\ngreatest distance: " << greatest << ", where coordinates are up to " << size
            << '\n';
  return lost == 0 && count > 0 && greatest < 1e-9 * size ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps points of a mesh to its intrinsic triangulation and back, and prints how far they end from where they
// started. Usage: round_trip [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  t.insert_vertex(*halfedges(t.mesh()).begin(), {0.2, 0.3, 0.5});
  const IT::Integer_coordinates& coordinates = t.correspondence();
  const IT::Input& input = coordinates.input();

  std::vector<std::array<double, 3>> points; // of the input
  for (const Mesh::Vertex_index v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  //! [in_space]
  const auto in_space = [&](const IT::Surface_point& p) {
    return IT::position(IT::weighted_vertices(t, coordinates, p), points);
  };
  //! [in_space]

  double greatest = 0, size = 0;
  std::size_t count = 0, lost = 0;
  for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) {
    if (input.is_border(h)) continue;
    //! [round_trip]
    const IT::Surface_point start{h, {0.5, 0.25, 0.25}}; // on the input
    const auto there = IT::locate_on_intrinsic(t, coordinates, start);
    if (!there) {
      ++lost;
      continue;
    }
    const IT::Surface_point end =
        IT::locate_on_input(t, coordinates, there->halfedge, there->weights).point;
    //! [round_trip]
    const auto a = in_space(start), b = in_space(end);
    greatest = std::max(greatest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    size = std::max({size, std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    ++count;
  }
  std::cout << count << " points there and back, " << lost
            << " lost\ngreatest distance: " << greatest << ", where coordinates are up to " << size
            << '\n';
  return lost == 0 && count > 0 && greatest < 1e-9 * size ? 0 : 1;
}

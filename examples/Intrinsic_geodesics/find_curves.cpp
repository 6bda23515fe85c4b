// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds a path through points that are named by numbers, a loop and a geodesic in a direction, writes them, and cuts the
// surface open along them.
// Usage: find_curves [MESH.off]

#include <CGAL/Intrinsic_geodesics.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  const IT::Triangle_soup soup =
      IT::read_triangle_soup(std::filesystem::path(argc > 1 ? argv[1] : "data/part.off"));
  Triangulation t(IT::make_domain(soup).input);
  IT::flip_to_delaunay(t);

  //! [find]
  IT::Wanted_curve path, loop;
  path.places = {IT::Place::at_vertex(0), IT::Place::in_face(100, {0.5, 0.25, 0.25})};
  loop.places = {IT::Place::at_vertex(10), IT::Place::at_vertex(40), IT::Place::at_vertex(70)};
  loop.is_loop = loop.stays_at_places = true;
  auto found = IT::find_curves(t, {path, loop});
  for (const IT::Found_curve& curve : found.curves)
    std::cout << "length " << curve.way.length << ", through " << curve.way.faces.size()
              << " faces\n";
  const std::vector<IT::Polyline> lines = IT::polylines(t, found, soup.points);
  //! [find]

  const IT::Cut_surface pieces = IT::cut_along(t, found); // along all edges with curves

  //! [trace]
  IT::Tangents_at_places<Triangulation> tangent(t, soup.points);
  const auto start = tangent.on_input(IT::Place::at_vertex(0), std::array<double, 3>{1, 0, 0});
  const IT::Traced_curve ray =
      IT::traced_curve(t.input(), IT::trace_geodesic_on_input(t, start.point, start.vector, 0.1));
  //! [trace]
  std::cout << lines.size() << " lines; " << pieces.number_of_components
            << " pieces; a ray of length " << ray.length << '\n';
  return found.is_certified ? 0 : 1;
}

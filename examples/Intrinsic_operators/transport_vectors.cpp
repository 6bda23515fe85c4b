// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes a tangent vector from one vertex to all others along shortest paths, by the vector heat method, and the field to space.

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  //! [transport]
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const IT::Vector_heat_method<Triangulation> heat(t); // factors matrices once

  const Triangulation::vertex_descriptor v = *vertices(t.mesh()).begin();
  const IT::Tangent_field field = heat.transport(v, 1); // along the real axis there
  const std::vector<std::array<double, 3>> vectors = IT::vectors_in_space(t, field, mesh);
  //! [transport]

  //! [in space]
  const std::vector<std::array<double, 3>> points = IT::points_of(mesh);
  IT::Vectors along(t, points);
  const IT::Found_vectors found = // from vertex 0, the part of (1, 0, 0) that is in its plane
      along.transport({{IT::Place::at_vertex(0)}, {}, {{1, 0, 0}}});
  const std::vector<std::array<double, 3>> arrows = IT::vectors_in_space(t, found.vectors, mesh);
  //! [in space]
  double longest = 0; // the whole vector has the length 1
  for (const std::array<double, 3>& x : arrows)
    longest = std::max(longest, std::hypot(x[0], x[1], x[2]));
  std::cout << "a vector in space has a part of length " << longest << " in the surface\n";

  std::size_t unit = 0; // transport keeps lengths
  for (const std::array<double, 3>& x : vectors)
    unit += std::abs(std::hypot(x[0], x[1], x[2]) - 1) < 1e-6 ? 1 : 0;
  std::cout << unit << " of " << vectors.size() << " vectors have the length 1\n";
  return unit == vectors.size() && longest < 1 + 1e-6 ? 0 : 1;
}

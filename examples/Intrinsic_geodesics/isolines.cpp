// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the lines of equal distance from a vertex of a mesh. Usage:
// isolines [MESH.off [OUT.vtp [LEVELS]]]

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cstddef>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const std::size_t number = argc > 3 ? std::stoul(argv[3]) : 10;

  //! [isolines]
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const auto distances = IT::Polyhedral_distance(t, *vertices(t.mesh()).begin()).distances();
  const double farthest = *std::max_element(distances.begin(), distances.end());
  std::vector<double> levels;
  for (std::size_t i = 0; i < number; ++i)
    levels.push_back(farthest * double(i + 1) / double(number + 1));
  const std::vector<IT::Isoline> lines = IT::isolines(t, distances, levels);
  const std::vector<IT::Polyline> in_space = IT::polylines(t, lines, mesh); // on the mesh
  //! [isolines]

  if (argc > 2) IT::write_polylines(argv[2], in_space, "level");
  std::vector<double> length(number);
  for (const IT::Isoline& line : lines)
    length[line.number_of_level] += IT::length_of_isoline(t, line);
  for (std::size_t i = 0; i < number; ++i)
    std::cout << "distance " << levels[i] << ": length " << length[i] << '\n';
  return std::all_of(length.begin(), length.end(), [](double x) { return x > 0; }) ? 0 : 1;
}

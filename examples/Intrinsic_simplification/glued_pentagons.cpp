// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Glues halves of the sides of a regular pentagon in all ways that close, and finds the convex
// polyhedron of each. Usage: glued_pentagons [OUT.obj]

#include <CGAL/Intrinsic_simplification.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Partners = std::array<std::uint32_t, 10>; // of each half of a side

bool pair(unsigned word, Partners& partners) { // whose bits open and close halves like brackets
  std::vector<std::uint32_t> open;
  for (std::uint32_t k = 0; k < 10; ++k, word /= 2) {
    if (word % 2 == 1) open.push_back(k);
    if (word % 2 == 1) continue;
    if (open.empty()) return false;
    partners[partners[k] = open.back()] = k;
    open.pop_back();
  }
  return open.empty();
}
IT::Intrinsic_input glued(const Partners& partners) { // ten triangles about the centre
  // points that become one get the least number
  Partners vertex{}, point{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  for (int round = 0; round < 10; ++round)
    for (std::uint32_t k = 0; k < 10; ++k) // where k begins, its partner ends
      point[k] = point[(partners[k] + 1) % 10] = std::min(point[k], point[(partners[k] + 1) % 10]);
  IT::Gluing g{1, {}, {}}; // the centre is vertex 0
  for (std::uint32_t k = 0; k < 10; ++k)
    vertex[k] = point[k] == k ? g.number_of_vertices++ : vertex[point[k]];
  for (std::uint32_t k = 0; k < 10; ++k) {
    g.origin.insert(g.origin.end(), {vertex[k], vertex[(k + 1) % 10], 0});
    g.glue.insert(g.glue.end(), {3 * partners[k], 3 * ((k + 1) % 10) + 2, 3 * ((k + 9) % 10) + 1});
  }
  const IT::Gluing_map map(g);
  const double half = .5, inner = half / std::tan(std::numbers::pi / 5);
  std::vector<double> squared(map.number_of_edges());
  for (std::uint32_t f = 0; f < 10; ++f)
    for (std::uint32_t k = 0; const IT::Gluing_map::Halfedge h : map.sides({f}))
      squared[h.index / 2] = // even points of the border are corners
          k++ == 0 ? half * half : inner * inner + ((f + k) % 2 == 1 ? half * half : 0);
  return {map, squared};
}

int main(int argc, char* argv[]) {
  std::ofstream out(argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "pentagons.obj");
  Partners partners{};
  double polyhedra = 0, polygons = 0;
  std::size_t points = 1;
  for (unsigned word = 0; word < 1024; ++word) {
    if (!pair(word, partners)) continue;
    try {
      //! [embed]
      const IT::Corresponding_triangulation t(glued(partners));
      const IT::Convex_polyhedron p = IT::embed_convex(t);
      //! [embed]
      ++(p.shape == IT::Convex_shape::polyhedron ? polyhedra : polygons);
      for (const auto& [x, y, z] : p.points) // beside each other
        out << "v " << x + 2 * (polyhedra + polygons) << ' ' << y << ' ' << z << '\n';
      for (const auto& [i, j, k] : p.faces)
        out << "f " << points + i << ' ' << points + j << ' ' << points + k << '\n';
      points += p.points.size();
    } catch (const IT::Invalid_input&) { // more than a full turn at a vertex
    }
  }
  std::cout << polyhedra << " polyhedra, " << polygons << " polygons, front and back\n";
  return polyhedra + polygons == 15 ? 0 : 1;
}

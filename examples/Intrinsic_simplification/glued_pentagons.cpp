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

// The halves are opened and closed like brackets, as the bits of a word say.
bool pair(unsigned word, Partners& partners) {
  std::vector<std::uint32_t> open;
  for (std::uint32_t k = 0; k < 10; ++k)
    if ((word >> k & 1) != 0) {
      open.push_back(k);
    } else if (open.empty()) {
      return false;
    } else {
      partners[partners[k] = open.back()] = k;
      open.pop_back();
    }
  return open.empty();
}

// Ten triangles about the centre, with the halves glued; side 0 of each is a half.
IT::Intrinsic_input glued(const Partners& partners) {
  Partners point{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}; // points that become one get the least number
  for (int round = 0; round < 10; ++round)
    for (std::uint32_t k = 0; k < 10; ++k) // where k begins, its partner ends
      point[k] = point[(partners[k] + 1) % 10] = std::min(point[k], point[(partners[k] + 1) % 10]);
  IT::Gluing g{1, {}, {}}; // the centre is vertex 0
  Partners vertex{};
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
    for (std::uint32_t k = 0; const IT::Gluing_map::Halfedge h : map.sides({f})) {
      const bool is_corner = (f + k) % 2 == 0;
      squared[h.index / 2] = k++ == 0 ? half * half : inner * inner + (is_corner ? half * half : 0);
    }
  return {map, squared};
}

int main(int argc, char* argv[]) {
  std::ofstream out(argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "pentagons.obj");
  Partners partners{};
  std::array<int, 3> number{}; // polyhedra, polygons, surfaces that are not convex
  std::size_t points = 1;
  for (unsigned word = 0; word < 1024; ++word) {
    if (!pair(word, partners)) continue;
    try {
      //! [embed]
      const IT::Corresponding_triangulation t(glued(partners));
      const IT::Convex_polyhedron p = IT::embed_convex(t);
      //! [embed]
      const int place = number[0] + number[1];
      ++number[p.shape == IT::Convex_shape::polyhedron ? 0 : 1];
      for (const auto& [x, y, z] : p.points)
        out << "v " << x + 2 * (place % 7) << ' ' << y - 2 * (place / 7) << ' ' << z << '\n';
      for (const auto& [i, j, k] : p.faces)
        out << "f " << points + i << ' ' << points + j << ' ' << points + k << '\n';
      points += p.points.size();
    } catch (const IT::Invalid_input&) { // more than a full turn at a vertex
      ++number[2];
    }
  }
  std::cout << number[0] << " polyhedra, " << number[1] << " polygons, front and back, and "
            << number[2] << " surfaces that are not convex\n";
  return number[0] + number[1] + number[2] == 42 ? 0 : 1;
}

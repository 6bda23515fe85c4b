// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: heat_matrix [MESH.off [OUT.bin]]
// The distances by heat between all pairs of vertices: a file of floats, a column per vertex.

#include <CGAL/Intrinsic_operators.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main(int argc, char** argv) {
  IT::Corresponding_triangulation t(IT::read_triangle_soup(argc > 1 ? argv[1] : "data/part.off"));
  IT::flip_to_delaunay(t);
  const std::filesystem::path name =
      argc > 2 ? argv[2] : std::filesystem::temp_directory_path() / "heat_matrix.bin";
  const std::size_t n = t.number_of_vertices();

  //! [matrix]
  std::vector<decltype(t)::vertex_descriptor> sources(n); // by rows
  for (const auto v : vertices(t.mesh())) sources[t.input_vertex(v)] = v;
  const IT::Heat_distance heat(t); // factors once for all columns
  std::ofstream file(name, std::ios::binary);
  std::vector<float> columns;
  for (std::size_t first = 0; first < n; first += 256) {
    const auto sets = std::span(sources).subspan(first, std::min<std::size_t>(256, n - first));
    columns.resize(n * sets.size());
    IT::heat_distances(heat, sets, std::span(columns)); // in all processors
    file.write(reinterpret_cast<const char*>(columns.data()),
               static_cast<std::streamsize>(columns.size() * sizeof(float)));
  }
  //! [matrix]
  file.close();
  const bool is_complete = std::filesystem::file_size(name) == n * n * sizeof(float);
  std::cout << n << " columns" << (is_complete ? "" : " are not in the file") << '\n';
  if (argc <= 2) std::filesystem::remove(name);
  return is_complete ? 0 : 1;
}

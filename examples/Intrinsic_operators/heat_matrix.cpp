// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Usage: heat_matrix [MESH.off [OUT.bin]]
// The distances by heat between all pairs of vertices: a file of floats, a column per vertex.

#include <CGAL/Intrinsic_operators.h>

#include <cstddef>
#include <cstdint>
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
  std::vector<std::vector<IT::Place>> sets; // of one vertex each
  for (std::uint32_t v = 0; v < n; ++v) sets.push_back({IT::Place::at_vertex(v)});
  std::ofstream file(name, std::ios::binary);
  IT::Distances distances(t); // factors once for all columns, and solves in all processors
  distances.for_each_column(
      sets,
      [&](std::size_t, std::span<const double> column) {
        const std::vector<float> rounded(column.begin(), column.end());
        file.write(reinterpret_cast<const char*>(rounded.data()),
                   static_cast<std::streamsize>(n * sizeof(float)));
      },
      {IT::Distance_method::heat});
  //! [matrix]
  file.close();
  const bool is_complete = std::filesystem::file_size(name) == n * n * sizeof(float);
  std::cout << n << " columns" << (is_complete ? "" : " are not in the file") << '\n';
  if (argc <= 2) std::filesystem::remove(name);
  return is_complete ? 0 : 1;
}

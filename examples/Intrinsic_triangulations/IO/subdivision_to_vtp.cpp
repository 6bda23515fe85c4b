// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the common subdivision of a mesh and its intrinsic Delaunay triangulation for ParaView,
// with a function on it. Usage: subdivision_to_vtp [MESH.off [OUT.vtp]]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

int main(int argc, char* argv[]) {
  const std::string name = "subdivision_" + std::to_string(std::random_device()()) + ".vtp";
  const std::filesystem::path file =
      argc > 2 ? std::filesystem::path(argv[2]) : std::filesystem::temp_directory_path() / name;
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const IT::Common_subdivision s = IT::common_subdivision(t);

  //! [write]
  const std::vector<std::array<double, 3>> positions = IT::positions(s, mesh);

  std::vector<double> height; // any function on the surface: one value for each vertex of s
  for (const std::array<double, 3>& p : positions) height.push_back(p[2]);
  const std::vector<IT::Subdivision_field> fields{{"height", height}};
  IT::write_common_subdivision(file, s, positions, fields);
  //! [write]

  std::ifstream in(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  in.close();
  std::cout << s.number_of_faces() << " polygons, " << text.size() << " bytes, " << file << '\n';
  if (argc < 3) std::filesystem::remove(file); // the test leaves nothing behind
  const auto has = [&](const std::string& what) { return text.find(what) != std::string::npos; };
  return has("NumberOfPolys=\"" + std::to_string(s.number_of_faces()) + '"') &&
                 has("NumberOfPoints=\"" + std::to_string(positions.size()) + '"') &&
                 has("Name=\"height\"")
             ? 0
             : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a mesh to Delaunay, inserts a vertex, and writes the common subdivision with the input,
// with a function on it: three statements. Usage: common_subdivision [MESH.off [OUT.vtp]]

#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const std::filesystem::path file =
      argc > 2 ? argv[2] : std::filesystem::temp_directory_path() / "common_subdivision.vtp";
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const auto inserted = t.insert_vertex(*halfedges(t.mesh()).begin(), {0.25, 0.25, 0.5});
  const Eigen::VectorXd area = IT::lumped_mass_matrix(t).diagonal(); // of the cells of vertices

  //! [subdivision]
  const IT::Common_subdivision s = IT::common_subdivision(t);
  IT::write_common_subdivision(file, s, IT::positions(s, mesh),
                               std::array{IT::interpolated_field("area", s, area)});
  //! [subdivision]

  //! [mesh]
  Mesh cells; // a mesh of your own type, whose faces are those of s
  for (const std::array<double, 3>& p : IT::positions(s, mesh))
    cells.add_vertex({p[0], p[1], p[2]});
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    std::vector<Mesh::Vertex_index> corners;
    for (const std::uint32_t v : s.face(f)) corners.push_back(Mesh::Vertex_index(v));
    cells.add_face(corners);
  }
  //! [mesh]

  //! [polylines]
  const IT::Edge_polylines lines = IT::input_edge_polylines(s); // vertices of s, edge by edge
  std::size_t most_crossed = 0;
  for (std::size_t e = 0; e < lines.size(); ++e)
    most_crossed = std::max(most_crossed, lines[e].size());
  //! [polylines]

  std::cout << "an edge of the mesh has " << most_crossed << " vertices\n";
  std::cout << s.number_of_vertices() << " vertices, " << s.number_of_edges() << " edges, "
            << s.number_of_faces() << " faces, " << s.crossings.size() << " crossings\n";
  const auto euler = static_cast<long>(s.number_of_vertices() + s.number_of_faces()) -
                     static_cast<long>(s.number_of_edges());
  std::cout << "Euler characteristic " << euler << '\n';
  const bool is_written = std::filesystem::file_size(file) > s.number_of_faces();
  if (argc <= 2) std::filesystem::remove(file);
  return inserted.status == IT::Move_status::done && is_written &&
                 cells.number_of_faces() == s.number_of_faces()
             ? 0
             : 1;
}

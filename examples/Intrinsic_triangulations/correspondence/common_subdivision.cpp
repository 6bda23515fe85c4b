// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a mesh to Delaunay, inserts a vertex, and writes the common subdivision with the input.
// Usage: common_subdivision [MESH.off [OUT.ply]]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Intrinsic_triangulations.h>

#include <array>
#include <fstream>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

int main(int argc, char** argv) {
  Mesh mesh;
  std::ifstream in(argc > 1 ? argv[1] : "data/part.off");
  if (!in || !CGAL::IO::read_OFF(in, mesh)) {
    std::cerr << "the mesh cannot be read; give an OFF file\n";
    return 1;
  }
  //! [subdivision]
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const auto inserted = t.insert_vertex(*halfedges(t.mesh()).begin(), {0.25, 0.25, 0.5});
  const IT::Common_subdivision s = IT::common_subdivision(t);
  //! [subdivision]
  if (inserted.status != IT::Move_status::done) return 1;

  std::vector<std::array<double, 3>> points;
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  std::cout << s.number_of_vertices() << " vertices, " << s.number_of_edges() << " edges, "
            << s.number_of_faces() << " faces, " << s.crossings.size() << " crossings\n";
  const auto euler = static_cast<long>(s.number_of_vertices() + s.number_of_faces()) -
                     static_cast<long>(s.number_of_edges());
  std::cout << "Euler characteristic " << euler << '\n';
  if (argc > 2) IT::write_common_subdivision(argv[2], s, IT::positions(s, points));
}

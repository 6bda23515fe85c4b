// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Takes a tangent vector field at the vertices of a mesh to its refinement and back, and from there
// to vectors in space, at vertices and on the faces of the common subdivision: one statement each.
// Usage: vector_field [MESH.off]

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

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30));

  //! [transfer]
  // at each vertex the unit vector along its edge `opposite(halfedge(v, mesh), mesh)`: 1 in the
  // polar coordinates there
  const IT::Tangent_field on_mesh(mesh.number_of_vertices(), 1);
  const IT::Tangent_field field = IT::tangent_field_to_intrinsic(t, on_mesh, mesh);
  const IT::Tangent_field back = IT::tangent_field_to_input(t, field, mesh);
  //! [transfer]
  //! [field]
  const auto at_vertices = IT::vectors_in_space(t, field, mesh);
  const auto on_faces = IT::vectors_in_space(t, field, IT::common_subdivision(t), mesh);
  //! [field]

  double shortest = 2, longest = 0;
  double error = 0;
  for (const auto& z : back) error = std::max(error, std::abs(z - 1.));
  for (const auto v : vertices(t.mesh())) {
    if (t.is_inserted(v)) continue; // where vectors are averaged
    const std::array<double, 3>& x = at_vertices[t.input_vertex(v)];
    shortest = std::min(shortest, std::hypot(x[0], x[1], x[2]));
    longest = std::max(longest, std::hypot(x[0], x[1], x[2]));
  }
  std::cout << num_vertices(t.mesh()) << " vectors at vertices, those of the mesh of length "
            << shortest << " to " << longest << ", and " << on_faces.size()
            << " on faces; back on the mesh they differ by " << error << '\n';
  return shortest > 1 - 1e-9 && longest < 1 + 1e-9 && error < 1e-9 ? 0 : 1;
}

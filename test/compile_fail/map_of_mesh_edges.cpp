// expect at once of templates: constrained_input_edges\(t, mesh, map\) makes one of a map from edges of your mesh
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Edges of the mesh are not those of the triangulation.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  Mesh mesh;
  IT::Corresponding_triangulation t(mesh);
  const auto map = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  IT::flip_to_delaunay(t, IT::parameters::edge_is_constrained_map(map));
}

// expect at once of templates: a vertex of the user's mesh is vertex_on_intrinsic
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Sources are on the triangulation, whose mesh is another one than the user's.

#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  const Mesh mesh;
  const IT::Corresponding_triangulation t(mesh);
  IT::Heat_distance(t).distances(Mesh::Vertex_index(0));
}

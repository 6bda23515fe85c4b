// expect at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes have no metric of their own. What is done with the result is wrong only because of that.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  Mesh mesh;
  const auto result = IT::flip_to_delaunay(mesh);
  return result.status == IT::Status::done ? 0 : 1;
}

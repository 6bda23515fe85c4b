// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <algorithm>
#include <cmath>

// A kite whose long diagonal, of length 6, is flipped: the short one has length 2.
bool check_openmesh() {
  namespace IT = CGAL::Intrinsic_triangulations;
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Mesh mesh;
  const auto a = mesh.add_vertex({-3, 0, 0}), b = mesh.add_vertex({0, -1, 0});
  const auto c = mesh.add_vertex({3, 0, 0}), d = mesh.add_vertex({0, 1, 0});
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  IT::Intrinsic_triangulation<Mesh> t(mesh);
  const bool flipped = IT::flip_to_delaunay(t).flips == 1;
  double shortest = 100;
  for (const auto e : edges(t.mesh())) shortest = std::min(shortest, t.squared_length(e));
  return flipped && std::abs(shortest - 4) < 1e-12;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a torus open along short loops, maps it to a round disk, and gives each corner of its faces
// a place in the plane. Then makes the cut geodesic.

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  constexpr unsigned n = 24; // n x n cells
  Mesh mesh;
  std::vector<Mesh::Vertex_index> v;
  for (unsigned i = 0; i < n * n; ++i) {
    const double a = 2 * std::numbers::pi * (i % n) / n, b = 2 * std::numbers::pi * (i / n) / n;
    const double r = 3 + std::cos(b);
    v.push_back(mesh.add_vertex({r * std::cos(a), r * std::sin(a), std::sin(b)}));
  }
  const auto at = [&](unsigned x, unsigned y) { return v[y % n * n + x % n]; };
  for (unsigned i = 0; i < n * n; ++i) {
    const unsigned x = i % n, y = i / n;
    mesh.add_face(at(x, y), at(x + 1, y), at(x + 1, y + 1));
    mesh.add_face(at(x, y), at(x + 1, y + 1), at(x, y + 1));
  }

  //! [map]
  const IT::Intrinsic_input input(mesh);
  const IT::Opened_input disk = IT::cut_open(input, IT::cut_to_disk(input));
  IT::Intrinsic_triangulation<> t(disk.input);
  const IT::Injective_map map = IT::injective_harmonic_map(t);
  const Eigen::RowVector2d first = map.uv.row(disk.corners[0][0]); // of face 0, corner 0
  //! [map]
  //! [geodesic]
  IT::Intrinsic_triangulation<> torus(mesh);
  const auto cut = IT::flip_to_geodesic_cut(torus);
  double length = 0;
  for (const auto e : edges(torus.mesh()))
    if (get(cut.edges, e)) length += torus.length(e);
  //! [geodesic]
  std::cout << "injective: " << map.certificate.is_injective() << ", the first corner at " << first
            << "; a geodesic cut of length " << length << '\n';
  return map.certificate.is_injective() && cut.shortening.status == IT::Status::done ? 0 : 1;
}

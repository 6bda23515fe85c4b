// expect at once: build one of the mesh, Corresponding_triangulation t\(mesh\)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values are interpolated on a triangulation.

#include <CGAL/Intrinsic_operators/editing/interpolate_harmonically.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  const Mesh mesh;
  IT::interpolate_harmonically(mesh, std::vector<std::uint32_t>{0}, Eigen::VectorXd::Zero(1));
}

// expect: satisfaction of .NumberedComplex<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Connectivity without lengths has no geodesics.

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Gluing_map mesh;
  angle_at_source(mesh, 0);
}

// expect: satisfaction of .ReadableFaceGraph<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A soup of triangles has no halfedges.

#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  euler_characteristic(Triangle_soup());
}

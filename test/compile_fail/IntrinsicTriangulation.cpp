// expect: satisfaction of .IntrinsicTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What has neither a mesh nor a metric has no Delaunay triangulation.

#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

int main() {
  const struct {
  } nothing;
  return CGAL::Intrinsic_triangulations::is_delaunay(nothing);
}

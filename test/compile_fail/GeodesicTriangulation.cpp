// expect: satisfaction of .GeodesicTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation without a metric does not compare angles, nor take flips back.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  Integer_only_triangulation<>* t = nullptr;
  insert_geodesic(*t, {}, {});
}

// expect: satisfaction of .RefinableTriangulation<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation whose edges flip, but whose vertices stay, cannot be refined.

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  Integer_only_triangulation<>* t = nullptr;
  delaunay_refine(*t);
}

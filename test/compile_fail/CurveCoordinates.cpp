// expect: satisfaction of .CurveCoordinates<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Directions are no curves.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Intrinsic_triangulation<Gluing_map, Euclidean_traits<double>, Signposts>* t = nullptr;
  edge_crossings(*t, t->correspondence());
}

// expect: satisfaction of .FaceNorm<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A norm is of a vector in a face, not of a vector alone.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  scale_by_norm(Gluing_map(), [](Plane_vector<double>) { return 1.0; });
}

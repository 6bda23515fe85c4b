// expect: satisfaction of .VertexFactors<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A factor is of a vertex, not of a face.

#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  scale_conformally(Gluing_map(), [](Gluing_map::Face) { return 0.0; });
}

// expect: satisfaction of .RefinableMetric<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A metric that only flips.

#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

struct Only_flips : CGAL::Intrinsic_triangulations::Euclidean_metric<double> {
  using Euclidean_metric::Euclidean_metric;
  bool insert_in_face(const CGAL::Intrinsic_triangulations::Vertex_star&,
                      const std::array<double, 3>&) = delete;
};

template <CGAL::Intrinsic_triangulations::RefinableMetric Metric>
void use(Metric&) {}

int main() {
  Only_flips metric;
  use(metric);
}

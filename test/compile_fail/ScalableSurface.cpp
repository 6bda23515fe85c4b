// expect: satisfaction of .ScalableSurface<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A soup of triangles has no metric between its faces.

#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  scale_conformally(Triangle_soup(), [](int) { return 0.0; });
}

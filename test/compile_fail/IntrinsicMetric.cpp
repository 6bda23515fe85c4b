// expect: satisfaction of .IntrinsicMetric<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A metric that decides nothing.

#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

struct Lengths_only {
  using FT = double;
  struct Scope {};
  double squared_length(std::uint32_t) const { return 1; }
};

template <CGAL::Intrinsic_triangulations::IntrinsicMetric Metric>
void use(Metric&) {}

int main() {
  Lengths_only metric;
  use(metric);
}

// expect: satisfaction of .PointRange<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Coordinates that are not in points are no points.

#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <array>
#include <vector>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const std::vector<std::array<int, 3>> faces{{0, 1, 2}};
  triangle_soup(std::vector<double>(9), faces);
}

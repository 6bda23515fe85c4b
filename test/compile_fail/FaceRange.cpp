// expect: satisfaction of .FaceRange<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Points are no faces.

#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <array>
#include <vector>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const std::vector<std::array<double, 3>> points(3);
  triangle_soup(points, std::vector<int>{0, 1, 2});
}

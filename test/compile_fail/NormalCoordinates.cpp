// expect: satisfaction of .NormalCoordinates<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A list of numbers is not read by edges.

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <vector>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Input* input = nullptr;
  corner_coordinates(*input, std::vector<int>(3), 0);
}

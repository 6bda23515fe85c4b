// expect: satisfaction of .MutableDeltaComplex<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A list of gluings cannot be flipped.

#include <CGAL/Intrinsic_triangulation.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  Intrinsic_triangulation<Gluing, Euclidean_traits<double>>* none = nullptr;
  return none != nullptr;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A user's program: checks quickly that CMake finds and links what the library needs, and runs the other checks.

#include "checks.h"

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#ifdef DOWNSTREAM_INCLUDES_SOURCES // does not link the library
#include <CGAL/Intrinsic_triangulations_sources.h>
#ifdef DOWNSTREAM_HAS_operators
#include <CGAL/Intrinsic_simplification_sources.h> // those of all packages
// after the sources: headers must not use names that these have
#include <CGAL/Intrinsic_simplification.h>
#endif
#endif

#include <iostream>

namespace {

bool expect(bool condition, const char* what) {
  if (!condition) std::cerr << "failed: " << what << '\n';
  return condition;
}

// Uses a header of the library, MPFR and GMP.
bool check_link() {
  CGAL::Intrinsic_triangulations::Gluing gluing;
  gluing.number_of_vertices = 1;
  gluing.origin = {0, 0, 0, 0, 0, 0};
  gluing.glue = {3, 4, 5, 0, 1, 2};
  const CGAL::Intrinsic_triangulations::Gluing_map torus(gluing);
  const CGAL::Intrinsic_triangulations::Mpfr_number two(2.0), root = sqrt(two);
  return torus.number_of_edges() == 3 && !(root * root == two);
}

} // namespace

int main() {
  bool good = expect(check_link(), "link");
#ifdef DOWNSTREAM_HAS_torus
  good &= expect(check_torus(), "torus");
#endif
#ifdef DOWNSTREAM_HAS_everything
  good &= expect(check_everything(), "everything");
#endif
#ifdef DOWNSTREAM_HAS_operators
  good &= expect(check_operators(), "operators");
#endif
#ifdef DOWNSTREAM_HAS_openmesh
  good &= expect(check_openmesh(), "openmesh");
#endif
  return good ? 0 : 1;
}

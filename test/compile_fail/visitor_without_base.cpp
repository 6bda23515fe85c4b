// expect at once of templates: a visitor of refinement derives from Refinement_visitor
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor has all that refinement calls, by its base.

#include <CGAL/Intrinsic_triangulations.h>

#include <cstddef>

namespace IT = CGAL::Intrinsic_triangulations;

struct Progress {
  bool progress(std::size_t) { return true; }
};

int main() {
  IT::Corresponding_triangulation t{IT::Intrinsic_input()};
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).visitor(Progress()));
}

// expect at once of templates: a named parameter is given that this function does not have
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounds are a matter of adaptive refinement.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30).maximum_rounds(3));
}

// expect at once of templates: (Unknown_parameter = [^;]*maximum_rounds|expect_name<[^,]*maximum_rounds)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounds are a matter of adaptive refinement. The compiler names the parameter.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30).maximum_rounds(3));
}

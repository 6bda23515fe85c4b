// expect at once of templates: (Unknown_parameter = [^;]*point_t|expect_name<[^,]*point_t)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A triangulation knows its points. The compiler names CGAL's parameter, also before one that is known.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::flip_to_delaunay(t, CGAL::parameters::vertex_point_map(1).maximum_number(3));
}

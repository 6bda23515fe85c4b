// expect at once of templates: a visitor of flip_to_delaunay.. derives from Flip_to_delaunay_visitor
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A visitor of flips has what they call.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <cstddef>

namespace IT = CGAL::Intrinsic_triangulations;

struct Counter {
  std::size_t flips = 0;
};

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::flip_to_delaunay(t, IT::parameters::visitor(Counter()));
}

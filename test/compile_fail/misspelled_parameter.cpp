// expect at once: did you mean .minimum_angle.
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The name that is nearest to a wrong one is not another one of an angle.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::delaunay_refine(t, IT::parameters::min_angle(30));
}

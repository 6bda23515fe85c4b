// expect at once of templates: (Unknown_parameter = [^;]*shortest|expect_name<[^,]*shortest)
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Only functions that look for paths can look for the shortest; others keep what they start from.

#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulation.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  IT::Curve_network<IT::Intrinsic_triangulation<>> network(t);
  IT::shorten_curves(network, IT::parameters::shortest(true));
}

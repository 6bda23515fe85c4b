// expect at once: for a Domain or Point_cloud pass its input
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Domain domain = IT::make_domain(IT::read_triangle_soup("mesh.off"));
  IT::Corresponding_triangulation t(domain);
}

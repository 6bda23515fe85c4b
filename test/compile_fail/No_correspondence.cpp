// expect at once: a triangulation without correspondence does not store where edges run on the input; use Integer_coordinates
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Queries say what to do where there is no correspondence.

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  const IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  return IT::locate_on_input(t, IT::Surface_point()) ? 0 : 1;
}

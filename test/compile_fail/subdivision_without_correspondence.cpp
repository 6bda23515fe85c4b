// expect at once: a triangulation without correspondence does not store where edges run on the input; use Integer_coordinates
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What uses the result of a query that is refused says so after what to do.

#include <CGAL/Intrinsic_triangulations.h>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  IT::Intrinsic_triangulation<> t{IT::Intrinsic_input()};
  const auto subdivision = IT::common_subdivision(t);
  for (const auto e : edges(t.mesh()))
    if (IT::trace_edge(t, e).points.empty()) return 1;
  return static_cast<int>(subdivision.number_of_faces());
}

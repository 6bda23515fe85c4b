// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds a surface from signed incidence matrices and lengths, without points: three triangles that
// share one edge.

#include <CGAL/Intrinsic_triangulations.h>

#include <cstdint>
#include <iostream>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

int main() {
  //! [book]
  // edge 0 runs from vertex 0 to vertex 1; face f has the edges 0, 2 f + 1 and 2 f + 2
  IT::Signed_incidence incidence{5, 7, 3, {{0, 0, -1}, {0, 1, +1}}, {}};
  for (std::uint32_t f = 0; f < 3; ++f) {
    const std::uint32_t apex = 2 + f, up = 2 * f + 1, down = 2 * f + 2;
    for (const IT::Incidence_entry e :
         {IT::Incidence_entry{up, 1, -1}, {up, apex, +1}, {down, apex, -1}, {down, 0, +1}})
      incidence.vertex_edge.push_back(e);
    for (const std::uint32_t e : {0U, up, down}) incidence.edge_face.push_back({f, e, +1});
  }
  IT::Domain domain = IT::make_domain(incidence, std::vector<double>{4, 3, 3, 3, 3, 5, 5});
  //! [book]
  std::cout << domain.report.reason << "; sheets: " << domain.report.sheets << '\n';

  IT::Intrinsic_triangulation<> t(std::move(domain.input));
  IT::flip_to_delaunay(t);
  // the matrices of any mesh
  const IT::Signed_incidence cover = IT::incidence(t.mesh());
  std::cout << "faces of the cover: " << cover.number_of_faces << '\n';
  return cover.number_of_faces == 6 && IT::is_delaunay(t) ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Incidence_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Gluing gluing_from_incidence(const Signed_incidence& s,
                             std::vector<std::uint32_t>& edge_of_halfedge) {
  internal::Incidence_reader read(s);
  internal::glue_pairs(read.gluing, read.edges, [&read](std::uint32_t e) { read.fail_shared(e); });
  edge_of_halfedge = std::move(read.edge_of_halfedge);
  return std::move(read.gluing);
}

Gluing gluing_from_incidence(const Signed_incidence& s) {
  std::vector<std::uint32_t> edge_of_halfedge;
  return gluing_from_incidence(s, edge_of_halfedge);
}

} // namespace CGAL::Intrinsic_triangulations

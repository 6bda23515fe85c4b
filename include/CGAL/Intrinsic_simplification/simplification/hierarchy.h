// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H

#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief makes coarser and coarser surfaces, each of the one before.
\tparam Triangulation see `simplify()`
\param t the triangulation, Delaunay
\param levels how many at most
\param ratio the part of the vertices that stays at each level, below 1
\param options bounds of each level; `vertices` is replaced, and what is kept refers to
  `t`
\return the coarse surfaces, the finest first; fewer where no other vertex can be removed. The
  matrix from level i + 1 to i is `prolongation()` of element i + 1, where level 0 is `t`
\throws Invalid_input as `simplify()`
*/
template <NumberedTriangulation Triangulation>
std::vector<Simplification> hierarchy(const Triangulation& t, std::size_t levels,
                                      double ratio = 0.25, Simplify_options options = {}) {
  std::vector<Simplification> result;
  const auto wanted = [ratio](std::size_t n) {
    return static_cast<std::size_t>(ratio * static_cast<double>(n));
  };
  options.vertices = wanted(t.number_of_vertices());
  while (result.size() < levels) {
    Simplification next = result.empty()
                              ? simplify(t, options)
                              : simplify(delaunay_triangulation(result.back().surface), options);
    if (next.removed == 0) break;
    options.vertices = wanted(next.kept.size());
    options.kept_vertices.clear();
    options.kept_edges.clear();
    result.push_back(std::move(next));
    if (result.back().status != Status::done) break;
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_HIERARCHY_H

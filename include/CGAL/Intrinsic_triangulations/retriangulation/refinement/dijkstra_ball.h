// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DIJKSTRA_BALL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DIJKSTRA_BALL_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief finds the vertices within a distance along edges (§4.3 of the course).

In a Delaunay triangulation this is a geodesic ball up to a constant factor (§4.1.1).
\tparam Complex a model of `NumberedComplex`
\param complex the surface
\param center a vertex \pre it is not isolated
\param radius the distance, in the units of `complex`
\return the vertices, the center first, then by distance
\complexity O(n log n) for n edges at the vertices found
*/
template <NumberedComplex Complex>
std::vector<std::uint32_t> dijkstra_ball(const Complex& complex, std::uint32_t center,
                                         double radius) {
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap;
  std::unordered_map<std::uint32_t, double> distance{{center, 0}};
  std::vector<std::uint32_t> ball;
  heap.push({0, center});
  while (!heap.empty()) {
    const auto [d, v] = heap.top();
    heap.pop();
    if (d > distance[v]) continue;
    ball.push_back(v);
    const std::uint32_t first = complex.outgoing_halfedge(v);
    std::uint32_t h = first;
    do {
      const double to = d + std::sqrt(complex.squared_length(h / 2));
      const std::uint32_t w = complex.target(h);
      if (to <= radius) {
        const auto [known, is_new] = distance.insert({w, to});
        if (is_new || to < known->second) {
          known->second = to;
          heap.push({to, w});
        }
      }
      if (complex.is_border(h)) break;
      h = next_around_source(complex, h);
    } while (h != first);
  }
  return ball;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_DIJKSTRA_BALL_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Straight at the vertex is enough: with four edges on two lines, no diamond is strictly convex
// there. The face without area that the flip makes goes with the vertex.
constexpr double least_sine = 1e-7, straight = 1e-9;

// How good it is to flip an edge from a flat vertex, or less than 0 if that is impossible.
double merit(const Metric_triangles& t, std::uint32_t h, const Metric_diamond& d) {
  const std::array<double, 2> sines = d.sines();
  if (t.source(h) == t.target(h)) // a loop: flipping it removes two edges from the vertex
    return std::min(sines[0], sines[1]) > least_sine ? 2 + std::min(sines[0], sines[1]) : -1;
  if (sines[1] <= least_sine || sines[0] < -straight) return -1;
  return std::min(sines[0] + straight, sines[1]);
}

bool remove_flat_vertex(Metric_triangles& t, std::uint32_t v) {
  for (std::uint32_t cap = 4 * t.degree(v); t.degree(v) > 3; --cap) {
    if (cap == 0) return false;
    std::uint32_t best = Gluing::none;
    double greatest = 0;
    const std::uint32_t first = t.outgoing(v);
    std::uint32_t h = first;
    do {
      if (t.is_in_two_faces(h)) {
        const double m = merit(t, h, t.unfold(h));
        if (m > greatest) {
          greatest = m;
          best = h;
        }
      }
      h = t.opposite(Metric_triangles::previous(h));
    } while (h != first);
    if (best == Gluing::none) return false;
    t.flip(best, t.unfold(best));
  }
  std::uint32_t h = t.outgoing(v);
  for (int k = 0; k < 3; ++k, h = t.opposite(Metric_triangles::previous(h)))
    if (t.target(h) == v) return false;
  if (h != t.outgoing(v)) return false;
  t.remove(v);
  return true;
}

} // namespace

bool remove_flat(Metric_triangles& t, const std::vector<double>& within) {
  const std::vector<double> curvature = t.curvatures();
  std::vector<std::uint32_t> left;
  for (std::uint32_t v = 0; v < t.number_of_vertices(); ++v)
    if (std::abs(curvature[v]) <= within[v]) left.push_back(v);
  // Loops at a vertex may go with its neighbours. Flips that failed may block others; those to
  // Delaunay undo them.
  const std::vector<double> equal(t.number_of_vertices(), 1);
  for (bool was_blocked = false; !left.empty();) {
    std::vector<std::uint32_t> again;
    for (const std::uint32_t v : left)
      if (!remove_flat_vertex(t, v)) again.push_back(v);
    const bool is_blocked = again.size() == left.size();
    if (is_blocked && was_blocked) return false;
    was_blocked = is_blocked;
    left = std::move(again);
    if (!left.empty()) flip_to_convex(t, equal);
  }
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal

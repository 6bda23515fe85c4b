// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_MOLLIFICATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_MOLLIFICATION_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Tells whether the input has degenerate faces that flips cannot remove, by its metric before any
// flip.
//
// A flip of its longest side removes a cap (zero area, a vertex inside that side), if the face
// across has an area or loses its own degeneracy first. So following longest sides from a cap must
// end at a proper face. It does not if it meets the border, or two caps across the longest side of
// both (lengths increase along the way, so there is no other cycle). Zero lengths always stay.
// Linear.
template <class Metric>
bool has_irremovable_degeneracy(const Gluing_map& mesh, const Metric& metric) {
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e)
    if (metric.is_zero_length(e)) return true;
  const auto length = [&](Gluing_map::Halfedge h) {
    return metric.approximate_squared_length(h.index / 2);
  };
  std::vector<char> removable(mesh.number_of_faces(), 0);
  std::vector<std::uint32_t> path;
  for (std::uint32_t start = 0; start < mesh.number_of_faces(); ++start) {
    std::uint32_t f = start;
    path.clear();
    while (metric.is_degenerate(f) && !removable[f]) {
      const auto sides = mesh.sides({f});
      const Gluing_map::Halfedge longest = *std::max_element(
          sides.begin(), sides.end(), [&](auto g, auto h) { return length(g) < length(h); });
      const Gluing_map::Face across = mesh.face(Gluing_map::opposite(longest));
      if (across.index == Gluing::none || path.size() > mesh.number_of_faces() ||
          (!path.empty() && path.back() == across.index) || across.index == f)
        return true;
      path.push_back(f);
      f = across.index;
    }
    for (const std::uint32_t p : path) removable[p] = 1;
  }
  return false;
}

// Tells whether the input has a side of length zero, exactly. Linear.
bool has_edge_without_length(const Input_metric& input);

// The default amount added to squared lengths, in scaled units, where the mean edge is near 1. A
// zero length becomes 1.5e-11 of the mean edge, so that lengths agree with those in space to 1e-10.
// In proper faces doubles do not show the difference; a face without area gets one of about 1e-11,
// well above the rounding of squared lengths.
inline constexpr double default_squared_length_delta = 0x1p-72;

// The lengths of the edges, in scaled units.
std::vector<double> edge_lengths(const Gluing_map& mesh, const Input_metric& input);

// The epsilon of the course's Eq. 15: the smallest that, added to all lengths, makes every triangle
// inequality hold by at least `delta`, for which the course recommends 1e-5 of the mean edge.
double mollifying_epsilon(const Gluing_map& mesh, const std::vector<double>& lengths, double delta);

// Whether two sides of a face are together longer than the third one by less than 2^-30 of that.
// The area of such a face has fewer correct digits: rounding of lengths, at 2^-53, changes it by a
// relative 2^-23 or more.
bool has_nearly_degenerate_face(const Gluing_map& mesh, const std::vector<double>& lengths);

// The metric with the course's epsilon added to all lengths (§4.7). The new squared lengths are
// rounded to doubles, which define the result exactly. `epsilon` is set to what was added, in
// scaled units.
Input_metric mollify_lengths(const Gluing_map& mesh, const Input_metric& input, double delta,
                             double& epsilon);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_MOLLIFICATION_H

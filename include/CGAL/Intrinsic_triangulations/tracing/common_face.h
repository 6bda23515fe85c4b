// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRACING_COMMON_FACE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRACING_COMMON_FACE_H

#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief describes a point of the input from another halfedge of the same face.
\pre `base` and the halfedge of `p` have one face
*/
template <class Input>
Surface_point seen_from(const Input& input, const Surface_point& p, std::uint32_t base) {
  const std::array<double, 3>& w = p.weights;
  if (p.halfedge == base) return p;
  if (p.halfedge == input.next(base)) return {base, {w[2], w[0], w[1]}};
  return {base, {w[1], w[2], w[0]}};
}

namespace internal {

// All descriptions of a point, one per face that it is in.
template <class Input>
std::vector<Surface_point> descriptions(const Input& input, const Surface_point& p) {
  std::vector<Surface_point> result{p};
  const unsigned zeros = static_cast<unsigned>(std::count(p.weights.begin(), p.weights.end(), 0.0));
  std::uint32_t h = p.halfedge;
  for (unsigned k = 0; k < 3; ++k, h = input.next(h)) {
    if (zeros == 1 && p.weights[(k + 2) % 3] == 0 && !input.is_border(h ^ 1U))
      result.push_back({h ^ 1U, {p.weights[(k + 1) % 3], p.weights[k], 0}});
    if (zeros != 2 || p.weights[k] == 0) continue;
    std::uint32_t g = h; // about the vertex: counterclockwise, then from the border on
    while (!input.is_border(g = next_around_source(input, g)) && g != h) result.push_back({g});
    if (g == h) break;
    for (g = h; !input.is_border(g ^ 1U);) result.push_back({g = input.next(g ^ 1U)});
  }
  return result;
}

// Two points as seen from one halfedge of a face that they are both in, if there is one.
template <class Input>
std::optional<std::pair<Surface_point, Surface_point>>
in_one_face(const Input& input, const Surface_point& p, const Surface_point& q) {
  const std::vector<Surface_point> of_q = descriptions(input, q);
  for (const Surface_point& a : descriptions(input, p))
    for (const Surface_point& b : of_q)
      if (input.face(a.halfedge) == input.face(b.halfedge))
        return std::pair(a, seen_from(input, b, a.halfedge));
  return {};
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRACING_COMMON_FACE_H

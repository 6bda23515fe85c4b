// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINED_FACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_options.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
What refinement asks of faces: their values, which one comes first, why one stays as it is.
*/

namespace CGAL::Intrinsic_triangulations::internal {

template <class Triangulation>
Indexed_face indexed_face(const Triangulation& t, typename Triangulation::face_descriptor f) {
  const auto h = halfedge(f, t.mesh()), n = next(h, t.mesh()), l = next(n, t.mesh());
  const auto edge_number = [&t](auto g) { return t.numbers().halfedge(g) / 2; };
  return {t.index(f), {edge_number(h), edge_number(n), edge_number(l)}};
}

// in scaled units
template <class Triangulation>
Face_values<double> approximate_values(const Triangulation& t,
                                       typename Triangulation::face_descriptor f) {
  const Indexed_face i = indexed_face(t, f);
  const auto& m = t.metric();
  return {{m.approximate_squared_length(i.edges[0]), m.approximate_squared_length(i.edges[1]),
           m.approximate_squared_length(i.edges[2])},
          m.approximate_quadruple_area(i.face)};
}

// R = abc / (4 A)
inline double squared_circumradius(const Face_values<double>& v) {
  const auto& [l, a] = v;
  return l[0] / a * l[1] * (l[2] / a);
}

// The face of the greatest one comes first: largest circumradius, or greatest cotangent.
inline double refinement_priority(Refinement_order order, const Face_values<double>& v) {
  if (order == Refinement_order::first_come) return 0;
  if (order == Refinement_order::largest_first) return squared_circumradius(v);
  const auto& [l, a] = v;
  return (l[0] + l[1] + l[2] - 2 * std::min({l[0], l[1], l[2]})) / a;
}

// Why a face stays that does not meet the criteria.
inline Unsatisfied_reason unsatisfied_reason(Face_state s, bool was_stopped) {
  if (s == Face_state::needle) return Unsatisfied_reason::needle;
  if (s == Face_state::small_angle) return Unsatisfied_reason::small_angle;
  return was_stopped ? Unsatisfied_reason::stopped : Unsatisfied_reason::refused;
}

// Halfedges of the faces inside a rim, one each, as many as are asked for at most; each face is found from
// the first halfedge of the rim.
template <class Triangulation>
std::vector<typename Triangulation::halfedge_descriptor>
faces_inside(const Triangulation& t,
             const std::vector<typename Triangulation::halfedge_descriptor>& rim,
             std::size_t most) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  std::vector<Halfedge> stack{rim.front()}, found;
  std::vector<std::uint32_t> seen;
  while (!stack.empty() && seen.size() < most) {
    const Halfedge h = stack.back();
    stack.pop_back();
    const std::uint32_t f = t.index(face(h, t.mesh()));
    if (std::find(seen.begin(), seen.end(), f) != seen.end()) continue;
    seen.push_back(f);
    found.push_back(h);
    for (Halfedge g = next(h, t.mesh()); g != h; g = next(g, t.mesh()))
      if (std::find(rim.begin(), rim.end(), g) == rim.end()) stack.push_back(opposite(g, t.mesh()));
  }
  return found;
}

// Whether a vertex has no neighbour nearer than a distance, squared, in scaled units. Edges from it to
// itself may be shorter, about vertices of small angle.
template <class Triangulation>
bool keeps_distance(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                    double squared) {
  bool keeps = true;
  for_each_outgoing(v, t.mesh(), [&](auto h) {
    keeps = keeps && (target(h, t.mesh()) == v || t.metric().approximate_squared_length(
                                                      t.numbers().halfedge(h) / 2) >= squared);
  });
  return keeps;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINED_FACES_H

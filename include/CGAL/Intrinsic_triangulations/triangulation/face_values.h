// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FACE_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FACE_VALUES_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

// Stores intervals, which can be made narrow.
template <class Metric>
concept Has_enclosures = requires(const Metric& m, std::span<const Indexed_face> faces) {
  m.is_narrow(faces.front());
  typename Metric::Scope;
};

// The numbers of the face of a halfedge and of its sides, from that one on.
template <class Triangulation>
Indexed_face indexed_face_from(const Triangulation& t,
                               typename Triangulation::halfedge_descriptor h) {
  const auto n = next(h, t.mesh()), l = next(n, t.mesh());
  const auto edge_number = [&t](auto g) { return t.index(edge(g, t.mesh())); };
  return {t.index(face(h, t.mesh())), {edge_number(h), edge_number(n), edge_number(l)}};
}

// The numbers of a face and of its sides, from its halfedge on.
template <class Triangulation>
Indexed_face indexed_face(const Triangulation& t, typename Triangulation::face_descriptor f) {
  return indexed_face_from(t, halfedge(f, t.mesh()));
}

template <class Metric>
Face_values<double> approximate_values(const Metric& metric, const Indexed_face& face) {
  return {{metric.approximate_squared_length(face.edges[0]),
           metric.approximate_squared_length(face.edges[1]),
           metric.approximate_squared_length(face.edges[2])},
          metric.approximate_quadruple_area(face.face)};
}

// What is stored of a face, in scaled units.
template <class Triangulation>
Face_values<double> approximate_values(const Triangulation& t,
                                       typename Triangulation::face_descriptor f) {
  return approximate_values(t.metric(), indexed_face(t, f));
}

// The values of a face in scaled units, for users: with exact traits, intervals are made narrow first, and doubles with them.
template <class Triangulation>
Face_values<double> accurate_values(const Triangulation& t,
                                    typename Triangulation::face_descriptor f) {
  const Indexed_face face = indexed_face(t, f);
  if constexpr (Has_enclosures<typename Triangulation::Metric>) {
    if (!t.metric().is_narrow(face)) {
      const typename Triangulation::Metric::Scope scope;
      t.sharpen(std::span(&face, 1));
    }
  }
  return approximate_values(t.metric(), face);
}

// The squared length of an edge in scaled units, for users; see above.
template <class Triangulation>
double accurate_squared_length(const Triangulation& t, typename Triangulation::edge_descriptor e) {
  const std::uint32_t i = t.index(e);
  if constexpr (Has_enclosures<typename Triangulation::Metric>)
    if (!t.metric().is_narrow(i)) {
      const auto& mesh = t.mesh();
      const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
      const auto h = halfedge(e, mesh);
      const typename Triangulation::Metric::Scope scope;
      t.sharpen_length(
          indexed_face_from(t, face(h, mesh) != null ? h : opposite(h, mesh)));
    }
  return t.metric().approximate_squared_length(i);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_FACE_VALUES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FINE_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FINE_SURFACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A triangulation in plain arrays, as simplification reads it: sides are 3f + k.
struct Fine_surface {
  Gluing gluing;                      // vertices without gaps, isolated ones included
  std::vector<std::uint32_t> row;     // the user's vertex of each vertex
  std::uint32_t number_of_rows = 0;   // the number of the user's vertices
  std::vector<double> squared_length; // of each side, in scaled units
  std::vector<double> error;          // of each squared length, at most; empty: none
  std::vector<std::uint32_t> edge;    // of each side: its number in the triangulation
  int scale_exponent = 0;             // squared lengths are scaled by 4^s
};

// The squared length of an edge, and its greatest error.
template <class Triangulation>
std::pair<double, double> nearly_exact_squared_length(const Triangulation& t, std::uint32_t e) {
  const double l = t.metric().approximate_squared_length(e);
  if constexpr (Encloses_lengths<typename Triangulation::Metric>) {
    const auto [inf, sup] = CGAL::to_interval(t.metric().squared_length(e));
    const double error = sup - l > l - inf ? sup - l : l - inf;
    return {l, inf == sup && l == inf ? 0 : error + l * 0x1p-52};
  } else {
    return {l, 0};
  }
}

// Narrows the stored intervals of faces that flips have widened.
template <class Triangulation>
void narrow_lengths(const Triangulation& t) {
  if constexpr (Has_enclosures<typename Triangulation::Metric>) {
    const typename Triangulation::Metric::Scope scope;
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const Indexed_face face = indexed_face(t, f);
      if (!t.metric().is_narrow(face, 0x1p-49)) t.sharpen(std::span(&face, 1));
    }
  }
}

// \throws Invalid_input if faces are glued along the direction of both
template <NumberedTriangulation Triangulation>
Fine_surface fine_surface(const Triangulation& t) {
  const auto& mesh = t.mesh();
  Fine_surface s;
  s.scale_exponent = t.metric().scale_exponent();
  s.number_of_rows = t.number_of_vertices();
  std::vector<std::uint32_t> vertex(t.numbers().vertex_capacity(mesh), Gluing::none);
  for (const typename Triangulation::vertex_descriptor v : vertices(mesh)) {
    vertex[t.index(v)] = s.gluing.number_of_vertices++;
    s.row.push_back(t.input_vertex(v));
  }
  narrow_lengths(t);
  std::vector<std::uint32_t> side(2 * t.numbers().edge_capacity(mesh), Gluing::none);
  std::vector<typename Triangulation::halfedge_descriptor> halfedges;
  for (const typename Triangulation::face_descriptor f : faces(mesh)) {
    auto h = halfedge(f, mesh);
    for (int k = 0; k < 3; ++k, h = next(h, mesh)) {
      side[t.numbers().halfedge(h)] = static_cast<std::uint32_t>(halfedges.size());
      halfedges.push_back(h);
      s.gluing.origin.push_back(vertex[t.index(source(h, mesh))]);
      s.edge.push_back(t.index(edge(h, mesh)));
      const auto [length, error] = nearly_exact_squared_length(t, s.edge.back());
      s.squared_length.push_back(length);
      s.error.push_back(error);
    }
  }
  for (const auto h : halfedges) {
    const auto o = opposite(h, mesh);
    s.gluing.glue.push_back(CGAL::is_border(o, mesh) ? Gluing::none
                                                     : side[t.numbers().halfedge(o)]);
  }
  return s;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_FINE_SURFACE_H

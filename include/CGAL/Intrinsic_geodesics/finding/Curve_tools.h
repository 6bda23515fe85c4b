// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_FINDING_CURVE_TOOLS_H
#define CGAL_INTRINSIC_GEODESICS_FINDING_CURVE_TOOLS_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_geodesics/queries/add_geodesics.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Flip_log.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// What messages call a vertex.
template <class Triangulation>
std::string name_of_vertex(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return t.is_inserted(v) ? "a point inside of a face"
                          : "vertex " + std::to_string(t.input_vertex(v));
}

// What finds curves on a triangulation: it takes time linear in the mesh to make, and serves again.
template <class Triangulation>
struct Curve_tools {
  explicit Curve_tools(Triangulation& t) : network(t), find(t) {}

  // Shortest paths along edges from each vertex of a curve to the next.
  std::vector<typename Triangulation::halfedge_descriptor>
  way_along_edges(const Curve_through_vertices<Triangulation>& c) {
    using Vertex = typename Triangulation::vertex_descriptor;
    using Halfedge = typename Triangulation::halfedge_descriptor;
    const Triangulation& t = network.triangulation();
    std::vector<Halfedge> way;
    const std::size_t n = c.vertices.size();
    for (std::size_t i = 0; i + (c.is_loop ? 0 : 1) < n; ++i) {
      const Vertex from = c.vertices[i], to = c.vertices[(i + 1) % n];
      std::vector<Halfedge> piece = find(from, to);
      if (piece.empty()) // from another copy, and to one
        piece = find(copies_of_vertex(t, from), copies_of_vertex(t, to));
      if (piece.empty())
        throw Invalid_input(Element_kind::vertex, t.input_vertex(from),
                            "no path leads from " + name_of_vertex(t, from) + " to " +
                                name_of_vertex(t, to) +
                                ", which are in different components; choose points of one");
      way.insert(way.end(), piece.begin(), piece.end());
    }
    return way;
  }

  Curve_network<Triangulation> network;
  Edge_path_finder<Triangulation> find;
  // Remembers flips, if these are to be taken back: then no edges are labelled.
  Flip_log<Triangulation>* log = nullptr;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_FINDING_CURVE_TOOLS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_WHOLE_STAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_WHOLE_STAR_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>

#include <boost/graph/graph_traits.hpp>

#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The star of the source of a halfedge, which is its first spoke; none on the border, or if an edge joins the vertex to
// itself.
template <class Mesh>
std::optional<Whole_star> whole_star(typename boost::graph_traits<Mesh>::halfedge_descriptor first,
                                     const Mesh& mesh, const Mesh_adaptor<Mesh>& number) {
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;
  Whole_star s;
  Halfedge h = first;
  do {
    if (face(h, mesh) == boost::graph_traits<Mesh>::null_face() ||
        target(h, mesh) == source(h, mesh))
      return std::nullopt;
    s.spokes.push_back(number.halfedge(h) / 2);
    s.rim.push_back(number.halfedge(next(h, mesh)) / 2);
    s.faces.push_back(number.face(face(h, mesh)));
    h = opposite(next(next(h, mesh), mesh), mesh);
  } while (h != first);
  return s;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_WHOLE_STAR_H

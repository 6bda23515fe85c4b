// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_LABELS_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_LABELS_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief labels the edges along curves, so that they outlive the network as constrained edges (§5.4 of the course).

To be passed as named parameter `edge_is_constrained_map`: the edges are not flipped, and if refinement splits one, its parts
have its label. Thus each curve stays the union of the edges of its label. Where curves run along one edge, the first of them
labels it: they are to be told apart by `Curve_network::curves_along()` before.
\tparam Triangulation a model of `GeodesicTriangulation`
\param network the curves; the map does not refer to them
\return for each edge the number of the first curve along it, plus one; 0 for edges without curve
\complexity linear in the number of halfedges of the curves
*/
template <class Triangulation>
Marked_edges<Triangulation, std::uint32_t>
curve_labels(const Curve_network<Triangulation>& network) {
  Marked_edges<Triangulation, std::uint32_t> labels(network.triangulation());
  for (std::uint32_t c = network.number_of_curves(); c-- > 0;)
    for (const auto h : network.halfedges(c))
      put(labels, edge(h, network.triangulation().mesh()), c + 1);
  return labels;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_LABELS_H

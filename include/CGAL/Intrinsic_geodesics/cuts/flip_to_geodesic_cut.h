// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_FLIP_TO_GEODESIC_CUT_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_FLIP_TO_GEODESIC_CUT_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a cut along geodesics that makes disks of a triangulated surface.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <GeodesicTriangulation Triangulation>
struct Geodesic_cut {
  Marked_edges<Triangulation> edges; ///< marks of the edges to cut
  Shortening_result shortening;      ///< what shortening did; if not `done`, it stopped before
};

namespace internal {

// The marked edges as curves that stay at given vertices and at the border.
template <class Triangulation, class VertexRange>
Curve_network<Triangulation> network_of_cut(Triangulation& t, const VertexRange& through,
                                            const Marked_edges<Triangulation>& marks) {
  Curve_network<Triangulation> network(t);
  for (const auto v : through) network.fix(v);
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh())) network.fix(target(h, t.mesh()));
  add_marked_edges(network, marks);
  return network;
}

// Adds vertices that a cut along curves must pass through besides those that are given: loose ends,
// and a vertex on each component that has no vertex to pass through and no border yet.
template <class Triangulation>
void add_roots(const Curve_network<Triangulation>& network, std::vector<std::uint32_t>& through) {
  const Triangulation& t = network.triangulation();
  const auto number = [&t](auto v) { return t.numbers().vertex(v); };
  std::vector<std::uint32_t> ends;
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c) {
    if (network.is_loop(c) || network.is_point(c)) continue;
    ends.push_back(number(network.start(c)));
    ends.push_back(number(target(network.halfedges(c).back(), t.mesh())));
  }
  std::vector<std::uint32_t> count(t.numbers().vertex_capacity(t.mesh()), 0);
  for (const std::uint32_t v : ends) ++count[v];
  for (const std::uint32_t v : ends)
    if (count[v] == 1) through.push_back(v);
  const std::vector<std::uint32_t> component = joined_sets(count.size(), [&](const auto& join) {
    for (const auto e : edges(t.mesh()))
      join(number(source(e, t.mesh())), number(target(e, t.mesh())));
  });
  std::vector<char> has_root(count.size(), 0);
  for (const std::uint32_t v : through) has_root[component[v]] = 1;
  for (const auto h : halfedges(t.mesh()))
    if (CGAL::is_border(h, t.mesh())) has_root[component[number(target(h, t.mesh()))]] = 1;
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c) {
    const std::uint32_t v = number(network.start(c));
    if (has_root[component[v]] == 0) through.push_back(v);
    has_root[component[v]] = 1;
  }
}

// A cut among the edges with curves: curves that join leave out what divides a disk. All other
// edges are longer than all curves together, and the roots are on curves.
template <class Triangulation>
Marked_edges<Triangulation> cut_along_curves(const Curve_network<Triangulation>& network,
                                             std::vector<std::uint32_t> through) {
  const Triangulation& t = network.triangulation();
  Surface_to_cut s = surface_to_cut(t);
  double all = 0;
  for (const auto e : edges(t.mesh()))
    if (network.carries_curve(e)) all += s.length[s.side_of_edge(t.index(e))];
  for (const auto e : edges(t.mesh()))
    for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1})
      if (s.side[h] != Gluing::none && !network.carries_curve(e)) s.length[s.side[h]] += all;
  add_roots(network, through);
  return marks_of_cut(t, s, cut_to_disk(s, through, 0));
}

} // namespace internal

/*!
\brief finds a short cut that makes a disk of each component, see `cut_to_disk()`, and flips edges
until it is geodesic.

Between points where the cut branches, given vertices and the border, each part of the cut is a
geodesic then, the shortest near it. These points stay in place. Where parts join on their way,
parts that would divide a disk are left out.
\tparam Triangulation a model of `GeodesicTriangulation`
\tparam VertexRange a range of its vertices
\param t the triangulation
\param through vertices that the cut passes through
\param np optional named parameters: those of `shorten_curves()`
\return the cut: pass its edges as `edge_is_constrained_map()`, so that no other function flips them
\throws Invalid_input as `cut_to_disk()` does
\complexity that of `cut_to_disk()` and `shorten_curves()`
*/
template <GeodesicTriangulation Triangulation, std::ranges::input_range VertexRange,
          NamedParameters NP = parameters::Parameters<>>
  requires std::convertible_to < std::ranges::range_value_t<VertexRange>,
typename Triangulation::vertex_descriptor >
    Geodesic_cut<Triangulation> flip_to_geodesic_cut(Triangulation& t, const VertexRange& through,
                                                     const NP& np = parameters::default_values()) {
  Curve_network<Triangulation> network =
      internal::network_of_cut(t, through, cut_to_disk(t, through));
  const Shortening_result shortening = shorten_curves(network, np);
  std::vector<std::uint32_t> vertices;
  for (const typename Triangulation::vertex_descriptor v : through)
    vertices.push_back(t.numbers().vertex(v));
  return {internal::cut_along_curves(network, vertices), shortening};
}

/// finds a geodesic cut through no given vertices; see above.
template <GeodesicTriangulation Triangulation>
Geodesic_cut<Triangulation> flip_to_geodesic_cut(Triangulation& t) {
  return flip_to_geodesic_cut(t, std::vector<typename Triangulation::vertex_descriptor>());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_FLIP_TO_GEODESIC_CUT_H

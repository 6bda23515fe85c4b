// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EDGE_TRACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EDGE_TRACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/trace_signpost.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the paths of all intrinsic edges over the input: the input edges that each one crosses, from
the source of its halfedge `2e`.
*/
struct Edge_traces {
  /// For each edge number the index of its first crossing, and one entry more.
  std::vector<std::size_t> begin{0};
  /// The crossings of all edges: the halfedge of the input face that is left, and where it is crossed.
  std::vector<Geodesic_crossing> crossings;
  /// For each edge number the input halfedge that halfedge `2e` runs along, in its direction; none if
  /// it runs across faces. It may be a part of it only: between inserted vertices.
  std::vector<std::uint32_t> along;
  /// The first edge whose trace did not end at its end; none if all did.
  std::uint32_t first_failed = Gluing::none;
  /// Number of edges whose trace did not end at their ends: these have no crossings.
  std::uint32_t failed = 0;
  /// The first edge with a vertex so close to it that rounding may have decided the side.
  std::uint32_t first_uncertain = Gluing::none;
  /// Number of those.
  std::uint32_t uncertain = 0;

  /// tells whether all edges were traced, beyond rounding.
  bool is_certain() const { return failed == 0 && uncertain == 0; }
  /// returns the crossings of edge `e`.
  std::span<const Geodesic_crossing> operator[](std::uint32_t e) const {
    return {crossings.data() + begin[e], begin[e + 1] - begin[e]};
  }
};

/*!
\brief traces all intrinsic edges over the input.
\tparam Triangulation an instance of `Intrinsic_triangulation`
\param t the triangulation
\param signposts its signposts
\return the traces, and what failed
\complexity linear in the number of edges and crossings
*/
template <class Triangulation, class Signposts>
Edge_traces trace_edges(const Triangulation& t, const Signposts& signposts) {
  std::vector<char> exists;
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
    const std::size_t i = t.index(e);
    if (i >= exists.size()) exists.resize(i + 1, 0);
    exists[i] = 1;
  }
  Edge_traces traces;
  traces.along.assign(exists.size(), Gluing::none);
  traces.begin.reserve(exists.size() + 1);
  std::vector<Strip_side> strip;
  for (std::uint32_t e = 0; e < exists.size(); ++e) {
    if (exists[e] != 0) {
      const Geodesic_to_target r =
          internal::trace_signpost(t, signposts, 2 * e, traces.crossings, strip);
      traces.along[e] = r.along;
      if (!r.is_reached && traces.failed++ == 0) traces.first_failed = e;
      if (r.is_reached && !r.is_certain && traces.uncertain++ == 0) traces.first_uncertain = e;
    }
    traces.begin.push_back(traces.crossings.size());
  }
  return traces;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EDGE_TRACES_H

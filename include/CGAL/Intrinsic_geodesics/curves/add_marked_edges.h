// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_ADD_MARKED_EDGES_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_ADD_MARKED_EDGES_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <concepts>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Marked edges as loops and as chains between junctions; at a junction, not exactly two meet.
template <class Triangulation>
class Marked_chains {
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  using Chain = std::vector<Halfedge>;

  template <class Map>
  Marked_chains(const Triangulation& t, const Map& is_marked)
      : t_(t), at_(t.numbers().vertex_capacity(t.mesh())),
        is_waiting_(t.numbers().edge_capacity(t.mesh()), 0) {
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
      if (!get(is_marked, e)) continue;
      is_waiting_[t.index(e)] = 1;
      for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1}) {
        Marks& m = at_[source(h)];
        if (m.count < 2) m.outgoing[m.count] = h;
        ++m.count;
        marked_.push_back(h);
      }
    }
    for (Marks& m : at_) m.is_passage = m.count == 2 && are_in_one_fan(m.outgoing);
  }

  template <class Function>
  void for_each_junction(const Function& f) const {
    for (std::uint32_t v = 0; v < at_.size(); ++v)
      if (at_[v].count != 0 && !at_[v].is_passage) f(t_.numbers().vertex_at(v));
  }
  // once each, the chains that end at junctions before the loops
  template <class Function>
  void for_each_chain(const Function& f) {
    for (const bool is_loop : {false, true})
      for (const std::uint32_t h : marked_)
        if (is_waiting_[h / 2] != 0 && (is_loop || !at_[source(h)].is_passage))
          f(chain(h), is_loop);
  }

private:
  struct Marks {
    std::uint32_t count = 0;
    std::array<std::uint32_t, 2> outgoing{Gluing::none, Gluing::none};
    bool is_passage = false;
  };

  // at a vertex that is not manifold, two edges may be in different fans
  bool are_in_one_fan(const std::array<std::uint32_t, 2>& outgoing) const {
    Halfedge h = t_.numbers().halfedge_at(outgoing[0]);
    while (t_.numbers().halfedge(h) != outgoing[1]) {
      h = next(opposite(h, t_.mesh()), t_.mesh());
      if (t_.numbers().halfedge(h) == outgoing[0]) return false;
    }
    return true;
  }

  std::uint32_t source(std::uint32_t h) const {
    return t_.index(target(t_.numbers().halfedge_at(h ^ 1U), t_.mesh()));
  }

  // from a halfedge to the next junction, or all the way round
  Chain chain(std::uint32_t h) {
    Chain result;
    while (is_waiting_[h / 2] != 0) {
      is_waiting_[h / 2] = 0;
      result.push_back(t_.numbers().halfedge_at(h));
      const Marks& m = at_[source(h ^ 1U)];
      if (!m.is_passage) break;
      h = m.outgoing[m.outgoing[0] == (h ^ 1U) ? 1 : 0];
    }
    return result;
  }

  const Triangulation& t_;
  std::vector<Marks> at_; // per vertex
  std::vector<char> is_waiting_;
  std::vector<std::uint32_t> marked_; // halfedges
};

} // namespace internal

/*!
\brief adds the marked edges of a triangulation to a network, each once: a cut graph, seams, or
  borders of regions.

Vertices where one marked edge ends, more than two meet, or two from different fans of faces meet,
are junctions: they are fixed. Chains of edges between junctions become paths, all other edges
loops.
\tparam Triangulation a model of `GeodesicTriangulation`
\tparam EdgeIsMarked a readable property map from its edges to `bool`; `constrained_input_edges()`
  makes one from edges of the user's mesh
\param network the curves
\param is_marked is true for the edges to add
\return the number of curves added
\throws Invalid_input if an added curve crosses an older one; the curves added before it stay
\complexity linear in the mesh
*/
template <GeodesicTriangulation Triangulation, class EdgeIsMarked>
  requires requires(const EdgeIsMarked& map, typename Triangulation::edge_descriptor e) {
    { get(map, e) } -> std::convertible_to<bool>;
  }
std::uint32_t add_marked_edges(Curve_network<Triangulation>& network,
                               const EdgeIsMarked& is_marked) {
  using Chains = internal::Marked_chains<Triangulation>;
  Chains chains(network.triangulation(), is_marked);
  chains.for_each_junction([&](typename Triangulation::vertex_descriptor v) { network.fix(v); });
  std::uint32_t count = 0;
  chains.for_each_chain([&](const typename Chains::Chain& chain, bool is_loop) {
    if (is_loop)
      network.add_loop(chain);
    else
      network.add_path(chain);
    ++count;
  });
  return count;
}

/*!
\brief labels the edges along curves, so that they outlive the network as constrained edges (§5.4 of
  the course).

Pass the map as named parameter `edge_is_constrained_map`: algorithms do not flip its edges, and if
refinement splits one, the parts keep its label. So each curve stays the union of the edges of its
label. If curves share an edge, the first one labels it; `Curve_network::curves_along()` lists all.
\tparam Triangulation a model of `GeodesicTriangulation`
\param network the curves; the map does not refer to them
\return for each edge the number of the first curve along it, plus one; 0 for edges without curve
\complexity linear in the number of halfedges of the curves
*/
template <GeodesicTriangulation Triangulation>
Marked_edges<Triangulation, std::uint32_t>
curve_labels(const Curve_network<Triangulation>& network) {
  Marked_edges<Triangulation, std::uint32_t> labels(network.triangulation());
  for (std::uint32_t c = network.number_of_curves(); c-- > 0;)
    for (const auto h : network.halfedges(c))
      put(labels, edge(h, network.triangulation().mesh()), c + 1);
  return labels;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_ADD_MARKED_EDGES_H

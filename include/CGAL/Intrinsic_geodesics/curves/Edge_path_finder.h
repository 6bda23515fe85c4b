// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_EDGE_PATH_FINDER_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_EDGE_PATH_FINDER_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// No curve starts, passes or ends at a vertex without faces.
template <class Triangulation>
void expect_no_isolated_vertex(const Triangulation& t,
                               typename Triangulation::vertex_descriptor v) {
  if (!is_isolated(t, v)) return;
  std::uint32_t i = t.index(v);
  if constexpr (requires { t.input_vertex(v); }) i = t.input_vertex(v);
  throw Invalid_input(Element_kind::vertex, i,
                      "vertex " + std::to_string(i) +
                          " is isolated: no face has it; choose another");
}

} // namespace internal

/*!
\brief finds shortest paths along edges between vertices, by Dijkstra's algorithm from both ends.

Lengths are those of the triangulation, in doubles. Searches share memory, so each costs only what
it visits; on a surface with nonmanifold vertices each takes linear time. At such a vertex a path
may go on in any fan of faces.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <GeodesicTriangulation Triangulation>
class Edge_path_finder {
public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the triangulation.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;

  /// prepares searches. \param t the triangulation; it must outlive the finder, and may change
  /// between searches
  explicit Edge_path_finder(const Triangulation& t) : t_(t) {}

  /*!
  \brief finds a shortest path along edges.
  \return its halfedges from `from` to `to`; empty if they are equal or not connected
  \throws Invalid_input if a vertex is isolated
  \complexity n log n in the number of vertices nearer to an end than the ends are to each other
  */
  std::vector<halfedge_descriptor> operator()(vertex_descriptor from, vertex_descriptor to) {
    return (*this)(std::vector{from}, std::vector{to});
  }
  /// finds a shortest path along edges from one of several vertices to one of others, as between
  /// copies of two vertices on a cover; see above.
  std::vector<halfedge_descriptor> operator()(const std::vector<vertex_descriptor>& from,
                                              const std::vector<vertex_descriptor>& to) {
    start();
    label_ends(0, from);
    label_ends(1, to);
    while (!sides_[0].queue.empty() && !sides_[1].queue.empty() &&
           sides_[0].queue.top().first + sides_[1].queue.top().first < best_)
      advance(sides_[0].queue.top().first <= sides_[1].queue.top().first ? 0U : 1U);
    return path();
  }

  /*!
  \brief finds the shortest paths along edges from each of several vertices to the next one.
  \return their halfedges, one path after another
  \throws Invalid_input naming two vertices that no edges join, or one that is isolated
  \complexity that of a search for each path
  */
  std::vector<halfedge_descriptor> through(const std::vector<vertex_descriptor>& points) {
    std::vector<halfedge_descriptor> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const std::vector<halfedge_descriptor> way = (*this)(points[i], points[i + 1]);
      if (way.empty())
        throw Invalid_input(Element_kind::vertex, t_.input_vertex(points[i]),
                            "no edges lead from vertex " +
                                std::to_string(t_.input_vertex(points[i])) + " to vertex " +
                                std::to_string(t_.input_vertex(points[i + 1])) +
                                "; choose different vertices of one component");
      result.insert(result.end(), way.begin(), way.end());
    }
    return result;
  }

private:
  static constexpr std::uint32_t none = Gluing::none;

  // the best way so far to a vertex from one end
  struct Label {
    double distance;
    std::uint32_t halfedge; // the last one to it
    std::uint32_t search;   // its search
  };
  using Entry = std::pair<double, std::uint32_t>;
  struct Side {
    std::vector<Label> labels;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  };

  void start() {
    find_other_fans();
    ++search_;
    best_ = std::numeric_limits<double>::infinity();
    meeting_ = none;
    for (Side& s : sides_) {
      s.labels.resize(t_.numbers().vertex_capacity(t_.mesh()), {0, none, 0});
      s.queue = {};
    }
  }
  void label_ends(unsigned k, const std::vector<vertex_descriptor>& ends) {
    for (const vertex_descriptor v : ends) {
      internal::expect_no_isolated_vertex(t_, v);
      label(k, t_.index(v), 0, none);
    }
  }

  // Finds a halfedge of each fan of a vertex, without the fan of its own halfedge. Flips keep the
  // number of fans.
  void find_other_fans() {
    if (is_manifold_) return;
    other_fans_.clear();
    std::vector<char> is_seen(2 * std::size_t{t_.numbers().edge_capacity(t_.mesh())}, 0);
    const auto see = [&](halfedge_descriptor h) { is_seen[t_.numbers().halfedge(h)] = 1; };
    for (const vertex_descriptor v : vertices(t_.mesh()))
      if (!internal::is_isolated(t_, v)) for_each_outgoing(v, t_.mesh(), see);
    for (const halfedge_descriptor h : halfedges(t_.mesh()))
      if (is_seen[t_.numbers().halfedge(h)] == 0) {
        other_fans_.emplace(t_.index(source(h, t_.mesh())), h);
        for_each_outgoing_in_fan(h, t_.mesh(), see);
      }
    is_manifold_ = other_fans_.empty();
  }

  bool is_labelled(unsigned k, std::uint32_t v) const {
    return sides_[k].labels[v].search == search_;
  }

  void label(unsigned k, std::uint32_t v, double distance, std::uint32_t halfedge) {
    sides_[k].labels[v] = {distance, halfedge, search_};
    sides_[k].queue.emplace(distance, v);
    if (!is_labelled(1 - k, v) || distance + sides_[1 - k].labels[v].distance >= best_) return;
    best_ = distance + sides_[1 - k].labels[v].distance;
    meeting_ = v;
  }

  // takes the nearest vertex of a side
  void advance(unsigned k) {
    const double distance = sides_[k].queue.top().first;
    const std::uint32_t v = sides_[k].queue.top().second;
    sides_[k].queue.pop();
    if (distance > sides_[k].labels[v].distance) return;
    const auto relax = [&](halfedge_descriptor h) {
      const std::uint32_t i = t_.numbers().halfedge(h), w = t_.index(target(h, t_.mesh()));
      const double d = distance + std::sqrt(t_.metric().approximate_squared_length(i / 2));
      if (!is_labelled(k, w) || d < sides_[k].labels[w].distance) label(k, w, d, i);
    };
    for_each_outgoing(t_.numbers().vertex_at(v), t_.mesh(), relax);
    const auto [first, last] = other_fans_.equal_range(v);
    for (auto fan = first; fan != last; ++fan)
      for_each_outgoing_in_fan(fan->second, t_.mesh(), relax);
  }

  std::vector<halfedge_descriptor> path() const {
    std::vector<halfedge_descriptor> result;
    if (meeting_ == none) return result;
    const auto walk = [&](unsigned k) {
      for (std::uint32_t v = meeting_; sides_[k].labels[v].halfedge != none;) {
        const halfedge_descriptor h = t_.numbers().halfedge_at(sides_[k].labels[v].halfedge);
        result.push_back(k == 0 ? h : opposite(h, t_.mesh()));
        v = t_.index(source(h, t_.mesh()));
      }
    };
    walk(0);
    std::reverse(result.begin(), result.end());
    walk(1);
    return result;
  }

  const Triangulation& t_;
  std::array<Side, 2> sides_;
  bool is_manifold_ = false; // set by the first search
  std::unordered_multimap<std::uint32_t, halfedge_descriptor> other_fans_;
  std::uint32_t search_ = 0;
  double best_ = 0;
  std::uint32_t meeting_ = none;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_EDGE_PATH_FINDER_H

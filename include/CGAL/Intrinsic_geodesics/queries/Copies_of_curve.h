// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_COPIES_OF_CURVE_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_COPIES_OF_CURVE_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief chooses copies of the points of a curve on a cover: so that the shortest paths from each to
the next are as short as can be, and among these change from one copy of a vertex to another as
rarely as can be.
*/
template <class Triangulation>
class Copies_of_curve {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Vertices = std::vector<Vertex>;

public:
  /// prepares a choice. \param copies those of each point
  Copies_of_curve(const Triangulation& t, const std::vector<Vertices>& copies, bool is_loop)
      : t_(t), copies_(copies), is_loop_(is_loop), legs_(copies.size() - (is_loop ? 0 : 1)) {
    for (std::size_t i = 0; i < legs_.size(); ++i) legs_[i].resize(copies[i].size());
  }

  /// returns the copies. A loop that comes to another copy of its start than it left goes around
  /// again.
  Vertices chosen() {
    for (std::size_t k = 0; k < copies_[0].size() && are_linked(); ++k) {
      if (is_loop_ || k == 0) is_dead_end_.assign(legs_.size(), {});
      if (std::vector<std::size_t> way{k}; find_direct(way)) return along(way);
    }
    if (is_loop_) return chosen_loop();
    Layers layers{std::vector<Cost>(copies_[0].size(), Cost{0, 0, 0})};
    for (std::size_t i = 0; i < legs_.size(); ++i) layers.push_back(next_layer(layers.back(), i));
    const std::vector<Cost>& last = layers.back();
    return along(layers, static_cast<std::size_t>(
                             std::min_element(last.begin(), last.end(), is_less) - last.begin()));
  }

private:
  // what it costs to come to a copy, and from which copy of the point before
  struct Cost {
    double length = std::numeric_limits<double>::infinity();
    std::size_t passages = 0, before = 0;
  };
  using Layers = std::vector<std::vector<Cost>>;

  static bool is_less(const Cost& a, const Cost& b) {
    constexpr double rounding = 1e-11; // of sums of up to 90 000 lengths, by 2^-53 for each
    if (a.length < b.length * (1 - rounding)) return true;
    return a.length * (1 - rounding) <= b.length && a.passages < b.passages;
  }

  // Whether the copies of each point are one point for distances: then all are equally far.
  bool are_linked() const {
    return std::all_of(copies_.begin(), copies_.end(), [this](const Vertices& copies) {
      return std::all_of(copies.begin(), copies.end(),
                         [&](Vertex v) { return are_copies(t_, v, copies.front()); });
    });
  }

  // Goes on to the end, or around, without a change of copies, if that is possible.
  bool find_direct(std::vector<std::size_t>& way) {
    const std::size_t i = way.size() - 1;
    if (i == legs_.size()) {
      if (is_loop_) way.pop_back();
      return true;
    }
    if (!is_dead_end_[i].insert(way.back()).second) return false;
    const std::vector<Cost>& all = ways(i, way.back());
    for (std::size_t j = 0; j < all.size(); ++j) {
      if (!std::isfinite(all[j].length) || all[j].passages > 0 ||
          (is_loop_ && i + 1 == legs_.size() && j != way.front()))
        continue;
      way.push_back(j);
      if (find_direct(way)) return true;
      way.pop_back();
    }
    return false;
  }
  Vertices along(const std::vector<std::size_t>& way) const {
    Vertices result;
    for (std::size_t i = 0; i < way.size(); ++i) result.push_back(copies_[i][way[i]]);
    return result;
  }

  // from a copy of a point to all of the next one
  const std::vector<Cost>& ways(std::size_t i, std::size_t k) {
    if (std::vector<Cost>& found = legs_[i][k]; !found.empty()) return found;
    const Vertices& to = copies_[(i + 1) % copies_.size()];
    const Polyhedral_distance<Triangulation> distance(t_, copies_[i][k], parameters::targets(to));
    for (const Vertex v : to)
      legs_[i][k].push_back({distance.distance(v), passages(distance.shortest_path(v).points), 0});
    return legs_[i][k];
  }

  std::size_t passages(const std::vector<Surface_point>& points) const {
    const auto vertex = [&](const Surface_point& p) {
      return source(t_.numbers().halfedge_at(p.halfedge), t_.mesh());
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i].weights[0] == 1 && points[i + 1].weights[0] == 1 &&
          vertex(points[i]) != vertex(points[i + 1]) &&
          are_copies(t_, vertex(points[i]), vertex(points[i + 1])))
        ++count;
    return count;
  }

  // \param i number of a point, whose costs are in a layer
  std::vector<Cost> next_layer(const std::vector<Cost>& layer, std::size_t i) {
    std::vector<Cost> result(copies_[(i + 1) % copies_.size()].size());
    for (std::size_t k = 0; k < layer.size(); ++k)
      for (std::size_t j = 0; std::isfinite(layer[k].length) && j < result.size(); ++j) {
        const Cost& way = ways(i, k)[j];
        const Cost c{layer[k].length + way.length, layer[k].passages + way.passages, k};
        if (is_less(c, result[j])) result[j] = c;
      }
    return result;
  }

  // the copies of all points up to one in the last layer
  Vertices along(const Layers& layers, std::size_t last) const {
    Vertices result(layers.size());
    for (std::size_t i = layers.size(); i-- > 0; last = layers[i].at(last).before)
      result[i] = copies_[i % copies_.size()][last];
    return result;
  }

  Vertices chosen_loop() {
    const std::size_t starts = copies_[0].size();
    Vertices best;
    Cost least;
    least.passages = std::numeric_limits<std::size_t>::max();
    for (std::size_t start = 0; start < starts; ++start) {
      Layers layers{std::vector<Cost>(starts)};
      layers[0][start].length = 0;
      for (std::size_t round = 0; round < starts; ++round) {
        for (std::size_t i = 0; i < legs_.size(); ++i)
          layers.push_back(next_layer(layers.back(), i));
        const Cost& c = layers.back()[start];
        const bool is_found = std::isfinite(c.length);
        if (best.empty() || (is_found && (c.passages < least.passages ||
                                          (c.passages == least.passages && is_less(c, least))))) {
          if (is_found) least = c;
          best = along(layers, start);
          best.pop_back();
        }
        if (is_found && c.passages == 0) break;
      }
    }
    return best;
  }

  const Triangulation& t_;
  const std::vector<Vertices>& copies_;
  bool is_loop_;
  std::vector<std::set<std::size_t>> is_dead_end_; // copies of each point
  // of each point, from each copy; empty: unknown
  std::vector<std::vector<std::vector<Cost>>> legs_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_COPIES_OF_CURVE_H

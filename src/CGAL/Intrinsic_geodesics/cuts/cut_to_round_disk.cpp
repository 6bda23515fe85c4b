// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

class Round_disk_cutter {
public:
  Round_disk_cutter(const Surface_to_cut& s, std::span<const std::uint32_t> through)
      : length_(s.length), fans_(cut_open(s.gluing, std::vector<char>(s.gluing.glue.size(), 0))),
        g_(fans_.gluing), is_fixed_(g_.number_of_vertices, 0), is_cut_(g_.glue.size(), 0),
        distance_(g_.number_of_faces(), infinity), entry_(g_.number_of_faces(), Gluing::none) {
    if (s.length.size() != g_.glue.size())
      throw Invalid_input(Element_kind::none, 0,
                          std::to_string(s.length.size()) + " lengths for " +
                              std::to_string(g_.glue.size()) + " sides; give one for each");
    for (const std::uint32_t v : through) {
      if (v >= s.gluing.number_of_vertices)
        throw Invalid_input::about(Element_kind::vertex, v,
                                   ", which a cut is to pass through, does not exist");
      is_fixed_[v] = 1; // and copies, which have the numbers after
    }
    for (std::size_t v = 0; v < is_fixed_.size(); ++v)
      is_fixed_[v] = is_fixed_[fans_.original_vertex[v]];
  }

  std::vector<char> run(std::size_t centers) {
    std::vector<char> is_done(entry_.size(), 0);
    for (std::uint32_t f = 0; f < entry_.size(); ++f) {
      if (is_done[f] != 0) continue;
      grow(best_center(f, centers));
      for (const std::uint32_t reached : order_) is_done[reached] = 1;
      cut_component();
    }
    prune();
    return std::move(is_cut_);
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::uint32_t partner(std::uint32_t h) const { return Gluing::partner(g_.glue[h]); }

  // The way to the middle of side `h` from that of the side through which a face is entered: half
  // of the third side. From the first face all sides are at the same distance.
  double way_through(std::uint32_t f, std::uint32_t h) const {
    const double *const l = &length_[3 * std::size_t{f}], sum = l[0] + l[1] + l[2];
    if (entry_[f] == Gluing::none) return sum / 6;
    return entry_[f] == h ? 0 : (sum - length_[h] - length_[entry_[f]]) / 2;
  }

  // Finds the shortest ways from a face; `order_` has all faces that are reached, the last one is
  // the farthest.
  void grow(std::uint32_t root) {
    for (const std::uint32_t f : order_) {
      distance_[f] = infinity;
      entry_[f] = Gluing::none;
    }
    order_.clear();
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance_[root] = 0;
    queue.emplace(0, root);
    while (!queue.empty()) {
      const auto [d, f] = queue.top();
      queue.pop();
      if (d > distance_[f]) continue;
      order_.push_back(f);
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        if (g_.glue[h] == Gluing::none) continue;
        const std::uint32_t other = partner(h) / 3;
        const double next = d + way_through(f, h);
        if (!(next < distance_[other])) continue;
        distance_[other] = next;
        entry_[other] = partner(h);
        queue.emplace(next, other);
      }
    }
  }

  // Goes from a center some way to the farthest face, less each time (Badoiu and Clarkson 2003).
  std::uint32_t best_center(std::uint32_t center, std::size_t centers) {
    std::uint32_t best = center;
    double least = infinity;
    for (std::size_t n = 0; n < std::max<std::size_t>(centers, 1); ++n) {
      grow(center);
      std::uint32_t f = order_.back();
      const double farthest = distance_[f];
      if (farthest < least) {
        least = farthest;
        best = center;
      }
      while (distance_[f] > farthest / static_cast<double>(n + 2)) f = partner(entry_[f]) / 3;
      center = f;
    }
    return best;
  }

  // Cuts all edges but those of the tree.
  void cut_component() {
    std::size_t sides = 0, fixed = 0;
    bool is_closed = true;
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t f : order_)
      for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
        corners.push_back(g_.origin[h]);
        if (g_.glue[h] == Gluing::none) is_closed = false;
        if (g_.glue[h] == Gluing::none || entry_[f] == h || entry_[partner(h) / 3] == partner(h))
          continue;
        is_cut_[h] = 1;
        ++sides;
      }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::uint32_t v : corners)
      if (is_fixed_[v] != 0) ++fixed;
    // the cut is a tree, of which nothing stays between less than two vertices
    if (is_closed && sides / 2 + 1 == corners.size() && fixed < 2)
      throw Invalid_input::about(Element_kind::face, order_.front(),
                                 " is on a sphere; name two vertices that the cut passes through");
  }

  // Takes edges out of the cut that end at a vertex with no other edge of it, one after another.
  void prune() {
    std::vector<std::uint32_t> degree(g_.number_of_vertices, 0), edges; // one side of each
    for (std::uint32_t h = 0; h < is_cut_.size(); ++h)
      if (g_.glue[h] == Gluing::none || (is_cut_[h] != 0 && h < partner(h))) {
        edges.push_back(h);
        for (const std::uint32_t v : ends(h)) ++degree[v];
      }
    std::vector<std::vector<std::uint32_t>> at(g_.number_of_vertices);
    for (const std::uint32_t h : edges)
      for (const std::uint32_t v : ends(h)) at[v].push_back(h);
    std::vector<std::uint32_t> loose;
    const auto is_loose = [&](std::uint32_t v) { return degree[v] == 1 && is_fixed_[v] == 0; };
    for (std::uint32_t v = 0; v < degree.size(); ++v)
      if (is_loose(v)) loose.push_back(v);
    while (!loose.empty()) {
      const std::uint32_t v = loose.back();
      loose.pop_back();
      for (const std::uint32_t h : at[v]) {
        if (is_cut_[h] == 0) continue;
        is_cut_[h] = is_cut_[partner(h)] = 0;
        for (const std::uint32_t w : ends(h)) {
          --degree[w];
          if (w != v && is_loose(w)) loose.push_back(w);
        }
      }
    }
  }

  std::array<std::uint32_t, 2> ends(std::uint32_t h) const {
    return {g_.origin[h], g_.origin[Gluing::next(h)]};
  }

  const std::vector<double>& length_; // of each side
  Opened_surface fans_;               // at vertices where fans of faces meet they are taken apart
  const Gluing& g_;
  std::vector<char> is_fixed_; // per vertex: no end of the cut there is loose
  std::vector<char> is_cut_;   // per side
  std::vector<double> distance_;
  std::vector<std::uint32_t> entry_; // of each face: the side through which its way comes
  std::vector<std::uint32_t> order_; // faces that were reached, by distance
};

} // namespace

} // namespace internal

std::vector<char> cut_to_round_disk(const Surface_to_cut& s, std::span<const std::uint32_t> through,
                                    std::size_t centers) {
  return internal::Round_disk_cutter(s, through).run(centers);
}

} // namespace CGAL::Intrinsic_triangulations

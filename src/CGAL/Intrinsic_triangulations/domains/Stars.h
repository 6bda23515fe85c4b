// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_STARS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_STARS_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The stars of all points of a cloud.
struct Stars {
  std::vector<std::uint32_t> corners;            // of one star after the other, by names
  std::vector<char> is_tied;                     // for each corner, see `Delaunay_star`
  std::vector<std::array<std::size_t, 2>> range; // for each name; empty if it has no star
  std::vector<char> is_open;                     // for each name
  std::vector<std::pair<std::int64_t, std::uint32_t>> order; // of names, by signatures

  std::span<const std::uint32_t> star(std::uint32_t center) const {
    return {corners.data() + range[center][0], range[center][1] - range[center][0]};
  }
};

// The triangles of all stars, ordered by what depends neither on axes nor on names: the order of
// faces decides how those are glued that make one angle at an edge.
inline std::vector<std::array<std::uint32_t, 3>> triangles_of(Stars stars) {
  std::vector<std::uint32_t> rank(stars.range.size(), 0);
  for (std::uint32_t i = 0; i < stars.order.size(); ++i) rank[stars.order[i].second] = i;
  const auto is_before = [&rank](std::uint32_t v, std::uint32_t w) { return rank[v] < rank[w]; };
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(stars.corners.size());
  for (const auto& [signature, center] : stars.order) {
    const auto [from, to] = stars.range[center];
    const std::span<std::uint32_t> star(stars.corners.data() + from, to - from);
    if (star.empty()) continue;
    const bool is_open = stars.is_open[center] != 0;
    if (!is_open) {
      std::rotate(star.begin(), std::ranges::min_element(star, is_before), star.end());
      if (is_before(star.back(), star[1])) std::ranges::reverse(star.subspan(1));
    } else if (is_before(star.back(), star.front())) {
      std::ranges::reverse(star);
    }
    for (std::size_t i = 0; i + is_open < star.size(); ++i)
      triangles.push_back({center, star[i], star[(i + 1) % star.size()]});
  }
  return triangles;
}

// Chooses the diagonals of points on a circle. If all of these points have the circle in their
// stars, the diagonals end at the point with the least number: Laplacians and lumped masses do not
// depend on that, since the polygon is covered three times and its diagonals have no weight.
// Otherwise they would. Then an edge stays if another star has it without a tie, and is left out if
// none has.
class Ties {
public:
  explicit Ties(Stars& stars) : stars_(stars) {
    for_each_polygon([&](const Polygon& p, auto&&...) { ++stars_with_[p]; });
  }

  void resolve() {
    if (stars_with_.empty()) return;
    std::vector<char> stays(stars_.corners.size(), 1);
    for_each_polygon([&](const Polygon& p, std::uint32_t center, const auto& tied) {
      const bool is_everywhere = stars_with_.at(p) == p.size();
      for (const std::size_t i : tied) {
        const std::uint32_t q = stars_.corners[i];
        stays[i] = is_everywhere ? center == p[0] || q == p[0] : is_edge_elsewhere(p, center, q);
      }
    });
    keep_those(stays);
  }

private:
  using Polygon = std::vector<std::uint32_t>; // names of points on a circle, sorted

  // Calls `visit(polygon, center, tied)` with the corners between which edges are tied, as numbers
  // in `corners`. In a star whose edges are all tied, they stay.
  template <class Visit>
  void for_each_polygon(const Visit& visit) const {
    Polygon polygon;
    std::vector<std::size_t> tied;
    for (const auto& [signature, center] : stars_.order) {
      const std::size_t from = stars_.range[center][0], to = stars_.range[center][1];
      for (std::size_t i = from; i < to; ++i) {
        const auto after = [=](std::size_t k) { return from + (i - from + k) % (to - from); };
        if (stars_.is_tied[i] || !stars_.is_tied[after(1)]) continue;
        polygon = {center, stars_.corners[i]};
        tied.clear();
        for (std::size_t k = 1; stars_.is_tied[after(k)]; ++k) tied.push_back(after(k));
        for (std::size_t k = 1; k <= tied.size() + 1; ++k)
          polygon.push_back(stars_.corners[after(k)]);
        std::ranges::sort(polygon);
        visit(polygon, center, tied);
      }
    }
  }

  bool is_edge_elsewhere(const Polygon& polygon, std::uint32_t v, std::uint32_t w) const {
    for (std::size_t i = stars_.range[w][0]; i < stars_.range[w][1]; ++i)
      if (stars_.corners[i] == v && !stars_.is_tied[i]) return true;
    return std::ranges::any_of(polygon, [&](std::uint32_t c) {
      const std::span<const std::uint32_t> star = stars_.star(c);
      for (std::size_t i = 0, n = star.size(); i + (stars_.is_open[c] ? 1 : 0) < n; ++i)
        if (std::minmax(star[i], star[(i + 1) % n]) == std::minmax(v, w)) return true;
      return false;
    });
  }

  void keep_those(const std::vector<char>& stays) {
    std::size_t kept = 0;
    std::vector<std::size_t> place(stays.size() + 1); // of each corner among those that stay
    for (std::size_t i = 0; i < stays.size(); ++i) {
      place[i] = kept;
      if (stays[i]) stars_.corners[kept++] = stars_.corners[i];
    }
    place[stays.size()] = kept;
    stars_.corners.resize(kept);
    for (auto& [from, to] : stars_.range) from = place[from], to = place[to];
    stars_.is_tied.clear(); // they are settled
  }

  Stars& stars_;
  std::map<Polygon, std::size_t> stars_with_; // how many have it
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_STARS_H

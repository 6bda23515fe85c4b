// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Where half planes bounded by a line are, seen from one of them. It calls only predicates of the
// kernel on the given points, which are exact.
class Half_planes {
public:
  using Point = Point_kernel::Point_3;

  // \param numbers that identify equal points without a predicate
  Half_planes(const Point& a, const Point& b, const std::vector<Point>& apices,
              const std::vector<std::uint32_t>& numbers)
      : a_(a), b_(b), apices_(apices), numbers_(numbers), sector_(apices.size(), 4) {
    std::size_t first = 0;
    while (first < apices.size() && Point_kernel::Are_collinear()(a, b, apices[first])) ++first;
    for (std::size_t i = first; i < apices.size(); ++i)
      sector_[i] = numbers[i] == numbers[first] ? 0 : sector(apices[first], apices[i]);
  }

  bool is_before(std::uint32_t i, std::uint32_t j) const {
    if (sector_[i] != sector_[j]) return sector_[i] < sector_[j];
    return sector_[i] % 2 == 1 && numbers_[i] != numbers_[j] &&
           Point_kernel::Find_orientation()(a_, b_, apices_[i], apices_[j]) == CGAL::POSITIVE;
  }

private:
  // 0: in the half plane of `first`, 1: less than half a turn from there, 2: half a turn, 3: more,
  // 4: on the line
  int sector(const Point& first, const Point& p) const {
    const CGAL::Orientation side = Point_kernel::Find_orientation()(a_, b_, first, p);
    if (side != CGAL::COPLANAR) return side == CGAL::POSITIVE ? 1 : 3;
    if (Point_kernel::Are_collinear()(a_, b_, p)) return 4;
    return Point_kernel::Find_orientation_in_plane()(a_, b_, first, p) == CGAL::POSITIVE ? 0 : 2;
  }

  const Point &a_, &b_;
  const std::vector<Point>& apices_;
  const std::vector<std::uint32_t>& numbers_;
  std::vector<int> sector_;
};

std::vector<std::uint32_t> sort_around_edge(const std::vector<std::array<double, 3>>& points,
                                            std::uint32_t a, std::uint32_t b,
                                            const std::vector<std::uint32_t>& apices) {
  const auto point = [&points](std::uint32_t v) {
    return Half_planes::Point(points[v][0], points[v][1], points[v][2]);
  };
  std::vector<Half_planes::Point> corners;
  for (const std::uint32_t v : apices) corners.push_back(point(v));
  const Half_planes::Point from = point(a), to = point(b);
  const Half_planes planes(from, to, corners, apices);
  std::vector<std::uint32_t> order(apices.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return planes.is_before(i, j); });
  return order;
}

// The umbrella that each halfedge starts in. \return the vertex of each umbrella
std::vector<std::uint32_t>
Double_cover::number_umbrellas(std::vector<std::uint32_t>& umbrella) const {
  const Gluing& g = cover_;
  std::vector<std::uint32_t> row;
  umbrella.assign(g.origin.size(), Gluing::none);
  for (std::uint32_t start = 0; start < g.origin.size(); ++start) {
    if (umbrella[start] != Gluing::none) continue;
    const auto number = static_cast<std::uint32_t>(row.size());
    row.push_back(g.origin[start]);
    std::uint32_t h = start; // counterclockwise
    while (h != Gluing::none && umbrella[h] == Gluing::none) {
      umbrella[h] = number;
      h = g.glue[Gluing::next(Gluing::next(h))];
    }
    if (h != Gluing::none) continue;
    for (h = g.glue[start]; h != Gluing::none; h = g.glue[Gluing::next(h)]) // and clockwise
      umbrella[Gluing::next(h)] = number;
  }
  return row;
}

// By vertices, then as copies are ordered: by their measures up to rounding, so that equal ones
// stay as they are.
std::vector<std::uint32_t> Double_cover::order_umbrellas(const std::vector<std::uint32_t>& row,
                                                         const std::vector<std::uint32_t>& umbrella,
                                                         const std::vector<Corner>& corners) const {
  std::vector<Corner> sums(row.size(), {0, 0});
  for (std::uint32_t h = 0; h < umbrella.size(); ++h) {
    const Corner& c = corners[h % 6 < 3 ? side(h) : Gluing::next(side(h))];
    sums[umbrella[h]].angle += c.angle;
    sums[umbrella[h]].opposite += c.opposite;
  }
  std::vector<std::array<std::int64_t, 2>> steps;
  steps.reserve(sums.size());
  // with 30 binary places, so that rounding decides on no order
  for (const Corner& c : sums)
    steps.push_back({-std::llround(std::ldexp(c.angle, 30)),
                     c.opposite > 0 ? -std::llround(std::ldexp(std::log2(c.opposite), 30)) : 0});
  std::vector<std::uint32_t> order(row.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return std::pair(row[i], steps[i]) < std::pair(row[j], steps[j]);
  });
  return order;
}

Gluing Double_cover::take(std::vector<std::uint32_t>& row_of_vertex,
                          const std::vector<Corner>& corners) {
  std::vector<std::uint32_t> umbrella;
  const std::vector<std::uint32_t> row = number_umbrellas(umbrella),
                                   order = order_umbrellas(row, umbrella, corners);
  std::vector<std::uint32_t> copy(row.size()), copies(cover_.number_of_vertices, 0);
  for (const std::uint32_t v : row) ++copies[v];
  row_of_vertex.clear();
  auto next = order.begin();
  for (std::uint32_t v = 0; v < copies.size(); ++v) {
    for (std::uint32_t k = 0; k < copies[v]; ++k)
      copy[*next++] = static_cast<std::uint32_t>(row_of_vertex.size()) + k;
    row_of_vertex.insert(row_of_vertex.end(), std::max(copies[v], 1U), v);
  }
  for (std::size_t h = 0; h < umbrella.size(); ++h) cover_.origin[h] = copy[umbrella[h]];
  cover_.number_of_vertices = static_cast<std::uint32_t>(row_of_vertex.size());
  return std::move(cover_);
}

// Whether there are at most two different apices: then the faces at them alternate, and no angle is
// computed, since two have only one cyclic order. This holds at nearly all edges of a point cloud,
// where each triangle occurs three times.
static bool take_turns(const std::vector<std::uint32_t>& apices,
                       std::vector<std::uint32_t>& order) {
  const auto count = static_cast<std::uint32_t>(apices.size());
  std::array<std::uint32_t, 2> next{0, 0}; // face of each apex
  while (next[1] < count && apices[next[1]] == apices[0]) ++next[1];
  if (next[1] == count) next[1] = 0;
  const std::array<std::uint32_t, 2> apex{apices[0], apices[next[1]]};
  for (const std::uint32_t v : apices)
    if (v != apex[0] && v != apex[1]) return false;
  order.clear();
  while (order.size() < apices.size())
    for (unsigned k = 0; k < 2; ++k) {
      while (next[k] < count && apices[next[k]] != apex[k]) ++next[k];
      if (next[k] < count) order.push_back(next[k]++);
      if (apex[0] == apex[1]) break;
    }
  return true;
}

// Whether the half planes of two points at the line from `a` to `b` are the same up to rounding:
// the sine of their angle is below 2^-30, as for ties of `Delaunay_star`.
static bool is_same_half_plane(const std::array<double, 3>& a, const std::array<double, 3>& b,
                               const std::array<double, 3>& p, const std::array<double, 3>& q) {
  using Vector = std::array<double, 3>;
  const auto from_a = [&a](const Vector& to) { // of length about 1
    Vector v = difference(to, a);
    const double size = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    for (double& x : v) x = size > 0 ? x / size : 0;
    return v;
  };
  const Vector m = cross_product(from_a(b), from_a(p)), n = cross_product(from_a(b), from_a(q));
  const double cosine = inner_product(m, n);
  return cosine > 0 && norm(cross_product(m, n)) <= 0x1p-30 * cosine;
}

// Faces in one half plane up to rounding keep their order: how they differ depends on the axes.
static void ignore_rounding(const std::vector<std::array<double, 3>>& points, std::uint32_t a,
                            std::uint32_t b, const std::vector<std::uint32_t>& apices,
                            std::vector<std::uint32_t>& order) {
  const auto is_same = [&](std::uint32_t i, std::uint32_t j) {
    return apices[i] == apices[j] ||
           is_same_half_plane(points[a], points[b], points[apices[i]], points[apices[j]]);
  };
  std::size_t last = order.size(); // those before the first are next to it, too
  while (last > 1 && is_same(order[last - 1], order[last % order.size()])) --last;
  std::rotate(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(last % order.size()),
              order.end());
  for (auto from = order.begin(); from != order.end();) {
    auto to = from + 1;
    while (to != order.end() && is_same(*(to - 1), *to)) ++to;
    std::sort(from, to);
    from = to;
  }
}

// Orders the faces at an edge by their angles, and lets those that are repeated go around once
// more: each is then glued to other faces, as if none were repeated, and not to a copy of itself.
static std::vector<std::uint32_t>
order_around_edge(const std::vector<std::array<double, 3>>& points, std::uint32_t a,
                  std::uint32_t b, const std::vector<std::uint32_t>& apices) {
  std::vector<std::uint32_t> order = sort_around_edge(points, a, b, apices);
  ignore_rounding(points, a, b, apices, order);
  std::vector<std::uint32_t> by_apex = order, round(apices.size(), 0);
  std::stable_sort(by_apex.begin(), by_apex.end(),
                   [&apices](std::uint32_t i, std::uint32_t j) { return apices[i] < apices[j]; });
  for (std::size_t i = 1; i < by_apex.size(); ++i)
    if (apices[by_apex[i]] == apices[by_apex[i - 1]]) round[by_apex[i]] = round[by_apex[i - 1]] + 1;
  std::stable_sort(order.begin(), order.end(),
                   [&round](std::uint32_t i, std::uint32_t j) { return round[i] < round[j]; });
  return order;
}

// Glues faces around their edges, one edge after the other.
class Fan_gluer {
public:
  Fan_gluer(const Gluing& faces, const std::vector<std::array<double, 3>>& points)
      : faces_(faces), points_(points), cover_(faces) {}

  void glue(std::span<const Edge_side> fan) {
    if (fan.size() <= 2 || points_.empty()) return cover_.glue(fan);
    apices_.clear();
    for (const Edge_side& s : fan)
      apices_.push_back(faces_.origin[Gluing::next(Gluing::next(s.halfedge))]);
    const std::uint32_t h = fan[0].halfedge;
    if (!take_turns(apices_, order_))
      order_ =
          order_around_edge(points_, faces_.origin[h], faces_.origin[Gluing::next(h)], apices_);
    // the order that repeated faces have is that about the first face's own direction
    if (!fan[0].is_along) std::ranges::reverse(order_);
    sorted_.clear();
    for (const std::uint32_t i : order_) sorted_.push_back(fan[i]);
    cover_.glue(sorted_);
  }

  // Faces whose first corner is the center of a star: those of one star are glued to each other.
  void glue_stars(std::span<const Edge_side> fan) {
    for (auto& sides : of_star_) sides.clear();
    for (const Edge_side& s : fan) {
      const unsigned corner = s.halfedge % 3; // the center is an end of sides 0 and 2
      const bool is_from_center = (corner == 0) == s.is_along;
      of_star_[corner == 1 ? 2 : is_from_center ? 0 : 1].push_back(s);
    }
    for (const auto& sides : of_star_)
      if (!sides.empty()) glue(sides);
  }

  Double_cover take() { return std::move(cover_); }

private:
  const Gluing& faces_;
  const std::vector<std::array<double, 3>>& points_;
  Double_cover cover_;
  std::vector<Edge_side> sorted_;
  std::array<std::vector<Edge_side>, 3> of_star_; // of the source, of the target, and others
  std::vector<std::uint32_t> apices_, order_;
};

Double_cover tufted_cover(const Gluing& faces, const Sides_by_edge& edges,
                          const std::vector<std::array<double, 3>>& points) {
  Fan_gluer gluer(faces, points);
  for (std::uint32_t e = 0; e < edges.number_of_edges(); ++e) gluer.glue(edges[e]);
  return gluer.take();
}

Double_cover cover_of_stars(const Gluing& faces, const Sides_by_edge& edges,
                            const std::vector<std::array<double, 3>>& points) {
  Fan_gluer gluer(faces, points);
  for (std::uint32_t e = 0; e < edges.number_of_edges(); ++e) gluer.glue_stars(edges[e]);
  return gluer.take();
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

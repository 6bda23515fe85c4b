// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

[[noreturn]] static void throw_no_disk(const std::string& why) {
  throw Invalid_input(Element_kind::none, 0,
                      "only a disk is mapped to the plane, but the surface " + why +
                          "; cut_open() makes a disk of a connected oriented surface");
}

Disk_border disk_border(const Face_table& table, std::uint32_t sheets) {
  if (sheets > 1) throw_no_disk("is a cover");
  std::set<int> rows;
  for (const Table_face& f : table.faces) rows.insert(f.rows.begin(), f.rows.end());
  std::ptrdiff_t edges = 0;
  table.for_each_edge([&](const Table_face&, std::size_t) { ++edges; });
  const std::vector<std::uint32_t> component = table.components();
  for (const int row : rows)
    if (component[static_cast<std::size_t>(row)] != static_cast<std::uint32_t>(*rows.begin()))
      throw_no_disk("is not connected");
  std::map<int, std::pair<int, double>> next;
  table.for_each_border_side([&](const Table_face& f, std::size_t k) {
    if (!next.insert({f.rows[k], {f.rows[(k + 1) % 3], f.length(k)}}).second)
      throw_no_disk("has a border that meets itself at the vertex of row " +
                    std::to_string(f.rows[k]));
  });
  if (next.empty()) throw_no_disk("has no border");
  Disk_border border;
  int row = next.begin()->first;
  do {
    border.rows.push_back(static_cast<std::uint32_t>(row));
    border.lengths.push_back(next.at(row).second);
    row = next.at(row).first;
  } while (row != next.begin()->first);
  if (border.rows.size() < next.size()) throw_no_disk("has more than one border");
  if (static_cast<std::ptrdiff_t>(rows.size()) - edges +
          static_cast<std::ptrdiff_t>(table.faces.size()) !=
      1)
    throw_no_disk("has handles, or is not manifold");
  if (border.rows.size() < 3)
    throw_no_disk("has only " + std::to_string(border.rows.size()) + " vertices on its border");
  return border;
}

// the position of each vertex along the border, as a part of its length
static std::vector<double> places_along(const Disk_border& border) {
  std::vector<double> places{0};
  for (const double l : border.lengths) places.push_back(places.back() + l);
  const double all = places.back();
  for (double& x : places) x /= all;
  return places; // one more than there are vertices: 1
}

Border_map circular_border(const Disk_border& border) {
  Border_map map{border.rows, Eigen::MatrixX2d(static_cast<Eigen::Index>(border.rows.size()), 2)};
  const std::vector<double> places = places_along(border);
  for (Eigen::Index i = 0; i < map.positions.rows(); ++i) {
    const double angle = 2 * std::numbers::pi * places[static_cast<std::size_t>(i)];
    map.positions.row(i) << std::cos(angle), std::sin(angle);
  }
  return map;
}

// The turns at the corners are to the left, and make one round.
static void expect_convex(const std::vector<std::array<double, 2>>& corners) {
  using Corner = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const std::size_t n = corners.size();
  const auto point = [&](std::size_t i) { return Corner(corners[i % n][0], corners[i % n][1]); };
  for (const std::array<double, 2>& c : corners)
    if (!std::isfinite(c[0]) || !std::isfinite(c[1]))
      throw std::invalid_argument("the corners must be finite");
  std::size_t lows = 0; // corners at which the sides begin to rise
  for (std::size_t i = 0; i < n; ++i) {
    if (CGAL::orientation(point(i), point(i + 1), point(i + 2)) != CGAL::LEFT_TURN)
      throw std::invalid_argument("the polygon does not turn left at corner " +
                                  std::to_string((i + 1) % n));
    if (point(i) > point(i + 1) && point(i + 1) < point(i + 2)) ++lows;
  }
  if (n < 3 || lows != 1)
    throw std::invalid_argument(
        "the polygon is not convex: it goes around more than once, or has less than three corners");
}

// The places in the border of the vertices at the corners, increasing: the nearest in proportion to
// length that leave enough vertices for later corners.
static std::vector<std::size_t> vertices_at_corners(const std::vector<double>& places,
                                                    const std::vector<double>& wanted) {
  const std::size_t vertices = places.size() - 1, n = wanted.size();
  std::vector<std::size_t> result{0};
  for (std::size_t c = 1; c < n; ++c) {
    std::size_t best = result.back() + 1;
    for (std::size_t i = best; i + (n - 1 - c) < vertices; ++i)
      if (std::abs(places[i] - wanted[c]) < std::abs(places[best] - wanted[c])) best = i;
    result.push_back(best);
  }
  result.push_back(vertices);
  return result;
}

Border_map polygonal_border(const Disk_border& border,
                            const std::vector<std::array<double, 2>>& corners) {
  expect_convex(corners);
  const std::size_t n = corners.size();
  if (border.rows.size() < n)
    throw std::invalid_argument(
        "the border has " + std::to_string(border.rows.size()) +
        " vertices, less than the polygon has corners; refine the triangulation");
  const auto point = [&](std::size_t i) { return Eigen::RowVector2d(corners[i % n].data()); };
  std::vector<double> wanted{0};
  for (std::size_t c = 0; c < n; ++c)
    wanted.push_back(wanted.back() + (point(c + 1) - point(c)).norm());
  const double around = wanted.back();
  wanted.pop_back();
  for (double& x : wanted) x /= around;
  const std::vector<double> places = places_along(border);
  const std::vector<std::size_t> at = vertices_at_corners(places, wanted);
  Border_map map{border.rows, Eigen::MatrixX2d(static_cast<Eigen::Index>(border.rows.size()), 2)};
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t i = at[c]; i < at[c + 1]; ++i) {
      const double x = (places[i] - places[at[c]]) / (places[at[c + 1]] - places[at[c]]);
      map.positions.row(static_cast<Eigen::Index>(i)) = (1 - x) * point(c) + x * point(c + 1);
    }
  return map;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

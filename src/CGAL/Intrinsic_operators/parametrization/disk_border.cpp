// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

[[noreturn]] static void throw_no_disk(const std::string& what, const std::string& why) {
  throw Invalid_input(Element_kind::none, 0,
                      "only disks are mapped to the plane, but " + what + ' ' + why +
                          "; cut it open to disks first");
}

namespace {

// Finds the borders of components, which have their least row as name.
class Border_finder {
public:
  explicit Border_finder(const Face_table& table)
      : table_(table), component_(table.components()), place_(table.number_of_rows, Gluing::none),
        euler_(table.number_of_rows, 0), next_(table.number_of_rows, {Gluing::none, 0}) {
    for (const Table_face& f : table.faces) {
      ++euler_[component_[row(f, 0)]];
      for (std::size_t k = 0; k < 3; ++k) has_faces_[row(f, k)] = 1;
    }
    table.for_each_edge(
        [this](const Table_face& f, std::size_t) { --euler_[component_[row(f, 0)]]; });
    for (std::uint32_t r = 0; r < component_.size(); ++r) {
      if (has_faces_[r] == 0) continue;
      ++euler_[component_[r]];
      if (component_[r] == r) place_[r] = components_++;
    }
  }

  std::vector<Disk_border> run() {
    link();
    std::vector<Disk_border> borders(components_);
    for (std::uint32_t r = 0; r < next_.size(); ++r) {
      if (next_[r].first == Gluing::none) continue;
      Disk_border& border = borders[place_[component_[r]]];
      if (!border.rows.empty()) fail(r, "has more than one border");
      for (std::uint32_t v = r; next_[v].first != Gluing::none;) {
        border.rows.push_back(v);
        border.lengths.push_back(next_[v].second);
        v = std::exchange(next_[v].first, Gluing::none);
      }
    }
    for (std::uint32_t r = 0; r < place_.size(); ++r) {
      if (place_[r] == Gluing::none) continue;
      const std::size_t size = borders[place_[r]].rows.size();
      if (size == 0) fail(r, "has no border");
      if (euler_[r] != 1) fail(r, "has handles, or is not manifold");
      if (size < 3) fail(r, "has only " + std::to_string(size) + " vertices on its border");
    }
    for (const Table_face& f : table_.faces)
      borders[place_[component_[row(f, 0)]]].area += f.area();
    return borders;
  }

private:
  static std::uint32_t row(const Table_face& f, std::size_t k) {
    return static_cast<std::uint32_t>(f.rows[k]);
  }

  void link() {
    table_.for_each_border_side([this](const Table_face& f, std::size_t k) {
      auto& next = next_[row(f, k)];
      if (next.first != Gluing::none)
        fail(row(f, k),
             "has a border that meets itself at the vertex of row " + std::to_string(f.rows[k]));
      next = {row(f, (k + 1) % 3), f.length(k)};
    });
  }

  [[noreturn]] void fail(std::uint32_t r, const std::string& why) const {
    throw_no_disk(components_ == 1
                      ? "the surface"
                      : "the component of the vertex of row " + std::to_string(component_[r]),
                  why);
  }

  const Face_table& table_;
  std::vector<std::uint32_t> component_;               // of each row
  std::vector<std::uint32_t> place_;                   // of a component among all
  std::vector<std::ptrdiff_t> euler_;                  // characteristic of each component
  std::vector<std::pair<std::uint32_t, double>> next_; // on the border, with the distance
  std::vector<char> has_faces_ = std::vector<char>(component_.size(), 0); // of each row
  std::uint32_t components_ = 0;
};

} // namespace

std::vector<Disk_border> disk_borders(const Face_table& table, std::uint32_t sheets) {
  if (sheets > 1) throw_no_disk("the surface", "is a cover");
  return Border_finder(table).run();
}

// the position of each vertex along the border, as a part of its length
static std::vector<double> places_along(const Disk_border& border) {
  std::vector<double> places{0};
  for (const double l : border.lengths) places.push_back(places.back() + l);
  const double all = places.back();
  for (double& x : places) x /= all;
  return places; // one more than there are vertices: 1
}

// Maps each border by a function, scaled in proportion to its disk, and packs them.
template <class Function>
static Border_map borders_beside_each_other(const std::vector<Disk_border>& borders,
                                            const Function& positions) {
  std::size_t size = 0;
  double largest = 0;
  for (const Disk_border& b : borders) {
    size += b.rows.size();
    largest = std::max(largest, b.area);
  }
  Border_map map{{}, Eigen::MatrixX2d(static_cast<Eigen::Index>(size), 2)};
  std::vector<std::uint32_t> component;
  for (std::uint32_t i = 0; i < borders.size(); ++i) {
    const Disk_border& b = borders[i];
    // smaller ones would be less than a pixel on a screen
    const double part = std::sqrt(b.area / largest), radius = part >= 1e-3 ? part : 1e-3;
    map.positions.middleRows(static_cast<Eigen::Index>(component.size()),
                             static_cast<Eigen::Index>(b.rows.size())) =
        borders.size() == 1 ? positions(b) : Eigen::MatrixX2d(radius * positions(b));
    map.rows.insert(map.rows.end(), b.rows.begin(), b.rows.end());
    component.insert(component.end(), b.rows.size(), i);
  }
  pack_components(map.positions, component);
  return map;
}

Border_map circular_border(const std::vector<Disk_border>& borders) {
  return borders_beside_each_other(borders, [](const Disk_border& border) {
    Eigen::MatrixX2d result(static_cast<Eigen::Index>(border.rows.size()), 2);
    const std::vector<double> places = places_along(border);
    for (Eigen::Index i = 0; i < result.rows(); ++i) {
      const double angle = 2 * std::numbers::pi * places[static_cast<std::size_t>(i)];
      result.row(i) << std::cos(angle), std::sin(angle);
    }
    return result;
  });
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

// The places of the vertices of one border on a convex polygon.
static Eigen::MatrixX2d on_polygon(const Disk_border& border,
                                   const std::vector<std::array<double, 2>>& corners) {
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
  Eigen::MatrixX2d result(static_cast<Eigen::Index>(border.rows.size()), 2);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t i = at[c]; i < at[c + 1]; ++i) {
      const double x = (places[i] - places[at[c]]) / (places[at[c + 1]] - places[at[c]]);
      result.row(static_cast<Eigen::Index>(i)) = (1 - x) * point(c) + x * point(c + 1);
    }
  return result;
}

Border_map polygonal_border(const std::vector<Disk_border>& borders,
                            const std::vector<std::array<double, 2>>& corners) {
  expect_convex(corners);
  return borders_beside_each_other(
      borders, [&](const Disk_border& border) { return on_polygon(border, corners); });
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

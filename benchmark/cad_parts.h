// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_CAD_PARTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_CAD_PARTS_H

#include "synthetic_meshes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <vector>

/// Parts as CAD programs triangulate them: no vertices but those of curves, so that planes consist
/// of slivers and cylinders of needles. All are closed surfaces.
namespace CGAL::Intrinsic_triangulations::synthetic {

/// returns a plate with three round corners of `n / 3` points each, whose two faces are fans of
/// slivers from the sharp corner.
inline Triangle_soup rounded_plate(std::uint32_t n) {
  const double width = 100, height = 60, radius = 20, thickness = 2;
  std::vector<std::array<double, 2>> rim{{0, 0}};
  const std::array<std::array<double, 2>, 3> centers{
      {{width - radius, radius}, {width - radius, height - radius}, {radius, height - radius}}};
  const std::uint32_t m = n / 3;
  for (std::uint32_t k = 0; k < 3; ++k)
    for (std::uint32_t i = 0; i <= m; ++i) {
      const double angle = std::numbers::pi / 2 * (k + double(i) / m - 1);
      rim.push_back(
          {centers[k][0] + radius * std::cos(angle), centers[k][1] + radius * std::sin(angle)});
    }
  const auto count = static_cast<std::uint32_t>(rim.size());
  Triangle_soup soup;
  for (const double z : {0., thickness})
    for (const auto& [x, y] : rim) soup.points.push_back({x, y, z});
  for (std::uint32_t i = 1; i + 1 < count; ++i) {
    soup.triangles.push_back({0, i + 1, i});
    soup.triangles.push_back({count, count + i, count + i + 1});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    soup.triangles.push_back({i, j, count + j});
    soup.triangles.push_back({i, count + j, count + i});
  }
  return soup;
}

/// returns a shaft of three cylinders of needles, `n` points on each circle at uneven distances;
/// rings lie between the cylinders, and its ends are fans from points of their circles.
inline Triangle_soup stepped_shaft(std::uint32_t n) {
  const std::array<std::array<double, 2>, 3> steps{{{5, 40}, {8, 60}, {6, 30}}}; // radius, length
  Triangle_soup soup;
  double x = 0;
  for (const auto& [radius, length] : steps) {
    for (const double end : {x, x + length})
      for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.09 * std::sin(7. * i)) / n;
        soup.points.push_back({end, radius * std::cos(angle), radius * std::sin(angle)});
      }
    x += length;
  }
  for (std::uint32_t p = 0; p < 5 * n; p += n)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t j = (i + 1) % n;
      soup.triangles.push_back({p + i, p + n + j, p + j});
      soup.triangles.push_back({p + i, p + n + i, p + n + j});
    }
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    soup.triangles.push_back({0, i, i + 1});
    soup.triangles.push_back({5 * n, 5 * n + i + 1, 5 * n + i});
  }
  return soup;
}

/// Collects triangles of a plate, whose vertices are named by their coordinates.
class Plate_maker {
public:
  /// A point of the plane, and whether it is on the upper face.
  struct Corner {
    std::array<double, 2> place;
    bool is_above;
  };
  /// sets the height of the upper face.
  explicit Plate_maker(double thickness) : thickness_(thickness) {}
  /// adds a triangle.
  void add(const Corner& a, const Corner& b, const Corner& c) {
    soup_.triangles.push_back({vertex(a), vertex(b), vertex(c)});
  }
  /// adds a triangle to the upper face, and that below it to the lower one.
  void add_to_both(const std::array<double, 2>& a, const std::array<double, 2>& b,
                   const std::array<double, 2>& c) {
    add({a, true}, {b, true}, {c, true});
    add({a, false}, {c, false}, {b, false});
  }
  /// adds a wall, on the left of which the plate is.
  void add_wall(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    add({a, false}, {b, false}, {b, true});
    add({a, false}, {b, true}, {a, true});
  }
  /// returns the triangles.
  const Triangle_soup& soup() const { return soup_; }

private:
  std::uint32_t vertex(const Corner& c) {
    const std::array<double, 3> p{c.place[0], c.place[1], c.is_above ? thickness_ : 0};
    const auto [i, is_new] =
        number_.try_emplace(p, static_cast<std::uint32_t>(soup_.points.size()));
    if (is_new) soup_.points.push_back(p);
    return i->second;
  }

  double thickness_;
  Triangle_soup soup_;
  std::map<std::array<double, 3>, std::uint32_t> number_;
};

/// returns a plate with a row of round holes of `n` points each, which fans of slivers join to the
/// corners of rectangles around them.
inline Triangle_soup plate_with_holes(std::uint32_t holes, std::uint32_t n) {
  const double width = 20, height = 30, radius = 7;
  Plate_maker plate(3);
  for (std::uint32_t k = 0; k < holes; ++k) {
    const double left = width * k, right = left + width;
    const std::array<std::array<double, 2>, 4> corners{
        {{right, height}, {left, height}, {left, 0}, {right, 0}}};
    const auto angle = [&](std::uint32_t i) { return 2 * std::numbers::pi * i / n + 0.1; };
    const auto rim = [&](std::uint32_t i) {
      return std::array{left + width / 2 + radius * std::cos(angle(i % n)),
                        height / 2 + radius * std::sin(angle(i % n))};
    };
    const auto quadrant = [&](std::uint32_t i) {
      return static_cast<std::size_t>(2 * angle(i % n) / std::numbers::pi) % 4;
    };
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::size_t from = quadrant(i), to = quadrant(i + 1);
      plate.add_to_both(rim(i), corners[from], rim(i + 1));
      if (from != to) plate.add_to_both(corners[from], corners[to], rim(i + 1));
      plate.add_wall(rim(i + 1), rim(i));
    }
    plate.add_wall({left, 0}, {right, 0});
    plate.add_wall({right, height}, {left, height});
  }
  plate.add_wall({width * holes, 0}, {width * holes, height});
  plate.add_wall({0, height}, {0, 0});
  return plate.soup();
}

} // namespace CGAL::Intrinsic_triangulations::synthetic

#endif // CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_CAD_PARTS_H

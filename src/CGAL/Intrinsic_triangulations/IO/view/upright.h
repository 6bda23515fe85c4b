// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UPRIGHT_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UPRIGHT_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// How a surface stands on a page.
struct Standing {
  std::array<double, 3> up{0, 1, 0}; // a unit vector
  double height = 0;                 // the extent along it
};

// Finds how a surface stands, of which files say nothing: on the largest flat part of it that has
// all of the surface on one side. Points are in the ball of radius 1.
class Standing_finder {
  using Direction = std::array<double, 3>;
  using Points = std::span<const std::array<float, 3>>;
  using Triangles = std::span<const std::array<std::uint32_t, 3>>;

public:
  Standing_finder(Points points, Triangles triangles) : points_(points), triangles_(triangles) {
    for (const std::array<std::uint32_t, 3>& t : triangles) {
      normals_.push_back(normal(t));
      areas_.push_back(std::hypot(normals_.back()[0], normals_.back()[1], normals_.back()[2]));
      area_ += areas_.back();
    }
  }

  // Along the axes, z before y before x, and then along normals. Without a base, y is up, or z if
  // the surface is least high along y. \param extent the sides of the bounding box
  Standing find(const Direction& extent) const {
    constexpr double least_share = 0.03; // of the area; faces of fine meshes of balls have less
    // of areas that are equal up to rounding the first counts, as on a cube
    constexpr double clearly_more = 1.01;
    Standing best;
    double largest = least_share * area_;
    std::vector<Direction> ups{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
    for (const Direction& n : frequent_normals()) ups.push_back(n);
    bool has_base = false;
    for (const double sign : {1., -1.})
      for (Direction up : ups) {
        for (double& x : up) x *= sign;
        if (const double area = base_area(up); area > (has_base ? clearly_more : 1) * largest) {
          largest = area;
          best.up = up;
          has_base = true;
        }
      }
    if (!has_base && extent[1] <= std::min(extent[0], extent[2])) best.up = {0, 0, 1};
    best.height = range(best.up)[1] - range(best.up)[0];
    return best;
  }

private:
  static double dot(const Direction& n, const std::array<float, 3>& p) {
    return n[0] * double{p[0]} + n[1] * double{p[1]} + n[2] * double{p[2]};
  }

  // twice the area vector
  Direction normal(const std::array<std::uint32_t, 3>& t) const {
    Direction u, v;
    for (std::size_t c = 0; c < 3; ++c) {
      u[c] = double{points_[t[1]][c]} - double{points_[t[0]][c]};
      v[c] = double{points_[t[2]][c]} - double{points_[t[0]][c]};
    }
    return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }

  // The normals of most area, up to sign.
  std::vector<Direction> frequent_normals() const {
    constexpr std::size_t most = 8; // a box with its corners cut off has seven, up to sign
    constexpr double steps = 32;    // within two degrees they are one
    std::map<std::array<long, 3>, std::size_t> bins;
    std::vector<Direction> sums;
    for (std::size_t t = 0; t < normals_.size(); ++t) {
      if (!(areas_[t] > 0)) continue;
      Direction n = normals_[t];
      const bool is_negative = std::ranges::lexicographical_compare(n, Direction{0, 0, 0});
      std::array<long, 3> key{};
      for (std::size_t c = 0; c < 3; ++c) {
        if (is_negative) n[c] = -n[c];
        key[c] = std::lround(steps * n[c] / areas_[t]);
      }
      const auto [bin, is_new] = bins.try_emplace(key, sums.size());
      if (is_new) sums.push_back({0, 0, 0});
      for (std::size_t c = 0; c < 3; ++c) sums[bin->second][c] += n[c];
    }
    const auto length = [](const Direction& n) { return std::hypot(n[0], n[1], n[2]); };
    std::ranges::sort(sums, std::greater<>(), length);
    sums.resize(std::min(sums.size(), most));
    for (Direction& n : sums)
      for (const double l = length(n); double& x : n) x /= l;
    return sums;
  }

  std::array<double, 2> range(const Direction& n) const {
    std::array<double, 2> result{0, 0};
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const double x = dot(n, points_[v]);
      result =
          v == 0 ? std::array{x, x} : std::array{std::min(result[0], x), std::max(result[1], x)};
    }
    return result;
  }

  // twice the area of the faces at the lowest place
  double base_area(const Direction& up) const {
    constexpr double flat = 1e-3; // half a pixel where the surface fills 1000
    const double top = range(up)[0] + flat;
    double sum = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (std::ranges::all_of(triangles_[t],
                              [&](std::uint32_t v) { return dot(up, points_[v]) <= top; }))
        sum += areas_[t];
    return sum;
  }

  Points points_;
  Triangles triangles_;
  std::vector<Direction> normals_;
  std::vector<double> areas_;
  double area_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_UPRIGHT_H

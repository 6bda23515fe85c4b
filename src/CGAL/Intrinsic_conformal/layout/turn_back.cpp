// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/layout/turn_back.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/enum.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

class Triangle_turner {
public:
  Triangle_turner(const std::vector<std::array<std::uint32_t, 3>>& triangles,
                  Eigen::MatrixX2d& positions)
      : triangles_(triangles), z_(positions), given_(positions),
        limit_(0x1p-44 * (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).norm()) {
  }

  void run() {
    std::vector<std::uint32_t> turned;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      if (is_turned(t)) turned.push_back(t);
    const std::size_t count = turned.size();
    if (count == 0 || count > most_triangles) return;
    find_stars();
    for (int sweep = 0; sweep < most_sweeps && !turned.empty(); ++sweep)
      turned = after_sweep(turned);
    if (turned.size() >= count) z_ = given_;
  }

private:
  static constexpr std::size_t most_triangles = 10000; // more are no effect of rounding
  static constexpr int most_sweeps = 40;               // 5 are enough where the search succeeds

  using Complex = std::complex<double>;
  Complex place(std::uint32_t v) const { return point_of_row(z_, v); }
  bool is_turned(std::uint32_t t) const { return internal::is_turned(z_, triangles_[t]); }

  // The triangles at each vertex.
  void find_stars() {
    begin_.assign(static_cast<std::size_t>(z_.rows()) + 1, 0);
    for (const auto& triangle : triangles_)
      for (const std::uint32_t v : triangle) ++begin_[v + 1];
    for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
    star_.resize(begin_.back());
    std::vector<std::size_t> at = begin_;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      for (const std::uint32_t v : triangles_[t]) star_[at[v]++] = t;
  }

  // Moves the vertices of triangles. \return those that are turned then, among all around
  std::vector<std::uint32_t> after_sweep(const std::vector<std::uint32_t>& turned) {
    std::vector<std::uint32_t> vertices, around, result;
    for (const std::uint32_t t : turned)
      vertices.insert(vertices.end(), triangles_[t].begin(), triangles_[t].end());
    make_set(vertices);
    for (const std::uint32_t v : vertices) move(v);
    for (const std::uint32_t v : vertices)
      for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) around.push_back(star_[i]);
    make_set(around);
    for (const std::uint32_t t : around)
      if (is_turned(t)) result.push_back(t);
    return result;
  }

  static void make_set(std::vector<std::uint32_t>& numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  // The distance of doubles near a place.
  static double distance_of_doubles(Complex z) {
    const double x = std::max(std::abs(z.real()), std::abs(z.imag()));
    return std::nextafter(x, std::numeric_limits<double>::infinity()) - x;
  }

  // How much lower the triangles at a vertex are than the distance of doubles, which is the unit:
  // the sum, and the most.
  struct Lack {
    double sum = 0, most = 0;
  };
  Lack lack(std::uint32_t v, const std::vector<double>& units) const {
    Lack result;
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) {
      const auto& triangle = triangles_[star_[i]];
      const Complex a = place(triangle[0]), b = place(triangle[1]) - a, c = place(triangle[2]) - a;
      const double longest = std::max({std::abs(b), std::abs(c), std::abs(c - b)});
      const double height = longest > 0 ? std::imag(std::conj(b) * c) / longest : 0;
      const double unit = units[i - begin_[v]], missing = unit - height;
      if (!(missing > 0)) continue;
      result.sum += missing / unit;
      result.most = std::max(result.most, missing);
    }
    return result;
  }

  // Moves a vertex to the best of some places around it.
  void move(std::uint32_t v) {
    const Complex from = place(v), given = point_of_row(given_, v);
    std::vector<double> units;
    for (std::size_t i = begin_[v]; i < begin_[v + 1]; ++i) {
      double& unit = units.emplace_back(0);
      for (const std::uint32_t w : triangles_[star_[i]])
        unit = std::max(unit, distance_of_doubles(place(w)));
    }
    const Lack now = lack(v, units);
    double least = now.sum;
    Complex best = from;
    const double radius = std::max(now.most, distance_of_doubles(from));
    for (const double part : {4., 2., 1., 0.5, 0.25, 0.0625})
      for (int k = 0; k < 16; ++k) {
        const Complex z = from + std::polar(part * radius, std::numbers::pi * k / 8);
        if (std::abs(z - given) > limit_) continue;
        z_.row(v) << z.real(), z.imag();
        if (const double sum = lack(v, units).sum; sum < least) {
          least = sum;
          best = z;
        }
      }
    z_.row(v) << best.real(), best.imag();
  }

  const std::vector<std::array<std::uint32_t, 3>>& triangles_;
  Eigen::MatrixX2d& z_;
  const Eigen::MatrixX2d given_;
  double limit_; // of all moves of a vertex: 512 roundings
  std::vector<std::size_t> begin_;
  std::vector<std::uint32_t> star_;
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> triangles_of_pieces(const Common_subdivision& s) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t k = 2; k < s.face(f).size(); ++k)
      triangles.push_back({s.face(f)[0], s.face(f)[k - 1], s.face(f)[k]});
  return triangles;
}

bool is_turned(const Eigen::MatrixX2d& z, const std::array<std::uint32_t, 3>& triangle) {
  using Point_2 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto point = [&z](std::uint32_t v) { return Point_2(z(v, 0), z(v, 1)); };
  const auto& [a, b, c] = triangle;
  return CGAL::orientation(point(a), point(b), point(c)) != CGAL::LEFT_TURN;
}

bool is_turned_in_disk(const Eigen::MatrixX2d& z, const std::array<std::uint32_t, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  return orientation_in_disk(point_of_row(z, a), point_of_row(z, b), point_of_row(z, c)) <= 0;
}

void turn_back(const std::vector<std::array<std::uint32_t, 3>>& triangles,
               Eigen::MatrixX2d& positions) {
  if (positions.rows() > 0 && positions.allFinite()) Triangle_turner(triangles, positions).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal

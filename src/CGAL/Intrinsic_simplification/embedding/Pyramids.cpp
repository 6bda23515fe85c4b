// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

double difference_of_squares(double a, double b) { return (a - b) * (a + b); }

// Where the line of h comes nearest to the apex, measured from the source of h.
double along(const Metric_triangles& t, const std::vector<double>& r, std::uint32_t h) {
  const double l = t.length(h);
  return (l * l + difference_of_squares(r[t.source(h)], r[t.target(h)])) / (2 * l);
}

// The signed distance of the foot of the apex from h, and nonzero if it is negative by more than
// rounding.
double foot_of(const Metric_triangles& t, const std::vector<double>& r, std::uint32_t h) {
  const double side = t.length(Metric_triangles::previous(h)), x = side * t.cosine(h),
               y = side * t.sine(h);
  const std::uint32_t k = t.source(Metric_triangles::previous(h));
  return (side * side + difference_of_squares(r[t.source(h)], r[k]) - 2 * along(t, r, h) * x) /
         (2 * y);
}

// How far rounding may move a foot.
double rounding_of_foot(const Metric_triangles& t, const std::vector<double>& r, std::uint32_t h) {
  const double y = t.length(Metric_triangles::previous(h)) * t.sine(h), a = r[t.source(h)];
  return y > 0 ? 0x1p-48 * (a * a / y + a) : 0; // a face without area is flipped
}

} // namespace

bool Pyramids::build(const Metric_triangles& t, const std::vector<double>& radii) {
  foot.resize(t.number_of_halfedges());
  height.resize(t.number_of_faces());
  curvature.assign(t.number_of_vertices(), 2 * std::numbers::pi);
  for (std::uint32_t f = 0; f < t.number_of_faces(); ++f) {
    std::uint32_t longest = 3 * f;
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      foot[h] = foot_of(t, radii, h);
      if (t.length(h) > t.length(longest)) longest = h;
    }
    const double squared = CGAL::square(radii[t.source(longest)]) -
                           CGAL::square(along(t, radii, longest)) - CGAL::square(foot[longest]);
    if (!(squared > 0)) return false;
    height[f] = std::sqrt(squared);
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::uint32_t i = t.source(h);
      curvature[i] -=
          std::atan2(radii[i] * height[f] * t.sine(h),
                     squared * t.cosine(h) - foot[h] * foot[Metric_triangles::previous(h)]);
    }
  }
  return true;
}

Eigen::SparseMatrix<double> Pyramids::derivatives(const Metric_triangles& t,
                                                  const std::vector<double>& radii) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(std::size_t{3} * t.number_of_halfedges());
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    const std::uint32_t g = t.opposite(h);
    if (g < h) continue;
    const std::uint32_t a = t.source(h), b = t.target(h);
    const double l = t.length(h), r = radii[a], s = radii[b];
    const double cotangents = foot[h] / height[h / 3] + foot[g] / height[g / 3];
    const double weight =
        cotangents * r * s / (l * (CGAL::square(foot[h]) + CGAL::square(height[h / 3])));
    const double one_less_cosine =
        (l * l - CGAL::square(r - s)) / (2 * r * s); // of the angle at the apex
    const int i = static_cast<int>(a), j = static_cast<int>(b);
    if (i == j) {
      entries.emplace_back(i, i, 2 * weight * one_less_cosine);
      continue;
    }
    entries.emplace_back(i, j, weight);
    entries.emplace_back(j, i, weight);
    entries.emplace_back(i, i, -weight * (1 - one_less_cosine));
    entries.emplace_back(j, j, -weight * (1 - one_less_cosine));
  }
  const int n = static_cast<int>(t.number_of_vertices());
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

bool flip_to_convex(Metric_triangles& t, const std::vector<double>& radii) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
    if (!t.is_removed(h / 3) && h < t.opposite(h)) queue.push_back(h);
  return flip_to_convex(t, radii, std::move(queue));
}

bool flip_to_convex(Metric_triangles& t, const std::vector<double>& radii,
                    std::vector<std::uint32_t> queue) {
  std::size_t left = std::size_t{1000} * t.number_of_halfedges(); // a cap against endless ties
  while (!queue.empty()) {
    const std::uint32_t h = queue.back(), g = t.opposite(h);
    queue.pop_back();
    const double feet = foot_of(t, radii, h) + foot_of(t, radii, g);
    if (feet >= -rounding_of_foot(t, radii, h) - rounding_of_foot(t, radii, g)) continue;
    if (!t.is_in_two_faces(h) || left-- == 0) return false;
    const Metric_diamond d = t.unfold(h);
    const std::array<double, 2> sines = d.sines();
    if (!(sines[0] > 0 && sines[1] > 0)) return false;
    t.flip(h, d);
    for (const std::uint32_t n : {Metric_triangles::next(h), Metric_triangles::previous(h),
                                  Metric_triangles::next(g), Metric_triangles::previous(g)})
      queue.push_back(n);
  }
  return true;
}

double area_of(const Metric_triangles& t) {
  double result = 0;
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); h += 3)
    result += t.length(h) * t.length(Metric_triangles::previous(h)) * t.sine(h) / 2;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Angle_product.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

double difference(const Vertex_weights& w, std::uint32_t i, std::uint32_t j) {
  return (w[i] - w[j]).to_double();
}

// Where the line of h comes nearest to the apex, measured from the source of h.
double along(const Metric_triangles& t, const Vertex_weights& w, std::uint32_t h) {
  const double l = t.length(h);
  return (l * l + difference(w, t.source(h), t.target(h))) / (2 * l);
}

// The signed distance of the foot of the apex from h.
double foot_of(const Metric_triangles& t, const Vertex_weights& w, std::uint32_t h) {
  const double side = t.length(Metric_triangles::previous(h)), x = side * t.cosine(h),
               y = side * t.sine(h);
  const std::uint32_t k = t.source(Metric_triangles::previous(h));
  return (side * side + difference(w, t.source(h), k) - 2 * along(t, w, h) * x) / (2 * y);
}

// How far rounding may move a foot.
double rounding_of_foot(const Metric_triangles& t, const Vertex_weights& w, std::uint32_t h) {
  const double side = t.length(Metric_triangles::previous(h)), y = side * t.sine(h);
  const std::uint32_t i = t.source(h), j = t.target(h), k = t.source(Metric_triangles::previous(h));
  const double size =
      side * (side + t.length(h)) + std::abs(difference(w, i, j)) + std::abs(difference(w, i, k));
  return y > 0 ? 0x1p-48 * (size / y + side) : 0; // a face without area is flipped
}

// A pyramid with 106 bits.
class Precise_pyramid {
public:
  Precise_pyramid(const Metric_triangles& t, const Apex_radii& radii, std::uint32_t face) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t h = 3 * face + k;
      side_[k] = t.squared_length(h);
      weight_[k] = radii.weights[t.source(h)];
      squared_radius_[k] = radii.squared(t.source(h));
    }
    for (std::size_t k = 0; k < 3; ++k)
      product_[k] = side_[k] + side_[(k + 2) % 3] - side_[(k + 1) % 3];
    const Double_double squared = (side_[0] * side_[2]).scaled(4) - product_[0] * product_[0];
    area_ = squared.to_double() > 0 ? sqrt(squared) : Double_double(0);
    if (!(area_.to_double() > 0)) return;
    for (std::size_t k = 0; k < 3; ++k) foot_[k] = foot_by_length(k);
    const std::size_t longest =
        static_cast<std::size_t>(std::max_element(side_.begin(), side_.end(),
                                                  [](const auto& a, const auto& b) {
                                                    return a.to_double() < b.to_double();
                                                  }) -
                                 side_.begin());
    const Double_double twice = twice_along(longest);
    squared_height_ = squared_radius_[longest] - (twice * twice / side_[longest]).scaled(.25) -
                      side_[longest] * foot_[longest] * foot_[longest];
  }
  bool exists() const { return area_.to_double() > 0 && squared_height_.to_double() > 0; }
  double height() const { return std::sqrt(squared_height_.to_double()); }
  double foot(std::size_t k) const { return (foot_[k] * sqrt(side_[k])).to_double(); }

  // of the surface at the corner k: a multiple of the cosine and the sine
  std::array<Double_double, 2> corner(std::size_t k) const { return {product_[k], area_}; }
  // at the radius to the corner k
  std::array<Double_double, 2> dihedral(std::size_t k) const {
    const std::size_t p = (k + 2) % 3;
    return {squared_height_ * product_[k] - (side_[k] * side_[p] * foot_[k] * foot_[p]).scaled(2),
            sqrt(squared_radius_[k] * squared_height_) * area_};
  }

private:
  Double_double twice_along(std::size_t k) const { // times the length of the side
    return side_[k] + weight_[k] - weight_[(k + 1) % 3];
  }
  Double_double foot_by_length(std::size_t k) const {
    const std::size_t p = (k + 2) % 3;
    return (side_[p] + weight_[k] - weight_[p] -
            (twice_along(k) * product_[k] / side_[k]).scaled(.5)) /
           area_;
  }

  std::array<Double_double, 3> side_, weight_, squared_radius_, product_, foot_;
  Double_double area_, squared_height_;
};

} // namespace

void Apex_radii::balance() {
  double sum = 0;
  for (const Double_double& w : weights) sum += w.to_double();
  // a sum of two doubles that is exact
  const double before = std::exchange(base, base + sum / static_cast<double>(weights.size()));
  for (Double_double& w : weights) w = w - Double_double::difference(base, before);
}

bool Pyramids::build(const Metric_triangles& t, const Apex_radii& radii) {
  foot.resize(t.number_of_halfedges());
  height.resize(t.number_of_faces());
  curvature.assign(t.number_of_vertices(), 2 * std::numbers::pi);
  lost.assign(t.number_of_vertices(), 0);
  std::vector<Angle_product> left(t.number_of_vertices()), less(t.number_of_vertices());
  for (std::uint32_t f = 0; f < t.number_of_faces(); ++f) {
    const Precise_pyramid pyramid(t, radii, f);
    if (!pyramid.exists()) return false;
    height[f] = pyramid.height();
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t v = t.source(3 * f + k);
      const auto [x, y] = pyramid.dihedral(k);
      const auto [u, w] = pyramid.corner(k);
      foot[3 * f + k] = pyramid.foot(k);
      left[v].multiply(x, -y);
      less[v].multiply(x * u + y * w, y * u - x * w);
      const double angle = std::atan2(y.to_double(), x.to_double());
      curvature[v] -= angle;
      lost[v] += angle - std::atan2(w.to_double(), u.to_double());
    }
  }
  for (std::uint32_t v = 0; v < t.number_of_vertices(); ++v) {
    curvature[v] = left[v].near(curvature[v]);
    lost[v] = less[v].near(lost[v]);
  }
  return true;
}

Pyramids::Edge_terms Pyramids::terms(const Metric_triangles& t, const Apex_radii& radii,
                                     std::uint32_t h) const {
  const std::uint32_t g = t.opposite(h), a = t.source(h), b = t.target(h);
  const double l = t.length(h), r = radii[a], s = radii[b];
  const double cotangents = foot[h] / height[h / 3] + foot[g] / height[g / 3];
  const double d = difference(radii.weights, a, b) / (r + s);
  return {cotangents * r * s / (l * (CGAL::square(foot[h]) + CGAL::square(height[h / 3]))),
          (l * l - CGAL::square(d)) / (2 * r * s), d / (r * s)};
}

Eigen::SparseMatrix<double> Pyramids::derivatives(const Metric_triangles& t,
                                                  const Apex_radii& radii) const {
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(std::size_t{3} * t.number_of_halfedges());
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    if (t.opposite(h) < h) continue;
    const Edge_terms e = terms(t, radii, h);
    const int i = static_cast<int>(t.source(h)), j = static_cast<int>(t.target(h));
    if (i == j) {
      entries.emplace_back(i, i, 2 * e.weight * e.one_less_cosine);
      continue;
    }
    entries.emplace_back(i, j, e.weight);
    entries.emplace_back(j, i, e.weight);
    entries.emplace_back(i, i, -e.weight * (1 - e.one_less_cosine));
    entries.emplace_back(j, j, -e.weight * (1 - e.one_less_cosine));
  }
  const int n = static_cast<int>(t.number_of_vertices());
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::VectorXd Pyramids::derivatives_by_base(const Metric_triangles& t,
                                              const Apex_radii& radii) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(t.number_of_vertices());
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) { // both ends of each edge
    const Edge_terms e = terms(t, radii, h);
    result[t.source(h)] +=
        e.weight * (e.inverse_difference + e.one_less_cosine / radii[t.source(h)]) / 2;
  }
  return result;
}

bool flip_to_convex(Metric_triangles& t, const Vertex_weights& weights) {
  std::vector<std::uint32_t> queue;
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h)
    if (!t.is_removed(h / 3) && h < t.opposite(h)) queue.push_back(h);
  return flip_to_convex(t, weights, std::move(queue));
}

bool flip_to_convex(Metric_triangles& t, const Vertex_weights& weights,
                    std::vector<std::uint32_t> queue) {
  std::size_t left = std::size_t{1000} * t.number_of_halfedges(); // a cap against endless ties
  while (!queue.empty()) {
    const std::uint32_t h = queue.back(), g = t.opposite(h);
    queue.pop_back();
    const double feet = foot_of(t, weights, h) + foot_of(t, weights, g);
    if (feet >= -rounding_of_foot(t, weights, h) - rounding_of_foot(t, weights, g)) continue;
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

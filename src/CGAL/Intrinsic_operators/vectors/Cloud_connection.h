// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_CLOUD_CONNECTION_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_CLOUD_CONNECTION_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// An edge of triangles at points of a cloud.
struct Cloud_edge {
  std::uint32_t source, target; // the lesser number first
  double weight;
};

// The tangent planes of a point cloud, connected by triangles at each point among its neighbours.
class Cloud_connection {
public:
  using Vector = Eigen::Vector3d;
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  Cloud_connection(const std::vector<std::array<double, 3>>& points, std::size_t neighbours)
      : triangles_(triangles_at_points(points, neighbours, report_)),
        normals_(points.size(), Vector::Zero()), first_(points.size(), Vector::Zero()),
        areas_(points.size(), 0) {
    double largest = 0;
    for (const std::array<double, 3>& p : points)
      for (const double x : p) largest = std::max(largest, std::abs(x));
    exponent_ = largest > 0 ? std::ilogb(largest) : 0;
    for (const std::array<double, 3>& p : points)
      places_.emplace_back(std::ldexp(p[0], -exponent_), std::ldexp(p[1], -exponent_),
                           std::ldexp(p[2], -exponent_));
    for (const auto& t : triangles_) add(t);
    merge_edges();
    for (Vector& n : normals_) n = n.norm() > 0 ? Vector(n.normalized()) : Vector(Vector::Zero());
    orient();
    for (std::uint32_t i = 0; i < first_.size(); ++i) make_plane(i);
    for (auto& t : triangles_) turn(t);
    for (const Cloud_edge& e : edges_)
      if (is_seam(e)) ++seam_edges_;
  }

  const Point_cloud_report& report() const { return report_; }
  // Computations use the points times 2^-exponent.
  int exponent() const { return exponent_; }
  const std::vector<Vector>& places() const { return places_; }
  // Edges of all triangles, with cotangent weights of the surface.
  const std::vector<Cloud_edge>& edges() const { return edges_; }
  // Counterclockwise about the normals; there about three times.
  const Triangles& triangles() const { return triangles_; }
  const Vector& first_axis(std::size_t i) const { return first_[i]; }
  Vector second_axis(std::size_t i) const { return normals_[i].cross(first_[i]); }
  std::size_t seam_edges() const { return seam_edges_; }

  Connection_graph graph() const {
    Connection_graph graph;
    graph.size = places_.size();
    graph.areas = areas_;
    double sum = 0;
    for (const Cloud_edge& e : edges_) {
      const Vector d = places_[e.target] - places_[e.source];
      sum += d.norm();
      const double weight = is_seam(e) ? 0 : std::max(0., e.weight); // no heat crosses a seam
      graph.edges.push_back({static_cast<int>(e.source), static_cast<int>(e.target), weight,
                             d.norm(), angle(e.source, d), angle(e.target, -d)});
    }
    const double mean = edges_.empty() ? 1 : sum / static_cast<double>(edges_.size());
    graph.squared_mean_length = mean * mean;
    return graph;
  }

private:
  // Triangles are there about three times.
  void add(const std::array<std::uint32_t, 3>& t) {
    const Vector normal = (places_[t[1]] - places_[t[0]]).cross(places_[t[2]] - places_[t[0]]);
    const double twice_area = normal.norm();
    if (!(twice_area > 0)) return;
    normals_[t[0]] += normal;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = t[k], j = t[(k + 1) % 3], apex = t[(k + 2) % 3];
      areas_[i] += twice_area / 18;
      const double cotangent =
          (places_[i] - places_[apex]).dot(places_[j] - places_[apex]) / twice_area;
      edges_.push_back({std::min(i, j), std::max(i, j), cotangent / 6});
    }
  }

  void merge_edges() {
    std::sort(edges_.begin(), edges_.end(), [](const Cloud_edge& a, const Cloud_edge& b) {
      return std::tie(a.source, a.target, a.weight) < std::tie(b.source, b.target, b.weight);
    });
    std::size_t size = 0;
    for (const Cloud_edge& e : edges_) {
      if (size > 0 && edges_[size - 1].source == e.source && edges_[size - 1].target == e.target)
        edges_[size - 1].weight += e.weight;
      else
        edges_[size++] = e;
    }
    edges_.resize(size);
  }

  // Orients normals alike at neighbours, where they bend least first.
  void orient() {
    std::vector<std::vector<std::uint32_t>> neighbours(places_.size());
    for (const Cloud_edge& e : edges_) {
      neighbours[e.source].push_back(e.target);
      neighbours[e.target].push_back(e.source);
    }
    using Step = std::tuple<double, std::uint32_t, std::uint32_t>; // how straight, to, from
    std::vector<char> is_turned(places_.size(), 0);
    for (std::uint32_t start = 0; start < places_.size(); ++start) {
      std::priority_queue<Step> steps;
      steps.emplace(1, start, start);
      while (!steps.empty()) {
        const auto [straight, i, from] = steps.top();
        steps.pop();
        if (is_turned[i] != 0) continue;
        is_turned[i] = 1;
        if (normals_[i].dot(normals_[from]) < 0) normals_[i] = -normals_[i];
        for (const std::uint32_t j : neighbours[i])
          if (is_turned[j] == 0) steps.emplace(std::abs(normals_[i].dot(normals_[j])), j, i);
      }
      for (const std::uint32_t j : neighbours[start]) nearer(start, j);
    }
  }

  // Keeps the vector to the nearest neighbour.
  void nearer(std::uint32_t i, std::uint32_t j) {
    const Vector d = places_[j] - places_[i];
    if (first_[i].norm() == 0 || d.norm() < first_[i].norm()) first_[i] = d;
  }

  void make_plane(std::uint32_t i) {
    if (normals_[i].norm() == 0) {
      first_[i].setZero();
      return;
    }
    Vector x = first_[i] - normals_[i].dot(first_[i]) * normals_[i];
    // where half of the digits cancel, the direction is rounding
    if (!(x.norm() > 1e-8 * first_[i].norm())) x = normals_[i].unitOrthogonal();
    first_[i] = x.normalized();
  }

  bool is_seam(const Cloud_edge& e) const { return normals_[e.source].dot(normals_[e.target]) < 0; }

  void turn(std::array<std::uint32_t, 3>& t) const {
    const Vector normal = (places_[t[1]] - places_[t[0]]).cross(places_[t[2]] - places_[t[0]]);
    if (normal.dot(normals_[t[0]]) < 0) std::swap(t[1], t[2]);
  }

  double angle(std::uint32_t i, const Vector& d) const {
    return std::atan2(second_axis(i).dot(d), first_axis(i).dot(d));
  }

  Point_cloud_report report_;
  Triangles triangles_;
  int exponent_ = 0;
  std::vector<Vector> places_, normals_, first_;
  std::vector<double> areas_;
  std::vector<Cloud_edge> edges_;
  std::size_t seam_edges_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_CLOUD_CONNECTION_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_HEAT_TRANSPORT_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_HEAT_TRANSPORT_IMPL_H

#include <CGAL/Intrinsic_triangulations/applications/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/factored_laplacian.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/graph_parts.h>
#include <CGAL/Intrinsic_triangulations/applications/vectors/unit_vector.h>
#include <CGAL/Intrinsic_triangulations/compilation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Heat_transport::Heat_transport(Connection_graph graph, double time_scale)
    : graph_(std::move(graph)), time_(time_scale * graph_.squared_mean_length),
      masses_(positive_masses(graph_)) {
  at_source_.reserve(graph_.edges.size());
  at_target_.reserve(graph_.edges.size());
  for (const Connection_edge& e : graph_.edges) {
    at_source_.push_back(std::polar(1., e.source_angle));
    at_target_.push_back(std::polar(1., e.target_angle));
  }
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::MatrixXd Heat_transport::diffused(const Eigen::MatrixXd& b) const {
  if (!functions_) functions_.emplace(factored_laplacian<double>(graph_, 0, time_, masses_));
  return functions_->solve(b);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::MatrixXcd Heat_transport::diffused(const Eigen::MatrixXcd& b) const {
  if (!vectors_)
    vectors_.emplace(factored_laplacian<std::complex<double>>(graph_, 1, time_, masses_));
  return vectors_->solve(b);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXd Heat_transport::heat(const std::vector<Source_corner>& source) const {
  Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(graph_.size));
  for (const Source_corner& c : source) b[c.vertex] += c.weight;
  return diffused(Eigen::MatrixXd(b));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXd Heat_transport::extended(const Vector_sources& sources) const {
  Eigen::MatrixXd b(sources.weights.size(), 2);
  b << sources.lengths, sources.weights;
  const Eigen::MatrixXd heat = diffused(b);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(b.rows());
  for (Eigen::Index i = 0; i < b.rows(); ++i)
    if (heat(i, 1) > 0) result[i] = heat(i, 0) / heat(i, 1);
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXcd Heat_transport::transported(const Vector_sources& sources) const {
  const Eigen::VectorXd lengths = extended(sources);
  Eigen::VectorXcd z = diffused(Eigen::MatrixXcd(sources.vectors));
  for (Eigen::Index i = 0; i < z.size(); ++i) z[i] = unit_vector(z[i]) * lengths[i];
  return z;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXcd Heat_transport::parallel_frames(const std::vector<Source_corner>& source) const {
  Eigen::VectorXcd b = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(graph_.size));
  for (const Source_corner& c : source) b[c.vertex] += c.weight * c.frame;
  return b;
}

// In the plane, positions of the source relative to the vertices, times the heat of functions there, are in the kernel of heat
// whose vectors are moved by the edge that they cross: exactly, on any triangulation.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXcd Heat_transport::affine_logarithm(const std::vector<Source_corner>& source) const {
  const auto size = static_cast<Eigen::Index>(graph_.size);
  Eigen::MatrixXcd b = Eigen::MatrixXcd::Zero(size, 2); // positions, frames
  b.col(1) = parallel_frames(source);
  for (const Source_corner& c : source) b(c.vertex, 0) -= c.weight * c.frame * c.offset;
  const Eigen::VectorXd heat = this->heat(source);
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    const double w = time_ * e.weight * e.length;
    b(e.source, 0) += w * heat[e.target] * at_source_[i];
    b(e.target, 0) += w * heat[e.source] * at_target_[i];
  }
  const Eigen::MatrixXcd z = diffused(b);
  Eigen::VectorXcd result = Eigen::VectorXcd::Zero(size);
  for (Eigen::Index i = 0; i < size; ++i)
    if (heat[i] > 0) result[i] = -z(i, 0) / heat[i] * std::conj(unit_vector(z(i, 1)));
  for (const Source_corner& c : source) result[c.vertex] = c.offset;
  return result;
}

// Vectors that point away from the source, at the neighbours of its vertices.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXcd Heat_transport::outward_vectors(const std::vector<Source_corner>& source) const {
  std::vector<double> weight(graph_.size, 0);
  for (const Source_corner& c : source) weight[static_cast<std::size_t>(c.vertex)] += c.weight;
  const auto at = [&weight](int i) { return weight[static_cast<std::size_t>(i)]; };
  Eigen::VectorXcd b = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(graph_.size));
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    if (e.source == e.target) continue;
    if (at(e.source) > 0) b[e.target] -= at(e.source) * e.weight * at_target_[i];
    if (at(e.target) > 0) b[e.source] -= at(e.target) * e.weight * at_source_[i];
  }
  return b;
}

// What makes a matrix definite that has constants in its kernel: a vertex in each part that edges connect.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
std::vector<double> Heat_transport::pins() const {
  const std::vector<std::size_t> part = graph_parts(graph_);
  std::vector<double> pins(graph_.size, 0);
  for (std::size_t i = 0; i < graph_.size; ++i)
    if (part[i] == i) pins[i] = 1;
  return pins;
}

// The function whose differences along edges are nearest to those along unit vectors, zero at the source.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXd Heat_transport::distances(const std::vector<Source_corner>& source,
                                          const Eigen::VectorXcd& radial) const {
  if (!poisson_) poisson_.emplace(factored_laplacian<double>(graph_, 0, 1, pins()));
  Eigen::VectorXd b = Eigen::VectorXd::Zero(radial.size());
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    const std::complex<double>&x = radial[e.source], &y = radial[e.target];
    const double ends = (x == 0. ? 0 : 1) + (y == 0. ? 0 : 1);
    if (ends == 0) continue;
    const double along =
        (std::conj(at_source_[i]) * x).real() - (std::conj(at_target_[i]) * y).real();
    const double flow = e.weight * e.length * along / ends;
    b[e.source] -= flow;
    b[e.target] += flow;
  }
  Eigen::VectorXd r = poisson_->solve(Eigen::MatrixXd(b));
  double error = 0;
  for (const Source_corner& c : source) error += c.weight * (r[c.vertex] - std::abs(c.offset));
  r.array() -= error;
  return r;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Eigen::VectorXcd Heat_transport::polar_logarithm(const std::vector<Source_corner>& source) const {
  Eigen::MatrixXcd b(static_cast<Eigen::Index>(graph_.size), 2);
  b << outward_vectors(source), parallel_frames(source);
  const Eigen::MatrixXcd z = diffused(b);
  Eigen::VectorXcd radial = z.col(0).unaryExpr(&unit_vector);
  for (const Source_corner& c : source) radial[c.vertex] = unit_vector(c.frame * c.offset);
  const Eigen::VectorXd r = distances(source, radial);
  Eigen::VectorXcd result(radial.size());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = std::max(0., r[i]) * radial[i] * std::conj(unit_vector(z(i, 1)));
  for (const Source_corner& c : source) result[c.vertex] = c.offset;
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_APPLICATIONS_VECTORS_HEAT_TRANSPORT_IMPL_H

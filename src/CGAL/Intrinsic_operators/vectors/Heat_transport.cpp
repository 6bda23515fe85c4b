// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/solvers/Diffusion.h>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Vector_sources::add(Eigen::Index vertex, double weight, double value) {
  if (!std::isfinite(value))
    throw std::invalid_argument("the values and vectors of sources must be finite");
  has_different = has_different || (common && *common != value);
  common = value;
  weights[vertex] += weight;
  lengths[vertex] += weight * value;
}

Heat_transport::Heat_transport(Connection_graph graph, double time_factor)
    : graph_(std::move(graph)), part_(graph_.parts()),
      time_(flow_time(time_factor, graph_.squared_mean_length,
                      std::accumulate(graph_.areas.begin(), graph_.areas.end(), 0.))),
      masses_(positive_masses(graph_)) {}

// Transport does without them: sines and cosines take a tenth of the time of its first call.
const Edge_directions& Heat_transport::directions() const {
  if (directions_) return *directions_;
  Edge_directions found;
  found.at_source.reserve(graph_.edges.size());
  found.at_target.reserve(graph_.edges.size());
  for (const Connection_edge& e : graph_.edges) {
    found.at_source.push_back(std::polar(1., e.source_angle));
    found.at_target.push_back(std::polar(1., e.target_angle));
  }
  return directions_.emplace(std::move(found));
}

const Function_flow& Heat_transport::functions() const {
  if (!functions_)
    functions_ = std::make_shared<const Function_flow>(scaled_laplacian<double>(graph_, 0, time_),
                                                       masses_, analysis_);
  return *functions_;
}

const Vector_flow& Heat_transport::vectors() const {
  if (!vectors_)
    vectors_ = std::make_shared<const Vector_flow>(
        scaled_laplacian<std::complex<double>>(graph_, 1, time_), masses_, analysis_);
  return *vectors_;
}

void Heat_transport::factor(Transport_step step) const {
  if (step == Transport_step::functions_factored)
    functions();
  else
    vectors();
}

// Whether there is a source in the part of each vertex.
std::vector<char> Heat_transport::reached(const Eigen::VectorXd& weights) const {
  std::vector<char> result(graph_.size, 0);
  for (std::size_t i = 0; i < result.size(); ++i)
    if (weights[static_cast<Eigen::Index>(i)] > 0) result[part_[i]] = 1;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = result[part_[i]];
  return result;
}

Heat<double> Heat_transport::heat(const Eigen::VectorXd& weights) const {
  return functions()(weights, reached(weights));
}

Eigen::VectorXd Heat_transport::unit_weight(Eigen::Index source) const {
  return Eigen::VectorXd::Unit(static_cast<Eigen::Index>(graph_.size), source);
}

Eigen::VectorXd Heat_transport::log_heat(const Eigen::VectorXd& weights) const {
  const Heat<double> found = heat(weights);
  Eigen::VectorXd result(found.value.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) result[i] = internal::log_heat(found, i);
  return result;
}

Eigen::VectorXd Heat_transport::extended(const Vector_sources& sources) const {
  if (sources.weights.size() == 0 || !(sources.weights.maxCoeff() > 0))
    throw std::invalid_argument("there must be a source; none is given");
  const std::vector<char> is_reached = reached(sources.weights);
  Eigen::VectorXd result(sources.weights.size());
  if (!sources.has_different) { // its mean by any weights, without heat
    for (Eigen::Index i = 0; i < result.size(); ++i)
      result[i] =
          is_reached[static_cast<std::size_t>(i)] != 0 ? *sources.common : unknown_vector.real();
    return result;
  }
  const std::vector<Heat<double>> heat = functions().all(
      {Heat<double>(sources.lengths), Heat<double>(sources.weights)}, {is_reached, is_reached});
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = heat[1].value[i] > 0 ? heat_ratio(heat[0], heat[1], i) : unknown_vector.real();
  return result;
}

Eigen::VectorXcd Heat_transport::transported(const Vector_sources& sources,
                                             const Eigen::VectorXd& lengths) const {
  Eigen::VectorXcd start = sources.vectors;
  for (Eigen::Index i = 0; i < start.size(); ++i)
    if (start[i] != 0. && !(std::abs(start[i]) > cancelled * sources.lengths[i])) start[i] = 0;
  const auto z = vectors()(start, reached(sources.weights));
  Eigen::VectorXcd result = z.value.unaryExpr(&unit_vector);
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = lengths[i] == 0 ? 0 : result[i] == 0. ? unknown_vector : lengths[i] * result[i];
  return result;
}

// The part that edges add to positions that cross them, times the heat from a neighbour, with its
// exponents. \param frames the frame of the source, transported to all vertices
std::vector<Heat<double>>
Heat_transport::positions_at_neighbours(const Heat<double>& heat,
                                        const Eigen::VectorXcd& frames) const {
  std::vector<Heat<double>> b(2, Heat<double>(Eigen::VectorXd::Zero(heat.value.size())));
  std::vector<int> level = heat.level;
  const auto number = [](int i) { return static_cast<std::size_t>(i); };
  for (const Connection_edge& e : graph_.edges) {
    if (e.weight == 0) continue;
    int &s = level[number(e.source)], &t = level[number(e.target)];
    s = std::min(s, heat.level[number(e.target)]);
    t = std::min(t, heat.level[number(e.source)]);
  }
  const auto add = [&b](int i, const std::complex<double>& z) {
    b[0].value[i] += z.real();
    b[1].value[i] += z.imag();
  };
  const auto& [at_source, at_target] = directions();
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    if (e.weight == 0) continue;
    const double w = -time_ * e.weight * e.length;
    add(e.source, w * heat.at(e.target, level[number(e.source)]) * at_source[i] *
                      std::conj(frames[e.source]));
    add(e.target, w * heat.at(e.source, level[number(e.target)]) * at_target[i] *
                      std::conj(frames[e.target]));
  }
  for (Heat<double>& h : b) {
    h.level = level;
    h.exponent = heat.exponent;
  }
  return b;
}

// In the plane, positions times the heat of functions are heat that moves along the edges that it
// crosses: exactly, on any triangulation. On curved surfaces edges have directions in the
// transported frame of the source: heat that turns with each edge would lose the source after some
// edges.
Eigen::VectorXcd Heat_transport::affine_logarithm(Eigen::Index source) const {
  const Eigen::VectorXd start = unit_weight(source);
  const std::vector<char> is_reached = reached(start);
  const Heat<double> heat = this->heat(start);
  const Eigen::VectorXcd frames = vectors()(start, is_reached).value.unaryExpr(&unit_vector);
  const std::vector<Heat<double>> z =
      functions().all(positions_at_neighbours(heat, frames), {is_reached, is_reached});
  Eigen::VectorXcd result(heat.value.size());
  for (Eigen::Index i = 0; i < result.size(); ++i)
    result[i] = heat.value[i] > 0 && frames[i] != 0.
                    ? std::complex(heat_ratio(z[0], heat, i), heat_ratio(z[1], heat, i))
                    : unknown_vector;
  result[source] = 0;
  return result;
}

// Vectors that point away from the source, at its neighbours. Weighted by cotangents and lengths of
// edges they sum to zero in the plane, since linear functions are harmonic. A nonzero sum would
// dominate far away, where it is parallel, not radial.
Eigen::VectorXcd Heat_transport::outward_vectors(Eigen::Index source) const {
  Eigen::VectorXcd b = Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(graph_.size));
  const auto& [at_source, at_target] = directions();
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    if (e.source == e.target) continue;
    const double flow = e.weight * e.length;
    if (e.source == source) b[e.target] -= flow * at_target[i];
    if (e.target == source) b[e.source] -= flow * at_source[i];
  }
  return b;
}

// Diagonal entries that make a matrix with constants in its kernel definite: one vertex in each
// connected part.
Eigen::VectorXd Heat_transport::pins() const {
  Eigen::VectorXd pins(static_cast<Eigen::Index>(graph_.size));
  for (std::size_t i = 0; i < graph_.size; ++i)
    pins[static_cast<Eigen::Index>(i)] = part_[i] == i ? 1 : 0;
  return pins;
}

// The function whose differences along edges are nearest to those along unit vectors, zero at the
// source.
Eigen::VectorXd Heat_transport::distances(Eigen::Index source,
                                          const Eigen::VectorXcd& radial) const {
  if (!poisson_) poisson_.emplace(scaled_laplacian<double>(graph_, 0, 1), pins(), analysis_);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(radial.size());
  const auto& [at_source, at_target] = directions();
  for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
    const Connection_edge& e = graph_.edges[i];
    const std::complex<double>&x = radial[e.source], &y = radial[e.target];
    const double ends = (x == 0. ? 0 : 1) + (y == 0. ? 0 : 1);
    if (ends == 0) continue;
    const double along =
        (std::conj(at_source[i]) * x).real() - (std::conj(at_target[i]) * y).real();
    const double flow = e.weight * e.length * along / ends;
    b[e.source] -= flow;
    b[e.target] += flow;
  }
  Eigen::VectorXd r = poisson_->solve(Eigen::MatrixXd(b));
  r.array() -= r[source];
  return r;
}

Eigen::VectorXcd Heat_transport::polar_logarithm(Eigen::Index source) const {
  using Vectors = Heat<std::complex<double>>;
  const Eigen::VectorXd start = unit_weight(source);
  const std::vector<char> is_reached = reached(start);
  const std::vector<Vectors> z = // away from the source, and parallel to its real axis
      vectors().all({Vectors(outward_vectors(source)), Vectors(start)}, {is_reached, is_reached});
  Eigen::VectorXcd radial = z[0].value.unaryExpr(&unit_vector);
  radial[source] = 0;
  const Eigen::VectorXd r = distances(source, radial);
  Eigen::VectorXcd result(radial.size());
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const std::complex<double> direction = radial[i] * std::conj(unit_vector(z[1].value[i]));
    // the length is unknown, but positive
    constexpr double least = std::numeric_limits<double>::min();
    result[i] = direction == 0. ? unknown_vector : std::max(least, r[i]) * direction;
  }
  result[source] = 0;
  return result;
}

void lengthen_to_chords(const std::vector<std::array<double, 3>>& at,
                        const std::vector<std::uint32_t>& first, std::size_t source, double unit,
                        std::vector<std::complex<double>>& log) {
  const auto& q = at[source];
  std::vector<double> least(log.size(), std::numeric_limits<double>::infinity());
  const auto vertex = [&first](std::size_t i) { return first.empty() ? i : first[i]; };
  for (std::size_t i = 0; i < log.size(); ++i)
    least[vertex(i)] = std::fmin(least[vertex(i)], std::abs(log[i])); // not that of unknown ones
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto& p = at[i];
    const double chord = unit * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    const double length = std::abs(log[i]), nearest = least[vertex(i)];
    if (nearest < chord) log[i] = (chord + (length - nearest)) * unit_vector(log[i]);
    if (log[i] == 0. && chord > 0) log[i] = unknown_vector;
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

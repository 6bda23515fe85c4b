// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_HEAT_TRANSPORT_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_HEAT_TRANSPORT_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/solvers/Laplacian_factorization.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A long step before the transport of vectors.
enum class Transport_step {
  functions_factored, ///< the matrix for the heat of functions is factored
  vectors_factored    ///< the matrix for vectors is factored
};

namespace internal {

template <class Scalar>
struct Heat;
class Function_flow;
class Vector_flow;

// The directions of each edge at its ends.
struct Edge_directions {
  std::vector<std::complex<double>> at_source, at_target;
};

// Vectors at vertices or points, with the lengths to diffuse.
struct Vector_sources {
  explicit Vector_sources(std::size_t size)
      : vectors(Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(size))),
        lengths(Eigen::VectorXd::Zero(vectors.size())),
        weights(Eigen::VectorXd::Zero(vectors.size())) {}
  // Adds a length or value. \throws std::invalid_argument if it is not finite
  void add(Eigen::Index vertex, double weight, double value);

  Eigen::VectorXcd vectors;
  Eigen::VectorXd lengths; // or values, of functions
  Eigen::VectorXd weights;
  std::optional<double> common; // the length, if it is the same for all
  bool has_different = false;   // lengths
};

// Makes the logarithms of a vertex at least as long as chords in space; a logarithm without
// direction becomes unknown. The order of the copies of a vertex by length stays.
// \param at positions of vertices, possibly unknown \param first the first copy of the vertex of
// each copy; empty: there is one of each \param unit that of positions, in that of the logarithms
void lengthen_to_chords(const std::vector<std::array<double, 3>>& at,
                        const std::vector<std::uint32_t>& first, std::size_t source, double unit,
                        std::vector<std::complex<double>>& log);

// Diffuses functions and tangent vectors for a short time, by the numbers of a graph, in scaled
// units. Each matrix is factored once, when it is first needed.
class Heat_transport {
public:
  // \param time_factor of the time, in squares of the mean length of edges
  Heat_transport(Connection_graph graph, double time_factor);

  const Connection_graph& graph() const { return graph_; }

  // Factors the matrix whose factor a step names, unless it is.
  void factor(Transport_step step) const;
  // Whether it is factored.
  bool is_factored(Transport_step step) const {
    return step == Transport_step::functions_factored ? functions_ != nullptr : vectors_ != nullptr;
  }

  // for each vertex, the representative of its part, which heat connects
  const std::vector<std::uint32_t>& parts() const { return part_; }

  // the natural logarithm of the heat that comes from vertices with weights
  Eigen::VectorXd log_heat(const Eigen::VectorXd& weights) const;
  // the mean of the values at sources, by the heat that comes from each
  // \throws std::invalid_argument if sources are missing; `transported()` does the same
  Eigen::VectorXd extended(const Vector_sources& sources) const;
  // the vectors from sources, with given lengths
  Eigen::VectorXcd transported(const Vector_sources& sources, const Eigen::VectorXd& lengths) const;
  // positions in the frame of a vertex, by heat of affine vectors
  Eigen::VectorXcd affine_logarithm(Eigen::Index source) const;
  // the angle between a radial and a parallel field, and the distance whose gradient is the radial
  // field
  Eigen::VectorXcd polar_logarithm(Eigen::Index source) const;

private:
  Heat<double> heat(const Eigen::VectorXd& weights) const;
  const Function_flow& functions() const;
  const Vector_flow& vectors() const;
  const Edge_directions& directions() const;
  std::vector<char> reached(const Eigen::VectorXd& weights) const;
  Eigen::VectorXd unit_weight(Eigen::Index source) const;
  Eigen::VectorXcd outward_vectors(Eigen::Index source) const;
  std::vector<Heat<double>> positions_at_neighbours(const Heat<double>& heat,
                                                    const Eigen::VectorXcd& frames) const;
  Eigen::VectorXd distances(Eigen::Index source, const Eigen::VectorXcd& radial) const;
  Eigen::VectorXd pins() const;

  Connection_graph graph_;
  std::vector<std::uint32_t> part_;
  double time_;
  Eigen::VectorXd masses_; // areas, ones at isolated vertices
  mutable std::optional<Edge_directions> directions_;
  mutable Shared_analysis analysis_; // of all matrices: they have entries in the same places
  mutable std::optional<Laplacian_factorization> poisson_;
  mutable std::shared_ptr<const Function_flow> functions_;
  mutable std::shared_ptr<const Vector_flow> vectors_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_HEAT_TRANSPORT_H

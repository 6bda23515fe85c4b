// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_HEAT_METHOD_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_HEAT_METHOD_H

#include <CGAL/Intrinsic_operators/distance/positions_of_rows.h>
#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Heat_transport.h>
#include <CGAL/Intrinsic_operators/vectors/Point_frames.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief transports tangent vectors over a surface by short-time heat flow (the vector heat method; N.
Sharp, Y. Soliman, K. Crane, *The Vector Heat Method*, 2019), and finds logarithmic maps.

(M + t L_1) z = vectors,  (M + t L_0) u = lengths,  (M + t L_0) p = 1 at sources;    result  (z /
|z|) (u / p)

with the connection Laplacian L_1, the Laplacian L_0 and the lumped mass matrix M: at each vertex,
the vector that arrives along the shortest path from the nearest source, with its length. On flat
surfaces transport is exact. Each matrix is factored once, when it is first needed: further sources
cost triangular solves. Weights are nonnegative in Delaunay triangulations: call
`flip_to_delaunay()` before. On a cover, functions have one value for all copies of a vertex, and
heat of functions passes from one sheet to another there.

Vectors at vertices are those of a `Tangent_field`. At border vertices, computations do not scale
angles; a vector that points out of the surface stays in the half of the circle beyond the border.
Points are places on the triangulation with vectors in the frame of their halfedge, as
`Tangent_vector`; `surface_point(t, face_location)` makes one. Unknown vectors are NaN: on
components without a source, and without direction, as where sources cancel. Heat falls with
distance, below the range of doubles after some hundred edges; values have separate exponents, so
distances and lengths may have any size.

Const functions factor what they need: threads may share them after `factor()` and one call each.
\tparam Triangulation a model of `MeasuredTriangulation` and `NumberedTriangulation`
*/
template <ConnectedTriangulation Triangulation_>
class Vector_heat_method {
public:
  /// the triangulation
  using Triangulation = Triangulation_;
  using vertex_descriptor = typename Triangulation::vertex_descriptor; ///< a vertex of it
  using Complex = std::complex<double>; ///< a vector in the coordinates of a vertex

  /*!
  \brief reads angles, weights and areas of a triangulation.
  \param t the triangulation; it must outlive this object unchanged
  \param np optional named parameters:
    - `time_factor(x)`: the time of diffusion is x times the square of the mean length of the edges.
      Default: 1.
  \throws Invalid_input if a face has no area
  \throws std::invalid_argument if the time is not positive, or so long that heat is even
    everywhere, or the surface is that of a cloud of points, see `Point_cloud_vectors`
  \complexity linear; the first query factors matrices
  */
  template <NamedParameters NP = parameters::Parameters<>>
  explicit Vector_heat_method(const Triangulation_& t, const NP& np = parameters::default_values())
      : frames_(t), heat_(internal::connection_graph(t, frames_.angles()),
                          internal::value_or<internal::tags::time_factor>(np, 1.)) {
    internal::expect_names<internal::tags::time_factor>(np);
    if (!t.input().names().is_cover()) return;
    first_ = Vertex_copies(t).first_of_copies();
    joined_.emplace(heat_.graph().joined(first_),
                    internal::value_or<internal::tags::time_factor>(np, 1.));
  }
  /// A triangulation that would end before this object is refused: give it a name.
  template <NamedParameters NP = parameters::Parameters<>>
  explicit Vector_heat_method(const Triangulation_&&,
                              const NP& = parameters::default_values()) = delete;

  /*!
  \brief factors the matrices before the first query, so that the caller can observe and stop it.
  \param np optional named parameters:
    - `visitor(v)`: `v.progress(step)` is called with a `Transport_step` after each, and returns
      whether to go on.
  \return `cancelled` if the visitor stopped it; then a query factors the rest
  \complexity that of factoring a real and a complex matrix, once
  */
  template <NamedParameters NP = parameters::Parameters<>>
  Status factor(const NP& np = parameters::default_values()) const {
    internal::expect_names<internal::tags::visitor>(np);
    auto progress = internal::progress_of(np);
    factor(Transport_step::functions_factored);
    if (!progress(Transport_step::functions_factored)) return Status::cancelled;
    factor(Transport_step::vectors_factored);
    progress(Transport_step::vectors_factored); // nothing is left to be stopped
    return Status::done;
  }
  void factor(Transport_step step) const { heat_.factor(step); } ///< factors one matrix, once
  bool is_factored(Transport_step s) const { return heat_.is_factored(s); } ///< tells whether it is

  /// returns the triangulation.
  const Triangulation& triangulation() const { return frames_.triangulation(); }

  /// returns the mean length of the edges of the triangulation, in the units of the input.
  double mean_edge_length() const { return unit() * std::sqrt(heat_.graph().squared_mean_length); }

  /*!
  \brief returns the logarithm of the heat at all vertices that comes from a point: most of it comes
  from the nearest of several points.
  \param p the point
  \return natural logarithms, by the numbers of a `Tangent_field`; minus infinity on other
  components
  \complexity that of solving with one factored real matrix; once more for each 700 edges or so from
    the point
  */
  Eigen::VectorXd log_heat(const Surface_point& p) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(frames_.size()));
    for (const auto& c : frames_.corners(p)) weights[c.vertex] += c.weight;
    return heat_.log_heat(weights);
  }

  /// returns whether two points are on one component of the surface. \complexity constant
  bool are_connected(const Surface_point& p, const Surface_point& q) const {
    return part(p) == part(q);
  }

  /// returns areas about vertices, up to a factor, by the numbers of a `Tangent_field`.
  const std::vector<double>& relative_areas() const { return heat_.graph().areas; }

  /*!
  \brief extends values at vertices to all vertices: smoothly, near the value of the nearest source.
  \param sources vertices and their values
  \return values by the numbers of a `Tangent_field`, between the least and the greatest value of
    sources; NaN on components without a source
  \throws std::invalid_argument if there is no source, one is an isolated vertex, or a value is not
    finite
  \complexity that of solving with one factored real matrix, unless all values are the same
  */
  Eigen::VectorXd
  extend_scalars(const std::vector<std::pair<vertex_descriptor, double>>& sources) const {
    internal::Vector_sources s(heat_.graph().size);
    for (const auto& [v, value] : sources) {
      const auto i = static_cast<Eigen::Index>(number(v));
      s.add(i, 1, value);
    }
    return extended(s);
  }

  /// extends values at points; see above.
  Eigen::VectorXd
  extend_scalars(const std::vector<std::pair<Surface_point, double>>& sources) const {
    internal::Vector_sources s(heat_.graph().size);
    for (const auto& [p, value] : sources)
      for (const auto& c : frames_.corners(p)) s.add(c.vertex, c.weight, value);
    return extended(s);
  }

  /*!
  \brief transports vectors from vertices to all vertices.
  \param sources vertices, and vectors in their coordinates; those at one vertex add up
  \return the vectors
  \throws std::invalid_argument as `extend_scalars()`
  \complexity that of solving with a factored complex matrix; with a real one too, unless all
    vectors have the same length, bit by bit
  */
  Tangent_field transport(const std::vector<std::pair<vertex_descriptor, Complex>>& sources) const {
    internal::Vector_sources s(heat_.graph().size);
    for (const auto& [v, z] : sources) {
      const std::uint32_t i = number(v);
      s.add(i, 1, std::abs(z));
      s.vectors[i] += frames_.from_field(i, z);
    }
    return transported(s);
  }

  /// transports the vector `z` from vertex `v` to all vertices; see above.
  Tangent_field transport(vertex_descriptor v, const Complex& z) const {
    return transport(std::vector<std::pair<vertex_descriptor, Complex>>{{v, z}});
  }

  /// transports vectors from points; see above. A vector in a face moves to the corners, by their
  /// weights.
  Tangent_field transport(const std::vector<Tangent_vector>& sources) const {
    internal::Vector_sources s(heat_.graph().size);
    for (const Tangent_vector& v : sources) {
      const Complex z(v.vector[0], v.vector[1]);
      for (const auto& c : frames_.corners(v.point)) {
        s.add(c.vertex, c.weight, std::abs(z));
        s.vectors[c.vertex] += c.weight * c.to_here(z);
      }
    }
    return transported(s);
  }

  /// transports a vector from a point; see above.
  Tangent_field transport(const Tangent_vector& v) const {
    return transport(std::vector<Tangent_vector>{v});
  }

  /*!
  \brief finds the logarithmic map of a vertex: for each vertex, the vector at `v` along the
  shortest path, whose exponential map is that vertex (see `exponential_map()`). By heat, vectors
  are no shorter than chords in space; near the cut locus, where several paths are shortest, that is
  the only guarantee.
  \param v the vertex, which is not isolated
  \param method how to find it
  \return by the numbers of a `Tangent_field`, vectors in the coordinates of `v`; NaN on other
  components
  \throws std::invalid_argument if the vertex is isolated
  \complexity exact: that of `logarithmic_map()`; else that of solving twice with one factored real
    and once with one factored complex matrix
  */
  std::vector<Complex> logarithmic_map(vertex_descriptor v,
                                       Logarithm_method method = Logarithm_method::exact) const {
    if (method == Logarithm_method::exact)
      return Intrinsic_triangulations::logarithmic_map(triangulation(), v);
    const std::uint32_t i = number(v);
    std::vector<Complex> result = logarithm(i, method);
    for (Complex& z : result) z = frames_.to_field(i, z);
    return result;
  }

  /*!
  \brief finds the logarithmic map of a point; see above. By heat, it is interpolated in the face
  between those of its corners: in the plane, the mean of squared distances from corners is greater
  than the squared distance by that of their own.
  \return vectors in the frame of `p.halfedge`; at a vertex, angles from the sides of its face are
    those on the surface
  */
  std::vector<Complex> logarithmic_map(const Surface_point& p,
                                       Logarithm_method method = Logarithm_method::exact) const {
    if (method == Logarithm_method::exact)
      return Intrinsic_triangulations::logarithmic_map(triangulation(), p);
    std::vector<Complex> result(heat_.graph().size, 0);   // the mean vectors
    std::vector<double> squared_length(result.size(), 0); // in scaled units
    for (const auto& c : frames_.corners(p)) {
      const std::vector<Complex> log = logarithm(c.vertex, method);
      for (std::size_t i = 0; i < result.size(); ++i) {
        const Complex z = log[i] / unit();
        result[i] += c.weight * (c.offset + c.from_here(z));
        squared_length[i] += c.weight * (std::norm(z) - std::norm(c.offset));
      }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Complex direction = internal::unit_vector(result[i]);
      const bool is_known = direction != 0. || squared_length[i] <= 0;
      result[i] = is_known ? unit() * std::sqrt(std::max(0., squared_length[i])) * direction
                           : internal::unknown_vector;
    }
    return result;
  }

  /*!
  \brief finds a logarithmic map between two points: interpolates one in the face of `q`.
  \param log the result of `logarithmic_map(p)`
  \param p a point
  \param q another point; in the same face, the result is exact
  \return the vector to `q`, in the frame of `p.halfedge`
  \throws std::invalid_argument if `log` does not have a vector per vertex
  */
  Complex logarithm_at(const std::vector<Complex>& log, const Surface_point& p,
                       const Surface_point& q) const {
    if (log.size() != heat_.graph().size)
      throw std::invalid_argument("a logarithmic map has a vector per vertex, " +
                                  std::to_string(heat_.graph().size) + ", not " +
                                  std::to_string(log.size()));
    return frames_.interpolated(log, p, q);
  }

private:
  std::uint32_t part(const Surface_point& p) const {
    return heat_.parts()[static_cast<std::size_t>(frames_.corners(p)[0].vertex)];
  }

  std::uint32_t number(vertex_descriptor v) const {
    if (frames_.is_isolated(v))
      throw std::invalid_argument("vertex " + std::to_string(frames_.number(v)) +
                                  " has no face, so that there are no vectors at it");
    return frames_.number(v);
  }

  Eigen::VectorXd extended(const internal::Vector_sources& s) const {
    if (!joined_) return heat_.extended(s);
    internal::Vector_sources at_first = s;
    at_first.lengths.setZero();
    at_first.weights.setZero();
    for (Eigen::Index i = 0; i < s.weights.size(); ++i) {
      const std::uint32_t first = first_[static_cast<std::size_t>(i)];
      at_first.lengths[first] += s.lengths[i];
      at_first.weights[first] += s.weights[i];
    }
    const Eigen::VectorXd values = joined_->extended(at_first);
    return Eigen::VectorXd::NullaryExpr(
        values.size(), [&](Eigen::Index i) { return values[first_[static_cast<std::size_t>(i)]]; });
  }

  Tangent_field transported(const internal::Vector_sources& s) const {
    const Eigen::VectorXcd z = heat_.transported(s, extended(s));
    Tangent_field result(heat_.graph().size);
    for (std::uint32_t i = 0; i < result.size(); ++i) result[i] = frames_.to_field(i, z[i]);
    return result;
  }

  // the unit of computations in that of the input
  double unit() const { return std::ldexp(1., -triangulation().metric().scale_exponent()); }

  std::vector<Complex> logarithm(std::uint32_t source, Logarithm_method method) const {
    const Eigen::VectorXcd z = method == Logarithm_method::affine ? heat_.affine_logarithm(source)
                                                                  : heat_.polar_logarithm(source);
    std::vector<Complex> result(heat_.graph().size);
    for (std::size_t i = 0; i < result.size(); ++i)
      result[i] = unit() * z[static_cast<Eigen::Index>(i)];
    lengthen_to_chords(source, result);
    return result;
  }

  // Where positions are known, no path is shorter than the way in space.
  void lengthen_to_chords(std::uint32_t source, std::vector<Complex>& log) const {
    const auto rows = internal::positions_of_rows(triangulation());
    if (rows.empty()) return;
    std::vector<std::array<double, 3>> at(log.size());
    for (const vertex_descriptor v : vertices(triangulation().mesh()))
      at[frames_.number(v)] = rows[triangulation().input_vertex(v)];
    internal::lengthen_to_chords(at, first_, source, unit(), log);
  }

  internal::Point_frames<Triangulation> frames_;
  internal::Heat_transport heat_;
  // On a cover, the first copy of the vertex of each copy, and heat of functions on these alone.
  std::vector<std::uint32_t> first_;
  std::optional<internal::Heat_transport> joined_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_HEAT_METHOD_H

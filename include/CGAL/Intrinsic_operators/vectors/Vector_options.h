// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_OPTIONS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_OPTIONS_H

#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

/*!
\file
What is asked of `Vectors`, and what it finds.
*/

namespace CGAL::Intrinsic_triangulations {

/// What `Vectors` is doing when it asks whether to go on.
enum class Vector_step : std::uint8_t {
  windows,       ///< looks through the windows of exact distances; how many is counted
  factorization, ///< factors matrices
  solution,      ///< solves with them
  field          ///< factors matrices and solves for a field of directions
};

/// How vectors are found.
struct Vector_options {
  /// Of the flow of heat, see `Vector_heat_method`.
  double time_factor = defaults::time_factor;
  /// Of each point of a cloud, see `Point_cloud_vectors`.
  std::size_t neighbors = defaults::neighbors;
  /// Of linear problems of direction fields; those of heat and of clouds are factored.
  Linear_solver solver = Linear_solver::automatic;
  /// How far logarithms along shortest paths go, in the units of the input.
  double maximum_distance = std::numeric_limits<double>::infinity();
  /// Is called with what is done, and how much of it; returns whether to go on. On clouds of points
  /// only `directions()` asks.
  std::function<bool(Vector_step, std::uint64_t)> progress{};
};

namespace internal {

// \throws std::invalid_argument if a field on a cloud is to be iterated: its matrix is not that of
// a graph without negative weights
inline void expect_factor_for_cloud(const Vector_options& options) {
  if (options.solver == Linear_solver::iterative)
    throw std::invalid_argument("fields on a cloud of points need a direct solver; take one");
}

} // namespace internal

/// Vectors at places: in their tangent planes, see `Tangents_at_places`, or in space.
struct Given_vectors {
  std::vector<Place> places; ///< where they are, normalized
  /// One per place; none: they are in space.
  std::vector<std::complex<double>> in_planes{};
  std::vector<std::array<double, 3>> in_space{}; ///< one per place, or none

  /// tells whether all places are named as vertices, not as corners of faces.
  bool are_at_vertices() const {
    return std::none_of(places.begin(), places.end(), [](const Place& p) { return p.has_face(); });
  }
};

/// Vectors at all vertices.
struct Found_vectors {
  /// Of each copy of a vertex, see `Tangent_field`; of each point of a cloud; NaN if unknown.
  Tangent_field vectors{};
  /// The number in `vectors` of the one that stands for each row; `Gluing::none` if the vertex has
  /// no face.
  std::vector<std::uint32_t> of_row{};
  Status status = Status::done; ///< or `cancelled`: then there are no vectors
};

/// A field of directions, and the faces where it is singular; none on a cloud of points, which has
/// no faces.
struct Found_directions : Found_vectors {
  std::vector<int> index{}; ///< of each face of the triangulation, see `Field_singularities`
  /// The centres of faces with an index other than 0, on the input, and this index.
  std::vector<std::pair<Surface_point, int>> centres{};
  std::ptrdiff_t index_sum = 0; ///< of all faces
  int border_turns = 0;         ///< along all boundary loops
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_VECTOR_OPTIONS_H

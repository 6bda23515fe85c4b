// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_FIELDS_H
#define INTRINSIC_PYTHON_FIELDS_H

#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_operators/vectors/Vectors.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// What functions on vectors have in common.

namespace python {

using Complex = std::complex<double>; ///< a tangent vector

/// A coordinate of a vector that is not known.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Vectors at the vertices of a triangulation.
using Field = IT::Found_vectors;

/// returns two coordinates for each row.
inline std::vector<std::array<double, 2>> coordinates_of(const Field& field) {
  std::vector<std::array<double, 2>> result(field.of_row.size(), {unknown, unknown});
  for (std::size_t r = 0; r < field.of_row.size(); ++r)
    if (const std::uint32_t i = field.of_row[r]; i != IT::Gluing::none)
      result[r] = {field.vectors[i].real(), field.vectors[i].imag()};
  return result;
}

/// returns how to find vectors. \param watch is asked meanwhile; it must outlive the result
inline IT::Vector_options vector_options(double time_factor, std::size_t neighbors, Watch& watch) {
  IT::Vector_options options;
  options.time_factor = time_factor;
  options.neighbors = neighbors;
  options.progress = [&watch](IT::Vector_step step, std::uint64_t count) {
    static constexpr std::array names{"windows", "factorization", "solution",
                                      "factorization and solutions"};
    return watch(names[static_cast<std::size_t>(step)], count);
  };
  return options;
}

/// returns what finds vectors on the triangulation of a surface, which keeps it.
template <class T>
IT::Vectors<T>& vectors_on(Surface& s, const T& t) {
  return s.cached<IT::Vectors<T>>("vectors",
                                  [&] { return std::make_unique<IT::Vectors<T>>(t, s.points); });
}

/// returns vectors that the user gives at points.
/// \throws Invalid_input if there is not one vector per point
inline IT::Given_vectors given_vectors(std::vector<Place> places, const Doubles& array) {
  const Row_matrix rows = matrix_of(array);
  if (rows.rows() != static_cast<Eigen::Index>(places.size()))
    refuse("there must be a vector per point, " + std::to_string(places.size()) + ", not " +
           std::to_string(rows.rows()));
  if (rows.cols() != 2 && rows.cols() != 3)
    refuse("vectors have two coordinates in the tangent plane or three in space, not " +
           std::to_string(rows.cols()));
  IT::Given_vectors given{std::move(places)};
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    if (rows.cols() == 2)
      given.in_planes.emplace_back(rows(i, 0), rows(i, 1));
    else
      given.in_space.push_back({rows(i, 0), rows(i, 1), rows(i, 2)});
  return given;
}

/// adds the functions on direction fields and signed distances.
void bind_directions(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_FIELDS_H

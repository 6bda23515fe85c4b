// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_FIELDS_H
#define INTRINSIC_PYTHON_FIELDS_H

#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>

#include <array>
#include <bit>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// What functions on vectors have in common.

namespace python {

using Complex = std::complex<double>; ///< a tangent vector

/// A coordinate of a vector that is not known.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Vectors at the vertices of a triangulation.
struct Field {
  IT::Tangent_field vectors;         ///< on a cover, of each copy of a vertex
  std::vector<std::uint32_t> of_row; ///< which of them stands for each row

  /// returns two coordinates for each row.
  std::vector<std::array<double, 2>> coordinates() const {
    std::vector<std::array<double, 2>> result(of_row.size(), {unknown, unknown});
    for (std::size_t r = 0; r < of_row.size(); ++r)
      if (of_row[r] != IT::Gluing::none)
        result[r] = {vectors[of_row[r]].real(), vectors[of_row[r]].imag()};
    return result;
  }
};

/// Asks whether to go on, whatever was done.
struct Watching {
  Watch* watch;      ///< what is asked
  const char* stage; ///< what is being done
  /// is called after each step.
  template <class... Step>
  bool progress(const Step&...) {
    return (*watch)(stage, 0);
  }
};

/// tells whether the surface is that of a cloud of points, each of which has one tangent plane.
template <class T>
bool is_cloud(const T& t) {
  return t.input().names().sheets > 2;
}

/// How a method diffuses.
struct Diffusion {
  double time_factor;    ///< of the time, in squares of the mean edge
  std::size_t neighbors; ///< of each point of a cloud that are triangulated

  /// returns a key for the cache.
  std::string key(const char* method) const {
    return std::string(method) + ' ' + std::to_string(std::bit_cast<std::uint64_t>(time_factor)) +
           ' ' + std::to_string(neighbors);
  }
};

/// returns the method on the triangulation of a surface, which keeps its factorizations.
template <class T>
const IT::Vector_heat_method<T>& vector_heat(Surface& s, const T& t, const Diffusion& d,
                                             Watch& watch) {
  using Method = IT::Vector_heat_method<T>;
  const Method& method = s.cached<Method>(d.key("vector heat"), [&] {
    return new Method(t, IT::parameters::time_factor(d.time_factor));
  });
  Watching visitor{&watch, "factorization"};
  (void)method.factor(IT::parameters::visitor(std::ref(visitor)));
  watch.begin("solution");
  return method;
}

/// returns the method on the points of a surface, inserted ones, too; it keeps its factorizations.
template <class T>
const IT::Point_cloud_vectors& cloud_vectors(Surface& s, const T& t, const Diffusion& d) {
  using Method = IT::Point_cloud_vectors;
  return s.cached<Method>(d.key("cloud vectors"), [&] {
    return new Method(IT::points_of_rows(t, s.points), d.neighbors, d.time_factor);
  });
}

/// returns the number of a point of a cloud. \throws Invalid_input if it is in a face
inline std::size_t point_of_cloud(const Place& p) {
  if (!p.is_vertex()) refuse("a cloud of points has no faces; give the number of a point");
  return p.vertex;
}

/// returns the field of the vectors of a cloud.
template <class T>
Field cloud_field(const T& t, IT::Tangent_field vectors) {
  Field field{std::move(vectors), {}};
  field.vectors.resize(t.number_of_vertices(), Complex(unknown, unknown));
  for (std::uint32_t r = 0; r < field.vectors.size(); ++r) field.of_row.push_back(r);
  return field;
}

/// adds the functions on direction fields and signed distances.
void bind_directions(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_FIELDS_H

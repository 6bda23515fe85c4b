// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fields.h"
#include "Faces_in_order.h"

#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Logarithmic maps, transport of vectors, fields in space, and the frames of coordinates.

namespace python {

namespace {

// ---- Logarithmic maps --------------------------------------------------------------------------

// \param method "exact", "affine" or "polar", or none
py::array_t<double> log_map(Surface& s, const Place_numbers& place,
                            const std::optional<std::string>& method, double time_factor,
                            double maximum_distance, std::size_t neighbors, Watch& watch) {
  const Place p = place_of(s, place);
  IT::Vector_options options = vector_options(time_factor, neighbors, watch);
  options.maximum_distance = maximum_distance;
  return array_of(with_triangulation(s, watch, [&](auto& t) {
    auto& find = vectors_on(s, t);
    const IT::Logarithm_method by = !method              ? find.usual_method()
                                    : *method == "exact" ? IT::Logarithm_method::exact
                                    : *method == "polar" ? IT::Logarithm_method::polar
                                                         : IT::Logarithm_method::affine;
    return coordinates_of(find.logarithms(p, by, options));
  }));
}

// ---- Transport ---------------------------------------------------------------------------------

Field transport(Surface& s, const Place_arrays& places, const Doubles& vectors, double time_factor,
                std::size_t neighbors, Watch& watch) {
  const IT::Given_vectors given = given_vectors(places_of(s, places), vectors);
  const IT::Vector_options options = vector_options(time_factor, neighbors, watch);
  return with_triangulation(s, watch,
                            [&](auto& t) { return vectors_on(s, t).transport(given, options); });
}

py::array_t<double> extend(Surface& s, const Place_arrays& places, const Doubles& values,
                           double time_factor, std::size_t neighbors, Watch& watch) {
  const std::vector<Place> at = places_of(s, places);
  expect_size(values, at.size(), "values");
  const std::vector<double> given(values.data(), values.data() + values.size());
  const IT::Vector_options options = vector_options(time_factor, neighbors, watch);
  return array_of(with_triangulation(
      s, watch, [&](auto& t) { return vectors_on(s, t).extend(at, given, options); }));
}

// ---- Fields in space ---------------------------------------------------------------------------

// Vectors in space, by rows; not numbers where they are unknown.
template <class T>
std::vector<Point> in_space(Surface& s, const T& t, const IT::Tangent_field& vectors,
                            const std::vector<std::uint32_t>& of_row, std::size_t neighbors) {
  if (s.points.empty()) refuse("this surface has lengths alone, so that it is not in space");
  std::vector<Point> result;
  if (vectors_on(s, t).is_cloud()) {
    result.assign(of_row.size(), {unknown, unknown, unknown});
    const IT::Point_cloud_vectors& cloud = vectors_on(s, t).cloud(neighbors);
    for (std::size_t i = 0; i < cloud.size(); ++i) result[i] = cloud.in_space(i, vectors[i]);
    return result;
  }
  const auto& sectors =
      s.cached<IT::Vertex_sectors>("sectors", [&] { return new IT::Vertex_sectors(t, s.points); });
  std::vector<Point> found = sectors.in_space(vectors);
  const auto is_known = [&](std::uint32_t i) { return !std::isnan(vectors[i].real()); };
  bool are_rows = of_row.size() == found.size(); // as on surfaces without copies: no copy is made
  for (std::uint32_t r = 0; r < of_row.size() && are_rows; ++r) {
    are_rows = of_row[r] == r;
    if (are_rows && !is_known(r)) found[r] = {unknown, unknown, unknown};
  }
  if (are_rows) return found;
  result.reserve(of_row.size());
  for (const std::uint32_t i : of_row)
    result.push_back(i != IT::Gluing::none && is_known(i) ? found[i]
                                                          : Point{unknown, unknown, unknown});
  return result;
}

// Turned by an angle from the real axes.
py::array_t<double> vectors_in_space(Surface& s, const Field& field, double angle,
                                     std::size_t neighbors) {
  return array_of(with_triangulation(s, [&](auto& t) {
    if (angle == 0) return in_space(s, t, field.vectors, field.of_row, neighbors);
    IT::Tangent_field turned = field.vectors;
    for (Complex& z : turned) z *= std::polar(1., angle);
    return in_space(s, t, turned, field.of_row, neighbors);
  }));
}

// ---- Frames ------------------------------------------------------------------------------------

// A field with the vector `at(r)` for each row `r`, which is unknown where it is not a number.
template <class T, class Vector>
Field field_of_rows(const T& t, const Vector& at) {
  Field field;
  const IT::Vertex_copies copies(t);
  field.of_row = copies.first_of_rows();
  if (t.input().names().is_cloud()) // a cloud of points has a vector for each of them
    std::iota(field.of_row.begin(), field.of_row.end(), 0U);
  field.vectors.assign(std::max(field.of_row.size(), copies.size()), 0);
  for (std::size_t r = 0; r < field.of_row.size(); ++r) {
    if (field.of_row[r] == IT::Gluing::none) continue;
    const Complex z = at(r);
    if (std::isnan(std::abs(z)))
      field.of_row[r] = IT::Gluing::none;
    else
      field.vectors[field.of_row[r]] = z;
  }
  return field;
}

// Vectors that the user gives by coordinates, at all vertices.
Field field_of_coordinates(Surface& s, const Doubles& coordinates) {
  const auto given = matrix_of(coordinates);
  return with_triangulation(s, [&](auto& t) {
    return field_of_rows(t, [&](std::size_t r) {
      const auto i = static_cast<Eigen::Index>(r);
      return Complex(given(i, 0), given(i, 1));
    });
  });
}

// The unit vectors along an axis of the polar coordinates of each row.
py::array_t<double> axes_in_space(Surface& s, double angle, std::size_t neighbors) {
  return array_of(with_triangulation(s, [&](auto& t) {
    const Field field = field_of_rows(t, [&](std::size_t) { return std::polar(1., angle); });
    return in_space(s, t, field.vectors, field.of_row, neighbors);
  }));
}

// The unit vectors along the real axes of the coordinates of a field.
py::array_t<double> field_axes_in_space(Surface& s, const Field& field, std::size_t neighbors) {
  return array_of(with_triangulation(s, [&](auto& t) {
    const IT::Tangent_field ones(field.vectors.size(), 1);
    return in_space(s, t, ones, field.of_row, neighbors);
  }));
}

// The polar angle of each side of the triangles, at the vertex where it starts.
py::array_t<double> side_angles(Surface& s) {
  return array_of(with_triangulation(s, [](auto& t) {
    const std::vector<double> angles = IT::polar_angles(t);
    const Faces_in_order order(t);
    std::vector<Point> rows;
    for (const auto f : order.order()) {
      const auto sides = t.mesh().sides(f);
      const auto angle = [&](std::size_t k) { return angles[t.numbers().halfedge(sides[k])]; };
      rows.push_back({angle(0), angle(1), angle(2)});
    }
    return rows;
  }));
}

} // namespace

void bind_fields(py::module_& m) {
  py::class_<Field>(m, "Field").def_property_readonly("coordinates", [](const Field& f) {
    return array_of(coordinates_of(f));
  });
  m.def("parts_of_field", [](const Field& f) { return std::make_pair(f.vectors, f.of_row); });
  m.def("field_of_parts", [](IT::Tangent_field vectors, std::vector<std::uint32_t> of_row) {
    for (const std::uint32_t i : of_row)
      if (i >= vectors.size() && i != IT::Gluing::none)
        refuse("this is no field of vectors; pickle it again");
    return Field{std::move(vectors), std::move(of_row)};
  });
  m.def("log_map", &log_map);
  m.def("transport", &transport);
  m.def("extend", &extend);
  m.def("vectors_in_space", &vectors_in_space);
  m.def("field_of_coordinates", &field_of_coordinates);
  m.def("axes_in_space", &axes_in_space);
  m.def("field_axes_in_space", &field_axes_in_space);
  m.def("side_angles", &side_angles);
  bind_directions(m);
}

} // namespace python

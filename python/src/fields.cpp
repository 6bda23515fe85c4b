// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "fields.h"
#include "Faces_in_order.h"
#include "asked_vectors.h"

#include <CGAL/Intrinsic_operators/compiled.h>
#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/copies_of_rows.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/logarithms_from_place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_sectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Logarithmic maps, transport of vectors, fields in space, and the frames of coordinates.

namespace python {

namespace {

// ---- Logarithmic maps --------------------------------------------------------------------------

IT::Logarithm_method logarithm_method(const std::string& method) {
  if (method.empty() || method == "exact") return IT::Logarithm_method::exact;
  if (method == "affine") return IT::Logarithm_method::affine;
  if (method == "polar") return IT::Logarithm_method::polar;
  refuse("method=\"" + method + "\" does not exist; give \"exact\", \"affine\" or \"polar\"");
}

// How to find a logarithmic map.
struct Asked_logarithm {
  IT::Logarithm_method method;
  Diffusion diffusion;
  double maximum_distance;
};

// From a vertex or a point of the triangulation.
template <class T, class From>
std::vector<Complex> logarithms_from(Surface& s, const T& t, const From& from,
                                     const Asked_logarithm& asked, Watch& watch) {
  if (asked.method != IT::Logarithm_method::exact)
    return vector_heat(s, t, asked.diffusion, watch).logarithmic_map(from, asked.method);
  Watching visitor{&watch, "windows"};
  return IT::logarithmic_map(
      t, from, IT::parameters::maximum_distance(asked.maximum_distance).visitor(std::ref(visitor)));
}

template <class T>
std::vector<Complex> logarithms(Surface& s, const T& t, const Place& p,
                                const Asked_logarithm& asked, Watch& watch) {
  return IT::logarithms_from_place(t, p, asked.method, [&](const auto& from) {
    return logarithms_from(s, t, from, asked, watch);
  });
}

py::array_t<double> log_map(Surface& s, const Place_arrays& place, const std::string& method,
                            double time_factor, double maximum_distance, std::size_t neighbors,
                            const py::object& progress) {
  const Place p = places_of(s, place).at(0);
  const Diffusion diffusion{time_factor, neighbors};
  Watch watch(progress);
  return array_of(with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      if (!method.empty() && method != "affine")
        refuse("logarithmic maps of points are found by affine heat; leave out method=\"" + method +
               "\"");
      return cloud_field(t, cloud_vectors(s, t, diffusion).logarithmic_map(point_of_cloud(p)))
          .coordinates();
    }
    const Asked_logarithm asked{logarithm_method(method), diffusion, maximum_distance};
    Field field{logarithms(s, t, p, asked, watch), {}};
    field.of_row = IT::nearest_copies_of_rows(t, field.vectors);
    return field.coordinates();
  }));
}

// ---- Transport ---------------------------------------------------------------------------------

Field transport(Surface& s, const Place_arrays& places, const Doubles& vectors, double time_factor,
                std::size_t neighbors, const py::object& progress) {
  const Asked_vectors asked(places_of(s, places), vectors);
  const Diffusion diffusion{time_factor, neighbors};
  Watch watch(progress);
  return with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      const IT::Point_cloud_vectors& cloud = cloud_vectors(s, t, diffusion);
      return cloud_field(t, cloud.transport(vectors_of_cloud(cloud, asked)));
    }
    Vector_finder find(t, s.points);
    const auto& heat = vector_heat(s, t, diffusion, watch);
    Field field{find.sheets().averaged(asked.are_at_vertices()
                                           ? heat.transport(find.at_vertices(asked))
                                           : heat.transport(find.tangents(asked))),
                {}};
    field.of_row = IT::known_copies_of_rows(t, field.vectors);
    return field;
  });
}

py::array_t<double> extend(Surface& s, const Place_arrays& places, const Doubles& values,
                           double time_factor, std::size_t neighbors, const py::object& progress) {
  const std::vector<Place> at = places_of(s, places);
  expect_size(values, at.size(), "values");
  const auto given = vector_of(values);
  const Diffusion diffusion{time_factor, neighbors};
  Watch watch(progress);
  return array_of(with_triangulation(s, watch, [&](auto& t) {
    using T = std::remove_cvref_t<decltype(t)>;
    std::vector<double> result(t.number_of_vertices(), unknown);
    if (is_cloud(t)) {
      std::vector<std::pair<std::size_t, double>> sources;
      for (std::size_t i = 0; i < at.size(); ++i)
        sources.push_back({point_of_cloud(at[i]), given[static_cast<Eigen::Index>(i)]});
      std::ranges::copy(cloud_vectors(s, t, diffusion).extend_scalars(sources), result.begin());
      return result;
    }
    Place_finder<T> find(t);
    std::vector<std::pair<IT::Surface_point, double>> sources;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (const IT::Surface_point& p : find.points(at[i]))
        sources.push_back({p, given[static_cast<Eigen::Index>(i)]});
    const Eigen::VectorXd extended = vector_heat(s, t, diffusion, watch).extend_scalars(sources);
    const std::vector<std::uint32_t> first = IT::first_copies_of_rows(t); // all have one value
    for (std::size_t r = 0; r < first.size(); ++r)
      if (first[r] != IT::Gluing::none) result[r] = extended[first[r]];
    return result;
  }));
}

// ---- Fields in space ---------------------------------------------------------------------------

// Vectors in space, by rows; not numbers where they are unknown.
template <class T>
std::vector<Point> in_space(Surface& s, const T& t, const IT::Tangent_field& vectors,
                            const std::vector<std::uint32_t>& of_row, std::size_t neighbors) {
  std::vector<Point> result(of_row.size(), {unknown, unknown, unknown});
  if (s.points.empty()) refuse("this surface has lengths alone, so that it is not in space");
  if (is_cloud(t)) {
    const IT::Point_cloud_vectors& cloud = cloud_vectors(s, t, {1, neighbors});
    for (std::size_t i = 0; i < cloud.size(); ++i) result[i] = cloud.in_space(i, vectors[i]);
    return result;
  }
  const auto& sectors =
      s.cached<IT::Vertex_sectors>("sectors", [&] { return new IT::Vertex_sectors(t, s.points); });
  const std::vector<Point> found = sectors.in_space(vectors);
  for (std::size_t r = 0; r < of_row.size(); ++r)
    if (of_row[r] != IT::Gluing::none && !std::isnan(vectors[of_row[r]].real()))
      result[r] = found[of_row[r]];
  return result;
}

// Turned by an angle from the real axes.
py::array_t<double> vectors_in_space(Surface& s, const Field& field, double angle,
                                     std::size_t neighbors) {
  return array_of(with_triangulation(s, [&](auto& t) {
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
  if (is_cloud(t))
    field = cloud_field(t, {});
  else
    field.of_row = IT::first_copies_of_rows(t);
  field.vectors.assign(std::max<std::size_t>(field.vectors.size(), IT::Vertex_copies(t).size()), 0);
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
    return array_of(f.coordinates());
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

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "asked_vectors.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/connection_laplacian.h>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/copies_of_rows.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/vector_field.h>

#include <pybind11/stl.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Vectors on surfaces: logarithmic maps, transport, direction fields, signed distances.

namespace python {

namespace {

using Complex = std::complex<double>;
using Row = std::array<double, 2>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// Vectors by the numbers of a `Tangent_field`, and which of them stands for each row.
struct Field {
  IT::Tangent_field vectors;
  std::vector<std::uint32_t> of_row;

  std::vector<Row> coordinates() const {
    std::vector<Row> result(of_row.size(), {unknown, unknown});
    for (std::size_t r = 0; r < of_row.size(); ++r)
      if (of_row[r] != IT::Gluing::none)
        result[r] = {vectors[of_row[r]].real(), vectors[of_row[r]].imag()};
    return result;
  }
};

// Asks whether to go on, whatever was done.
struct Watching {
  Watch* watch;
  const char* stage;
  template <class... Step>
  bool progress(const Step&...) {
    return (*watch)(stage);
  }
};

// Whether the surface is that of a cloud of points, each of which has one tangent plane.
template <class T>
bool is_cloud(const T& t) {
  return t.input().names().sheets > 2;
}

// The time of a diffusion, and, for a cloud, how many neighbours of each point are triangulated.
struct Diffusion {
  double time_factor;
  std::size_t neighbors;

  std::string key(const char* method) const {
    return std::string(method) + ' ' + std::to_string(std::bit_cast<std::uint64_t>(time_factor)) +
           ' ' + std::to_string(neighbors);
  }
};

template <class T>
const IT::Vector_heat_method<T>& vector_heat(Surface& s, const T& t, const Diffusion& d,
                                             Watch& watch) {
  using Method = IT::Vector_heat_method<T>;
  const Method& method = s.cached<Method>(d.key("vector heat"), [&] {
    return new Method(t, IT::parameters::time_factor(d.time_factor));
  });
  Watching visitor{&watch, "factorization"};
  (void)method.factor(IT::parameters::visitor(std::ref(visitor)));
  return method;
}

const IT::Point_cloud_vectors& cloud_vectors(Surface& s, const Diffusion& d) {
  using Method = IT::Point_cloud_vectors;
  return s.cached<Method>(d.key("cloud vectors"),
                          [&] { return new Method(s.points, d.neighbors, d.time_factor); });
}

std::size_t point_of_cloud(const Place& p) {
  if (!p.is_vertex()) refuse("a cloud of points has no faces; give the number of a point");
  return p.vertex;
}

// A vector of a cloud for each row; none at points that were inserted.
template <class T>
Field cloud_field(const T& t, IT::Tangent_field vectors) {
  Field field{std::move(vectors), {}};
  field.vectors.resize(t.number_of_vertices(), Complex(unknown, unknown));
  for (std::uint32_t r = 0; r < field.vectors.size(); ++r) field.of_row.push_back(r);
  return field;
}

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

// From a vertex, in its polar coordinates, or from a point, in the frame of the user's face.
template <class T>
std::vector<Complex> logarithms(Surface& s, const T& t, const Place& p,
                                const Asked_logarithm& asked, Watch& watch) {
  if (p.is_vertex())
    return logarithms_from(s, t, Place_finder<T>(t).vertex(p.vertex), asked, watch);
  const IT::Surface_point on_input = point_on_input(t.input(), p);
  const IT::Tangent_vector axis = *IT::tangent_to_intrinsic(t, {on_input, {1, 0}});
  std::vector<Complex> result = logarithms_from(s, t, axis.point, asked, watch);
  const Complex turn = std::polar(1., -std::atan2(axis.vector[1], axis.vector[0]));
  for (Complex& z : result) z *= turn;
  return result;
}

py::array_t<double> log_map(Surface& s, const Place_arrays& place, const std::string& method,
                            double time_factor, double maximum_distance, std::size_t neighbors,
                            const py::object& progress) {
  const Place p = places_of(place).at(0);
  const Diffusion diffusion{time_factor, neighbors};
  Watch watch(progress);
  return array_of(with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      if (!method.empty() && method != "affine")
        refuse("logarithmic maps of points are found by affine heat; leave out method=\"" + method +
               "\"");
      return cloud_field(t, cloud_vectors(s, diffusion).logarithmic_map(point_of_cloud(p)))
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
  const Asked_vectors asked(places_of(places), vectors);
  const Diffusion diffusion{time_factor, neighbors};
  Watch watch(progress);
  return with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      const IT::Point_cloud_vectors& cloud = cloud_vectors(s, diffusion);
      return cloud_field(t, cloud.transport(vectors_of_cloud(cloud, asked)));
    }
    Vector_finder find(t, s.points);
    const auto& heat = vector_heat(s, t, diffusion, watch);
    return Field{asked.are_at_vertices() ? heat.transport(find.at_vertices(asked))
                                         : heat.transport(find.tangents(asked)),
                 IT::first_copies_of_rows(t)};
  });
}

py::array_t<double> extend(Surface& s, const Place_arrays& places, const Doubles& values,
                           double time_factor, std::size_t neighbors, const py::object& progress) {
  const std::vector<Place> at = places_of(places);
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
      std::ranges::copy(cloud_vectors(s, diffusion).extend_scalars(sources), result.begin());
      return result;
    }
    Place_finder<T> find(t);
    std::vector<std::pair<IT::Surface_point, double>> sources;
    for (std::size_t i = 0; i < at.size(); ++i) {
      std::vector<IT::Surface_point> points;
      find.append(at[i], points);
      for (const IT::Surface_point& p : points)
        sources.push_back({p, given[static_cast<Eigen::Index>(i)]});
    }
    const Eigen::VectorXd extended = vector_heat(s, t, diffusion, watch).extend_scalars(sources);
    const std::vector<std::uint32_t> first = IT::first_copies_of_rows(t);
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
  std::vector<Point> result(of_row.size(), {unknown, unknown, unknown}), found;
  if (s.points.empty()) refuse("this surface has lengths alone, so that it is not in space");
  if (is_cloud(t)) {
    const IT::Point_cloud_vectors& cloud = cloud_vectors(s, {1, neighbors});
    for (std::size_t i = 0; i < cloud.size(); ++i) result[i] = cloud.in_space(i, vectors[i]);
    return result;
  }
  found = IT::vectors_in_space(t, vectors, s.points);
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

// The unit vectors along an axis of the polar coordinates of each row.
py::array_t<double> axes_in_space(Surface& s, double angle, std::size_t neighbors) {
  return array_of(with_triangulation(s, [&](auto& t) {
    Field field;
    if (is_cloud(t))
      field = cloud_field(t, {});
    else
      field.of_row = IT::first_copies_of_rows(t);
    const std::size_t copies =
        std::max<std::size_t>(field.vectors.size(), IT::internal::Vertex_copies(t).size());
    field.vectors.assign(copies, std::polar(1., angle));
    return in_space(s, t, field.vectors, field.of_row, neighbors);
  }));
}

py::tuple connection_laplacian(Surface& s, int degree) {
  return array_of(
      with_triangulation(s, [&](auto& t) { return IT::connection_laplacian(t, degree); }));
}

// ---- Direction fields --------------------------------------------------------------------------

// A field of directions, and where it is singular.
struct Directions {
  Field field{};
  std::vector<int> index{};          // of each face of the triangulation
  std::vector<std::int64_t> faces{}; // the user's, at centres of singular faces
  std::vector<Point> weights{};
  std::vector<Point> points{};
  std::vector<int> singular{}; // their indices
  std::ptrdiff_t sum = 0;
  int border_turns = 0;
};

template <class T>
IT::Direction_field
smooth_field(const T& t, const Surface& s, int degree, const std::optional<double>& strength,
             const std::vector<std::pair<typename T::vertex_descriptor, Complex>>& fixed,
             Watch& watch) {
  Watching visitor{&watch, "factorization and solutions"};
  const auto np = IT::parameters::visitor(std::ref(visitor));
  if (!strength) return IT::smoothest_direction_field(t, degree, fixed, np);
  if (degree % 2 != 0)
    refuse("directions of curvature have no sign; with align, give an even degree: 2 for lines, 4 "
           "for crosses");
  if (s.points.empty())
    refuse("a surface with lengths alone has no directions of curvature; leave align out");
  return IT::aligned_direction_field(t, degree, IT::principal_directions(t, s.points), *strength,
                                     fixed, np);
}

// Finds the centres of the faces with an index other than 0.
template <class T>
void add_singularities(const T& t, const std::vector<Point>& points, Directions& d) {
  for (const auto f : faces(t.mesh())) {
    const int i = d.index[t.index(f)];
    if (i == 0) continue;
    const auto p = IT::locate_on_input(
        t, {t.numbers().halfedge(halfedge(f, t.mesh())), {1. / 3, 1. / 3, 1. / 3}});
    if (!p) continue;
    const std::uint32_t face = t.input().face(p->halfedge);
    d.faces.push_back(t.input().names().polygon(face));
    d.weights.push_back(IT::seen_from(t.input(), *p, t.input().halfedge_of_face(face)).weights);
    d.singular.push_back(i);
    if (!points.empty()) d.points.push_back(IT::point_in_space(t, *p, points));
  }
}

Directions cloud_directions(Surface& s, int degree, const std::optional<double>& strength,
                            const Asked_vectors& asked, std::size_t neighbors) {
  if (strength)
    refuse("align needs curvature, which a cloud of points does not have; leave it out");
  const IT::Point_cloud_vectors& cloud = cloud_vectors(s, {1, neighbors});
  Directions result;
  result.field.vectors =
      cloud.smoothest_direction_field(degree, vectors_of_cloud(cloud, asked)).directions();
  return result;
}

Directions directions(Surface& s, int degree, const std::optional<double>& strength,
                      const Asked_vectors& asked, std::size_t neighbors, Watch& watch) {
  return with_triangulation(s, watch, [&](auto& t) {
    if (is_cloud(t)) {
      Directions result = cloud_directions(s, degree, strength, asked, neighbors);
      result.field = cloud_field(t, std::move(result.field.vectors));
      return result;
    }
    if (!asked.are_at_vertices()) refuse("directions can be fixed at vertices only");
    const IT::Direction_field f =
        smooth_field(t, s, degree, strength, Vector_finder(t, s.points).at_vertices(asked), watch);
    const auto singular = IT::singularities(t, f);
    Directions result{{f.directions(), IT::first_copies_of_rows(t)}, singular.index};
    result.sum = singular.sum();
    for (const auto& [h, turns] : singular.turns) result.border_turns += turns;
    add_singularities(t, s.points, result);
    return result;
  });
}

py::tuple direction_field(Surface& s, int degree, const std::optional<double>& strength,
                          const Place_arrays& places, const Doubles& vectors, std::size_t neighbors,
                          const py::object& progress) {
  Watch watch(progress);
  Directions d =
      directions(s, degree, strength, Asked_vectors(places_of(places), vectors), neighbors, watch);
  return py::make_tuple(std::move(d.field), array_of(std::move(d.index)),
                        array_of(std::move(d.faces)), array_of(std::move(d.weights)),
                        array_of(std::move(d.points)), array_of(std::move(d.singular)), d.sum,
                        d.border_turns);
}

// ---- Signed distances --------------------------------------------------------------------------

// The shortest ways along edges from each vertex of a curve to the next one.
template <class T>
std::vector<typename T::halfedge_descriptor> along_edges(const T& t,
                                                         const std::vector<std::uint32_t>& rows) {
  Place_finder<T> vertices(t);
  IT::Edge_path_finder<T> find(t);
  std::vector<typename T::halfedge_descriptor> curve;
  for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
    const auto way = find(vertices.vertex(rows[i]), vertices.vertex(rows[i + 1]));
    if (way.empty())
      refuse("no edges lead from vertex " + std::to_string(rows[i]) + " to vertex " +
             std::to_string(rows[i + 1]) + "; choose different vertices of one component");
    curve.insert(curve.end(), way.begin(), way.end());
  }
  return curve;
}

py::array_t<double> signed_distance(Surface& s, const std::vector<Integers>& curves,
                                    double time_factor) {
  std::vector<std::vector<std::uint32_t>> rows;
  for (const Integers& c : curves)
    rows.push_back(numbers_of(c, std::numeric_limits<std::uint32_t>::max(), "vertex"));
  return array_of(with_triangulation(s, [&](auto& t) {
    using Method = IT::Signed_heat_distance<std::remove_cvref_t<decltype(t)>>;
    std::vector<std::vector<typename std::remove_cvref_t<decltype(t)>::halfedge_descriptor>> along;
    for (const auto& curve : rows) along.push_back(along_edges(t, curve));
    return s
        .cached<Method>(Diffusion{time_factor, 0}.key("signed heat"),
                        [&] { return new Method(t, IT::parameters::time_factor(time_factor)); })
        .distances(along);
  }));
}

} // namespace

void bind_fields(py::module_& m) {
  py::class_<Field>(m, "Field").def_property_readonly("coordinates", [](const Field& f) {
    return array_of(f.coordinates());
  });
  m.def("log_map", &log_map);
  m.def("transport", &transport);
  m.def("extend", &extend);
  m.def("vectors_in_space", &vectors_in_space);
  m.def("axes_in_space", &axes_in_space);
  m.def("connection_laplacian", &connection_laplacian);
  m.def("direction_field", &direction_field);
  m.def("signed_distance", &signed_distance);
}

} // namespace python

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/text_lines.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_operators/vectors/copies_of_rows.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/logarithms_from_place.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

/// A vertex of the mesh file, and a vector in its polar coordinates.
struct Asked_vector {
  std::uint32_t row;
  std::complex<double> z;
};

// On each line the number of a vertex, an angle in degrees and, unless it is 1, a length.
std::vector<Asked_vector> read_vectors(const Options& options, std::size_t vertices) {
  const Number_table table =
      read_numbers(options.application.vectors, vertices, "vertices of " + options.input);
  if (table.columns != 2 && table.columns != 3)
    table.refuse(0, "give the number of a vertex, an angle in degrees, and a length or none");
  const std::vector<std::uint32_t> rows = vertex_numbers(table, vertices);
  std::vector<Asked_vector> vectors;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const double* const words = &table.values[table.columns * i];
    const double length = table.columns == 3 ? words[2] : 1;
    vectors.push_back({rows[i], std::polar(1., words[1] * std::numbers::pi / 180) * length});
  }
  return vectors;
}

// a value per row, that of one copy of a vertex; no number where there is none
template <class Values, class Part>
Eigen::VectorXd by_rows(const std::vector<std::uint32_t>& first, const Values& values,
                        const Part& part) {
  Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(first.size()),
                                                     std::numeric_limits<double>::quiet_NaN());
  for (std::size_t r = 0; r < first.size(); ++r)
    if (first[r] != IT::Gluing::none) result[static_cast<Eigen::Index>(r)] = part(values[first[r]]);
  return result;
}

// Whether the surface is that of a cloud of points, whose rows have tangent planes that copies do
// not have.
template <class Triangulation>
bool is_cloud(const Triangulation& t) {
  return t.input().names().sheets > 2;
}

template <class Triangulation>
std::vector<std::uint32_t> all_rows(const Triangulation& t) {
  std::vector<std::uint32_t> rows(t.number_of_vertices());
  std::iota(rows.begin(), rows.end(), 0U);
  return rows;
}

// Inserted vertices are points of the cloud, too.
template <class Triangulation>
IT::Point_cloud_vectors cloud_vectors(const Triangulation& t, const Options& options,
                                      const Points& points) {
  return IT::Point_cloud_vectors(IT::points_of_rows(t, points), options.neighbors.value_or(30),
                                 options.application.time_factor);
}

// The greatest value, and the number of vertices where none is known.
std::pair<double, std::size_t> greatest_known(const Eigen::VectorXd& values) {
  std::pair<double, std::size_t> result{0, 0};
  for (const double x : values) {
    if (std::isfinite(x)) result.first = std::max(result.first, x);
    if (!std::isfinite(x)) ++result.second;
  }
  return result;
}

// Vectors at the points of a cloud, in their planes.
template <class Triangulation>
Direction_field directions_of_points(const Triangulation& t, const std::string& name,
                                     const IT::Point_cloud_vectors& cloud,
                                     IT::Tangent_field vectors, unsigned degree) {
  Direction_field field{name, std::move(vectors), degree, all_rows(t)};
  for (std::size_t i = 0; i < cloud.size(); ++i) field.axes.push_back(cloud.axes(i));
  return field;
}

// Vectors by the numbers of their points.
std::vector<std::pair<std::size_t, std::complex<double>>>
vectors_at_points(const std::vector<Asked_vector>& asked) {
  std::vector<std::pair<std::size_t, std::complex<double>>> result;
  for (const Asked_vector& v : asked) result.push_back({v.row, v.z});
  return result;
}

template <class Triangulation>
Direction_field transported(const Triangulation& t, const std::vector<Asked_vector>& asked,
                            const Options& options, const Points& points) {
  if (is_cloud(t)) {
    const IT::Point_cloud_vectors cloud = cloud_vectors(t, options, points);
    return directions_of_points(t, "vector", cloud, cloud.transport(vectors_at_points(asked)), 1);
  }
  std::vector<std::pair<typename Triangulation::vertex_descriptor, std::complex<double>>> sources;
  IT::Vectors_on_sheets sheets(t);
  for (const Asked_vector& v : asked)
    for (const auto& copy : sheets(IT::vertex_of_row(t, v.row), v.z)) sources.push_back(copy);
  const IT::Vector_heat_method<Triangulation> heat(
      t, IT::parameters::time_factor(options.application.time_factor));
  Direction_field field{"vector", sheets.averaged(heat.transport(sources)), 1, {}};
  field.of_row = IT::known_copies_of_rows(t, field.vectors);
  return field;
}

template <class Triangulation>
Computed transport(const Triangulation& t, const Options& options, const Points& points) {
  const std::vector<Asked_vector> sources = read_vectors(options, t.input().number_of_rows());
  Marks marks{"sources"};
  for (const Asked_vector& v : sources) marks.points.push_back({{points[v.row]}, false, 0});
  Computed computed{"transport", {}, {}};
  computed.directions = transported(t, sources, options, points);
  computed.functions.push_back(
      {"length", by_rows(computed.directions->of_row, computed.directions->vectors,
                         [](const std::complex<double>& z) { return std::abs(z); })});
  computed.shown = computed.functions.size(); // none: arrows
  computed.marks = std::move(marks);
  const auto [longest, unknown] = greatest_known(computed.functions[0].values);
  computed.json = {
      {"sources", sources.size()}, {"longest", longest}, {"unknown_vertices", unknown}};
  return computed;
}

using Complex = std::complex<double>;

// Where a map is torn, or stretched more than this many times.
constexpr double greatest_stretch = 3;

struct Torn_map {
  std::size_t edges = 0;
  double radius = std::numeric_limits<double>::infinity(); // of a disk without them
  std::vector<char> vertices;                              // per row: whether an edge ends there
};

// The cut locus crosses edges that are much longer in the map than on the surface.
template <class Triangulation>
Torn_map torn_map(const Triangulation& t, const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
  Torn_map torn;
  torn.vertices.assign(static_cast<std::size_t>(u.size()), 0);
  const double unit = std::ldexp(1., -t.metric().scale_exponent());
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const std::uint32_t i = t.input_vertex(source(h, t.mesh())),
                        j = t.input_vertex(target(h, t.mesh()));
    const double length = unit * std::sqrt(t.metric().approximate_squared_length(t.index(e)));
    if (!(std::hypot(u[i] - u[j], v[i] - v[j]) > greatest_stretch * length)) continue;
    ++torn.edges;
    torn.vertices[i] = torn.vertices[j] = 1;
    torn.radius = std::min({torn.radius, std::hypot(u[i], v[i]), std::hypot(u[j], v[j])});
  }
  return torn;
}

template <class Triangulation>
std::string logarithm_method(const Triangulation& t, const std::string& asked) {
  if (!is_cloud(t)) return asked.empty() ? "exact" : asked;
  if (!asked.empty() && asked != "affine")
    throw std::runtime_error("logarithmic maps of points are found by affine heat; leave out "
                             "--method " +
                             asked);
  return "affine";
}

// A vector for each row of a cloud.
template <class Triangulation>
std::vector<Complex> cloud_logarithms(const Triangulation& t, std::uint32_t row,
                                      const Options& options, const Points& points) {
  if (row >= t.input().number_of_rows())
    throw std::runtime_error("logarithmic maps of points start at one of them; give its number "
                             "with --source");
  return cloud_vectors(t, options, points).logarithmic_map(row);
}

template <class Triangulation>
std::vector<Complex> logarithms(const Triangulation& t, const IT::Place& source,
                                const Options& options, const std::string& method) {
  const IT::Logarithm_method by = method == "exact"   ? IT::Logarithm_method::exact
                                  : method == "polar" ? IT::Logarithm_method::polar
                                                      : IT::Logarithm_method::affine;
  std::optional<IT::Vector_heat_method<Triangulation>> heat;
  return IT::logarithms_from_place(t, source, by, [&](const auto& from) {
    if (by == IT::Logarithm_method::exact) return IT::logarithmic_map(t, from);
    if (!heat) heat.emplace(t, IT::parameters::time_factor(options.application.time_factor));
    return heat->logarithmic_map(from, by);
  });
}

template <class Triangulation>
Computed logarithmic_map(const Triangulation& t, const Sources& sources, const Options& options,
                         const Points& points) {
  if (sources.size() != 1 || sources[0].size() != 1)
    throw std::runtime_error("logarithmic maps have one source; give one point with --source");
  const std::string method = logarithm_method(t, options.application.logarithm);
  const std::vector<Complex> log = is_cloud(t)
                                       ? cloud_logarithms(t, sources[0][0].vertex, options, points)
                                       : logarithms(t, sources[0][0], options, method);
  const std::vector<std::uint32_t> nearest =
      is_cloud(t) ? all_rows(t) : IT::nearest_copies_of_rows(t, log);
  Computed computed{"logmap", {}, {}};
  computed.functions = {{"u", by_rows(nearest, log, [](const Complex& z) { return z.real(); })},
                        {"v", by_rows(nearest, log, [](const Complex& z) { return z.imag(); })}};
  computed.is_map = true;
  Torn_map torn = torn_map(t, computed.functions[0].values, computed.functions[1].values);
  computed.is_torn = std::move(torn.vertices);
  const auto [radius, unknown] =
      greatest_known(by_rows(nearest, log, [](const Complex& z) { return std::abs(z); }));
  computed.json = {{"method", method},
                   {"radius", radius},
                   {"injectivity_radius", finite_or_null(torn.radius)},
                   {"torn_edges", torn.edges},
                   {"unknown_vertices", unknown}};
  return computed;
}

// The field that is asked for: the smoothest one, or one that follows curvature.
template <class Triangulation>
IT::Direction_field field_of(
    const Triangulation& t, const Options& options, const Points& points,
    const std::vector<std::pair<typename Triangulation::vertex_descriptor, std::complex<double>>>&
        fixed) {
  const int degree = static_cast<int>(options.application.degree);
  if (!options.application.alignment) return IT::smoothest_direction_field(t, degree, fixed);
  return IT::aligned_direction_field(t, degree, IT::principal_directions(t, points),
                                     *options.application.alignment, fixed);
}

// The centres of the faces with an index other than 0, in space, with the index.
template <class Triangulation>
std::vector<IT::Polyline> centres(const Triangulation& t, const std::vector<int>& index,
                                  const Points& points) {
  std::vector<IT::Polyline> result;
  for (const auto f : faces(t.mesh())) {
    const int i = index[t.index(f)];
    const IT::Surface_point centre{t.numbers().halfedge(halfedge(f, t.mesh())),
                                   {1. / 3, 1. / 3, 1. / 3}};
    if (i == 0) continue;
    if (const auto p = IT::locate_on_input(t, centre))
      result.push_back({{IT::point_in_space(t, *p, points)}, false, i});
  }
  return result;
}

// On a cloud there are no faces in which a field could be singular.
template <class Triangulation>
Computed field_of_points(const Triangulation& t, const Options& options, const Points& points) {
  const Application_options& o = options.application;
  if (o.alignment)
    throw std::runtime_error(options.input +
                             ": --align needs curvature, which a cloud of points does not have; "
                             "leave it out");
  if (!o.singularities.empty())
    throw std::runtime_error(options.input +
                             ": singularities lie in faces, and a cloud of points has no faces; "
                             "leave --singularities out");
  std::vector<Asked_vector> fixed;
  if (!o.vectors.empty()) fixed = read_vectors(options, t.input().number_of_rows());
  const IT::Point_cloud_vectors cloud = cloud_vectors(t, options, points);
  const IT::Direction_field field =
      cloud.smoothest_direction_field(static_cast<int>(o.degree), vectors_at_points(fixed));
  Computed computed{"field", {}, {}};
  computed.directions = directions_of_points(t, "direction", cloud, field.directions(), o.degree);
  computed.json = {{"degree", field.degree},
                   {"fixed", fixed.size()},
                   {"alignment", nullptr},
                   {"seam_edges", cloud.seam_edges()}};
  return computed;
}

template <class Triangulation>
Computed direction_field(const Triangulation& t, const Options& options, const Points& points) {
  if (is_cloud(t)) return field_of_points(t, options, points);
  std::vector<std::pair<typename Triangulation::vertex_descriptor, std::complex<double>>> fixed;
  std::vector<Asked_vector> asked;
  if (!options.application.vectors.empty())
    asked = read_vectors(options, t.input().number_of_rows());
  IT::Vectors_on_sheets sheets(t);
  for (const Asked_vector& v : asked)
    for (const auto& copy : sheets(IT::vertex_of_row(t, v.row), v.z)) fixed.push_back(copy);
  const int degree = static_cast<int>(options.application.degree);
  const IT::Direction_field field = field_of(t, options, points, fixed);
  const auto singular = IT::singularities(t, field);
  int turns = 0;
  for (const auto& [h, n] : singular.turns) turns += n;
  Computed computed{"field", {}, {}};
  computed.directions = {"direction", sheets.averaged(field.directions(), degree, fixed),
                         options.application.degree, IT::first_copies_of_rows(t), singular.index};
  computed.marks = {"singularities", centres(t, singular.index, points)};
  computed.json = {
      {"degree", degree},
      {"fixed", asked.size()},
      {"alignment",
       options.application.alignment ? Json(*options.application.alignment) : Json(nullptr)},
      {"singular_faces",
       singular.index.size() -
           static_cast<std::size_t>(std::count(singular.index.begin(), singular.index.end(), 0))},
      {"index_sum", singular.sum()},
      {"border_turns", turns}};
  return computed;
}

} // namespace

void run_transport(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points& points, Progress&) {
    return transport(t, options, points);
  });
}
void run_logmap(const Options& options) {
  run_application(options, [&](const auto& t, const Sources& sources, const Points& points,
                               Progress&) { return logarithmic_map(t, sources, options, points); });
}
void run_field(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&, const Points& points, Progress&) {
    return direction_field(t, options, points);
  });
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/text_lines.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/formulas/is_torn.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// On each line the number of a vertex, an angle in degrees and, unless it is 1, a length.
IT::Given_vectors read_vectors(const Options& options, std::size_t vertices) {
  const Number_table table =
      read_numbers(options.application.vectors, vertices, "vertices of " + options.input);
  if (table.columns != 2 && table.columns != 3)
    table.refuse(0, "give the number of a vertex, an angle in degrees, and a length or none");
  IT::Given_vectors given;
  for (const std::uint32_t row : vertex_numbers(table, vertices)) {
    const double* const words = &table.values[table.columns * given.places.size()];
    const double length = table.columns == 3 ? words[2] : 1;
    given.places.push_back(IT::Place::at_vertex(row));
    given.in_planes.push_back(std::polar(1., words[1] * std::numbers::pi / 180) * length);
  }
  return given;
}

IT::Vector_options asked_options(const Options& options) {
  IT::Vector_options asked;
  asked.time_factor = options.application.time_factor;
  asked.neighbors = options.neighbors.value_or(asked.neighbors);
  asked.solver = IT::solver_named(options.application.solver);
  return asked;
}

// A value per row; no number where there is none.
template <class Part>
Eigen::VectorXd by_rows(const IT::Found_vectors& found, const Part& part) {
  Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(found.of_row.size()),
                                                     std::numeric_limits<double>::quiet_NaN());
  for (std::size_t r = 0; r < found.of_row.size(); ++r)
    if (const std::uint32_t i = found.of_row[r]; i != IT::Gluing::none)
      result[static_cast<Eigen::Index>(r)] = part(found.vectors[i]);
  return result;
}

double length_of(const std::complex<double>& z) { return std::abs(z); }

// The greatest value, and the number of vertices where none is known.
std::pair<double, std::size_t> greatest_known(const Eigen::VectorXd& values) {
  std::pair<double, std::size_t> result{0, 0};
  for (const double x : values) {
    if (std::isfinite(x)) result.first = std::max(result.first, x);
    if (!std::isfinite(x)) ++result.second;
  }
  return result;
}

// What files and pages show of vectors.
template <class Triangulation>
Direction_field shown(IT::Vectors<Triangulation>& find, const std::string& name,
                      const IT::Found_vectors& found, unsigned degree, const Options& options) {
  Direction_field field{name, found.vectors, degree, found.of_row};
  if (!find.is_cloud()) return field;
  const IT::Point_cloud_vectors& cloud = find.cloud(asked_options(options).neighbors);
  for (std::size_t i = 0; i < cloud.size(); ++i) field.axes.push_back(cloud.axes(i));
  return field;
}

template <class Triangulation>
Computed transport(const Triangulation& t, const Options& options, const Points& points) {
  const IT::Given_vectors sources = read_vectors(options, t.input().number_of_rows());
  IT::Vectors<Triangulation> find(t, points);
  const IT::Found_vectors found = find.transport(sources, asked_options(options));
  Computed computed{"transport", {}, {{"length", by_rows(found, length_of)}}};
  computed.directions = shown(find, "vector", found, 1, options);
  computed.shown = computed.functions.size(); // none: arrows
  computed.marks.name = "sources";
  for (const IT::Place& p : sources.places)
    computed.marks.points.push_back({{points[p.vertex]}, false, 0});
  const auto [longest, unknown] = greatest_known(computed.functions[0].values);
  computed.json = {
      {"sources", sources.places.size()}, {"longest", longest}, {"unknown_vertices", unknown}};
  return computed;
}

struct Torn_map {
  std::size_t edges = 0;
  double radius = std::numeric_limits<double>::infinity(); // of a disk without them
};

// The cut locus crosses edges that are torn.
template <class Triangulation>
Torn_map torn_map(const Triangulation& t, const Eigen::VectorXd& u, const Eigen::VectorXd& v) {
  Torn_map torn;
  const double unit = std::ldexp(1., -t.metric().scale_exponent());
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    const std::uint32_t i = t.input_vertex(source(h, t.mesh())),
                        j = t.input_vertex(target(h, t.mesh()));
    const double length = unit * std::sqrt(t.metric().approximate_squared_length(t.index(e)));
    if (!IT::is_torn({u[i], v[i]}, {u[j], v[j]}, length)) continue;
    ++torn.edges;
    torn.radius = std::min({torn.radius, std::hypot(u[i], v[i]), std::hypot(u[j], v[j])});
  }
  return torn;
}

template <class Triangulation>
Computed logarithmic_map(const Triangulation& t, const Sources& sources, const Options& options,
                         const Points& points) {
  if (sources.size() != 1 || sources[0].size() != 1)
    throw std::runtime_error("logarithmic maps have one source; give one point with --source");
  IT::Vectors<Triangulation> find(t, points);
  const std::string& asked = options.application.logarithm;
  const IT::Logarithm_method by = asked == "exact"    ? IT::Logarithm_method::exact
                                  : asked == "polar"  ? IT::Logarithm_method::polar
                                  : asked == "affine" ? IT::Logarithm_method::affine
                                                      : find.usual_method();
  const IT::Found_vectors log = find.logarithms(sources[0][0], by, asked_options(options));
  Computed computed{"logmap", {}, {}};
  computed.functions = {
      {"u", by_rows(log, [](const std::complex<double>& z) { return z.real(); })},
      {"v", by_rows(log, [](const std::complex<double>& z) { return z.imag(); })}};
  computed.is_map = computed.is_logarithm = true;
  const Torn_map torn = torn_map(t, computed.functions[0].values, computed.functions[1].values);
  const auto [radius, unknown] = greatest_known(by_rows(log, length_of));
  computed.json = {{"method", IT::name_of(by)},
                   {"radius", radius},
                   {"injectivity_radius", torn.radius},
                   {"torn_edges", torn.edges},
                   {"unknown_vertices", unknown}};
  return computed;
}

template <class Triangulation>
Computed direction_field(const Triangulation& t, const Options& options, const Points& points) {
  const Application_options& o = options.application;
  IT::Vectors<Triangulation> find(t, points);
  if (find.is_cloud() && !o.singularities.empty())
    throw std::runtime_error(options.input +
                             ": singularities lie in faces, and a cloud of points has no faces; "
                             "leave --singularities out");
  IT::Given_vectors fixed;
  if (!o.vectors.empty()) fixed = read_vectors(options, t.input().number_of_rows());
  const IT::Found_directions found =
      find.directions(static_cast<int>(o.degree), o.alignment, fixed, asked_options(options));
  Computed computed{"field", {}, {}};
  computed.directions = shown(find, "direction", found, o.degree, options);
  computed.json = {{"degree", o.degree},
                   {"fixed", fixed.places.size()},
                   {"alignment", o.alignment ? Json(*o.alignment) : Json(nullptr)}};
  if (find.is_cloud()) {
    computed.json["seam_edges"] = find.cloud(asked_options(options).neighbors).seam_edges();
    return computed;
  }
  computed.directions->index = found.index;
  computed.marks.name = "singularities";
  for (const auto& [p, index] : found.centres)
    computed.marks.points.push_back({{IT::point_in_space(t, p, points)}, false, index});
  const auto regular = std::count(found.index.begin(), found.index.end(), 0);
  computed.json["singular_faces"] = found.index.size() - static_cast<std::size_t>(regular);
  computed.json["index_sum"] = found.index_sum;
  computed.json["border_turns"] = found.border_turns;
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

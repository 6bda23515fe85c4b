// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../status_name.h"
#include "application.h"
#include "conformal_disks.h"
#include "conformal_layout.h"
#include "prescribed_angles.h"

#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/conformal_sphere.h>
#include <CGAL/Intrinsic_operators/conformal/flat_angles.h>
#include <CGAL/Intrinsic_operators/conformal/flat_surface.h>
#include <CGAL/Intrinsic_operators/conformal/flat_torus.h>
#include <CGAL/Intrinsic_operators/conformal/hyperbolic_metric.h>
#include <CGAL/Intrinsic_operators/conformal/ideal_start.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_scaled.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

namespace {

bool is_number(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

// The ratio in a word such as 10x or 2.5x; nothing if it is none.
std::optional<double> ratio_of(const std::string& word) {
  if (word.size() < 2 || word.back() != 'x') return std::nullopt;
  const std::string number = word.substr(0, word.size() - 1);
  if (number.find_first_not_of("0123456789.") != std::string::npos) return std::nullopt;
  try {
    return std::stod(number);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

template <class Ideal>
IT::Prescribed_angles angles_of(Ideal& ideal, const Uniformize_options& options) {
  if (!options.angles.empty()) return read_angles(options.angles, ideal.number_of_vertices());
  if (!options.cones.empty() && is_number(options.cones))
    return IT::place_cones(ideal, std::stoul(options.cones));
  if (const std::optional<double> ratio = ratio_of(options.cones))
    return IT::place_cones_within(ideal, *ratio);
  IT::Prescribed_angles angles = IT::flat_angles(ideal);
  if (options.target == "disk") // the border becomes geodesic
    for (std::size_t v = 0; v < angles.size(); ++v)
      if (angles.is_free(v)) angles.set(v, IT::Multiple_of_pi{1, 1});
  if (!options.cones.empty()) read_cones(options.cones, angles);
  return angles;
}

// Vertices with prescribed angles that are no full turns.
Json cones_json(const IT::Prescribed_angles& angles) {
  Json cones = Json::array();
  for (std::size_t v = 0; v < angles.size(); ++v)
    if (!angles.is_free(v) && angles.radians(v) != IT::Multiple_of_pi().radians())
      cones.push_back({{"vertex", v}, {"angle", angles.radians(v)}});
  return cones;
}

Json json_of(const IT::Conformal_metric& m, const IT::Prescribed_angles& angles,
             const Uniformize_options& options) {
  const Json cones = cones_json(angles);
  Json json = {{"status", name(m.status)},   {"start", options.start}, {"target", options.target},
               {"iterations", m.iterations}, {"residual", m.residual}, {"flips", m.flips},
               {"cones", cones.size()}};
  json["proven_residual"] = m.proven_residual ? finite_or_null(*m.proven_residual) : Json(nullptr);
  if (!options.cones.empty()) json["cone_angles"] = cones;
  return json;
}

// Text has the values alone.
bool writes_text(const Options& options) {
  return !options.output.empty() && !is_mesh_output(options);
}

// Whether files show the surface in its new shape.
bool writes_shape(const Options& options) {
  return needs_subdivision(options) && !writes_text(options);
}

// What a surface becomes, if the options do not say it.
template <class Triangulation>
std::string target_of(const Triangulation& t, const Uniformize_options& options) {
  const bool has_angles = !options.angles.empty() || !options.cones.empty();
  if (options.target == "disk") {
    if (!options.cones.empty() && (is_number(options.cones) || ratio_of(options.cones)))
      throw std::runtime_error("--cones " + options.cones +
                               " places cones of flat surfaces; with --target disk, list cones "
                               "with their angles in a file");
    return options.target;
  }
  if (has_angles && !options.target.empty() && options.target != "plane")
    throw std::runtime_error("--target " + options.target +
                             " has no cones; leave --angles and --cones out");
  if (!options.target.empty()) return options.target;
  if (has_angles || t.input().names().sheets != 1) return "plane";
  std::ptrdiff_t isolated = 0;
  for (const auto v : vertices(t.mesh()))
    if (halfedge(v, t.mesh()).index == IT::Gluing::none) ++isolated;
  const auto components = static_cast<std::ptrdiff_t>(IT::connected_components(t.mesh()).count);
  const std::ptrdiff_t euler = IT::euler_characteristic(t.mesh()) - isolated;
  if (components != 1 || euler % 2 != 0) return "plane";
  return euler == 2 ? "sphere" : euler == 0 ? "torus" : "disk";
}

Eigen::VectorXd vector_of(const std::vector<double>& u) {
  return Eigen::VectorXd::Map(u.data(), static_cast<Eigen::Index>(u.size()));
}

void report_scale(Computed& computed) {
  const Eigen::VectorXd& u = computed.functions.front().values;
  computed.json["least_u"] = u.minCoeff();
  computed.json["largest_u"] = u.maxCoeff();
  computed.json["max_scale_ratio"] = finite_or_null(std::exp(u.maxCoeff() - u.minCoeff()));
  computed.timed = "uniformize";
}

template <class Ideal>
Computed on_sphere(Ideal& ideal, const Points& points, const Options& options) {
  const IT::Conformal_sphere s = IT::conformal_sphere(ideal);
  Computed computed{"conformal",
                    json_of(s.metric, IT::Prescribed_angles(), options.uniformize),
                    {{"u", vector_of(IT::logarithmic_scale(ideal, s.layout))}}};
  if (!computed.functions.front().values.allFinite())
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "vertices fall together on the sphere in doubles; take --target plane "
                            "with --cones");
  computed.json["status"] = name(s.status());
  computed.json["pole"] = s.layout.pole;
  computed.json["rounds"] = s.rounds;
  computed.json["convex"] = s.is_convex;
  computed.json["injective"] = s.layout.is_injective();
  computed.json["flipped_faces"] = s.layout.flipped_faces;
  if (writes_shape(options)) { // vertices move to the sphere
    computed.displacements = Eigen::MatrixXd::Zero(ideal.number_of_vertices(), 3);
    for (std::size_t v = 0; v < ideal.number_of_vertices(); ++v) // without inserted ones
      for (std::size_t c = 0; c < 3; ++c)
        computed.displacements(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)) =
            s.layout.positions[v][c] - points[v][c];
  }
  report_scale(computed);
  return computed;
}

template <class Triangulation>
bool has_inserted(const Triangulation& t) {
  return t.number_of_vertices() > t.input().number_of_rows();
}

// The surface, or the double of one with border that was stored, on which results go by the same
// vertices.
// \throws Invalid_input if a cover has a border
template <class Triangulation, class Function>
Computed with_closed(const Triangulation& t, const Function& function) {
  if (IT::boundary_loops(t.mesh()).empty()) return function(t);
  if (t.input().names().sheets != 1)
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "the cover has a border; close it with --domain closed");
  Triangulation closed(double_of(t.input()));
  IT::flip_to_delaunay(closed);
  return function(closed);
}

// The number of places where edges of a triangulation cross those of its input.
template <class Triangulation>
std::uint64_t number_of_crossings(const Triangulation& t) {
  std::uint64_t number = 0;
  for (const auto e : edges(t.mesh()))
    number +=
        static_cast<std::uint64_t>(IT::crossings(t.correspondence().normal_coordinate(t.index(e))));
  return number;
}

// Pieces of a layout are about as many as crossings; each needs up to a kilobyte on the way.
template <class Triangulation, class Ideal>
void announce_size(const Triangulation& t, const Ideal& ideal, bool starts_from_input,
                   Progress& progress) {
  constexpr std::uint64_t many = 1'000'000;
  const std::uint64_t all =
      number_of_crossings(ideal) + (starts_from_input ? 0 : number_of_crossings(t));
  if (all >= many)
    progress.warn("edges cross at " + std::to_string(all) +
                  " places; a layout with as many pieces takes long and much memory, scale "
                  "factors alone, in a file .txt, do not");
}

// \param is_laid_out whether the result has a layout
template <class Triangulation>
Computed uniformized(const Triangulation& t, const Points& points, const Options& given,
                     bool is_laid_out, Progress& progress) {
  using Traits =
      std::conditional_t<Triangulation::Metric::is_exact, IT::Exact_ideal_hyperbolic_traits,
                         IT::Ideal_hyperbolic_traits<double>>;
  using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
  Options options = given;
  Uniformize_options& asked = options.uniformize;
  asked.target = target_of(t, asked);
  if (asked.start.empty()) asked.start = has_inserted(t) ? "input" : "delaunay";
  if (asked.start == "delaunay" && has_inserted(t))
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "scale factors belong to the vertices of the file, and others were "
                            "inserted; take --start input");
  Ideal ideal(asked.start == "input" ? IT::ideal_start(t.input()) : IT::ideal_start(t));
  if (asked.target == "sphere") return on_sphere(ideal, points, options);
  IT::Flat_surface start = IT::flat_surface(ideal);
  const IT::Prescribed_angles angles = angles_of(ideal, asked);
  const bool is_hyperbolic = asked.target == "disk";
  const IT::Conformal_metric m =
      is_hyperbolic ? IT::hyperbolic_metric(ideal, angles) : IT::conformal_metric(ideal, angles);
  Computed computed{"conformal", json_of(m, angles, asked), {{"u", vector_of(m.u)}}};
  if (!asked.cones.empty()) {
    computed.marks.name = "cones";
    for (const Json& cone : computed.json["cone_angles"])
      computed.marks.points.push_back({{points[cone["vertex"].get<std::size_t>()]}, false, 0});
  }
  std::optional<IT::Flat_torus> torus;
  if (asked.target == "torus") {
    torus = IT::flat_torus(IT::flat_surface(ideal));
    computed.json["period"] = {torus->period.real(), torus->period.imag()};
  }
  if (is_laid_out) {
    announce_size(t, ideal, asked.start == "input", progress);
    computed.laid_out = expect_reached(m, [&] {
      IT::Scaled_surface scaled = IT::scaled_surface(ideal, std::move(start), m.scale_factors,
                                                     angles, t.input().names(), is_hyperbolic);
      if (asked.start != "input") IT::add_mesh(scaled, t, ideal);
      const IT::Scaled_layout layout = IT::lay_out_scaled(scaled, torus ? &*torus : nullptr);
      computed.json["status"] = name(layout.status(m.status));
      return shown_layout(layout, points, computed.json);
    });
  }
  report_scale(computed);
  return computed;
}

// With the double in place of a surface with border.
Options closed(const Options& given) {
  Options options = given;
  if (options.domain == "auto" && !is_triangulation_file(options.input)) options.domain = "closed";
  return options;
}

} // namespace

void run_uniformize(const Options& given) {
  const Options options = closed(given);
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress& progress) {
    Computed computed = with_closed(t, [&](const auto& s) {
      return uniformized(s, points, options, writes_shape(options), progress);
    });
    computed.is_of_input = has_inserted(t);
    return computed;
  });
}

void run_conformal_map(const Options& given) {
  Options options = closed(given);
  options.uniformize.target = "plane";
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress& progress) {
    if (has_inserted(t))
      throw IT::Invalid_input(IT::Element_kind::none, 0,
                              "--method conformal maps the vertices of the file, and others were "
                              "inserted; start from the mesh");
    expect_disks(t.input());
    return map_of_disks(
        with_closed(t,
                    [&](const auto& s) { return uniformized(s, points, options, true, progress); }),
        t.input(), points, options.application.on == "input");
  });
}

} // namespace program

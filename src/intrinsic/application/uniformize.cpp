// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../status_name.h"
#include "application.h"
#include "prescribed_angles.h"

#include <CGAL/Intrinsic_operators/conformal/conformal_metric.h>
#include <CGAL/Intrinsic_operators/conformal/flat_angles.h>
#include <CGAL/Intrinsic_operators/conformal/ideal_start.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>

namespace program {

namespace {

bool is_number(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

template <class Ideal>
IT::Prescribed_angles angles_of(Ideal& ideal, const Uniformize_options& options) {
  if (!options.angles.empty()) return read_angles(options.angles, ideal.number_of_vertices());
  if (!options.cones.empty() && is_number(options.cones))
    return IT::place_cones(ideal, std::stoul(options.cones));
  IT::Prescribed_angles angles = IT::flat_angles(ideal);
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
             const Options& options) {
  const auto [least, most] = std::minmax_element(m.u.begin(), m.u.end());
  const Json cones = cones_json(angles);
  Json json = {{"status", name(m.status)},   {"start", options.uniformize.start},
               {"iterations", m.iterations}, {"residual", m.residual},
               {"flips", m.flips},           {"cones", cones.size()},
               {"least_u", *least},          {"largest_u", *most}};
  json["proven_residual"] = m.proven_residual ? finite_or_null(*m.proven_residual) : Json(nullptr);
  if (!options.uniformize.cones.empty()) json["cone_angles"] = cones;
  return json;
}

template <class Triangulation>
Computed uniformized(const Triangulation& t, const Options& options) {
  using Traits =
      std::conditional_t<Triangulation::Metric::is_exact, IT::Exact_ideal_hyperbolic_traits,
                         IT::Ideal_hyperbolic_traits<double>>;
  using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;
  Ideal ideal(options.uniformize.start == "input" ? IT::ideal_start(t.input())
                                                  : IT::ideal_start(t));
  const IT::Prescribed_angles angles = angles_of(ideal, options.uniformize);
  const IT::Conformal_metric m = IT::conformal_metric(ideal, angles);
  Computed computed{"conformal", json_of(m, angles, options), {}};
  computed.functions = {
      {"u", Eigen::VectorXd::Map(m.u.data(), static_cast<Eigen::Index>(m.u.size()))}};
  computed.timed = "uniformize";
  return computed;
}

} // namespace

void run_uniformize(const Options& given) {
  Options options = given;
  // the double of a surface with border
  if (options.domain == "auto" && !is_triangulation_file(options.input)) options.domain = "closed";
  run_application(options, [&](auto& t, const Sources&, const Points&, Progress&) {
    return uniformized(t, options);
  });
}

} // namespace program

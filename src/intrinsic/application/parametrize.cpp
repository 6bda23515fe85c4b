// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/parametrization/point_cloud_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// Flips and splits, which make harmonic maps injective, would remove edges that are to be kept.
template <class Triangulation>
IT::Injective_map map_of(Triangulation& t, const Options& options) {
  const std::string& method = options.application.map;
  if (method == "harmonic" && has_constraints(options))
    return IT::certified_map(t, IT::harmonic_map(t));
  return IT::parametrize(t, method == "lscm"       ? IT::Map_method::least_squares
                            : method == "spectral" ? IT::Map_method::spectral
                                                   : IT::Map_method::harmonic);
}

Json json_of(const IT::Injective_map& map, const IT::Map_distortion& distortion) {
  return {{"status", IT::name_of(map.status)},
          {"injective", map.certificate.is_injective()},
          {"flipped_faces", map.certificate.flipped},
          {"degenerate_faces", map.certificate.degenerate},
          {"border_is_simple", map.certificate.border_is_simple},
          {"rounds", map.rounds},
          {"inserted_vertices", map.inserted},
          {"mean_quasi_conformal", distortion.mean_quasi_conformal},
          {"max_quasi_conformal", distortion.maximum_quasi_conformal},
          {"min_area_ratio", distortion.minimum_area_ratio},
          {"max_area_ratio", distortion.maximum_area_ratio}};
}

template <class Triangulation>
Computed mapped(Triangulation& t, const Options& options) {
  const IT::Injective_map map = map_of(t, options);
  Computed computed{"parametrize", json_of(map, IT::measure_distortion(t, map.uv)), {}};
  computed.functions = {{"u", map.uv.col(0)}, {"v", map.uv.col(1)}};
  computed.is_map = true;
  return computed;
}

// The conformal map of a cloud of points, which has no faces that could be certified.
template <class Triangulation>
Computed map_of_points(const Triangulation& t, const Options& options, const Points& points) {
  if (options.application.map != "spectral")
    throw std::runtime_error("for a cloud of points only --method spectral works");
  const Eigen::MatrixX2d uv =
      IT::conformal_map_of_points(IT::points_of_rows(t, points), options.neighbors.value_or(30));
  Computed computed{"parametrize", {}, {}};
  for (const auto& [name, c] : {std::pair("u", 0), std::pair("v", 1)})
    computed.functions.push_back({name, Eigen::VectorXd(uv.col(c))});
  computed.is_map = true;
  computed.json = {{"method", "spectral"}};
  return computed;
}

} // namespace

void run_parametrize(const Options& options) {
  if (options.application.map == "conformal") return run_conformal_map(options);
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress&) {
    if (t.input().names().is_cloud()) return map_of_points(t, options, points);
    Computed computed = mapped(t, options);
    computed.json["method"] = options.application.map;
    Eigen::MatrixX2d uv(t.number_of_vertices(), 2);
    for (const Eigen::Index c : {0, 1})
      uv.col(c) = computed.functions[static_cast<std::size_t>(c)].values;
    computed.json["injective_on_input"] = IT::certify_map(t.input(), uv).is_injective();
    return computed;
  });
}

} // namespace program

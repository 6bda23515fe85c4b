// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_operators/parametrization/map_to_plane.h>
#include <CGAL/Intrinsic_operators/parametrization/parametrize.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <cstdint>
#include <string>

namespace program {

namespace {

// Flips and splits, which make harmonic maps injective, would remove edges that are to be kept.
IT::Map_options asked_of(const Options& options, Progress& progress) {
  const std::string& method = options.application.map;
  IT::Map_options asked;
  asked.method = method == "lscm"       ? IT::Map_method::least_squares
                 : method == "spectral" ? IT::Map_method::spectral
                                        : IT::Map_method::harmonic;
  asked.solver = IT::solver_named(options.application.solver);
  asked.keeps_edges = has_constraints(options);
  asked.neighbors = options.neighbors.value_or(asked.neighbors);
  asked.progress = [&progress](std::uint64_t steps) {
    return progress.show("mapping", std::to_string(steps) + " steps");
  };
  return asked;
}

Json json_of(const IT::Map_to_plane& map, const std::string& method) {
  if (!map.has_faces()) return {{"method", method}};
  return {{"status", IT::name_of(map.status)},
          {"injective", map.certificate.is_injective()},
          {"flipped_faces", map.certificate.flipped},
          {"degenerate_faces", map.certificate.degenerate},
          {"border_is_simple", map.certificate.border_is_simple},
          {"rounds", map.rounds},
          {"inserted_vertices", map.inserted},
          {"mean_quasi_conformal", map.distortion->mean_quasi_conformal},
          {"max_quasi_conformal", map.distortion->maximum_quasi_conformal},
          {"min_area_ratio", map.distortion->minimum_area_ratio},
          {"max_area_ratio", map.distortion->maximum_area_ratio},
          {"method", method},
          {"injective_on_input", *map.is_injective_on_input}};
}

} // namespace

void run_parametrize(const Options& options) {
  if (options.application.map == "conformal") return run_conformal_map(options);
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress& progress) {
    const IT::Map_to_plane map = IT::map_to_plane(t, points, asked_of(options, progress));
    Computed computed{"parametrize", json_of(map, options.application.map), {}};
    computed.functions = {{"u", map.uv.col(0)}, {"v", map.uv.col(1)}};
    computed.is_map = true;
    return computed;
  });
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "application.h"

#include <CGAL/Intrinsic_triangulations/applications/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_triangulations/applications/parametrization/measure_distortion.h>

#include <string>

namespace program {

namespace {

template <class Triangulation>
Eigen::MatrixX2d map_of(const Triangulation& t, const std::string& method) {
  if (method == "spectral") return IT::spectral_conformal_map(t);
  if (method == "lscm") return IT::least_squares_conformal_map(t);
  return IT::harmonic_map(t, IT::circular_border(t));
}

} // namespace

void run_parametrize(const Options& options) {
  run_application(options, [&](const auto& t, const Sources&) {
    const Eigen::MatrixX2d uv = map_of(t, options.application.map);
    const IT::Map_certificate certificate = IT::certify_map(t, uv);
    const IT::Map_distortion distortion = IT::measure_distortion(t, uv);
    Computed computed{"parametrize", {}, {}};
    computed.functions = {{"u", uv.col(0)}, {"v", uv.col(1)}};
    computed.is_map = true;
    computed.json = {{"method", options.application.map},
                     {"injective", certificate.is_injective()},
                     {"flipped_faces", certificate.flipped},
                     {"degenerate_faces", certificate.degenerate},
                     {"border_is_simple", certificate.border_is_simple},
                     {"mean_quasi_conformal", distortion.mean_quasi_conformal},
                     {"max_quasi_conformal", distortion.maximum_quasi_conformal},
                     {"min_area_ratio", distortion.minimum_area_ratio},
                     {"max_area_ratio", distortion.maximum_area_ratio}};
    return computed;
  });
}

} // namespace program

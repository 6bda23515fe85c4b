// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MAP_BY_METHOD_H
#define INTRINSIC_MAP_BY_METHOD_H

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>

#include <Eigen/Core>

#include <string>
#include <utility>

// Maps of disks, for the program and for the Python module.

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// returns a map that stays as it is, whether it is injective or not; without points, the visitor
/// has ended the work.
template <class Triangulation>
IT::Injective_map certified(const Triangulation& t, Eigen::MatrixX2d uv) {
  if (uv.rows() == 0) return {IT::Status::cancelled, std::move(uv), {}};
  IT::Injective_map map{IT::Status::done, std::move(uv), {}};
  map.certificate = IT::certify_map(t, map.uv);
  return map;
}

/// maps a disk. Harmonic maps are made injective by flips and splits.
/// \param method "lscm", "spectral", or else harmonic
/// \param np named parameters of the map, see `injective_harmonic_map()` and
///   `least_squares_conformal_map()`
template <class Triangulation, class NP = IT::parameters::Parameters<>>
IT::Injective_map map_by_method(Triangulation& t, const std::string& method,
                                const NP& np = IT::parameters::default_values()) {
  if (method == "spectral") return certified(t, IT::spectral_conformal_map(t, np));
  if (method == "lscm") return certified(t, IT::least_squares_conformal_map(t, np));
  return IT::injective_harmonic_map(t, np);
}

} // namespace program

#endif // INTRINSIC_MAP_BY_METHOD_H

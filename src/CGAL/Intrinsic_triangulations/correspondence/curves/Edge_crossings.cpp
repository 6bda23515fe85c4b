// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

void make_monotone(const Edge_crossings& crossings, Crossing_parameters& p) {
  for (std::size_t e = 0; e + 1 < crossings.begin.size(); ++e)
    for (std::uint32_t i = crossings.begin[e] + 1; i < crossings.begin[e + 1]; ++i)
      p.on_intrinsic[i] = std::max(p.on_intrinsic[i], p.on_intrinsic[i - 1]);
  for (std::size_t c = 0; c + 1 < crossings.curve_begin.size(); ++c)
    for (std::uint32_t i = crossings.curve_begin[c] + 1; i < crossings.curve_begin[c + 1]; ++i) {
      double& x = p.on_input[crossings.on_curve[i]];
      x = std::max(x, p.on_input[crossings.on_curve[i - 1]]);
    }
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

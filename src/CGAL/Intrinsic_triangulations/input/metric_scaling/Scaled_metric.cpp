// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/Scaled_metric.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

static double checked_squared_length(const Intrinsic_input& in, std::uint32_t e) {
  const auto &p = in.points[in.mesh.source({2 * e}).index],
             &q = in.points[in.mesh.target({2 * e}).index];
  const double square = Input_metric::squared_distance<double>(p, q);
  if (square < std::numeric_limits<double>::min() && p != q)
    throw Invalid_input::about(Element_kind::edge, e,
                               " is more than 2^500 times shorter than the mean edge; move its "
                               "vertices to the same place, or apart");
  return square;
}

// Diagonals of planar polygons are not the distances of the points.
static void add_planar_excess(Metric_source& s) {
  const std::vector<std::array<double, 3>> excess =
      planar_excess(s.in.mesh, s.in.points, s.in.names, s.in.planar_polygons, s.scale_exponent);
  std::vector<char> is_done(s.in.squared_lengths.size(), 0);
  for (std::uint32_t f = 0; f < excess.size(); ++f) {
    const std::array<Gluing_map::Halfedge, 3> sides = s.in.mesh.sides({f});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t e = sides[k].index / 2;
      if (is_done[e] == 0) s.in.squared_lengths[e] += excess[f][k];
      is_done[e] = 1;
    }
  }
}

Metric_source read_metric(Intrinsic_input in) {
  check_sizes(in);
  Metric_source s{std::move(in)};
  if (s.in.squared_lengths.empty() && !s.in.points.empty()) {
    s.scale_exponent = scale_points(s.in.mesh, s.in.points);
    for (std::uint32_t e = 0; e < s.in.mesh.number_of_edges(); ++e)
      s.in.squared_lengths.push_back(checked_squared_length(s.in, e));
    add_planar_excess(s);
  } else {
    s.in.points.clear(); // lengths that are given count
    s.scale_exponent = scale_squared_lengths(s.in.squared_lengths);
  }
  return s;
}

std::string text_of_length(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

// Names a face, its vertices and its lengths in the order of its sides.
[[noreturn]] static void refuse_face(const Intrinsic_input& in, std::uint32_t f) {
  std::string vertices, lengths, separator;
  for (const Gluing_map::Halfedge h : in.mesh.sides({f})) {
    vertices += separator + std::to_string(in.mesh.source(h).index);
    lengths += separator + text_of_length(std::sqrt(in.squared_lengths[h.index / 2]));
    separator = separator.empty() ? ", " : " and ";
  }
  throw Invalid_input::about(
      Element_kind::face, f,
      std::string(in.triangulated_polygons > 0 ? " of the triangulated mesh" : "") +
          " with vertices " + vertices + " gets sides of lengths " + lengths +
          ", which violate the triangle inequality; scale less, refine the mesh "
          "before, or ask for repair");
}

Scaled_metric finish_scaling(Intrinsic_input&& in, const Metric_scaling_options& options) {
  Scaled_metric result;
  result.input = std::move(in);
  std::vector<double>& lengths = result.input.squared_lengths;
  result.violating_faces = faces_violating_triangle_inequality(result.input.mesh, lengths);
  if (options.triangle_inequality == Triangle_inequality::repair) {
    const Shortening_report r = shorten_edges(result.input.mesh, lengths, options.margin);
    result.changed_edges = r.changed_edges;
    result.largest_relative_change = r.largest_relative_change;
  } else if (!result.violating_faces.empty()) {
    if (options.triangle_inequality == Triangle_inequality::refuse)
      refuse_face(result.input, result.violating_faces.front());
    result.is_metric = false;
  }
  return result;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

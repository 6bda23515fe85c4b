// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/parameters.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// What is done where new lengths violate the triangle inequality (§4.8 of the course). Faces without area
/// may do so by rounding already: meshes that have some need `repair`.
enum class Triangle_inequality {
  refuse, ///< an exception names the first face
  repair, ///< edges are shortened, see `shorten_edges()`
  check   ///< faces are listed, and no more: the result may not be a metric
};

/*!
\brief holds a new metric, and reports what had to be done about it.
*/
struct Scaled_metric {
  /// The surface with the new lengths; an `Intrinsic_triangulation` is built from it.
  Intrinsic_input input;
  /// Faces that the new lengths violated the triangle inequality in, before any repair, by their
  /// number in the order of iteration; after polygons were triangulated, if some were.
  std::vector<std::uint32_t> violating_faces;
  /// Edges that repair shortened.
  std::size_t changed_edges = 0;
  /// Largest (l - l') / l, where repair shortened an edge from l to l'.
  double largest_relative_change = 0;
  /// Whether all faces satisfy the triangle inequality now, so that a triangulation can be built.
  bool is_metric = true;
};

namespace internal {

// How a metric is scaled: see `scale_conformally()`.
struct Metric_scaling_options {
  Triangle_inequality triangle_inequality = Triangle_inequality::refuse;
  double margin = 1e-5;
};

template <class NP>
Metric_scaling_options metric_scaling_options(const NP& np) {
  expect_names<tags::triangle_inequality, tags::margin>(np);
  const Metric_scaling_options d;
  return {value_or<tags::triangle_inequality>(np, d.triangle_inequality),
          value_or<tags::margin>(np, d.margin)};
}

inline std::string text_of_length(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}

// Names a face, its vertices and its lengths in the order of its sides.
[[noreturn]] inline void refuse_face(const Intrinsic_input& in, std::uint32_t f) {
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

// Does what the options say about the triangle inequality.
inline Scaled_metric finish_scaling(Intrinsic_input&& in, const Metric_scaling_options& options) {
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_SCALED_METRIC_H

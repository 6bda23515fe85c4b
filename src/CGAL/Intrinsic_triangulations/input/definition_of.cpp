// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/definition_of.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The sides of faces in the order of the user's faces.
std::vector<std::uint32_t> sides_in_order(const Input& surface) {
  std::vector<std::uint32_t> result;
  result.reserve(3 * std::size_t{surface.number_of_faces()});
  for (std::uint32_t f = 0; f < surface.number_of_faces(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) result.push_back(3 * surface.names().faces.here(f) + k);
  return result;
}

Gluing gluing_in_order(const Input& surface, const std::vector<std::uint32_t>& sides) {
  const Gluing all = gluing_from_map(surface.mesh());
  std::vector<std::uint32_t> number(sides.size());
  for (std::uint32_t h = 0; h < sides.size(); ++h) number[sides[h]] = h;
  Gluing g{surface.number_of_vertices(), {}, {}};
  for (const std::uint32_t h : sides) {
    g.origin.push_back(surface.names().vertices.user(all.origin[h]));
    const std::uint32_t partner = all.glue[h]; // the surface is oriented
    g.glue.push_back(partner == Gluing::none ? partner : number[partner]);
  }
  return g;
}

std::vector<double> squares_in_order(const Input& surface, const Gluing_map& mesh,
                                     const std::vector<std::uint32_t>& sides) {
  const Input_metric& metric = surface.metric();
  const bool is_stored = !metric.is_embedded(); // without what mollification adds
  std::vector<double> result(mesh.number_of_edges());
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t side = sides[3 * f + k];
      const std::uint32_t e = surface.mesh().sides({side / 3})[side % 3].index / 2;
      result[mesh.sides({f})[k].index / 2] =
          std::ldexp(is_stored ? metric.squared_lengths()[e] : surface.squared_length(e),
                     -2 * surface.scale_exponent());
    }
  return result;
}

std::vector<std::array<double, 3>> points_in_order(const Input& surface) {
  std::vector<std::array<double, 3>> result(surface.number_of_vertices());
  for (std::uint32_t v = 0; v < result.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      result[surface.names().vertices.user(v)][c] =
          std::ldexp(surface.metric().points()[v][c], -surface.scale_exponent());
  return result;
}

} // namespace

} // namespace internal

Intrinsic_input definition_of(const Input& surface) {
  const std::vector<std::uint32_t> sides = internal::sides_in_order(surface);
  Intrinsic_input in;
  in.mesh = Gluing_map::from_valid(internal::gluing_in_order(surface, sides));
  in.names.polygon_of_triangle = surface.names().polygon_of_triangle;
  in.names.row_of_vertex = surface.names().row_of_vertex;
  in.names.sheets = surface.names().sheets;
  in.planar_polygons = surface.planar_polygons();
  const Input_metric& metric = surface.metric();
  const bool is_of_points =
      metric.is_in_space() || metric.delta() > 0 || !in.planar_polygons.empty();
  if (metric.is_embedded() && is_of_points)
    in.points = internal::points_in_order(surface);
  else
    in.squared_lengths = internal::squares_in_order(surface, in.mesh, sides);
  if (metric.delta() > 0) { // its square root is a part of the mean edge
    const std::vector<double> lengths = internal::edge_lengths(surface.mesh(), metric);
    in.mollification = Mollification::squared_lengths;
    in.mollification_amount = std::sqrt(metric.delta()) * static_cast<double>(lengths.size()) /
                              std::accumulate(lengths.begin(), lengths.end(), 0.);
  }
  return in;
}

} // namespace CGAL::Intrinsic_triangulations

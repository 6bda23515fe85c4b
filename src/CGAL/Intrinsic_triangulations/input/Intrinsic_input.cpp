// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/input/renumbering.h>
#include <CGAL/Intrinsic_triangulations/input/scaling.h>
#include <CGAL/Intrinsic_triangulations/input/triangulate_face_graph.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

std::size_t number_of_reversed(const std::vector<char>& triangles,
                               const std::vector<std::uint32_t>& polygon_of_triangle) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (triangles[t] != 0 && (polygon_of_triangle.empty() || t == 0 ||
                              polygon_of_triangle[t] != polygon_of_triangle[t - 1]))
      ++count;
  return count;
}

} // namespace internal

Intrinsic_input::Intrinsic_input() = default;
Intrinsic_input::Intrinsic_input(const Intrinsic_input& other) = default;
Intrinsic_input::Intrinsic_input(Intrinsic_input&& other) noexcept = default;
Intrinsic_input& Intrinsic_input::operator=(const Intrinsic_input& other) = default;
Intrinsic_input& Intrinsic_input::operator=(Intrinsic_input&& other) noexcept = default;
Intrinsic_input::~Intrinsic_input() = default;

Intrinsic_input::Intrinsic_input(Gluing_map g, std::vector<double> l, Mollification m)
    : mesh(std::move(g)), squared_lengths(std::move(l)), mollification(m) {}

Intrinsic_input::Intrinsic_input(Gluing_map g, std::vector<std::array<double, 3>> p,
                                 Mollification m)
    : mesh(std::move(g)), points(std::move(p)), mollification(m) {}

Intrinsic_input::Intrinsic_input(Triangle_soup soup, Mollification m)
    : points(std::move(soup.points)), mollification(m),
      triangulated_polygons(soup.triangulated_polygons) {
  std::vector<char> reversed;
  mesh = Gluing_map::from_valid(
      oriented_gluing_from_triangles(static_cast<std::uint32_t>(points.size()), soup.triangles,
                                     reversed, soup.polygon_of_triangle));
  reversed_faces = internal::number_of_reversed(reversed, soup.polygon_of_triangle);
  names.polygon_of_triangle = std::move(soup.polygon_of_triangle);
  planar_polygons = std::move(soup.planar_polygons);
}

namespace internal {

std::vector<std::array<double, 3>>
planar_excess(const Gluing_map& mesh, const std::vector<std::array<double, 3>>& points,
              const Input_names& names, const Planar_polygons& polygons, int scale_exponent) {
  std::vector<std::array<double, 3>> result;
  if (polygons.empty()) return result;
  const Power_of_two scale(scale_exponent);
  result.resize(mesh.number_of_faces(), {0, 0, 0});
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const Planar_polygons::Polygon polygon = polygons(names.polygon(f));
    if (polygon.points.empty()) continue;
    const std::array<Gluing_map::Halfedge, 3> sides = mesh.sides({f});
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.source(sides[k]).index, w = mesh.target(sides[k]).index;
      const std::size_t i = polygon.corner(names.row(v)), j = polygon.corner(names.row(w));
      if (polygon.is_side(i, j)) continue;
      const auto scaled = [&](Planar_polygons::Point p) {
        return Planar_polygons::Point{scale(p[0]), scale(p[1])};
      };
      result[f][k] =
          planar_excess(points[v], points[w], scaled(polygon.points[i]), scaled(polygon.points[j]));
    }
  }
  return result;
}

Mollification_report mollify(const Gluing_map& mesh, Input_metric& metric, Mollification kind,
                             std::optional<double> amount) {
  if (amount) { // in scaled units
    const std::vector<double> lengths = edge_lengths(mesh, metric);
    *amount *=
        std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
  }
  double added = amount ? *amount * *amount : default_squared_length_delta;
  if (kind == Mollification::lengths)
    // as the course recommends, see `mollifying_epsilon()`
    metric = mollify_lengths(mesh, metric, amount.value_or(1e-5), added);
  else
    metric.set_delta(added);
  const int s = metric.scale_exponent() * (kind == Mollification::lengths ? 1 : 2);
  return {kind, std::ldexp(added, -s)};
}

void check_sizes(const Intrinsic_input& in) {
  const bool embedded = in.squared_lengths.empty();
  const std::size_t needed = embedded ? in.mesh.number_of_vertices() : in.mesh.number_of_edges();
  const std::size_t given = embedded ? in.points.size() : in.squared_lengths.size();
  if (given != needed)
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(given) +
                            (embedded ? " points for " : " squared lengths for ") +
                            std::to_string(needed) +
                            (embedded ? " vertices; give one per vertex"
                                      : " edges; give one per edge of the gluing map"));
}

// Makes each face start at a side that is not glued to another side of the same face, so that its
// edge names that side alone: exact metrics identify sides by their edges.
void start_at_single_sides(Gluing_map& mesh) {
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto [h, n, l] = mesh.sides({f});
    if (n == Gluing_map::opposite(h)) mesh.set_halfedge(Gluing_map::Face{f}, l);
    if (l == Gluing_map::opposite(h)) mesh.set_halfedge(Gluing_map::Face{f}, n);
  }
}

void check_faces(const Gluing_map& mesh) {
  if (mesh.number_of_faces() == 0)
    throw Invalid_input(Element_kind::none, 0, "the mesh has no faces; give at least one");
  if (!mesh.is_oriented())
    throw Invalid_input(Element_kind::none, 0,
                        "the gluing does not respect the orientation of the faces; orient them, or "
                        "take the orientation double cover of a nonorientable surface with "
                        "--domain orientation-cover");
}

void check_mollification_amount(const std::optional<double>& amount) {
  if (amount && !(*amount > 0 && *amount <= 1))
    throw Invalid_input(Element_kind::none, 0,
                        "the amount of mollification is " + std::to_string(*amount) +
                            "; it is a part of the mean edge, above 0 and at most 1");
}

Input_definition::Parts scaled_and_ordered(Intrinsic_input& in) {
  check_mollification_amount(in.mollification_amount);
  check_faces(in.mesh);
  check_sizes(in);
  const bool embedded = in.squared_lengths.empty();
  const int scale =
      embedded ? scale_points(in.mesh, in.points) : scale_squared_lengths(in.squared_lengths);
  Input_definition::Parts parts;
  parts.number_of_vertices = in.mesh.number_of_vertices();
  parts.names = std::move(in.names);
  parts.planar_polygons = std::move(in.planar_polygons);
  parts.report.triangulated_polygons = in.triangulated_polygons;
  parts.report.reversed_faces = in.reversed_faces;
  if (embedded && in.may_renumber && is_badly_ordered(in.mesh)) {
    Input_names order = renumber(in.mesh, in.points);
    parts.names.vertices = std::move(order.vertices);
    parts.names.edges = parts.names.edges.after(order.edges);
    parts.names.faces = std::move(order.faces);
    parts.report.renumbered = true;
  }
  start_at_single_sides(in.mesh);
  parts.metric =
      embedded ? Input_metric::from_points(in.mesh, std::move(in.points), scale)
               : Input_metric::from_squared_lengths(in.mesh, std::move(in.squared_lengths), scale);
  if (embedded)
    parts.metric.set_excess(
        planar_excess(in.mesh, parts.metric.points(), parts.names, parts.planar_polygons, scale));
  return parts;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cut.h"
#include "../support/naming_file.h"

#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

using Halfedge = IT::Gluing_map::Halfedge;

// Nonzero for the edges to cut.
std::vector<char> edges_to_cut(const IT::Intrinsic_input& input, const Options& options) {
  const std::string& cut = options.application.cut;
  if (cut == "auto") return IT::cut_to_disk(input);
  Options listed = options;
  listed.constraints = cut;
  listed.sharp_angle.reset();
  return constraints_of(input, listed).is_constrained;
}

// The edges of the surface that is cut open, for the edges before.
void carry_over(Constraints& constraints, const IT::Gluing_map& before,
                const IT::Opened_input& opened) {
  if (constraints.count == 0) return;
  const IT::Gluing_map& after = opened.input.mesh;
  std::vector<char> is_constrained(after.number_of_edges(), 0);
  for (std::uint32_t f = 0; f < before.number_of_faces(); ++f) {
    const std::array<Halfedge, 3> sides = before.sides({f});
    std::array<Halfedge, 3> copies = after.sides({f});
    if (!opened.reversed_faces.empty() && opened.reversed_faces[f] != 0)
      std::swap(copies[0], copies[2]);
    for (std::size_t k = 0; k < 3; ++k)
      if (constraints.is_constrained[sides[k].index / 2] != 0)
        is_constrained[copies[k].index / 2] = 1;
  }
  constraints.is_constrained = std::move(is_constrained);
  constraints.mesh = after;
}

} // namespace

void take_sheet(IT::Read_surface& file) {
  if (file.facts.cloud || !file.input.names.is_cover()) return;
  file.input = IT::sheet_of_cover(file.input);
  file.facts.domain.sheets = 1;
}

Cut cut_to_disk(IT::Read_surface& file, Constraints& constraints, const Options& options) {
  Cut cut;
  if (file.facts.cloud) return cut;
  const std::vector<char> is_cut =
      naming_file(options.input, [&] { return edges_to_cut(file.input, options); });
  const std::string& edges = options.application.cut;
  IT::Opened_input opened = naming_file(edges == "auto" ? options.input : edges,
                                        [&] { return IT::cut_to_disks(file.input, is_cut); });
  const IT::Gluing_map& mesh = file.input.mesh;
  for (std::uint32_t e = 0; e < is_cut.size(); ++e) {
    const Halfedge h{2 * e};
    if (is_cut[e] == 0 || mesh.face(h).index == IT::Gluing::none ||
        mesh.face(Halfedge{2 * e + 1}).index == IT::Gluing::none)
      continue;
    ++cut.edges;
    if (file.input.points.empty()) continue;
    const Point &p = file.input.points[mesh.source(h).index],
                &q = file.input.points[mesh.target(h).index];
    cut.length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    cut.seams.push_back({{p, q}, false, 0});
  }
  if (cut.edges == 0 && opened.original_vertex.size() == mesh.number_of_vertices() &&
      mesh.is_oriented())
    return cut;
  carry_over(constraints, mesh, opened);
  cut.original_vertex = std::move(opened.original_vertex);
  file.input = std::move(opened.input);
  return cut;
}

void take_to_corners(const IT::Common_subdivision& s, std::vector<IT::Subdivision_field>& fields) {
  for (IT::Subdivision_field& field : fields) {
    if (!field.is_function()) continue;
    std::vector<double> at_corners;
    for (const std::uint32_t v : s.corner) at_corners.push_back(field.values[v]);
    field = {field.name, std::move(at_corners), IT::Subdivision_field::Place::corners};
  }
}

void close_seams(Drawn_subdivision& drawn, std::vector<IT::Subdivision_field>& fields,
                 const Cut& cut) {
  IT::Common_subdivision& s = drawn.s;
  const auto is_of_input = [&s](std::size_t v) {
    return s.kind(v) == IT::Subdivision_vertex_kind::input;
  };
  take_to_corners(s, fields);
  // a vertex of the file has its own number among its copies
  std::vector<std::uint32_t> of_file(cut.original_vertex.size(), IT::Gluing::none);
  for (std::uint32_t v = 0; v < s.vertices.size(); ++v)
    if (is_of_input(v)) of_file[s.vertices[v].on_input.vertices[0]] = v;
  std::vector<std::uint32_t> kept, number(s.number_of_vertices());
  for (std::uint32_t v = 0; v < number.size(); ++v) {
    const std::uint32_t first =
        is_of_input(v) ? of_file[cut.original_vertex[s.vertices[v].on_input.vertices[0]]] : v;
    if (first == v) kept.push_back(v);
  }
  for (std::uint32_t i = 0; i < kept.size(); ++i) number[kept[i]] = i;
  for (std::uint32_t v = 0; v < number.size(); ++v)
    if (is_of_input(v))
      number[v] = number[of_file[cut.original_vertex[s.vertices[v].on_input.vertices[0]]]];
  for (std::uint32_t& v : s.corner) v = number[v];
  std::vector<IT::Common_subdivision::Vertex> vertices;
  std::vector<Point> points;
  for (const std::uint32_t v : kept) {
    points.push_back(drawn.points[v]);
    if (v < s.vertices.size()) vertices.push_back(s.vertices[v]);
  }
  const auto rename = [&cut](std::uint32_t& v) { v = cut.original_vertex[v]; };
  for (IT::Common_subdivision::Vertex& v : vertices)
    for (std::size_t i = 0; i < v.on_input.size; ++i) rename(v.on_input.vertices[i]);
  for (IT::Common_subdivision::Crossing& x : s.crossings)
    for (std::uint32_t& v : x.on_input.vertices) rename(v);
  s.vertices = std::move(vertices);
  drawn.points = std::move(points);
}

} // namespace program

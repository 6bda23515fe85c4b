// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

void expect_no_cover(const Intrinsic_input& in) {
  if (!in.names.row_of_vertex.empty() || in.names.is_cover())
    throw Invalid_input(
        Element_kind::none, 0,
        "the surface is a cover, which is not cut open; cut the triangles below it, "
        "which sheet_of_cover() returns");
}

double length_of_side(const Intrinsic_input& in, Gluing_map::Halfedge h) {
  if (in.points.empty()) return std::sqrt(in.squared_lengths[h.index / 2]);
  const std::array<double, 3>&p = in.points[in.mesh.source(h).index],
                           &q = in.points[in.mesh.target(h).index];
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Whether an edge is inside of a polygon of the user.
bool is_inside_polygon(const Intrinsic_input& in, std::uint32_t e) {
  if (in.names.polygon_of_triangle.empty()) return false;
  const std::uint32_t f = in.mesh.face(Gluing_map::Halfedge{2 * e}).index,
                      g = in.mesh.face(Gluing_map::Halfedge{2 * e + 1}).index;
  return f != Gluing::none && g != Gluing::none && f != g &&
         in.names.polygon(f) == in.names.polygon(g);
}

// Throws if components are no disks.
void expect_disks(const Gluing_map& opened) {
  const std::size_t components = connected_components(opened).count,
                    borders = boundary_loops(opened).size();
  const std::optional<std::size_t> handles = genus(opened);
  if (handles == 0 && borders == components) return;
  const auto count = [](std::size_t n, const std::string& what) {
    return std::to_string(n) + ' ' + what + (n == 1 ? "" : "s");
  };
  throw Invalid_input(Element_kind::none, 0,
                      "these edges do not cut the surface to disks: cut open, it has " +
                          count(components, "component") + ", " +
                          (handles ? count(*handles, "handle") : "one side only") + " and " +
                          count(borders, "border") +
                          "; change the edges, or let a short cut be found");
}

// Calls a function with each side, by its number, and its halfedge.
template <class Function>
void for_each_side(const Gluing_map& mesh, const Function& f) {
  for (std::uint32_t face = 0, side = 0; face < mesh.number_of_faces(); ++face)
    for (const Gluing_map::Halfedge h : mesh.sides({face})) f(side++, h);
}

// The names of copies of vertices: first copies keep theirs, others have the numbers after.
Element_names names_of_copies(const Element_names& names, std::size_t copies) {
  if (names.is_identity()) return names;
  std::vector<std::uint32_t> user = names.users();
  for (std::size_t v = user.size(); v < copies; ++v) user.push_back(static_cast<std::uint32_t>(v));
  return Element_names(std::move(user));
}

// Planar polygons between copies of vertices. No diagonal is cut, so that a polygon has one copy.
Planar_polygons polygons_of_copies(const Intrinsic_input& in, const Opened_input& opened) {
  Planar_polygons result;
  result.report = in.planar_polygons.report;
  if (in.planar_polygons.empty()) return result;
  std::vector<std::vector<std::uint32_t>> corners; // sides of triangles, of each planar polygon
  std::vector<std::uint32_t> place;                // of a polygon among the planar ones
  for (std::size_t i = 0; i < in.planar_polygons.size(); ++i) {
    place.resize(in.planar_polygons.face(i) + std::size_t{1}, Gluing::none);
    place.back() = static_cast<std::uint32_t>(i);
  }
  corners.resize(in.planar_polygons.size());
  for (std::uint32_t f = 0; f < opened.corners.size(); ++f) {
    const std::uint32_t p = in.names.polygon(f);
    if (p < place.size() && place[p] != Gluing::none)
      for (const std::uint32_t v : opened.corners[f]) corners[place[p]].push_back(v);
  }
  for (std::size_t i = 0; i < in.planar_polygons.size(); ++i) {
    const Planar_polygons::Polygon polygon = in.planar_polygons(in.planar_polygons.face(i));
    std::vector<std::uint32_t> vertices(polygon.vertices.begin(), polygon.vertices.end());
    for (std::uint32_t& v : vertices) {
      const std::uint32_t before = v;
      for (const std::uint32_t c : corners[i])
        if (in.names.vertices.user(opened.original_vertex[c]) == before)
          v = opened.input.names.vertices.user(c);
    }
    result.add(in.planar_polygons.face(i), vertices, polygon.points);
  }
  return result;
}

} // namespace

} // namespace internal

Intrinsic_input sheet_of_cover(const Intrinsic_input& cover) {
  using internal::Double_cover;
  const Input_names& names = cover.names;
  if (!names.is_cover()) return cover;
  if (names.is_cloud())
    throw Invalid_input(Element_kind::none, 0,
                        "there are no triangles below a surface of " +
                            std::to_string(names.sheets) +
                            " sheets, such as that of a cloud of points; start from triangles");
  internal::check_sizes(cover);
  const Gluing above = gluing_from_map(cover.mesh);
  Gluing g{names.number_of_rows(above.number_of_vertices), {}, {}};
  for (std::uint32_t h = 0; h < above.origin.size() / 2; ++h) {
    g.origin.push_back(names.row(above.origin[Double_cover::front(h)]));
    g.glue.push_back(Gluing::none);
    // where two triangles meet, each side of one is glued to a side of the other
    const std::uint32_t p = above.glue[Double_cover::front(h)],
                        q = above.glue[Double_cover::back(h)];
    if (p == Gluing::none || q == Gluing::none) continue;
    const std::uint32_t other = Double_cover::side(p);
    if (other == h || other != Double_cover::side(q)) continue;
    g.glue.back() = p == Double_cover::front(other) ? other : Gluing::reversed(other);
  }
  Intrinsic_input result = cover;
  result.names = {};
  for (std::size_t f = 0; f < names.polygon_of_triangle.size(); f += 2)
    result.names.polygon_of_triangle.push_back(names.polygon_of_triangle[f]);
  result.mesh = Gluing_map::from_valid(g);
  if (!cover.points.empty()) {
    result.points.resize(g.number_of_vertices);
    for (std::uint32_t v = 0; v < cover.points.size(); ++v)
      result.points[names.row(v)] = cover.points[v];
    return result;
  }
  result.squared_lengths.resize(result.mesh.number_of_edges());
  internal::for_each_side(result.mesh, [&](std::uint32_t side, Gluing_map::Halfedge h) {
    const auto above_it = cover.mesh.sides({2 * (side / 3)})[side % 3];
    result.squared_lengths[h.index / 2] = cover.squared_lengths[above_it.index / 2];
  });
  return result;
}

std::vector<char> cut_to_disk(const Intrinsic_input& in, std::span<const std::uint32_t> through,
                              std::size_t roots) {
  internal::expect_no_cover(in);
  internal::check_sizes(in);
  Surface_to_cut s{gluing_from_map(in.mesh), {}, {}};
  internal::for_each_side(in.mesh, [&](std::uint32_t, Gluing_map::Halfedge h) {
    s.length.push_back(internal::length_of_side(in, h));
    s.is_kept.push_back(internal::is_inside_polygon(in, h.index / 2) ? 1 : 0);
  });
  const std::vector<char> sides = cut_to_disk(s, through, roots);
  std::vector<char> is_cut(in.mesh.number_of_edges(), 0);
  internal::for_each_side(in.mesh, [&](std::uint32_t side, Gluing_map::Halfedge h) {
    if (sides[side] != 0) is_cut[h.index / 2] = 1;
  });
  return is_cut;
}

Opened_input cut_open(const Intrinsic_input& in, const std::vector<char>& is_cut) {
  internal::expect_no_cover(in);
  internal::check_sizes(in);
  if (is_cut.size() != in.mesh.number_of_edges())
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(is_cut.size()) +
                            " marks of edges to cut; give one for each of the " +
                            std::to_string(in.mesh.number_of_edges()) + " edges");
  std::vector<char> sides;
  internal::for_each_side(in.mesh, [&](std::uint32_t, Gluing_map::Halfedge h) {
    sides.push_back(is_cut[h.index / 2]);
  });
  Opened_surface s = cut_open(gluing_from_map(in.mesh), sides);
  Opened_input result;
  Intrinsic_input& out = result.input;
  out = in;
  if (!in.mesh.is_oriented()) result.reversed_faces = orient_faces(s.gluing).reversed_faces;
  out.reversed_faces +=
      internal::number_of_reversed(result.reversed_faces, in.names.polygon_of_triangle);
  out.mesh = Gluing_map::from_valid(s.gluing);
  result.original_vertex = std::move(s.original_vertex);
  if (!in.points.empty())
    for (std::size_t v = in.points.size(); v < result.original_vertex.size(); ++v)
      out.points.push_back(in.points[result.original_vertex[v]]);
  result.corners.resize(s.gluing.number_of_faces());
  out.squared_lengths.assign(in.points.empty() ? out.mesh.number_of_edges() : 0, 0);
  std::vector<std::uint32_t> edge;
  internal::for_each_side(
      in.mesh, [&](std::uint32_t, Gluing_map::Halfedge h) { edge.push_back(h.index / 2); });
  internal::for_each_side(out.mesh, [&](std::uint32_t side, Gluing_map::Halfedge h) {
    const std::uint32_t f = side / 3, k = side % 3;
    result.corners[f][k] = s.gluing.origin[side];
    const bool is_reversed = !result.reversed_faces.empty() && result.reversed_faces[f] != 0;
    if (in.points.empty())
      out.squared_lengths[h.index / 2] =
          in.squared_lengths[edge[3 * f + (is_reversed ? 2 - k : k)]];
  });
  out.names.vertices = internal::names_of_copies(in.names.vertices, result.original_vertex.size());
  out.names.edges = Element_names();
  out.planar_polygons = internal::polygons_of_copies(in, result);
  return result;
}

Opened_input cut_to_disks(const Intrinsic_input& in, const std::vector<char>& is_cut) {
  Opened_input result = cut_open(in, is_cut.empty() ? cut_to_disk(in) : is_cut);
  if (!is_cut.empty()) internal::expect_disks(result.input.mesh);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

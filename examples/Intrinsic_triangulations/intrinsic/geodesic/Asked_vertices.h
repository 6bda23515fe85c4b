// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_ASKED_VERTICES_H
#define INTRINSIC_GEODESIC_ASKED_VERTICES_H

#include "../options.h"
#include "asked_curves.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Edge_path_finder.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace program {

/// Finds the vertices that were asked for, and inserts those that are inside of faces of the mesh.
template <class Triangulation>
class Asked_vertices {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Vertices = std::vector<Vertex>;

public:
  /// finds them on a triangulation.
  Asked_vertices(Triangulation& t, const Options& options) : t_(t), options_(options) {}

  /// finds the points of a curve, in order. \throws std::runtime_error naming the element that cannot be one
  Vertices operator()(const Asked_curve& curve) {
    Vertices result;
    for (const Asked_point& p : curve.points) {
      const Vertex v = p.is_vertex ? vertex_in_file(p.element, result) : vertex_in_face(p, curve);
      if (halfedge(v, t_.mesh()).index == IT::Gluing::none)
        throw std::runtime_error(curve.source + ": " + name(v) +
                                 " is isolated: no face has it; choose another");
      result.push_back(v);
    }
    return result;
  }

  /// names a vertex as the user does.
  std::string name(Vertex v) const {
    return t_.is_inserted(v)
               ? "a point inside of a face of " + options_.input
               : "vertex " + std::to_string(t_.input_vertex(v)) + " of " + options_.input;
  }

private:
  // On a cover, that copy of a vertex to which edges lead from the point before, if there is one.
  Vertex vertex_in_file(std::uint32_t number, const Vertices& before) const {
    const IT::Input_names& names = t_.input().names();
    const Vertex first = t_.numbers().vertex_at(names.vertex(number));
    if (names.row_of_vertex.empty() || before.empty()) return first;
    IT::Edge_path_finder<Triangulation> find(t_);
    const auto [begin, end] =
        std::equal_range(names.row_of_vertex.begin(), names.row_of_vertex.end(), number);
    for (auto copy = begin; copy != end; ++copy) {
      const Vertex v = t_.numbers().vertex_at(
          names.vertices.here(static_cast<std::uint32_t>(copy - names.row_of_vertex.begin())));
      if (v != before.back() && !find(before.back(), v).empty()) return v;
    }
    return first;
  }

  Vertex vertex_in_face(const Asked_point& p, const Asked_curve& curve) {
    const std::string face =
        curve.source + ": face " + std::to_string(p.element) + " of " + options_.input;
    std::uint32_t triangle = p.element;
    const IT::Input_names& names = t_.input().names();
    if (const std::vector<std::uint32_t>& polygon = names.polygon_of_triangle; !polygon.empty()) {
      const auto [begin, end] = std::equal_range(polygon.begin(), polygon.end(), p.element);
      if (end == begin)
        throw std::runtime_error(face + " has no three different vertices; choose another");
      if (end - begin != names.sheets)
        throw std::runtime_error(face + " is a polygon, in which barycentric coordinates name no "
                                        "point; triangulate it before");
      triangle = static_cast<std::uint32_t>(begin - polygon.begin());
    }
    const std::uint32_t first = t_.input().halfedge_of_face(names.faces.here(triangle));
    const auto v = IT::insert_point(t_, IT::Surface_point{first, p.weights});
    if (v.status != IT::Move_status::done)
      throw std::runtime_error(face + " has no room for a vertex at that point; choose another");
    return v.vertex;
  }

  Triangulation& t_;
  const Options& options_;
};

} // namespace program

#endif // INTRINSIC_GEODESIC_ASKED_VERTICES_H

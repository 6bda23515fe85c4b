// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_GEODESIC_ASKED_VERTICES_H
#define INTRINSIC_GEODESIC_ASKED_VERTICES_H

#include "../options.h"
#include "asked_curves.h"

#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/queries/Copies_of_curve.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

/// Finds the points that the command line names, and inserts vertices for points inside faces.
template <class Triangulation>
class Asked_vertices {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Vertices = std::vector<Vertex>;

public:
  /// finds them on a triangulation.
  Asked_vertices(Triangulation& t, const Options& options) : t_(t), options_(options) {}

  /// finds the points of a curve, in order.
  /// \throws std::runtime_error naming an element that cannot be one
  Vertices operator()(const Asked_curve& curve) {
    std::vector<Vertices> copies; // of each point
    for (const Asked_point& p : curve.points) {
      copies.push_back(p.is_vertex ? IT::internal::copies_of_row(t_, p.element)
                                   : vertices_in_face(p, curve));
      for (const Vertex v : copies.back())
        if (halfedge(v, t_.mesh()).index == IT::Gluing::none)
          throw std::runtime_error(curve.source + ": " + name(v) +
                                   " is isolated: no face has it; choose another");
    }
    if (t_.input().names().sheets > 1 && curve.kind != Curve_kind::source)
      return IT::internal::Copies_of_curve<Triangulation>(t_, copies, curve.is_loop).chosen();
    Vertices result;
    for (const Vertices& v : copies) result.push_back(v.front());
    return result;
  }

  /// names a vertex as the user does.
  std::string name(Vertex v) const {
    return t_.is_inserted(v)
               ? "a point inside of a face of " + options_.input
               : "vertex " + std::to_string(t_.input_vertex(v)) + " of " + options_.input;
  }

private:
  // On a cover, one on each sheet.
  Vertices vertices_in_face(const Asked_point& p, const Asked_curve& curve) {
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
    Vertices result;
    for (const auto& v : IT::insert_point_on_sheets(t_, IT::Surface_point{first, p.weights})) {
      if (v.status != IT::Move_status::done)
        throw std::runtime_error(face + " has no room for a vertex at that point; choose another");
      result.push_back(v.vertex);
    }
    return result;
  }

  Triangulation& t_;
  const Options& options_;
};

} // namespace program

#endif // INTRINSIC_GEODESIC_ASKED_VERTICES_H

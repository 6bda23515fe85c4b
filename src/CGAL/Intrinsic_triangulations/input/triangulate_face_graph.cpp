// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>
#include <CGAL/Intrinsic_triangulations/input/triangulate_face_graph.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

bool cut_polygon(Polygon_shaper& shaper, std::uint32_t face,
                 const std::vector<std::uint32_t>& corners,
                 const std::vector<std::array<double, 3>>& points,
                 std::vector<Polygon_shaper::Triangle>& triangles, Planar_polygons& planar) {
  std::vector<std::array<double, 3>> polygon;
  for (const std::uint32_t v : corners) polygon.push_back(points[v]);
  std::vector<std::uint32_t> sorted(corners);
  std::sort(sorted.begin(), sorted.end());
  shaper.load(std::move(polygon), std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());
  if (!shaper.triangulate(triangles)) return false;
  shaper.count(planar.report);
  if (shaper.is_flattened()) planar.add(face, corners, shaper.planar_points());
  return true;
}

Element_names names_of_sides(const Gluing_map& map,
                             const std::vector<std::uint32_t>& side_of_edge) {
  std::vector<std::uint32_t> user(map.number_of_edges(), Gluing::none);
  for (std::uint32_t e = 0; e < side_of_edge.size(); ++e) {
    if (side_of_edge[e] == Gluing::none) continue; // without faces
    user[map.sides({side_of_edge[e] / 3})[side_of_edge[e] % 3].index / 2] = e;
  }
  return Element_names(std::move(user));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

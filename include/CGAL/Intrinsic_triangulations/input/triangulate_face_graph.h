// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGULATE_FACE_GRAPH_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGULATE_FACE_GRAPH_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Glues the triangles of polygons: along diagonals within a polygon, along sides as the mesh has
// it.
class Polygon_gluing {
public:
  using Triangle = Polygon_shaper::Triangle;

  // `corners` and `sides` are the numbers of the vertices and of the halfedges that start there
  void add(const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& sides,
           const std::vector<Triangle>& triangles) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> diagonal;
    for (const Triangle& t : triangles)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t i = t[k], j = t[(k + 1) % 3];
        const auto h = static_cast<std::uint32_t>(gluing_.origin.size());
        gluing_.origin.push_back(corners[i]);
        gluing_.glue.push_back(Gluing::none);
        if (j == (i + 1) % corners.size()) {
          if (sides[i] >= side_.size()) side_.resize(sides[i] + std::size_t{1}, Gluing::none);
          side_[sides[i]] = h;
        } else if (const auto other = diagonal.find({j, i}); other != diagonal.end())
          glue(h, other->second);
        else
          diagonal.insert({{i, j}, h});
      }
  }

  // glues two halfedges of the mesh, of which at most one is on its border
  void glue_sides(std::uint32_t one, std::uint32_t other) {
    if (one < side_.size() && other < side_.size() && side_[one] != Gluing::none &&
        side_[other] != Gluing::none)
      glue(side_[one], side_[other]);
  }

  // returns the side of a triangle that a halfedge of the mesh is, if it has a face
  std::uint32_t side(std::uint32_t halfedge) const {
    return halfedge < side_.size() ? side_[halfedge] : Gluing::none;
  }

  Gluing take(std::uint32_t number_of_vertices) {
    gluing_.number_of_vertices = number_of_vertices;
    return std::move(gluing_);
  }

private:
  void glue(std::uint32_t h, std::uint32_t other) {
    gluing_.glue[h] = other;
    gluing_.glue[other] = h;
  }

  Gluing gluing_;
  std::vector<std::uint32_t> side_; // the side of a triangle that a halfedge of the mesh is
};

// the numbers of the halfedges around a face, and of the vertices that they start from
template <class FaceGraph>
void collect_sides(const FaceGraph& mesh,
                   typename boost::graph_traits<FaceGraph>::halfedge_descriptor first,
                   const Mesh_adaptor<FaceGraph>& number, std::vector<std::uint32_t>& sides,
                   std::vector<std::uint32_t>& corners) {
  sides.clear();
  corners.clear();
  typename boost::graph_traits<FaceGraph>::halfedge_descriptor h = first;
  do {
    sides.push_back(number.halfedge(h));
    corners.push_back(number.vertex(source(h, mesh)));
    h = next(h, mesh);
  } while (h != first);
}

// Triangulates a face with more than three sides, and keeps the planar polygon that takes its
// place. Returns false if it fails.
bool cut_polygon(Polygon_shaper& shaper, std::uint32_t face,
                 const std::vector<std::uint32_t>& corners,
                 const std::vector<std::array<double, 3>>& points,
                 std::vector<Polygon_shaper::Triangle>& triangles, Planar_polygons& planar);

// the edges of a gluing map that sides of its faces are, named by the place of the side in the list
Element_names names_of_sides(const Gluing_map& map, const std::vector<std::uint32_t>& side_of_edge);

} // namespace internal

/*!
\brief copies the connectivity of a mesh and cuts its polygonal faces into triangles.

Vertices keep their numbers. Planar polygons keep their shape. Nonplanar quadrilaterals are cut
along the diagonal where they bend less, others as their projection along the vector area; or they
become planar polygons.
\tparam FaceGraph a model of `FaceListGraph` and `HalfedgeListGraph`
\param mesh the mesh
\param points one point per vertex, in the order of iteration
\param kind what is made of polygons that are not planar
\param polygons set to the number of faces that are not triangles
\param names set to the edges and faces of `mesh` that those of the result come from
\param planar set to the polygons that became planar
\throws Invalid_input naming a face that cannot be triangulated
\complexity linear in the number of faces, for polygons of bounded size
*/
template <ReadableFaceGraph FaceGraph>
Gluing_map gluing_map_from_polygons(const FaceGraph& mesh,
                                    const std::vector<std::array<double, 3>>& points,
                                    Nonplanar_polygons kind, std::size_t& polygons,
                                    Input_names& names, Planar_polygons& planar) {
  using Traits = boost::graph_traits<FaceGraph>;
  const Mesh_adaptor<FaceGraph> number(mesh);
  std::vector<std::uint32_t> vertex(number.vertex_capacity(mesh), Gluing::none);
  std::uint32_t n = 0;
  for (const typename Traits::vertex_descriptor v : vertices(mesh)) vertex[number.vertex(v)] = n++;
  internal::Polygon_gluing gluing;
  internal::Polygon_shaper shaper(kind);
  std::vector<internal::Polygon_shaper::Triangle> triangles;
  std::vector<std::uint32_t> corners, sides, polygon_of_triangle;
  std::uint32_t f = 0;
  polygons = 0;
  const auto fail = [&f](const char* what) {
    throw Invalid_input::about(Element_kind::face, f, what);
  };
  for (const typename Traits::face_descriptor d : faces(mesh)) {
    internal::collect_sides(mesh, halfedge(d, mesh), number, sides, corners);
    for (std::uint32_t& v : corners) v = vertex[v];
    if (corners.size() < 3) fail(" has fewer than three sides; remove it");
    triangles.assign(1, {0, 1, 2});
    if (corners.size() > 3) {
      ++polygons;
      if (!internal::cut_polygon(shaper, f, corners, points, triangles, planar))
        fail(" is a polygon that cannot be triangulated; split it into triangles");
    }
    gluing.add(corners, sides, triangles);
    polygon_of_triangle.resize(polygon_of_triangle.size() + triangles.size(), f);
    ++f;
  }
  std::vector<std::uint32_t> side_of_edge;
  for (const typename Traits::edge_descriptor e : edges(mesh)) {
    const std::uint32_t one = number.halfedge(halfedge(e, mesh)),
                        other = number.halfedge(opposite(halfedge(e, mesh), mesh));
    gluing.glue_sides(one, other);
    side_of_edge.push_back(std::min(gluing.side(one), gluing.side(other)));
  }
  const Gluing_map result = Gluing_map::from_valid(gluing.take(n));
  names.polygon_of_triangle = std::move(polygon_of_triangle);
  names.edges = internal::names_of_sides(result, side_of_edge);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_TRIANGULATE_FACE_GRAPH_H

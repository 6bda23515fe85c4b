// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DOUBLED_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DOUBLED_SURFACE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Numbers sets of vertices that are joined by edges.
std::vector<std::uint32_t> components_of_vertices(const Gluing_map& mesh);

// A halfedge of each loop of the border that has flat vertices only.
std::vector<Gluing_map::Halfedge> loops_without_corner(const Gluing_map& mesh,
                                                       const std::vector<char>& is_flat);

/*
A surface, of which components are doubled that have curvature, or corners, and a loop of the
border without a corner: no vertex on such a loop is distinguished. Two copies of the component are
glued along these loops, where all vertices are flat then.

The exchange of the copies is an isometry of the double, so it keeps its Delaunay tessellation. No
vertex of that lies on a loop. So an edge that crosses a loop is its own image: it joins the two
copies of a vertex, at right angles to the loop, and crosses once. All other edges stay in one
copy. Polygons are disks, so that each loop is crossed. A polygon that a loop meets is its own
image, and the loop is its axis there, between the middles of two edges that cross. Hence an
isometry of doubles that keeps the copy of each vertex keeps the loops, and is one of the surfaces;
each of these extends to one.
*/
class Doubled_surface {
public:
  // \param is_flat of each vertex of the surface
  Doubled_surface(std::shared_ptr<const Input> surface, const std::vector<char>& is_flat);

  const Input& surface() const { return *surface_; }
  const std::shared_ptr<const Input>& shared_surface() const { return surface_; }
  // with copies; the surface itself if none is needed
  const std::shared_ptr<const Input>& input() const { return input_; }
  bool has_copies() const { return input_ != surface_; }

  // Vertices have copies after them.
  bool is_copy(std::uint32_t vertex) const { return vertex >= surface_->number_of_vertices(); }
  std::uint32_t on_surface(std::uint32_t vertex) const {
    return is_copy(vertex) ? vertex - surface_->number_of_vertices() : vertex;
  }
  Surface_point from_surface(const Surface_point& p) const;
  Surface_point on_surface(const Surface_point& p) const;

private:
  void glue_copies(const std::vector<char>& is_glued);
  // \param mesh with copies
  Input_metric metric(const Gluing_map& mesh) const;
  // the side that a side is or copies
  Face_side side_of_surface(const Face_side& s) const;

  std::shared_ptr<const Input> surface_, input_;
  std::vector<std::uint32_t> original_; // of each face of a copy
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_DOUBLED_SURFACE_H

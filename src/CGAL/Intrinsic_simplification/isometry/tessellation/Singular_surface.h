// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_SINGULAR_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_SINGULAR_SURFACE_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Doubled_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Moved_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The triangulation of the surface that the input has.
Corresponding_triangulation triangulation_of(std::shared_ptr<const Input> surface);

// Which vertices a tessellation has.
enum class Tessellation_vertices { all, not_flat };

/*
The Delaunay triangulation of a surface, and its tessellation: the edges between
cocircular faces are left out, and flat vertices if wanted.

Many flat vertices are removed from the input, whose faces lie in planes: faces of a Delaunay
triangulation run across creases, where lengths have roots of both sides. Flips after that take
about as long as removals. Few flat vertices are removed from the Delaunay triangulation, which is
fast to find; if lengths of edges that moves have made depend on irrational ones then, the input is
tried, too, unless that takes many moves. What one way cannot decide, the other one may.

A component with a border and no curvature, not even corners, is a flat cylinder, by Gauss and
Bonnet. Each of its two borders keeps a vertex, which may be any. So it has two faces, each with one
side on the border, and no ties. The lengths of the other two edges are arbitrary, but each face has
half of the area: that and the length of the border tell cylinders apart.

Of other surfaces, a component whose border has a loop without a corner is doubled, see
`Doubled_surface`: then this is the tessellation of the double.
*/
class Singular_surface {
public:
  Singular_surface(Corresponding_triangulation t, Tessellation_vertices vertices,
                   Isometry_run& run);
  Singular_surface(const Singular_surface&) = delete;
  Singular_surface& operator=(const Singular_surface&) = delete;

  const Input& surface() const { return doubled_ ? doubled_->surface() : start_->input(); }
  // the triangulation from which vertices were removed, or a Delaunay one
  const Corresponding_triangulation& start() const { return *start_; }
  const Moved_triangulation& triangulation() const { return *moved_; }
  const Dart_complex& darts() const { return *darts_; }
  const std::vector<char>& ties() const { return ties_; }
  std::uint32_t number_of_flat_vertices() const { return number_of_flat_vertices_; }
  // what could not be decided; empty if everything was proven
  const std::string& open() const { return open_; }
  // the continuous part of the group of isometries; empty if there is none
  const std::string& continuous_part() const { return continuous_part_; }
  bool is_proven() const { return open_.empty(); }
  // whether the caller has ended the computation
  bool is_ended() const { return is_ended_; }

  // the vertex of the surface where a halfedge starts
  std::uint32_t source(std::uint32_t halfedge) const {
    const std::uint32_t v = moved_->mesh().source(Gluing_map::Halfedge{halfedge}).index;
    return doubled_ ? doubled_->on_surface(v) : v;
  }
  // how many ends of an edge are copies
  std::uint32_t number_of_copied_ends(std::uint32_t edge) const {
    const Gluing_map::Halfedge h{2 * edge};
    const auto count = [this](Gluing_map::Vertex v) {
      return doubled_ && doubled_->is_copy(v.index) ? 1U : 0U;
    };
    return count(moved_->mesh().source(h)) + count(moved_->mesh().target(h));
  }
  Value_recipes::Id length(std::uint32_t dart) const {
    return moved_->length(darts_->halfedge[dart] / 2);
  }
  // Whether a vertex lies on a flat cylinder, see above.
  bool is_on_cylinder(std::uint32_t vertex) const {
    return !is_on_cylinder_.empty() && is_on_cylinder_[vertex] != 0;
  }
  bool has_cylinder() const {
    return std::find(is_on_cylinder_.begin(), is_on_cylinder_.end(), 1) != is_on_cylinder_.end();
  }
  bool is_on_cylinder(Gluing_map::Halfedge h) const {
    return is_on_cylinder(moved_->mesh().source(h).index);
  }
  // The number that isometric surfaces have in common at an edge: its squared length, or the
  // quadruple area of a face where the edge crosses a cylinder.
  Value_recipes::Id measure(std::uint32_t edge) const {
    return crosses_cylinder(edge)
               ? moved_->area(moved_->mesh().face(Gluing_map::Halfedge{2 * edge}).index)
               : moved_->length(edge);
  }
  bool crosses_cylinder(std::uint32_t edge) const {
    const Gluing_map::Halfedge h{2 * edge};
    return moved_->has_diamond(h) && is_on_cylinder(h);
  }
  // Of the two sides of a cylinder on its border, the same one for each halfedge of its faces:
  // points are mapped relative to it, since where the vertex of the other border lies is arbitrary.
  std::uint32_t border_of_cylinder(std::uint32_t halfedge) const;
  // edges whose faces are cocircular up to a relative error: the weight is at
  // most so far from zero
  std::vector<char> ties_within(double error) const;

  // takes points of the surface to the triangulation, and back
  std::vector<Surface_point> from_surface(std::span<const Surface_point> points) const;
  std::vector<Surface_point> to_surface(std::span<const Surface_point> points) const;

  // the tessellation of the surface, without copies, with all of its vertices
  std::shared_ptr<const Singular_surface> with_all_vertices(Isometry_run& run) const;

private:
  enum class Start { input, delaunay };

  // Doubles the surface where that is needed. \return which vertices are to be removed
  std::vector<char> removable_vertices();
  void choose_vertices(std::vector<char>& are_removed);
  void make(const std::vector<char>& are_removed, Isometry_run& run);
  // \throws Undecidable also if flips from the input are more than `most_moves`
  void make_from(Start start, const std::vector<char>& are_removed, Isometry_run& run,
                 std::size_t most_moves = std::numeric_limits<std::size_t>::max());
  // begins again from the input; if that takes too long or ends without a proof, all stays
  void try_input(const std::vector<char>& are_removed, Isometry_run& run);
  void find_ties();
  // whether lengths of moved edges can be compared by their triangles
  bool have_chains() const;

  std::shared_ptr<const Input> input_; // of the triangulation
  std::optional<Doubled_surface> doubled_;
  std::unique_ptr<Corresponding_triangulation> start_;
  std::unique_ptr<Moved_triangulation> moved_;
  std::vector<char> ties_;           // by edge
  std::vector<char> is_on_cylinder_; // by vertex; empty if all vertices stay
  std::optional<Dart_complex> darts_;
  std::uint32_t number_of_flat_vertices_ = 0;
  std::string open_, continuous_part_;
  bool is_ended_ = false;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_SINGULAR_SURFACE_H

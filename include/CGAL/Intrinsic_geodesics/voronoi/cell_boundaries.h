// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_VORONOI_CELL_BOUNDARIES_H
#define CGAL_INTRINSIC_GEODESICS_VORONOI_CELL_BOUNDARIES_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/// A place on a side of a face where the cell changes.
struct Side_break {
  std::uint32_t side;   ///< a corner
  double parameter;     ///< from 0 at the source of the side to 1 at its target
  std::uint32_t before; ///< index of the cell before it
  std::uint32_t after;  ///< index of the cell after it
};

/// A straight piece of the boundary between two cells, in a face.
struct Boundary_segment {
  std::array<std::uint32_t, 2> nodes; ///< where it begins and ends; pieces join at nodes
  std::array<Path_place, 2> places;   ///< the same in the face
  std::uint32_t left;                 ///< index of the cell on its left
  std::uint32_t right;                ///< index of the cell on its right
};

/// A place where boundaries meet.
struct Boundary_junction {
  std::uint32_t node;                 ///< its number
  Path_place place;                   ///< where it is
  std::vector<std::uint32_t> sources; ///< the cells around it, clockwise
};

/// A line of pieces that follow each other.
struct Boundary_line {
  std::vector<Boundary_segment> segments; ///< in order
  bool is_closed;                         ///< whether the last joins the first
};

/// Cells of a surface, in scaled units.
struct Cell_partition {
  std::vector<Side_break>
      breaks;              ///< on sides, one for both sides of an edge, in order; the numbers
                           ///< of these nodes are their indices
  std::uint32_t nodes = 0; ///< number of nodes
  std::vector<Boundary_segment> segments;   ///< in any order
  std::vector<Boundary_junction> junctions; ///< by the numbers of their nodes
  std::vector<double> areas;                ///< per cell
  bool is_complete = true;                  ///< whether rounding has never hidden how lines go on
};

/// finds the boundaries of cells, in faces and across edges, from the cell of each source.
/// `tolerance` is in scaled units. \pre windows are kept
Cell_partition cell_boundaries(const Distance_field& field,
                               std::span<const std::uint32_t> cell_of_source, double tolerance);

/// returns a thousandth of the mean length of the sides, in scaled units.
double default_cell_tolerance(const Corner_table& table);

/// joins the pieces to lines, which end at junctions or on the border.
std::vector<Boundary_line> joined_lines(const Cell_partition& partition);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_VORONOI_CELL_BOUNDARIES_H

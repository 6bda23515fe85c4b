// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_VORONOI_FACE_DIVIDER_H
#define CGAL_INTRINSIC_GEODESICS_VORONOI_FACE_DIVIDER_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Weighted_site.h>
#include <CGAL/Intrinsic_geodesics/voronoi/cell_boundaries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Boundaries of cells in one face.

**Why nothing is missed.** A shortest path to a point of a cell stays in the cell, and is straight
in the face until it leaves it. So in any convex part of the face without a source inside, each
piece of a cell reaches the boundary of the part. The labels along that boundary, which are exact,
tell all: if there is one, it is the label of all of the part; if there are two places where labels
change, one line joins them; if there are three, three lines meet in a point.

**How lines are found.** A part is cut in two until it has at most two changes, or is as small as
the tolerance: then lines meet in the middle of the changes. Two changes are joined by a straight
line if no label changes along the lines beside it, at the distance of the tolerance: then the exact
line is between them.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// A point on the boundary of a part of a face.
struct Part_corner {
  Plane_point point;                 ///< in the frame of the first side of the face
  std::uint32_t label;               ///< cell of what follows on the boundary
  std::uint32_t node = Gluing::none; ///< where the label changes, the number of this place
  std::uint32_t side = Gluing::none; ///< the side of the face on which that place is, or none
  double parameter = 0;              ///< where on that side
};

/// A convex part of a face, counterclockwise.
using Face_part = std::vector<Part_corner>;

/*!
\brief finds the boundaries of cells in faces.
*/
class Face_divider {
public:
  /// writes to a partition. `tolerance` is that of lines, in scaled units.
  Face_divider(const Labelled_field& labelled, double tolerance, Cell_partition& partition)
      : labelled_(labelled), table_(labelled.field.table), given_tolerance_(tolerance),
        out_(partition) {}

  /// divides a face along the boundary of which labels are known.
  void divide(std::uint32_t face, const Face_part& whole);

private:
  using Sites = std::vector<Weighted_site>;
  // What a line cuts off a part, on its left and on its right.
  struct Halves {
    bool is_cut = false;
    Face_part left, right;
  };
  // A line, and the direction to its left.
  struct Line {
    Plane_point point, left;
  };

  void divide(const Face_part& part, const Sites& sites, std::vector<Plane_point> sources,
              unsigned depth);
  void cut_and_divide(const Face_part& part, const Sites& sites,
                      const std::vector<Plane_point>& sources, const std::vector<Line>& lines,
                      unsigned depth);
  Halves cut(const Face_part& part, const Sites& sites, const Line& line);
  bool is_straight(const Face_part& part, const Sites& sites, const Part_corner& p,
                   const Part_corner& q) const;
  void join(const Face_part& part, std::size_t p, std::size_t q);
  void meet(const Face_part& part, const std::vector<std::size_t>& changes);
  void add_segment(const Part_corner& from, const Part_corner& to, std::uint32_t left,
                   std::uint32_t right);
  void add_area(std::uint32_t label, double area);
  Path_place place(const Part_corner& c) const;

  const Labelled_field& labelled_;
  const Corner_table& table_;
  double given_tolerance_;
  Cell_partition& out_;
  std::uint32_t face_ = 0;
  Plane_point axis_{1, 0}; // of its boxes
  double tolerance_ = 0;   // in this face
  double shortest_ = 0;    // part of a cut that counts
  std::size_t parts_ = 0;
  bool is_flat_ = false; // it has an area of zero, within rounding
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_VORONOI_FACE_DIVIDER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_FINDING_FOUND_CURVES_H
#define CGAL_INTRINSIC_GEODESICS_FINDING_FOUND_CURVES_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/finding/Wanted_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/*!
\file
How `find_curves()` works, and what it has found.
*/

namespace CGAL::Intrinsic_triangulations {

/// What `find_curves()` is doing.
enum class Curve_stage : std::uint8_t {
  paths_on_faces, ///< shortest paths on the faces below a cover; it counts windows
  paths,          ///< the other paths; it counts flips
  shortening,     ///< all of them are shortened; it counts flips
  certificate     ///< it decides exactly whether they are geodesic, and traces them
};

/// How `find_curves()` finds curves.
struct Find_curves_options {
  bool is_along_edges = false;      ///< whether curves start along edges, and cannot cross
  bool are_edges = false;           ///< whether all are edges, also of a double cover
  bool is_certified = true;         ///< whether to decide exactly whether they are geodesic
  bool is_traced = true;            ///< whether the points of ways are wanted
  bool keeps_initial = false;       ///< whether those before shortening are wanted
  double relative_length = 0;       ///< see `shorten_curves()`
  double minimum_joint_angle = 180; ///< see `shorten_curves()`
  /// Is called with what is done, and how much of it; returns whether to go on.
  std::function<bool(Curve_stage, std::uint64_t)> progress;

  /// tells whether each curve can be found as if the others were not there.
  bool is_alone() const {
    return !is_along_edges && relative_length == 0 && minimum_joint_angle == 180;
  }
};

/// A curve that was found.
struct Found_curve {
  /// Its way over the input: one point if it has contracted. Its status is `done` if it is
  /// geodesic; `inaccurate` if it is, but rounding hid shortest paths, so that it may be longer;
  /// `contracted`; or why it is none of these.
  Traced_curve way;
  bool is_loop = false;      ///< whether it was asked to return to its start
  bool is_on_faces = false;  ///< whether it is on the faces below a cover, and no edges
  double initial_length = 0; ///< its length before it was shortened
  Traced_curve initial;      ///< its way before that, if it was wanted; a tree has none
  /// The row of the user's vertex that it has contracted to; `Gluing::none`: there is none.
  std::uint32_t contracted_to = Gluing::none;

  /// tells whether its way returns to its first point.
  bool is_closed() const { return is_loop && way.status != Status::contracted; }
};

/// What `find_curves()` has found.
struct Found_curves {
  /// Chains of marked edges, then the curves in their order; a tree has one for each vertex.
  std::vector<Found_curve> curves;
  double length = 0;            ///< of all curves
  double initial_length = 0;    ///< of all, before they were shortened
  std::size_t joints = 0;       ///< number of joints of curves along edges
  Shortening_result shortening; ///< what was done; `cancelled`: there are no curves
  bool is_certified = false;    ///< whether all are proven to be geodesic
  std::string obstacle;         ///< why paths on faces are not certified; empty: they are
  /// How it ended: that of `shortening`, or `contracted` if all curves have shrunk to points.
  Status status = Status::done;
};

namespace internal {

// Says how a search for curves ended; nothing is kept of one that was cancelled.
inline void finish(Found_curves& found, bool is_cancelled) {
  Status& status = found.shortening.status;
  if (is_cancelled) {
    status = Status::cancelled;
    found.curves.clear();
  }
  const bool are_points =
      std::all_of(found.curves.begin(), found.curves.end(),
                  [](const Found_curve& c) { return c.way.status == Status::contracted; });
  found.status = are_points && status == Status::done ? Status::contracted : status;
}

} // namespace internal

/*!
\brief is the result of `find_curves()`: curves, and the edges along them.
\tparam Triangulation the type of the triangulation
*/
template <GeodesicTriangulation Triangulation>
struct Curves_along_edges : Found_curves {
  /// For each edge of the triangulation the number of the first curve along it, plus one; 0: none.
  Marked_edges<Triangulation, std::uint32_t> labels;
};

/*!
\brief returns curves as polylines in space, which `write_polylines()` writes.
\param t the triangulation
\param found what `find_curves()` found on it; polylines are labelled by the numbers of the curves
\param points coordinates of the vertices of the mesh that `t` was built from, in its order
\param way which way of the curves; the default is the one that was found
*/
template <CorrespondingTriangulation Triangulation>
std::vector<Polyline> polylines(const Triangulation& t, const Found_curves& found,
                                const std::vector<std::array<double, 3>>& points,
                                Traced_curve Found_curve::*way = &Found_curve::way) {
  std::vector<Polyline> lines;
  for (const Found_curve& c : found.curves) {
    Polyline line{{}, c.is_loop, static_cast<std::int32_t>(&c - found.curves.data())};
    for (const Surface_point& p : (c.*way).points)
      line.points.push_back(point_in_space(t, p, points));
    if (c.is_loop && line.points.size() > 1) line.points.pop_back(); // the start again
    if (!line.points.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

/*!
\brief cuts the surface of the user's mesh open along curves that are edges.
\param t the triangulation \param found what `find_curves()` found on it
\throws Invalid_input as the overload with marked edges, or if a curve has shrunk to a point
\complexity see there
*/
template <GeodesicTriangulation Triangulation>
  requires QueriedTriangulation<Triangulation> Cut_surface
  cut_along(const Triangulation& t, const Curves_along_edges<Triangulation>& found) {
    for (const Found_curve& c : found.curves)
      if (c.way.status == Status::contracted)
        throw Invalid_input(Element_kind::none, 0,
                            "curve " + std::to_string(&c - found.curves.data()) +
                                " has shrunk to a point, along which nothing can be cut; keep it "
                                "at its points (waypoints), or leave it out");
    return cut_along(t, found.labels);
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_FINDING_FOUND_CURVES_H

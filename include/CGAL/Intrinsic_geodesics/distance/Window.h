// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

/*!
\file
Windows: what a source sees through a side of a face, straight on, across all the faces before it laid out in the plane.

The frame of a side has its source at the origin and its target on the positive x-axis; the face that the window looks into
lies above, the image of the source below.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// Rays whose directions differ by less are not told apart: rounding may have made the difference. A path that
/// is taken for straight so is too short by no more than the square of it, relative to its length; except near
/// vertices that are as close together.
inline constexpr double window_angle_tolerance = 4e-13;

/// Distances that differ by less, relative to them, are not told apart.
inline constexpr double window_distance_tolerance = 0x1p-48;

/*!
\brief is an interval of a side that a source sees.
*/
struct Window {
  double begin;               ///< where the interval begins on the side, from its source on
  double end;                 ///< where it ends
  Plane_vector<double> image; ///< the source, in the frame of the side
  double offset;              ///< distance of the source from the nearest true one
  double begin_distance;      ///< from the image to the begin
  double end_distance;        ///< from the image to the end
  std::uint32_t side;         ///< a corner: the side of the face into which the window looks
  std::uint32_t source;       ///< number of the source: a vertex, or one in a face

  /// returns the least distance of a point of the interval from a true source.
  double least_distance() const {
    if (image.x >= begin && image.x <= end) return offset - image.y;
    return offset + std::min(begin_distance, end_distance);
  }
};

inline double planar_distance(const Plane_vector<double>& p, const Plane_vector<double>& q) {
  return std::sqrt(dot(p - q, p - q));
}

/*!
\brief is a face as a window sees it that looks into it: in the frame of the side.
*/
struct Window_face {
  const Face_corner& base;   ///< the side
  const Face_corner& right;  ///< the side after it
  const Face_corner& left;   ///< the side before it
  Plane_vector<double> apex; ///< the corner opposite the side

  Window_face(const Corner_table& table, std::uint32_t side)
      : base(table.corners[side]), right(table.corners[Corner_table::next(side)]),
        left(table.corners[Corner_table::previous(side)]), apex{left.length * base.cosine,
                                                                left.length * base.sine} {}
};

/// How the apex of a face lies to the rays of a window.
struct Apex_view {
  double distance;    ///< from the image
  double crossing;    ///< where the line from the image crosses the side
  double tolerance;   ///< how far crossings may be apart that are not told apart
  bool is_not_before; ///< it is not to the left of the window
  bool is_not_after;  ///< it is not to the right of the window
  bool is_near_begin; ///< it is on the left ray as far as can be told
  bool is_near_end;   ///< it is on the right ray as far as can be told

  Apex_view(const Window& w, const Window_face& f) : distance(planar_distance(w.image, f.apex)) {
    const double height = f.apex.y - w.image.y, below = -w.image.y / height;
    crossing = w.image.x + (f.apex.x - w.image.x) * below;
    const double least = window_angle_tolerance * distance / height;
    const double at_begin = least * w.begin_distance, at_end = least * w.end_distance;
    is_not_before = crossing >= w.begin - at_begin;
    is_not_after = crossing <= w.end + at_end;
    is_near_begin = crossing <= w.begin + 2 * at_begin;
    is_near_end = crossing >= w.end - 2 * at_end;
    tolerance = 2 * least * distance * below;
  }
  bool is_seen() const { return is_not_before && is_not_after; }
};

// Where the ray from an image through the point x of the side hits the line that leaves the corner at the origin at an angle:
// the distance from the corner.
inline double ray_hit(double x, Plane_vector<double> image, const Face_corner& angle) {
  const double hit = x * -image.y / ((image.x - x) * angle.sine - image.y * angle.cosine);
  return hit >= 0 ? hit : 0; // also if it is not a number
}

// The image in the frame of the side that leaves the corner at the origin at an angle.
inline Plane_vector<double> turned(Plane_vector<double> image, const Face_corner& angle) {
  return {image.x * angle.cosine + image.y * angle.sine,
          image.y * angle.cosine - image.x * angle.sine};
}

// Sets the distances to the ends of a window. Tells whether it is one. A source on the line of the side, as in faces of
// area zero, is put below it by as good as nothing: it sees everything through its own place, and nothing elsewhere.
inline bool measure_window(Window& w) {
  if (!(w.begin < w.end)) return false;
  w.image.y = std::min(w.image.y, -0x1p-80 * w.end);
  w.begin_distance = planar_distance(w.image, {w.begin, 0});
  w.end_distance = planar_distance(w.image, {w.end, 0});
  return true;
}

// What a window sees of the side on the left of the face, from its begin to `end`, or to the apex.
inline bool left_child(const Window& w, const Window_face& f, bool to_apex, Window& child) {
  if (f.left.opposite == Gluing::none) return false;
  child.image = turned(w.image, f.base);
  child.begin = ray_hit(w.begin, w.image, f.base);
  child.end = to_apex ? f.left.length : std::min(f.left.length, ray_hit(w.end, w.image, f.base));
  child.offset = w.offset;
  child.source = w.source;
  child.side = f.left.opposite;
  return measure_window(child);
}

// What a window sees of the side on the right of the face, from its begin or from the apex.
inline bool right_child(const Window& w, const Window_face& f, bool from_apex, Window& child) {
  if (f.right.opposite == Gluing::none) return false;
  // seen in the mirror, from the target of the side
  const double length = f.base.length;
  const Plane_vector<double> mirrored{length - w.image.x, w.image.y};
  const Plane_vector<double> image = turned(mirrored, f.right);
  child.image = {f.right.length - image.x, image.y};
  child.begin =
      from_apex ? 0 : std::max(0.0, f.right.length - ray_hit(length - w.begin, mirrored, f.right));
  child.end = std::max(0.0, f.right.length - ray_hit(length - w.end, mirrored, f.right));
  child.offset = w.offset;
  child.source = w.source;
  child.side = f.right.opposite;
  return measure_window(child);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H

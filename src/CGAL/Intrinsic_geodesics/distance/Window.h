// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstdint>

/*!
\file
Windows: what a source sees through a side of a face, straight on, across all faces before it, laid
out in the plane.

The frame of a side has its source at the origin and its target on the positive x-axis; the face
that the window looks into lies above, the image of the source below.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// Rays whose directions differ by less count as one: rounding may have made the difference. A path
/// that counts as straight so is too short by at most the square of it, relative to its length;
/// except near vertices that are as close together.
inline constexpr double window_angle_tolerance = 4e-13;

/// Distances that differ by less, relative to them, count as equal: by sixteen units in the last
/// place, for the rounding of two legs, a hypotenuse and sums.
inline constexpr double window_distance_tolerance = 0x1p-48;

/*!
\brief is an interval of a side that a source sees.
*/
struct Window {
  double begin;               ///< where the interval begins on the side, from its source on
  double end;                 ///< where it ends
  Plane_vector<double> image; ///< the source, in the frame of the side
  double offset;              ///< distance of the source from the nearest true one
  std::uint32_t source;       ///< number of the source: a vertex, or one in a face
  std::uint32_t next;         ///< another window that waits, see `Window_queue`

  /// returns the square of the distance from the image to a place on the side.
  double squared_distance(double place) const {
    return (place - image.x) * (place - image.x) + image.y * image.y;
  }
};

/// Squares of the distances from the image of a window to the ends of its interval.
struct Squared_rays {
  double begin; ///< to the begin
  double end;   ///< to the end

  explicit Squared_rays(const Window& w)
      : begin(w.squared_distance(w.begin)), end(w.squared_distance(w.end)) {}
  /// returns the square of the least distance of a point of the interval.
  double least(const Window& w) const {
    const bool is_inside = ((w.image.x >= w.begin) & (w.image.x <= w.end)) != 0;
    const double at_ends = std::min(begin, end), inside = w.image.y * w.image.y;
    return is_inside ? inside : at_ends;
  }
  /// returns whether all paths through the window are longer than others by way of the ends of the
  /// side, which have the given distances.
  bool are_useless(const Window& w, double at_source, double at_target, double length) const {
    const double by_source = at_source + w.end - w.offset;
    const double by_target = at_target + (length - w.begin) - w.offset;
    constexpr double least = 1 - 2 * window_distance_tolerance;
    // bits, as branches would be predicted wrongly
    return ((std::min(by_source, by_target) < 0) | (by_source * by_source < end * least) |
            (by_target * by_target < begin * least)) != 0;
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

/// How the apex of a face lies to the rays of a window. Squares decide, without roots.
struct Apex_view {
  double crossing;         ///< where the line from the image crosses the side
  double below;            ///< the part of that line that is below the side
  double squared_distance; ///< of the apex from the image
  double squared_height;   ///< of the apex above the image
  bool is_not_before;      ///< it is not to the left of the window
  bool is_not_after;       ///< it is not to the right of the window

  Apex_view(const Window& w, const Squared_rays& rays, const Window_face& f) {
    const Plane_vector<double> up = f.apex - w.image;
    below = -w.image.y / up.y;
    crossing = w.image.x + up.x * below;
    squared_distance = dot(up, up);
    squared_height = up.y * up.y;
    is_not_before = is_positive(crossing - w.begin, rays.begin);
    is_not_after = is_positive(w.end - crossing, rays.end);
  }
  bool is_seen() const { return (is_not_before & is_not_after) != 0; }
  /// whether it is on the left ray, within rounding
  bool is_near_begin(const Window& w, const Squared_rays& rays) const {
    return is_positive(w.begin - crossing, 4 * rays.begin);
  }
  /// whether it is on the right ray, within rounding
  bool is_near_end(const Window& w, const Squared_rays& rays) const {
    return is_positive(crossing - w.end, 4 * rays.end);
  }
  /// whether its line crosses the side where another one does, within rounding
  bool is_near(double other_crossing) const {
    return is_positive(-std::abs(crossing - other_crossing), 4 * squared_distance * below * below);
  }

private:
  // whether a difference is positive, or rounding may have made it negative at a distance from the
  // image
  bool is_positive(double x, double square) const {
    constexpr double tolerance = window_angle_tolerance * window_angle_tolerance;
    return ((x >= 0) | (x * x * squared_height <= tolerance * squared_distance * square)) != 0;
  }
};

// Where the ray from an image through the point x of the side hits the line that leaves the corner
// at the origin at an angle: the distance from the corner.
inline double ray_hit(double x, Plane_vector<double> image, const Face_corner& angle) {
  const double hit = x * -image.y / ((image.x - x) * angle.sine - image.y * angle.cosine);
  return hit >= 0 ? hit : 0; // also if it is not a number
}

// The image in the frame of the side that leaves the corner at the origin at an angle.
inline Plane_vector<double> turned(Plane_vector<double> image, const Face_corner& angle) {
  return {image.x * angle.cosine + image.y * angle.sine,
          image.y * angle.cosine - image.x * angle.sine};
}

// Whether a window is not empty. A source on the line of the side, as in faces of area zero, moves
// below it by almost nothing: it sees everything through its own place, and nothing elsewhere.
inline bool is_window(Window& w) {
  w.image.y = std::min(w.image.y, -0x1p-80 * w.end);
  return w.begin < w.end;
}

// What a window sees of the side on the left of the face, from its begin to `end`, or to the apex.
inline bool left_child(const Window& w, const Window_face& f, bool to_apex, Window& child) {
  if (f.left.opposite == Gluing::none) return false;
  child.image = turned(w.image, f.base);
  child.begin = ray_hit(w.begin, w.image, f.base);
  child.end = to_apex ? f.left.length : std::min(f.left.length, ray_hit(w.end, w.image, f.base));
  child.offset = w.offset;
  child.source = w.source;
  return is_window(child);
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
  return is_window(child);
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief keeps the windows that look into faces, 32 bytes each, in a list per side.

The ends of intervals are rounded outwards to multiples of 2^-32 of the side, the ends of the side exactly. A path through
what is added to an interval passes a vertex on the wrong side by that much: it is too short by the square of it, as a rule.
*/
class Stored_windows {
public:
  /// A window without what its side tells.
  struct Record {
    Plane_vector<double> image; ///< the source, in the frame of the side
    std::uint32_t begin;        ///< of the interval, in units of the side
    std::uint32_t end;          ///< of the interval
    std::uint32_t source;       ///< number of the source
    std::uint32_t next;         ///< another window of the side, or `Gluing::none`
  };

  /// forgets all windows, and makes room for those of a number of sides.
  void keep(std::size_t sides) {
    blocks_.clear();
    first_.assign(sides, Gluing::none);
    size_ = 0;
  }
  /// tells whether windows are kept.
  bool are_kept() const { return !first_.empty(); }
  /// adds a window to a side with a length.
  void add(const Window& w, std::uint32_t side, double length) {
    if (size_ % block_size == 0)
      blocks_.push_back(std::make_unique_for_overwrite<Record[]>(block_size));
    at(size_) = {w.image, rounded(w.begin / length * units), rounded(w.end / length * units + 1),
                 w.source, first_[side]};
    first_[side] = size_++;
  }
  /// calls a function with a window after the other that look through a side.
  template <class Function>
  void for_each(std::uint32_t side, const Function& f) const {
    for (std::uint32_t i = first_[side]; i != Gluing::none; i = at(i).next) f(at(i));
  }
  /// returns where an interval begins or ends on a side with a length.
  static double place(std::uint32_t end, double length) {
    return end == largest ? length : end / units * length;
  }
  /// returns the number of windows.
  std::size_t size() const { return size_; }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return blocks_.size() * block_size * sizeof(Record) + first_.size() * sizeof(std::uint32_t);
  }

private:
  static constexpr std::uint32_t block_size = 1U << 13U;
  static constexpr std::uint32_t largest = 0xffffffffU;
  static constexpr double units = largest;

  static std::uint32_t rounded(double x) { // downwards
    return static_cast<std::uint32_t>(std::clamp(x, 0.0, units));
  }
  Record& at(std::uint32_t i) const { return blocks_[i / block_size][i % block_size]; }

  std::vector<std::unique_ptr<Record[]>> blocks_;
  std::vector<std::uint32_t> first_; // per side
  std::uint32_t size_ = 0;
};

/// A point of a face.
struct Point_in_face {
  std::uint32_t side;            ///< a corner
  Plane_vector<double> point;            ///< in the frame of the side
  std::array<double, 3> weights; ///< of the source of the side, its target, and the apex
};

/// How the last piece of a shortest path comes to a point.
struct Arrival {
  enum class Kind : std::uint8_t {
    none,      ///< no path is known
    at_source, ///< the point is a source
    straight,  ///< straight from `image` through `side`, from an end of it, or from within the face
    copied     ///< the point is a copy of vertex `source` on a cover, where the path comes to
  };
  Plane_vector<double> image{0, 0};            ///< of the source, in the frame of `side`
  std::uint32_t side = Gluing::none;   ///< a corner
  std::uint32_t source = Gluing::none; ///< number of the source: a vertex, or one in a face
  Kind kind = Kind::none;

  /// returns the corner of a vertex to which a path comes straight: the apex seen from the side.
  std::uint32_t corner() const { return Corner_table::previous(side); }
};

/// A distance, and where it comes from.
struct Distance_and_arrival {
  double distance = std::numeric_limits<double>::infinity();
  Arrival arrival;
};

/*!
\brief is what window propagation finds: distances and last pieces of shortest paths at vertices, and the windows of all
faces, which tell the distances of all other points. In scaled units.
*/
struct Distance_field {
  Corner_table table;                         ///< the surface
  std::vector<Distance_and_arrival> vertices; ///< per vertex
  std::vector<Point_in_face>
      face_sources; ///< sources in faces: the i-th has the number of vertices plus i
  std::vector<std::uint32_t>
      sources_by_face;    ///< the indices of sources in faces, in the order of their faces
  Stored_windows windows; ///< what looks into faces, if it is kept: points in faces need it
  double radius = 0;      ///< distances up to this one are known

  /// starts without sources.
  explicit Distance_field(Corner_table t)
      : table(std::move(t)), vertices(table.first_corner.size()) {}

  /// forgets what was found, and has sources no more.
  void clear() {
    vertices.assign(vertices.size(), {});
    face_sources.clear();
    sources_by_face.clear();
    radius = 0;
  }
  /// returns how far the source of a window is from the nearest true one.
  double offset(std::uint32_t source) const {
    return source < vertices.size() ? vertices[source].distance : 0;
  }
  /// returns how many windows are looked through at most: there are more on bodies that are very thin.
  std::uint64_t default_cap() const { return 4000000 + 500 * std::uint64_t{table.corners.size()}; }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return table.corners.size() * sizeof(Face_corner) +
           vertices.size() * (sizeof(Distance_and_arrival) + sizeof(std::uint32_t)) +
           windows.bytes();
  }
  /// returns the sources in a face.
  std::span<const std::uint32_t> sources_in_face(std::uint32_t face) const {
    // no equal_range() of ranges: clang 14 refuses that of g++'s library
    const auto is_before = [this](std::uint32_t s, std::uint32_t f) {
      return face_sources[s].side / 3 < f;
    };
    const auto begin =
        std::lower_bound(sources_by_face.begin(), sources_by_face.end(), face, is_before);
    return {begin, std::lower_bound(begin, sources_by_face.end(), face + 1, is_before)};
  }
  /// returns a point in the frame of a side in that of another side of the face.
  Plane_vector<double> turned_to(std::uint32_t side, Plane_vector<double> p, std::uint32_t from) const {
    while (from != side) {
      const std::uint32_t n = Corner_table::next(from);
      // seen in the mirror, and turned about the target, where n starts
      const Plane_vector<double> back = turned({table.corners[from].length - p.x, p.y}, table.corners[n]);
      p = {back.x, -back.y};
      from = n;
    }
    return p;
  }
  /// returns the point of the face of a side with given weights of the source of the side, its target, and the apex.
  Point_in_face point(std::uint32_t side, const std::array<double, 3>& weights) const {
    const Window_face face(table, side);
    return {side,
            {weights[1] * face.base.length + weights[2] * face.apex.x, weights[2] * face.apex.y},
            weights};
  }
  /// finds the distance of a point of a face. \pre windows are kept
  Distance_and_arrival at(const Point_in_face& p) const {
    Distance_and_arrival best;
    const auto go_straight = [&](std::uint32_t side, Plane_vector<double> image, std::uint32_t source,
                                 double distance) {
      if (distance < best.distance)
        best = {distance, {image, side, source, Arrival::Kind::straight}};
    };
    const std::uint32_t face = p.side / 3;
    for (const std::uint32_t s : sources_in_face(face)) {
      const Plane_vector<double> q = turned_to(p.side, face_sources[s].point, face_sources[s].side);
      go_straight(p.side, q, static_cast<std::uint32_t>(vertices.size() + s),
                  planar_distance(q, p.point));
    }
    for (std::uint32_t side = 3 * face; side < 3 * face + 3; ++side) {
      const Plane_vector<double> q = turned_to(side, p.point, p.side), corner{0, 0};
      const std::uint32_t v = table.corners[side].origin;
      go_straight(side, corner, v, vertices[v].distance + planar_distance(q, corner));
      look_through(side, q, best);
    }
    return best;
  }

private:
  // Through the windows of a side.
  void look_through(std::uint32_t side, Plane_vector<double> p, Distance_and_arrival& best) const {
    const double length = table.corners[side].length;
    windows.for_each(side, [&](const Stored_windows::Record& w) {
      const double distance = offset(w.source) + planar_distance(w.image, p);
      if (!(distance < best.distance)) return;
      const double crossing = w.image.x + (p.x - w.image.x) * (-w.image.y / (p.y - w.image.y));
      const double tolerance = window_angle_tolerance * length;
      if (crossing < Stored_windows::place(w.begin, length) - tolerance ||
          crossing > Stored_windows::place(w.end, length) + tolerance)
        return;
      best = {distance, {w.image, side, w.source, Arrival::Kind::straight}};
    });
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H

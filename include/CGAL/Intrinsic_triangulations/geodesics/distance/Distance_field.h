// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Stored_windows.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Window.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/// A point of a face.
struct Point_in_face {
  std::uint32_t side;            ///< a corner
  Plane_vector<double> point;    ///< in the frame of the side
  std::array<double, 3> weights; ///< of the source of the side, its target, and the apex
};

/// How the last piece of a shortest path comes to a point.
struct Arrival {
  enum class Kind : std::uint8_t {
    none,      ///< no path is known
    at_source, ///< the point is a source
    straight,  ///< straight from `image` through `side`, or from within the face
    leaving,   ///< along `side`, from its target to its source
    following, ///< along `side`, from its source to its target
    copied     ///< the point is a copy of vertex `source` on a cover, where the path comes to
  };
  Plane_vector<double> image{0, 0};    ///< of the source, in the frame of `side`
  std::uint32_t side = Gluing::none;   ///< a corner
  std::uint32_t source = Gluing::none; ///< number of the source: a vertex, or one in a face
  Kind kind = Kind::none;
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
  Stored_windows windows; ///< what looks into faces
  double radius = 0;      ///< distances up to this one are known

  /// starts without sources.
  explicit Distance_field(Corner_table t)
      : table(std::move(t)), vertices(table.first_corner.size()), windows(table.corners.size()) {}

  /// returns how far the source of a window is from the nearest true one.
  double offset(std::uint32_t source) const {
    return source < vertices.size() ? vertices[source].distance : 0;
  }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return table.corners.size() * sizeof(Face_corner) +
           vertices.size() * (sizeof(Distance_and_arrival) + sizeof(std::uint32_t)) +
           windows.bytes();
  }
  /// returns the sources in a face.
  std::span<const std::uint32_t> sources_in_face(std::uint32_t face) const;
  /// returns a point in the frame of a side in that of another side of the face.
  Plane_vector<double> turned_to(std::uint32_t side, Plane_vector<double> p,
                                 std::uint32_t from) const;
  /// returns the point of the face of a side with given weights of the source of the side, its target, and the apex.
  Point_in_face point(std::uint32_t side, const std::array<double, 3>& weights) const;
  /// finds the distance of a point of a face.
  Distance_and_arrival at(const Point_in_face& p) const;

private:
  void look_through(std::uint32_t side, Plane_vector<double> p, Distance_and_arrival& best) const;
  void go_to_corner(std::uint32_t side, Plane_vector<double> p, Distance_and_arrival& best) const;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Distance_field_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_DISTANCE_FIELD_H

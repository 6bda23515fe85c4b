// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Distance_field.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Shortest paths, from the point back to the source. A piece of a path is a straight line in the plane from the point to the
image of the source, which is known: the faces along it are laid out one after the other, no window is looked for. Where the line
passes a vertex so closely that rounding may decide on which side, the path goes through the vertex, and on by the last piece
of the shortest path to that: a walk never loses its way.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// A point of a face: the side in whose order weights are given.
struct Path_place {
  std::uint32_t side;            ///< a corner
  std::array<double, 3> weights; ///< of the source of the side, its target, the apex
};

/*!
\brief follows a shortest path backwards.
*/
class Path_tracer {
public:
  /// starts.
  explicit Path_tracer(const Distance_field& field) : field_(field), table_(field.table) {}
  /// follows the path from a vertex.
  Status trace(std::uint32_t v);
  /// follows the path from a point in a face.
  Status trace(const Point_in_face& p);
  /// returns the path from the point to the source: every piece lies in the face of the place where it ends.
  const std::vector<Path_place>& places() const { return places_; }
  /// returns a direction in which the path leaves the last of its places, in the frame of the side
  /// there: far along the first piece of
  /// the path.
  Plane_vector<double> departure() const { return departure_; }

private:
  // A place of a straight line to the image of a source: both in the frame of a side, as the far
  // end of the line.
  struct Ray {
    std::uint32_t side;
    Plane_vector<double> from;
    Plane_vector<double> end;
    Plane_vector<double> image;
    std::uint32_t source;
    double tolerance;
  };
  enum class Step { crossed, at_vertex, at_source, lost };

  Status follow(Arrival arrival, Plane_vector<double> from);
  Step start(const Ray& ray);
  Step cross(Ray& ray);
  bool arrive(const Ray& ray, Step& step);
  bool arrive_at_corner(const Ray& ray);
  void turn_to(Ray& ray, std::uint32_t side) const;
  bool passes(const Ray& ray, Plane_vector<double> p) const;
  Arrival move_to(std::uint32_t corner, Plane_vector<double> departure = {0, 0});
  void end_at(const Ray& ray, const Path_place& place);
  std::uint32_t vertex() const { return table_.corners[places_.back().side].origin; }

  static constexpr std::size_t most_places = std::size_t{1} << 22U;

  const Distance_field& field_;
  const Corner_table& table_;
  std::vector<Path_place> places_;
  Plane_vector<double> departure_{0, 0};
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Path_tracer_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_SPREAD_WINDOWS_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_SPREAD_WINDOWS_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/// Vertices and points in faces, such as sources and targets. Their indices are by the order in
/// which they were added.
struct Places {
  /// A vertex or a point in a face.
  template <class Place>
  struct Numbered {
    Place place;
    std::uint32_t index;
  };
  std::vector<Numbered<std::uint32_t>> vertices; ///< by their numbers
  std::vector<Numbered<Point_in_face>> points;   ///< others

  /// returns how many there are.
  std::uint32_t size() const { return static_cast<std::uint32_t>(vertices.size() + points.size()); }
  /// adds a vertex.
  void add(std::uint32_t v) { add(v, size()); }
  /// adds a point in a face.
  void add(const Point_in_face& p) { add(p, size()); }
  /// adds a vertex with an index.
  void add(std::uint32_t v, std::uint32_t index);
  /// adds a point in a face with an index.
  void add(const Point_in_face& p, std::uint32_t index);
};

/// What stops a propagation early.
struct Propagation_limits {
  double radius = std::numeric_limits<double>::infinity();           ///< in scaled units
  std::uint64_t windows = std::numeric_limits<std::uint64_t>::max(); ///< number to look through
  Places targets; ///< if there are any, it stops once their distances are known
};

/// Memory of a propagation that the next one takes over, so that one that changes little costs
/// little. For surfaces with as many faces and vertices as the first one.
class Propagation_memory {
public:
  struct Arrays; ///< in the sources

  Propagation_memory();
  ~Propagation_memory();
  Propagation_memory(Propagation_memory&&) noexcept;
  Propagation_memory& operator=(Propagation_memory&&) noexcept;

  /// returns the arrays, as at the start of a propagation.
  Arrays& cleared(const Distance_field& field);
  /// returns the number of bytes held.
  std::size_t bytes() const;

private:
  std::unique_ptr<Arrays> arrays_; // null before the first propagation
};

/*!
\brief spreads windows from sources over the surface of a field.
\param field the surface; distances and windows are written there. Where it has distances already,
  as from other sources, windows go on only where they are nearer
\param sources where the distance is 0
\param limits when to stop
\param memory what propagations on this surface left
\param progress is called now and then, with the number of windows and the distance reached, and
  returns whether to go on
\return `done`, `cap` or `cancelled`, and the number of windows
*/
std::pair<Status, std::uint64_t>
spread_windows(Distance_field& field, const Places& sources, const Propagation_limits& limits,
               Propagation_memory& memory,
               const std::function<bool(std::uint64_t, double)>& progress);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_SPREAD_WINDOWS_H

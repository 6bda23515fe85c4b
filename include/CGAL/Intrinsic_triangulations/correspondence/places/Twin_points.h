// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TWIN_POINTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TWIN_POINTS_H

#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows the points of a cloud that are at the place of an earlier one, see
`make_point_cloud()`. They have no vertex with faces, and so no row of their own: their values are
those of their twins.

On surfaces that are no clouds there are none.
*/
class Twin_points {
public:
  /// finds them. \complexity linear in the number of vertices, n log n in that of twins
  template <NumberedTriangulation Triangulation>
  explicit Twin_points(const Triangulation& t) {
    const auto& points = t.input().metric().points();
    if (!t.input().names().is_cloud() || points.empty()) return;
    const auto has_faces = [&t](auto v) {
      return halfedge(v, t.mesh()) !=
             boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
    };
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> alone; // rows without faces
    for (const auto v : vertices(t.mesh()))
      if (!t.is_inserted(v) && !has_faces(v))
        alone[points[t.index(v)]].push_back(t.input_vertex(v));
    if (alone.empty()) return;
    for (const auto v : vertices(t.mesh())) {
      if (t.is_inserted(v) || !has_faces(v)) continue;
      const auto found = alone.find(points[t.index(v)]);
      if (found == alone.end()) continue;
      for (const std::uint32_t row : found->second) twins_[row] = t.input_vertex(v);
    }
  }

  /// returns the row that a point has: its own, or that of its twin.
  std::uint32_t row(std::uint32_t point) const {
    const auto found = twins_.find(point);
    return found == twins_.end() ? point : found->second;
  }

  /// copies the values of twins, in a vector, or the rows of a matrix or column of Eigen.
  template <class Values>
  void copy(Values& values) const {
    for (const auto& [point, row] : twins_) {
      if constexpr (requires { values.row(0); })
        values.row(point) = values.row(row);
      else
        values[point] = values[row];
    }
  }

private:
  std::map<std::uint32_t, std::uint32_t> twins_; // rows of points, and of the first ones there
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_PLACES_TWIN_POINTS_H

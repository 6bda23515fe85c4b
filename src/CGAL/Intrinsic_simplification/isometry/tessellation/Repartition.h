// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REPARTITION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REPARTITION_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations::internal {

// A face before or after a move, with points of one frame for both.
struct Moved_face {
  std::uint32_t face;
  std::array<std::uint32_t, 3> sides; // its halfedges
  std::array<Developed_faces::Point, 3> corners;
};

// A face, laid out in the plane.
struct Plane_face {
  std::uint32_t face;
  std::array<std::uint32_t, 3> sides;          // its halfedges
  std::array<Plane_vector<double>, 3> corners; // where each of them starts
  bool has_area = true;                        // not by doubles, which are rounded

  // barycentric coordinates of a point of the plane, those outside are negative; all are if the
  // face has no area
  std::array<double, 3> weights(const Plane_vector<double>& p) const {
    const auto area = [&](std::size_t k) {
      return cross(corners[(k + 1) % 3] - p, corners[(k + 2) % 3] - p);
    };
    const double all = cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (!has_area || !(all > 0)) return {-1, -1, -1};
    return {area(0) / all, area(1) / all, area(2) / all};
  }
  Plane_vector<double> place(const Surface_point& p) const {
    const std::size_t first = p.halfedge == sides[0] ? 0 : p.halfedge == sides[1] ? 1 : 2;
    Plane_vector<double> sum{0, 0};
    for (std::size_t k = 0; k < 3; ++k) sum = sum + p.weights[k] * corners[(first + k) % 3];
    return sum;
  }
};

// The point of the faces at a place in the plane; of the face that contains it
// best.
inline Surface_point point_at(std::span<const Plane_face> faces, const Plane_vector<double>& z,
                              std::uint32_t* its_face = nullptr) {
  double best = -1;
  Surface_point result;
  bool is_first = true;
  for (const Plane_face& f : faces) {
    std::array<double, 3> w = f.weights(z);
    const double least = *std::min_element(w.begin(), w.end());
    if (!is_first && !(least > best)) continue;
    is_first = false;
    best = least;
    for (double& x : w) x = std::max(x, 0.0);
    const double sum = w[0] + w[1] + w[2];
    result = sum > 0 ? Surface_point{f.sides[0], {w[0] / sum, w[1] / sum, w[2] / sum}}
                     : Surface_point{f.sides[0], {1, 0, 0}};
    if (its_face != nullptr) *its_face = f.face;
  }
  return result;
}

// A move: some faces of the plane become others, on the same region; at most three become one.
// Moves are many, and few of them are ever laid out.
struct Repartition {
  using Faces = boost::container::static_vector<Moved_face, 3>;
  Faces before, after;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_REPARTITION_H

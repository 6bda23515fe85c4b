// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_ASKED_VECTORS_H
#define INTRINSIC_PYTHON_ASKED_VECTORS_H

#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Vectors that the user gives at points.

namespace python {

/// Vectors at points: two coordinates in the tangent plane, or three in space.
struct Asked_vectors {
  /// \throws Invalid_input if there is not one vector per point
  Asked_vectors(std::vector<Place> at, const Doubles& array)
      : places(std::move(at)), vectors(matrix_of(array)) {
    if (vectors.rows() != static_cast<Eigen::Index>(places.size()))
      refuse("there must be a vector per point, " + std::to_string(places.size()) + ", not " +
             std::to_string(vectors.rows()));
    if (vectors.cols() != 2 && vectors.cols() != 3)
      refuse("vectors have two coordinates in the tangent plane or three in space, not " +
             std::to_string(vectors.cols()));
  }

  /// tells whether they are in tangent planes.
  bool are_in_planes() const { return vectors.cols() == 2; }
  /// tells whether all points are named as vertices, not as corners of faces.
  bool are_at_vertices() const { return std::ranges::none_of(places, &Place::has_face); }
  /// returns a vector in a tangent plane.
  std::complex<double> in_plane(std::size_t i) const {
    const auto r = static_cast<Eigen::Index>(i);
    return {vectors(r, 0), vectors(r, 1)};
  }
  /// returns a vector in space.
  Eigen::Vector3d in_space(std::size_t i) const {
    return vectors.row(static_cast<Eigen::Index>(i)).transpose();
  }

  std::vector<Place> places; ///< where they are
  Row_matrix vectors;        ///< a row for each
};

/// returns the numbers of points of a cloud and vectors in their tangent planes.
inline std::vector<std::pair<std::size_t, std::complex<double>>>
vectors_of_cloud(const IT::Point_cloud_vectors& cloud, const Asked_vectors& asked) {
  std::vector<std::pair<std::size_t, std::complex<double>>> result;
  for (std::size_t i = 0; i < asked.places.size(); ++i) {
    const Place& p = asked.places[i];
    if (!p.is_vertex()) refuse("a cloud of points has no faces; give the number of a point");
    std::complex<double> z = 0;
    if (asked.are_in_planes())
      z = asked.in_plane(i);
    else if (p.vertex < cloud.size()) {
      const auto& [x, y] = cloud.axes(p.vertex);
      z = {Eigen::Vector3d::Map(x.data()).dot(asked.in_space(i)),
           Eigen::Vector3d::Map(y.data()).dot(asked.in_space(i))};
    }
    result.push_back({p.vertex, z});
  }
  return result;
}

/// Finds vectors on a triangulation; on a cover, also those on the other sheet.
template <class Triangulation>
class Vector_finder {
public:
  using Vertex = typename Triangulation::vertex_descriptor; ///< vertex of the triangulation

  /// prepares the search on a triangulation and the points of its surface.
  Vector_finder(const Triangulation& t, const std::vector<Point>& points)
      : find_(t, points), sheets_(t) {}

  /// returns vertices, and vectors in their polar coordinates. \pre all points are vertices
  std::vector<std::pair<Vertex, std::complex<double>>> at_vertices(const Asked_vectors& asked) {
    std::vector<std::pair<Vertex, std::complex<double>>> result;
    for (std::size_t i = 0; i < asked.places.size(); ++i) {
      const auto [v, z] =
          asked.are_in_planes()
              ? std::pair(find_.places().vertex(asked.places[i].vertex), asked.in_plane(i))
              : sheets_.at_vertex(tangent(asked, i));
      const auto copies = sheets_(v, z);
      result.insert(result.end(), copies.begin(), copies.end());
    }
    return result;
  }

  /// returns vectors in faces of the triangulation.
  std::vector<IT::Tangent_vector> tangents(const Asked_vectors& asked) {
    std::vector<IT::Tangent_vector> result;
    for (std::size_t i = 0; i < asked.places.size(); ++i) {
      const auto copies = sheets_(tangent(asked, i));
      result.insert(result.end(), copies.begin(), copies.end());
    }
    return result;
  }

  /// returns what finds vectors on the other sheet.
  IT::Vectors_on_sheets<Triangulation>& sheets() { return sheets_; }

private:
  IT::Tangent_vector tangent(const Asked_vectors& asked, std::size_t i) {
    if (asked.are_in_planes()) return find_(asked.places[i], asked.in_plane(i));
    const Eigen::Vector3d v = asked.in_space(i);
    return find_(asked.places[i], Point{v[0], v[1], v[2]});
  }

  IT::Tangents_at_places<Triangulation> find_;
  IT::Vectors_on_sheets<Triangulation> sheets_;
};

} // namespace python

#endif // INTRINSIC_PYTHON_ASKED_VECTORS_H

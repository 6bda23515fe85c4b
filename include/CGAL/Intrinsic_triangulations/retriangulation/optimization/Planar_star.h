// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_PLANAR_STAR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_PLANAR_STAR_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
The faces about a flat interior vertex, laid out in the plane with the vertex at the origin: a
polygon that is star-shaped about it.
*/
class Planar_star {
public:
  /*!
  Lays out the faces about the source of a halfedge. Returns false if a face is missing, if an edge
  joins the vertex to itself, or if the total angle is not a full turn: the vertex cannot be moved.
  */
  template <NumberedComplex Complex>
  bool load(const Complex& complex, std::uint32_t first) {
    spokes_.clear();
    rim_.clear();
    double angle = 0;
    std::uint32_t h = first;
    do {
      if (complex.is_border(h) || complex.target(h) == complex.source(h)) return false;
      const double length = std::sqrt(complex.squared_length(h / 2));
      spokes_.push_back(h);
      rim_.push_back({length * std::cos(angle), length * std::sin(angle)});
      angle += angle_at_source(complex, h);
      h = next_around_source(complex, h);
    } while (h != first);
    return std::abs(angle - 2 * std::numbers::pi) < angle_tolerance;
  }

  /// The halfedges from the vertex, counterclockwise.
  const std::vector<std::uint32_t>& spokes() const { return spokes_; }

  /*!
  The mean of the circumcenters of the faces, weighted by their areas: where the energy of the star
  is least (Chen and Holst 2011, Equation 4.13).

  4 A c = (|a|^2 b_y - |b|^2 a_y, |b|^2 a_x - |a|^2 b_x) for the circumcenter c and the area A of
  the face (0, a, b): no division by an area that may be small.
  */
  Plane_vector<double> optimum() const;

  /// The least distance from a point to the lines along the sides of the rim; negative if the point
  /// is outside of one.
  double clearance(const Plane_vector<double>& p) const;

  /// The face that a point of the star is in, and its weights there; on an edge if it is close.
  std::optional<Surface_point> locate(const Plane_vector<double>& p) const;

private:
  // Angles are accurate to a few units in the last place for each face, unless it is a needle: this
  // is 10^9 times as much, and less than any cone that users make.
  static constexpr double angle_tolerance = 1e-6;
  // Weights below are zero, as those of circumcenters (`on_edge`): far above rounding, and far
  // below the least step.
  static constexpr double on_spoke = 0x1p-30;

  std::vector<std::uint32_t> spokes_;
  std::vector<Plane_vector<double>> rim_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_OPTIMIZATION_PLANAR_STAR_H

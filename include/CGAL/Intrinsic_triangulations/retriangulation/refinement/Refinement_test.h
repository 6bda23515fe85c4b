// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_options.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

/// What a face needs.
enum class Face_state {
  good,       ///< it meets the criteria
  bad,        ///< it does not, and can be refined
  needle,     ///< it does not: see `Unsatisfied_reason::needle`
  small_angle ///< it does not: see `Unsatisfied_reason::small_angle`
};

/*!
\brief decides whether faces meet the criteria of refinement (Algorithm 4 of the course), by signs that
exact traits decide exactly.

The bound of angles is the cotangent, rounded so that the angle is not below the one asked for.
*/
class Refinement_test {
public:
  /*!
  \brief prepares the test.
  \param options the criteria
  \param scale_exponent lengths are scaled by 2^scale_exponent
  \throws std::invalid_argument if a bound is not a number, not positive, or an angle of 60 degrees or more
  */
  Refinement_test(const internal::Refinement_options& options, int scale_exponent) {
    const double angle = options.minimum_angle;
    if (!(angle >= 0 && angle < 60))
      throw std::invalid_argument("the minimum angle must be at least 0 and below 60 degrees");
    if (!(options.maximum_circumradius > 0) || !(options.maximum_edge_length > 0))
      throw std::invalid_argument("the bounds of circumradius and edge length must be positive");
    if (angle > 0) cotangent_ = (1 - 0x1p-50) / std::tan(angle * std::numbers::pi / 180);
    squared_radius_ = squared(options.maximum_circumradius, scale_exponent);
    squared_length_ = squared(options.maximum_edge_length, scale_exponent);
  }

  /*!
  \brief decides about a face.
  \param metric the arithmetic
  \param face the face
  \param corners the vertices where its sides start
  \param segments the edges that are not flipped
  */
  template <class Metric>
  Face_state operator()(const Metric& metric, const Indexed_face& face,
                        const std::array<std::uint32_t, 3>& corners,
                        const Constrained_segments& segments) const {
    const std::span<const Indexed_face> faces(&face, 1);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (squared_radius_ < infinity &&
        metric.sign(faces, Large_circumradius_expression{squared_radius_}) == POSITIVE)
      return Face_state::bad;
    if (squared_length_ < infinity)
      for (std::size_t k = 0; k < 3; ++k)
        if (metric.sign(faces, Long_side_expression{k, squared_length_}) == POSITIVE)
          return Face_state::bad;
    Face_state state = Face_state::good;
    if (cotangent_ < infinity)
      for (std::size_t k = 0; k < 3; ++k) {
        if (metric.sign(faces, Small_angle_expression{k, cotangent_}) != POSITIVE) continue;
        state = why_small(face.edges, corners, k, segments);
        if (state == Face_state::bad) break;
      }
    return state;
  }

private:
  static double squared(double length, int scale_exponent) {
    return std::ldexp(length * length, 2 * scale_exponent);
  }

  // why the angle opposite side k is small
  Face_state why_small(const std::array<std::uint32_t, 3>& edges,
                       const std::array<std::uint32_t, 3>& corners, std::size_t k,
                       const Constrained_segments& segments) const {
    const std::uint32_t e = edges[(k + 1) % 3], f = edges[(k + 2) % 3];
    if (e == f) return Face_state::needle;
    if (segments.is_segment(e) && segments.is_segment(f)) return Face_state::small_angle;
    if (segments.are_across_small_angle(corners[k], corners[(k + 1) % 3], std::atan(1 / cotangent_),
                                        !segments.is_segment(edges[k])))
      return Face_state::small_angle;
    return Face_state::bad;
  }

  double cotangent_ = std::numeric_limits<double>::infinity();
  double squared_radius_, squared_length_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H

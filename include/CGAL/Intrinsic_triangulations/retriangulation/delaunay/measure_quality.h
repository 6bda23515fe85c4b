// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_QUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_QUALITY_H

#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief describes the shapes of the faces of a triangulation, up to rounding.
*/
struct Quality {
  /// Least angle, in degrees.
  double minimum_angle = 180;
  /// Greatest angle, in degrees.
  double maximum_angle = 0;
  /// Numbers of angles below 10 degrees, from 10 to 20, ..., from 170 up.
  std::array<std::size_t, 18> angles{};
  /// Greatest aspect ratio: circumradius by twice the inradius, 1 for equilateral faces.
  double maximum_aspect_ratio = 0;
  /// Mean of the aspect ratios.
  double mean_aspect_ratio = 0;
  /// Least cotangent weight of edges between two faces; infinite if there are none. Border edges
  /// have one cotangent, of any sign.
  double minimum_weight = std::numeric_limits<double>::infinity();
  /// Greatest cotangent weight of edges between two faces.
  double maximum_weight = -std::numeric_limits<double>::infinity();
  /// Numbers of cotangent weights of such edges below 0, from 0 to 1/4, ..., from 7/4 to 2, from 2
  /// up.
  std::array<std::size_t, 10> weights{};
};

/*!
\brief greatest relative error of the squared lengths, areas and cotangent weights that statistics
  are made of.

Used by `measure_quality()`, and by the program for sums. Pass it to `area()` and
`cotangent_weight()` of a triangulation to get such values. Stored values nearly always have this
accuracy; a smaller tolerance would make statistics take longer than all flips.
*/
inline constexpr double statistics_tolerance = 0x1p-30;

namespace internal {

// Counts angles, and finds the least and the greatest, up to rounding. Most are counted by their
// cotangents: arc tangents took a third of the time that all statistics take.
class Angle_counts {
public:
  explicit Angle_counts(Quality& q) : quality_(q) {
    for (std::size_t k = 0; k < limits_.size(); ++k)
      limits_[k] = 1 / std::tan(static_cast<double>(10 * (k + 1)) / degrees);
  }

  // adds the angle whose cotangent is `numerator / area`
  void add(double area, double numerator) {
    const double cotangent = numerator / area;
    // the angle in degrees, and limits, are rounded: what rounding may change is left to `angle()`
    const double slack = 0x1p-46 * (1 + cotangent * cotangent);
    std::size_t bin = 0;
    for (const double limit : limits_) bin += std::size_t{cotangent <= limit};
    const bool is_certain = area > 0 && std::abs(cotangent) < 0x1p20 &&
                            (bin == 0 || limits_[bin - 1] - cotangent > slack) &&
                            (bin == limits_.size() || cotangent - limits_[bin] > slack);
    if (is_certain && cotangent + slack < greatest_ && cotangent - slack > least_) {
      ++quality_.angles[bin];
      return;
    }
    greatest_ = std::max(greatest_, cotangent);
    least_ = std::min(least_, cotangent);
    const double angle = std::atan2(area, numerator) * degrees;
    quality_.minimum_angle = std::min(quality_.minimum_angle, angle);
    quality_.maximum_angle = std::max(quality_.maximum_angle, angle);
    ++quality_
          .angles[std::min<std::size_t>(17, static_cast<std::size_t>(std::max(0.0, angle) / 10))];
  }

private:
  static constexpr double degrees = 180 / std::numbers::pi;

  Quality& quality_;
  std::array<double, 17> limits_{}; // cotangents of 10 to 170 degrees
  double greatest_ = -std::numeric_limits<double>::infinity(),
         least_ = std::numeric_limits<double>::infinity();
};

template <class Triangulation>
void measure_faces(const Triangulation& t, Quality& q) {
  double sum = 0;
  Angle_counts angles(q);
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const auto [lengths, area] = accurate_values(t, f, statistics_tolerance);
    const auto [a, b, c] = lengths;
    for (const double numerator : {a + b - c, b + c - a, c + a - b}) angles.add(area, numerator);
    // R / (2 r) = l l' l'' (l + l' + l'') / a^2, a = 4A
    const double la = std::sqrt(a), lb = std::sqrt(b), lc = std::sqrt(c);
    const double ratio = la / area * lb * (lc / area) * (la + lb + lc);
    q.maximum_aspect_ratio = std::max(q.maximum_aspect_ratio, ratio);
    sum += ratio;
  }
  q.mean_aspect_ratio = sum / static_cast<double>(num_faces(t.mesh()));
}

// Counts the weights of edges between two faces. \param weight a functor of edges
template <class Triangulation, class Weight>
void measure_weights(const Triangulation& t, const Weight& weight, Quality& q) {
  const auto& mesh = t.mesh();
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if (face(h, mesh) == null || face(opposite(h, mesh), mesh) == null) continue;
    const double w = weight(e);
    q.minimum_weight = std::min(q.minimum_weight, w);
    q.maximum_weight = std::max(q.maximum_weight, w);
    ++q.weights[w < 0 ? 0 : w < 2 ? 1 + static_cast<std::size_t>(4 * w) : 9];
  }
}

} // namespace internal

/*!
\brief measures the shapes of all faces.
\tparam Triangulation a model of `MeasuredTriangulation`
\tparam Is_tie a functor from edges to `bool`
\param t the triangulation
\param is_tie tells which edges are known to be cocircular: their weight is zero, and exact traits
need not prove it again
\complexity linear
*/
template <MeasuredTriangulation Triangulation,
          std::predicate<typename Triangulation::edge_descriptor> Is_tie>
Quality measure_quality(const Triangulation& t, const Is_tie& is_tie) {
  Quality q;
  internal::measure_faces(t, q);
  const typename Triangulation::Const_session session(t);
  internal::measure_weights(
      t,
      [&](const typename Triangulation::edge_descriptor& e) {
        return is_tie(e) ? 0 : session.cotangent_weight(e, statistics_tolerance);
      },
      q);
  return q;
}

/*!
\brief measures the shapes of all faces.

See the overload with a functor.
*/
template <MeasuredTriangulation Triangulation>
Quality measure_quality(const Triangulation& t) {
  return measure_quality(t, [](const auto&) { return false; });
}

/*!
\brief returns the energy that optimal Delaunay triangulations minimize: the error of interpolating
|x|^2, integrated over the faces (Chen and Xu, Optimal Delaunay triangulations, 2004).

On a flat face the error is the sum of b_i b_j L_ij over its sides, in barycentric coordinates b,
whose integral is A (L_ij + L_jk + L_ki) / 12: the energy is intrinsic. Delaunay flips lower it, and
so does every vertex. For equilateral faces of total area A with sides l it is A l^2 / 4.
\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation
\return the energy, in the units of the input to the fourth power
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
double odt_energy(const Triangulation& t) {
  double energy = 0;
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const auto [l, area] = internal::accurate_values(t, f);
    energy += area * (l[0] + l[1] + l[2]);
  }
  return std::ldexp(energy / 48, -4 * t.metric().scale_exponent());
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_QUALITY_H

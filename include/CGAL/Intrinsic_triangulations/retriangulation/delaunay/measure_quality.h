// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_QUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_MEASURE_QUALITY_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/Summed_weights.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/config.hpp>
#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

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
// cotangents, without branches that depend on them: arc tangents took a third of the time that all
// statistics take, and signs that cannot be predicted a tenth.
class Angle_counts {
public:
  explicit Angle_counts(Quality& q) : quality_(q) {
    for (int k = 1; k < 18; ++k) {
      const double limit = k == 9 ? 0 : 1 / std::tan(10 * k / degrees);
      // rounding may move what is below 0 to the cell above
      const std::size_t last = cell_of(limit), first = k == 9 ? last - 1 : last;
      for (std::size_t i = first; i <= last; ++i) cells_[i].limit = limit;
      for (std::size_t i = 0; i < first; ++i) ++cells_[i].wider;
    }
  }

  // adds the angle whose cotangent is `numerator / area`
  // \param cotangent the same up to rounding
  BOOST_FORCEINLINE void add(double area, double numerator, double cotangent) {
    // the angle in degrees, and limits, are rounded: what rounding may change is left to
    // `add_angle()`
    const double slack = 0x1p-46 * (1 + cotangent * cotangent);
    const Cell& cell = cells_[cell_of(cotangent)];
    if (area > 0 && slack < 1 && cotangent + slack < greatest_ && cotangent - slack > least_ &&
        std::abs(cotangent - cell.limit) > slack)
      ++quality_.angles[cell.wider + std::size_t{cotangent <= cell.limit}];
    else
      add_angle(area, numerator, cotangent);
  }

private:
  static constexpr double degrees = 180 / std::numbers::pi;

  // Cotangents in a sixteenth, which has at most one of a multiple of 10 degrees.
  struct Cell {
    double limit = -std::numeric_limits<double>::infinity(); // that one, or less than all
    std::size_t wider = 0; // how many such cotangents are in cells above
  };
  // cot(10 degrees) < 6; of what is not a number any
  static std::size_t cell_of(double cotangent) {
    return static_cast<std::size_t>(std::max(0., std::min(191., 16 * cotangent + 96)));
  }

  BOOST_NOINLINE void add_angle(double area, double numerator, double cotangent) {
    greatest_ = std::max(greatest_, cotangent);
    least_ = std::min(least_, cotangent);
    const double angle = std::atan2(area, numerator) * degrees;
    quality_.minimum_angle = std::min(quality_.minimum_angle, angle);
    quality_.maximum_angle = std::max(quality_.maximum_angle, angle);
    ++quality_
          .angles[std::min<std::size_t>(17, static_cast<std::size_t>(std::max(0.0, angle) / 10))];
  }

  Quality& quality_;
  std::array<Cell, 192> cells_{};
  double greatest_ = -std::numeric_limits<double>::infinity(),
         least_ = std::numeric_limits<double>::infinity();
};

// Makes stored values accurate to `statistics_tolerance`. Nearly all are: so all intervals are
// looked at in their order first, and those of faces only if there is a wide one.
// \return the `relative_width()` afterwards
template <class Triangulation>
double sharpen_for_statistics(const Triangulation& t) {
  const double width = relative_width(t);
  if (width <= statistics_tolerance) return width;
  if constexpr (requires { t.decider().take_followed(statistics_tolerance); }) {
    const typename Triangulation::Metric::Scope scope; // enclosures are rounded outwards
    t.decider().take_followed(statistics_tolerance);
  }
  for (const typename Triangulation::face_descriptor f : faces(t.mesh()))
    accurate_values(t, f, statistics_tolerance);
  return relative_width(t);
}

// Measures all faces. \pre their values are accurate
// \param visit called with the numbers of each face, its values in scaled units, the inverse of its
//   area, and `cotangents_of()` these
template <class Triangulation, class Visit>
void measure_faces(const Triangulation& t, Quality& q, const Visit& visit) {
  double sum = 0;
  std::size_t count = 0; // `num_faces()` is of numbers, also of those that no face has any more
  Angle_counts angles(q);
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const Indexed_face face = indexed_face_from(t, halfedge(f, t.mesh()));
    const Face_values<double> values = approximate_values(t.metric(), face);
    const auto [lengths, area] = values;
    const auto [a, b, c] = lengths;
    const double inverse = 1 / area;
    const std::array<double, 3> cotangents = cotangents_of(values, inverse);
    angles.add(area, b + c - a, cotangents[0]);
    angles.add(area, c + a - b, cotangents[1]);
    angles.add(area, a + b - c, cotangents[2]);
    visit(face, values, inverse, cotangents);
    // R / (2 r) = l l' l'' (l + l' + l'') / a^2, a = 4A
    const double la = std::sqrt(a), lb = std::sqrt(b), lc = std::sqrt(c);
    const double ratio = la * inverse * lb * (lc * inverse) * (la + lb + lc);
    q.maximum_aspect_ratio = std::max(q.maximum_aspect_ratio, ratio);
    sum += ratio;
    ++count;
  }
  q.mean_aspect_ratio = sum / static_cast<double>(count);
}

// Counts the weight of an edge between two faces.
inline void add_weight(double w, Quality& q) {
  q.minimum_weight = std::min(q.minimum_weight, w);
  q.maximum_weight = std::max(q.maximum_weight, w);
  ++q.weights[w < 0 ? 0 : w < 2 ? 1 + static_cast<std::size_t>(4 * w) : 9];
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
  internal::Summed_weights<Triangulation> sums(t, internal::sharpen_for_statistics(t));
  internal::measure_faces(t, q, [&](const auto&... values) { sums.add(values...); });
  const auto& mesh = t.mesh();
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  const typename Triangulation::Const_session session(t);
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const auto h = halfedge(e, mesh);
    if (face(h, mesh) == null || face(opposite(h, mesh), mesh) == null) continue;
    if (is_tie(e))
      internal::add_weight(0, q);
    else if (const auto weight = sums.certain(t.index(e), statistics_tolerance))
      internal::add_weight(*weight, q);
    else
      internal::add_weight(session.cotangent_weight(e, statistics_tolerance), q);
  }
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

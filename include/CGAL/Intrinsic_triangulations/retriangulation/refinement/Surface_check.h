// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_SURFACE_CHECK_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_SURFACE_CHECK_H

#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// The squared quadruple area that the sides of a face span, in units of its longest side. Keeping
// the rounding errors, as `squared_quadruple_area()` does, would take longer than the rest of the
// check.
inline double spanned_area(const Face_values<double>& v) {
  const auto& [l, m, n] = v.squared_lengths;
  const double longest = std::max({l, m, n}), a = l / longest, b = m / longest,
               p = a + b - n / longest;
  return 4 * a * b - p * p;
}

// How far that is from the area of the face. Not a number or infinite if a value is.
inline double area_discrepancy(const Face_values<double>& v) {
  const auto& l = v.squared_lengths;
  const double area = v.quadruple_area / *std::max_element(l.begin(), l.end());
  return std::abs(area * area - spanned_area(v));
}

/*!
Checks whether an algorithm with rounding has kept the surface: construct it before, query it after.

A move replaces faces by others of the same area up to eight units in the last place of it, 2^-50,
as long as they are faces: a million moves on one spot stay within 2^-30 of the area, sums far
below. Wrong lengths do not span the area of their faces: if they fit it to 2^-16, so do the angles
of faces that are not thin.

With exact traits it does nothing; otherwise the time is linear. Before, it only reads areas and
lengths in the order of storage, a tenth of the time of `measure()`.
*/
template <class Triangulation>
class Surface_check {
public:
  explicit Surface_check(const Triangulation& t) : t_(t) {
    if constexpr (!Triangulation::Metric::is_exact) before_ = measure_before();
  }

  /// returns the damage since construction.
  std::optional<Inaccuracy> find_inaccuracy() const {
    if constexpr (!Triangulation::Metric::is_exact) {
      const Measure after = measure();
      const auto found = [&](Inaccuracy::Kind kind, std::uint32_t face) {
        return Inaccuracy{kind, face, in_input_units(before_.area), in_input_units(after.area)};
      };
      if (after.euler_characteristic != before_.euler_characteristic)
        return found(Inaccuracy::Kind::topology, after.worst_face);
      if (after.bad_faces > before_.bad_faces)
        return found(Inaccuracy::Kind::face, after.first_bad_face);
      if (after.discrepancy > shape_tolerance)
        return found(Inaccuracy::Kind::shape, after.worst_face);
      if (!(std::abs(after.area - before_.area) <= area_tolerance * before_.area))
        return found(Inaccuracy::Kind::total_area, after.worst_face);
    }
    return std::nullopt;
  }

  /// records the damage in the result of an algorithm.
  template <class Result>
  void conclude(Result& result) const {
    result.inaccuracy = find_inaccuracy();
    if (result.inaccuracy) result.status = Status::inaccurate;
  }

private:
  // 2^22 roundings: those of the areas of four million faces, if all have one sign
  static constexpr double area_tolerance = 0x1p-30;
  // of the area of a face: changes its angles by 1e-5, which users of doubles do not see
  static constexpr double shape_tolerance = 0x1p-16;

  struct Measure {
    long double area = 0;
    std::uint64_t bad_faces = 0;
    std::uint32_t first_bad_face = 0, worst_face = 0;
    double discrepancy = 0; // the largest
    std::int64_t euler_characteristic = 0;
  };

  // without discrepancies; faces are looked at one by one only if some are bad
  Measure measure_before() const {
    Measure m;
    double least = std::numeric_limits<double>::infinity(), greatest = 0;
    const auto note = [&](double x) {
      least = x > 0 ? std::min(least, x) : 0;
      greatest = std::max(greatest, x);
    };
    for (const auto f : faces(t_.mesh())) {
      const double area = t_.metric().approximate_quadruple_area(t_.index(f));
      m.area += area;
      note(area);
      ++m.euler_characteristic;
    }
    for (const auto e : edges(t_.mesh())) {
      note(t_.metric().approximate_squared_length(t_.index(e)));
      --m.euler_characteristic;
    }
    const auto& vertex_range = vertices(t_.mesh());
    m.euler_characteristic += std::distance(vertex_range.begin(), vertex_range.end());
    return least > 0 && std::isfinite(greatest) ? m : measure();
  }

  Measure measure() const {
    Measure m;
    for (const auto f : faces(t_.mesh())) {
      add(m, t_.index(f), approximate_values(t_, f));
      ++m.euler_characteristic;
    }
    // counted here, since meshes may count removed elements
    const auto& vertex_range = vertices(t_.mesh());
    const auto& edge_range = edges(t_.mesh());
    m.euler_characteristic += std::distance(vertex_range.begin(), vertex_range.end()) -
                              std::distance(edge_range.begin(), edge_range.end());
    return m;
  }

  static void add(Measure& m, std::uint32_t f, const Face_values<double>& v) {
    m.area += v.quadruple_area;
    const double discrepancy = area_discrepancy(v);
    const auto& l = v.squared_lengths;
    if (!(std::min({l[0], l[1], l[2], v.quadruple_area}) > 0) || !std::isfinite(discrepancy)) {
      if (m.bad_faces++ == 0) m.first_bad_face = f;
    } else if (discrepancy > m.discrepancy) {
      m.discrepancy = discrepancy;
      m.worst_face = f;
    }
  }

  double in_input_units(long double quadruple_area) const {
    return std::ldexp(static_cast<double>(quadruple_area), -2 * t_.metric().scale_exponent() - 2);
  }

  const Triangulation& t_;
  Measure before_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_SURFACE_CHECK_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_CHART_GRID_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_CHART_GRID_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/Gmpq.h>
#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// A point (x e + y f) / scale of a chart, where e and f are the first and the last side of its
// first face, from their common corner.
struct Grid_point {
  std::int32_t x, y;
};

// The corners i, j, k and m of a diamond ij, with k on the left.
using Grid_diamond = std::array<Grid_point, 4>;

/*
The grid of a chart, if the coordinates x and y of its points have a small common denominator: they
do in drawings by integers, and in lattices of all shapes. Signs of diamonds are computed from grid
points by integers of 128 bits, exactly and without allocation: squared lengths are values of a
quadratic form with integer coefficients, up to one positive factor, and areas are determinants, up
to another one. Expressions of a diamond are linear in areas, so that factors do not matter.
*/
class Chart_grid {
public:
  Chart_grid() = default; // no grid
  // \param first the first face of the chart
  explicit Chart_grid(const Rational_triangle& first);

  bool exists() const { return scale_ != 0; }
  void drop() { scale_ = 0; }

  // The coordinates of a point, not scaled.
  Plane_number coordinates(const Plane_number& z) const {
    const Plane_number& f = corner_;
    const Gmpq y = z.y / f.y;
    return {z.x - y * f.x, y};
  }
  // Makes the scale a multiple of the denominators of such coordinates. Drops the grid if it gets
  // too large.
  void include(const Plane_number& coordinates);
  // The point with such coordinates, once all are included; nothing if it is not on the grid, or
  // far away. \pre there is a grid
  std::optional<Grid_point> point(const Plane_number& coordinates) const;

  // The sign of an expression of `Diamond_values`; nothing if numbers may not fit.
  template <class Expression>
  std::optional<Sign> sign(const Grid_diamond& d, const Expression& expression) const {
    if (!fits(d)) return std::nullopt;
    const Wide value = expression(values(d));
    return value > 0 ? POSITIVE : value < 0 ? NEGATIVE : ZERO;
  }
  // Squared lengths and quadruple areas, in doubles; nothing if numbers may not fit.
  // \param unit the length of the first side of the chart, squared \param area of its first face
  std::optional<Diamond_values<double>> approximate(const Grid_diamond& d, double unit,
                                                    double area) const;

private:
  __extension__ using Wide = __int128;

  bool fits(const Grid_diamond& d) const;
  Diamond_values<Wide> values(const Grid_diamond& d) const {
    const auto& [i, j, k, m] = d;
    const auto squared = [&](const Grid_point& p, const Grid_point& q) {
      const Wide x = std::int64_t{q.x} - p.x, y = std::int64_t{q.y} - p.y;
      return form_[0] * (x * x) + form_[1] * (x * y) + form_[2] * (y * y);
    };
    const auto area = [](const Grid_point& p, const Grid_point& q, const Grid_point& r) {
      const Wide x = std::int64_t{q.x} - p.x, y = std::int64_t{q.y} - p.y;
      return x * (std::int64_t{r.y} - p.y) - y * (std::int64_t{r.x} - p.x);
    };
    return {squared(i, j), squared(j, k), squared(k, i), squared(i, m),
            squared(m, j), area(i, j, k), area(j, i, m)};
  }

  std::int64_t scale_ = 0;             // 0: no grid
  std::array<std::int64_t, 3> form_{}; // of x^2, x y and y^2
  Plane_number corner_;                // f
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_CHART_GRID_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Mpzf.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

bool rational_square_root(const Gmpq& x, Gmpq& root) {
  const Gmpz n = x.numerator(), d = x.denominator();
  if (mpz_perfect_square_p(n.mpz()) == 0 || mpz_perfect_square_p(d.mpz()) == 0) return false;
  root = Gmpq(CGAL::sqrt(n), CGAL::sqrt(d));
  return true;
}

namespace internal {

// ab - cd, when rounding upwards.
static Interval_nt<false> determinant_interval(double a, double b, double c, double d) {
  return {-(-a * b + c * d), a * b + -c * d};
}

// The same if the error of one product is found, so that nothing is lost where they cancel; a wide
// interval if that may not be a double. Products must be finite.
static Interval_nt<false> sharp_determinant(double a, double b, double c, double d) {
  const double product = c * d, error = std::fma(-c, d, product);
  if (std::abs(product) < 0x1p-900 && c != 0 && d != 0) return determinant_interval(a, b, c, d);
  return {-(std::fma(-a, b, product) - error), std::fma(a, b, -product) + error};
}

// a = 2 |u x v| of a face in space to a few units, when rounding upwards, or an interval below zero
// if sides are not doubles. Most of the errors of all other values come from here.
static Interval_nt<false> embedded_area_interval(const Input_metric& m, std::uint32_t f) {
  using FT = Interval_nt<false>;
  const Input_metric::Sides& s = m.sides(f);
  const Input_metric::Point &p = m.points()[s[0]], &q = m.points()[s[1]], &r = m.points()[s[2]];
  const std::array<double, 3> u = {q[0] - p[0], q[1] - p[1], q[2] - p[2]},
                              v = {r[0] - p[0], r[1] - p[1], r[2] - p[2]};
  for (std::size_t k = 0; k < 3; ++k)
    if (u[k] != -(p[k] - q[k]) || v[k] != -(p[k] - r[k])) return {-1.0, -1.0};
  const auto squared_norm = [&](const auto& difference) {
    return interval_square(difference(u[1], v[2], u[2], v[1])) +
           interval_square(difference(u[2], v[0], u[0], v[2])) +
           interval_square(difference(u[0], v[1], u[1], v[0]));
  };
  FT squared = squared_norm(determinant_interval);
  // wide where digits cancel: the other way keeps them
  if (squared.sup() - squared.inf() > 0x1p-47 * squared.sup())
    squared = squared_norm(sharp_determinant);
  if (!(squared.inf() > 0x1p-800 && squared.sup() < 0x1p800)) return {-1.0, -1.0};
  const double root = std::sqrt(squared.inf()); // not below
  const bool is_exact = root * root == squared.inf() && -root * root == -squared.inf();
  return {is_exact ? 2 * root : -2 * (root * 0x1p-52 - root), 2 * std::sqrt(squared.sup())};
}

Interval_nt<false> quadruple_area_interval(const Input_metric& m, std::uint32_t f) {
  using FT = Interval_nt<false>;
  if (m.is_embedded() && m.delta() == 0 && !m.has_excess(f)) {
    const FT fast = embedded_area_interval(m, f);
    if (fast.inf() > 0) return fast;
  }
  const FT d = m.is_embedded() ? Embedded_area<FT>(m, f).squared : m.squared_quadruple_area<FT>(f);
  if (d.inf() > 0 && d.sup() - d.inf() <= 0x1p-36 * d.sup()) return CGAL::sqrt(d);
  const auto [inf, sup] = CGAL::to_interval(checked_squared_quadruple_area<Mpzf>(m, f));
  if (inf > 0x1p-900 || sup == 0) return CGAL::sqrt(FT(inf, sup)); // Mpzf does not report underflow
  return CGAL::sqrt(from_rational<FT>(m.squared_quadruple_area<Gmpq>(f)));
}

std::vector<double> excess_of_edges(const Input_metric& m, const Gluing_map& mesh) {
  std::vector<double> result;
  for (std::uint32_t f = 0; f < m.number_of_faces(); ++f) {
    if (!m.has_excess(f)) continue;
    result.resize(mesh.number_of_edges(), 0);
    const std::array<Gluing_map::Halfedge, 3> sides = mesh.sides({f});
    for (unsigned k = 0; k < 3; ++k) result[sides[k].index / 2] = m.excess(f, k);
  }
  return result;
}

} // namespace internal

template double quadruple_area(const Input_metric&, std::uint32_t);
template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
template std::vector<double> quadruple_areas(const Input_metric&);
template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);

} // namespace CGAL::Intrinsic_triangulations

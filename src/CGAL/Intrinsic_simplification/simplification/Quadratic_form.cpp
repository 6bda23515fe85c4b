// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Quadratic_form.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Relative margins of proofs. The first one that is tried suffices nearly always, and a fourth of
// it nearly never.
constexpr double least_margin = 0x1p-50, first_margin = 0x1p-46, greatest_margin = 0x1p-4;

// The proof with the least margin that has one: a larger margin is not harder.
// \param prove returns a proof with a margin, or nothing
template <class Prove>
auto proof_with_least_margin(const Prove& prove) {
  double margin = first_margin;
  auto proof = prove(margin);
  for (; proof && margin > least_margin; margin /= 4) {
    auto better = prove(margin / 4);
    if (!better) return proof;
    proof = better;
  }
  for (; !proof && margin < greatest_margin; margin *= 4) proof = prove(4 * margin);
  return proof;
}

double value(const Form& m, double x, double y) {
  return m.xx * x * x + 2 * (m.xy * x * y) + m.yy * y * y;
}

Form sum(const Form& a, double c, const Form& b) {
  return {a.xx + c * b.xx, a.xy + c * b.xy, a.yy + c * b.yy};
}

// The eigenvalues of b - a in the basis in which a is the unit matrix, the greater one first, from
// the difference: so they are precise where both forms are nearly the same.
struct Comparison_of_forms {
  Comparison_of_forms(const Form& a, const Form& b) : difference(sum(b, -1, a)) {
    const Form& d = difference;
    const double area = determinant(a);
    const double half = (a.yy * d.xx - 2 * (a.xy * d.xy) + a.xx * d.yy) / (2 * area);
    const double product = determinant(d) / area;
    const double root = std::sqrt(std::max(0., half * half - product));
    greater = half + root;
    smaller = half - root;
  }
  Form difference;
  double greater, smaller;
};

Side_values times(double c, const Side_values& q) { return {c * q[0], c * q[1], c * q[2]}; }

// Products of finite numbers, each equal to `Interval(a) * Interval(b)`. That tries all pairs of
// bounds, which would take most of the time of a proof.
Interval exact_product(double a, double b) { return {-CGAL_IA_MUL(-a, b), CGAL_IA_MUL(a, b)}; }
Interval exact_product(double a, const Interval& b) {
  return {-std::max(CGAL_IA_MUL(-a, b.inf()), CGAL_IA_MUL(-a, b.sup())),
          std::max(CGAL_IA_MUL(a, b.inf()), CGAL_IA_MUL(a, b.sup()))};
}
Interval exact_product(const Interval& a, const Interval& b) { return a * b; }

// The same if the first one is not negative: its bounds multiply those of the other one.
#ifdef CGAL_USE_SSE2
__m128d positive_multiple(double a, const Interval& b) {
  return IA_opacify128(
      _mm_mul_pd(IA_opacify128_weak(_mm_set1_pd(a)), IA_opacify128_weak(b.simd())));
}
Interval positive_product(double a, const Interval& b) { return Interval(positive_multiple(a, b)); }
Interval positive_product(const Interval& a, const Interval& b) {
  return Interval(_mm_max_pd(positive_multiple(a.inf(), b), positive_multiple(a.sup(), b)));
}
#else
Interval positive_product(double a, const Interval& b) { return a * b; }
Interval positive_product(const Interval& a, const Interval& b) { return a * b; }
#endif

// Certainly a b is at least the square of every number between the bounds. \pre a and b are not
// negative
bool is_proven_at_least_square(double a, double b, const Interval& root) {
  const double least = -CGAL_IA_MUL(-a, b);
  return CGAL_IA_MUL(root.inf(), root.inf()) <= least &&
         CGAL_IA_MUL(root.sup(), root.sup()) <= least;
}

// of a form with values on the sides of a triangle
bool is_nowhere_negative(const Interval& a, const Interval& b, const Interval& c) {
  return a.inf() >= 0 && c.inf() >= 0 && is_proven_at_least_square(4 * a.inf(), c.inf(), a + c - b);
}

bool is_above_all(const Enclosed_form& m, std::span<const Enclosed_form* const> forms) {
  return std::ranges::all_of(forms, [&](const Enclosed_form* f) { return is_proven_above(m, *f); });
}
bool is_below_all(const Enclosed_form& m, std::span<const Enclosed_form* const> forms) {
  return std::ranges::all_of(forms, [&](const Enclosed_form* f) { return is_proven_above(*f, m); });
}

} // namespace

Form_of_sides::Form_of_sides(const Plane_triangle& p) {
  const auto difference = [](double a, double b) { return Interval(a) - Interval(b); };
  if (p[0].x == 0 && p[0].y == 0)
    measure(p[1].x, p[1].y, p[2].x, p[2].y);
  else
    measure(difference(p[1].x, p[0].x), difference(p[1].y, p[0].y), difference(p[2].x, p[0].x),
            difference(p[2].y, p[0].y));
}

// The sides from the first point are (x, y) and (u, w).
template <class Number>
void Form_of_sides::measure(Number x, Number y, Number u, Number w) {
  const Interval xw = exact_product(x, w), uy = exact_product(u, y), area = square(xw - uy);
  if (!(area.inf() > 0)) {
    xx_.fill(Interval::largest());
    xy_ = yy_ = xx_;
    return;
  }
  const Interval inverse = 1. / area;
  const auto divided = [&](const Interval& a) { return positive_product(inverse, a); };
  const Interval wy = Interval(w) - Interval(y), ux = Interval(u) - Interval(x);
  xx_ = {divided(exact_product(w, wy)), divided(exact_product(w, y)),
         -divided(exact_product(y, wy))};
  yy_ = {divided(exact_product(u, ux)), divided(exact_product(u, x)),
         -divided(exact_product(x, ux))};
  const Interval half = (uy + xw) * 0.5;
  xy_ = {divided(half - exact_product(u, w)), -divided(half), divided(half - exact_product(x, y))};
}

Enclosed_form Form_of_sides::operator()(const Side_values& q) const {
  const auto sum_of = [&](const std::array<Interval, 3>& c, const auto& times) {
    return times(q[0], c[0]) + times(q[1], c[1]) + times(q[2], c[2]);
  };
  const auto matrix = [&](const auto& times) {
    return Enclosed_form{sum_of(xx_, times), sum_of(xy_, times), sum_of(yy_, times)};
  };
  if (q[0] >= 0 && q[1] >= 0 && q[2] >= 0)
    return matrix([](double a, const Interval& b) { return positive_product(a, b); });
  return matrix([](double a, const Interval& b) { return exact_product(a, b); });
}

Side_values side_values(const Form& m, const Plane_triangle& p) {
  return {value(m, p[1].x - p[0].x, p[1].y - p[0].y), value(m, p[2].x - p[1].x, p[2].y - p[1].y),
          value(m, p[0].x - p[2].x, p[0].y - p[2].y)};
}

Form join(const Form& a, const Form& b) {
  const Comparison_of_forms c(a, b);
  if (!(c.smaller < 0)) return b;
  if (!(c.greater > 0)) return a;
  return sum(a, c.greater / (c.greater - c.smaller), sum(c.difference, -c.smaller, a));
}

Form meet(const Form& a, const Form& b) {
  const Comparison_of_forms c(a, b);
  if (!(c.smaller < 0)) return a;
  if (!(c.greater > 0)) return b;
  return sum(a, c.smaller / (c.smaller - c.greater), sum(c.difference, -c.greater, a));
}

std::array<double, 2> factors(const Side_values& form, const Side_values& by) {
  const auto matrix = [](const Side_values& q) {
    return Form{q[0], (q[0] + q[2] - q[1]) / 2, q[2]};
  };
  const Form a = matrix(by);
  if (!(determinant(a) > 0)) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity};
  }
  const Comparison_of_forms c(a, matrix(form));
  return {std::max(0., 1 + c.smaller), 1 + c.greater};
}

bool is_proven_above(const Enclosed_form& upper, const Enclosed_form& lower) {
  const Interval x = upper.xx - lower.xx, z = upper.yy - lower.yy;
  return x.inf() >= 0 && z.inf() >= 0 &&
         is_proven_at_least_square(x.inf(), z.inf(), upper.xy - lower.xy);
}

bool is_proven_above(const Side_values& upper, const std::array<Interval, 3>& lower) {
  const auto difference = [&](std::size_t k) { return Interval(upper[k]) - lower[k]; };
  return is_nowhere_negative(difference(0), difference(1), difference(2));
}

bool is_proven_below(const Side_values& lower, const std::array<Interval, 3>& upper) {
  const auto difference = [&](std::size_t k) { return upper[k] - Interval(lower[k]); };
  return is_nowhere_negative(difference(0), difference(1), difference(2));
}

std::optional<Proven_form> proven_above(const Form& near, const Measured_triangle& t,
                                        std::span<const Enclosed_form* const> forms) {
  const Side_values q = side_values(near, t.points);
  return proof_with_least_margin([&](double margin) -> std::optional<Proven_form> {
    const Side_values larger = times(1 + margin, q);
    const Enclosed_form matrix = t.matrix(larger);
    if (!is_above_all(matrix, forms)) return std::nullopt;
    return Proven_form{larger, matrix};
  });
}

Proven_form proven_below(const Form& near, const Measured_triangle& t,
                         std::span<const Enclosed_form* const> forms) {
  const Side_values q = side_values(near, t.points);
  const auto proof = proof_with_least_margin([&](double margin) -> std::optional<Proven_form> {
    const Side_values smaller = times(1 / (1 + margin), q);
    const Enclosed_form matrix = t.matrix(smaller);
    if (!is_below_all(matrix, forms)) return std::nullopt;
    return Proven_form{smaller, matrix};
  });
  return proof.value_or(Proven_form{{0, 0, 0}, {0, 0, 0}});
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Word_integer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/prism.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

/*
Triangles in space that are folded along parallel lines only, the *rulings*.

Let h be an integer vector along the rulings. Unfolding about them leaves x = <p, h> of a point p as
it is. Triangles between two rulings lie in one plane, a *panel*. There y, the coordinate at right
angles, is off that of a point b by |(p - b) x h| / |h|, the root of a rational number, or its
negative: the sign is that of <n, h x (p - b)>, n a normal of the panel. So with b on the ruling
over which the panel is entered, |h| y is a sum of signed roots of integers |(p - b) x h|^2, one for
each panel on the way from the first. Such sums are equal if their terms are.

Coordinates are integers below 2^w, differences below 2^(w + 1), components of cross products below
2^(2w + 3), squares and products of these below 2^(4w + 8). With 2w + 10 <= 64 `words` the former
fit so many words and the latter twice as many.
*/
template <std::size_t words>
class Prism {
public:
  using Integer = Word_integer<words>;
  using Vector = std::array<Integer, 3>;
  using Points = boost::container::small_vector<Vector, 16>;

  // `points` are those of the diamond
  Prism(const Unfolded_diamond& diamond, Points points) : points_(std::move(points)) {
    is_valid_ = std::all_of(diamond.triangles.begin(), diamond.triangles.end(),
                            [this](const auto& t) { return add(t); }) &&
                panels_.size() > 1;
    if (!is_valid_) return;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::uint32_t p = diamond.point(c);
      x_[c] = inner_product(points_[p], ruling_);
      y_[c] = height(panel_[diamond.corners[c].triangle], p);
    }
  }

  // Whether the corners are proven to be those of an isosceles trapezoid with sides along or across
  // the rulings: {a, b} and c, d opposite with y_a = y_b, y_c = y_d, x_a + x_b = x_c + x_d, or the
  // same with x and y exchanged. Then rows a - b and c - d of the matrix with rows (x, y, x^2 +
  // y^2, 1) are linearly dependent. Its determinant, of which `Delaunay_expression` is a multiple,
  // is zero.
  bool is_isosceles_trapezoid() const {
    static constexpr Coefficients pairings[3][3] = {{{1, -1, 0, 0}, {0, 0, 1, -1}, {1, 1, -1, -1}},
                                                    {{1, 0, -1, 0}, {0, 1, 0, -1}, {1, -1, 1, -1}},
                                                    {{1, 0, 0, -1}, {0, 1, -1, 0}, {1, -1, -1, 1}}};
    return std::any_of(std::begin(pairings), std::end(pairings), [this](const auto& p) {
      const auto& [base, opposite, both] = p;
      return (x_vanishes(base) && x_vanishes(opposite) && y_vanishes(both)) ||
             (x_vanishes(both) && y_vanishes(base) && y_vanishes(opposite));
    });
  }

  // Whether three corners are proven to be collinear: x_a (y_b - y_c) + x_b (y_c - y_a) + x_c (y_a
  // - y_b) vanishes.
  bool is_collinear(std::size_t a, std::size_t b, std::size_t c) const {
    std::array<Wide, 4> factor{}; // times numbers of panels
    factor[a] = Wide(x_[c] - x_[b]);
    factor[b] = Wide(x_[a] - x_[c]);
    factor[c] = Wide(x_[b] - x_[a]);
    return y_vanishes(factor);
  }

  // whether triangles are folded along parallel lines only
  bool is_valid() const { return is_valid_; }
  // x of a corner
  const Integer& x(std::size_t corner) const { return x_[corner]; }
  // |h| y of a corner: how often the root of each of `squares()` is in the sum
  const auto& y(std::size_t corner) const { return y_[corner]; }
  const auto& squares() const { return squares_; }

private:
  using Wide = Word_integer<2 * words>;
  using Coefficients = std::array<int, 4>; // of the four corners
  using Roots = std::vector<int>;

  struct Panel {
    Vector normal;
    std::uint32_t base; // point on the ruling over which it is entered
    Roots height;       // y there
  };

  static Wide wide_product(const Vector& a, const Vector& b) {
    Wide sum;
    for (std::size_t k = 0; k < 3; ++k) {
      const Wide p = full_product(a[k].magnitude(), b[k].magnitude());
      sum = a[k].sign() * b[k].sign() < 0 ? sum - p : sum + p;
    }
    return sum;
  }
  static bool is_zero(const Vector& v) {
    return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
  }

  // puts the next triangle into its panel; false if it is folded along another line, or has no area
  bool add(const Unfolded_diamond::Triangle& t) {
    const Vector& start = points_[t.point[0]];
    const Vector side = difference(points_[t.point[1]], start),
                 apex = difference(points_[t.point[2]], start), normal = cross_product(side, apex);
    if (is_zero(normal)) return false;
    Roots height_of_base;
    if (!panels_.empty()) {
      const std::uint32_t p = panel_[t.parent()];
      const Vector& n = panels_[p].normal;
      const bool may_be_flat = inner_product(apex, n).is_zero(); // modulo 2^(64 words)
      if (may_be_flat && wide_product(apex, n).is_zero() && wide_product(normal, n).sign() > 0) {
        panel_.push_back(p);
        return true;
      }
      if (panels_.size() == 1)
        ruling_ = side;
      else if (!is_zero(cross_product(side, ruling_)))
        return false;
      height_of_base = height(p, t.point[0]);
    }
    panel_.push_back(static_cast<std::uint32_t>(panels_.size()));
    panels_.push_back({normal, t.point[0], height_of_base});
    return true;
  }

  // |h| y of a point of a panel
  Roots height(std::uint32_t panel, std::uint32_t point) {
    const auto& [normal, base, height_of_base] = panels_[panel];
    Roots result = height_of_base;
    const Vector v = cross_product(ruling_, difference(points_[point], points_[base]));
    const int sign = wide_product(normal, v).sign();
    if (sign == 0) return result;
    const Wide square = wide_product(v, v);
    const auto n = static_cast<std::size_t>(std::find(squares_.begin(), squares_.end(), square) -
                                            squares_.begin());
    if (n == squares_.size()) squares_.push_back(square);
    result.resize(std::max(result.size(), n + 1), 0);
    result[n] += sign;
    return result;
  }

  bool x_vanishes(const Coefficients& coefficients) const {
    Integer sum;
    for (std::size_t c = 0; c < 4; ++c) sum = sum + Integer(coefficients[c]) * x_[c];
    return sum.is_zero();
  }

  // whether that is proven
  template <class Factor>
  bool y_vanishes(const std::array<Factor, 4>& factors) const {
    for (std::size_t n = 0; n < squares_.size(); ++n) {
      Factor sum(0);
      for (std::size_t c = 0; c < 4; ++c)
        if (n < y_[c].size() && y_[c][n] != 0) sum = sum + factors[c] * Factor(y_[c][n]);
      if (!(sum == Factor(0))) return false;
    }
    return true;
  }

  Points points_;
  boost::container::small_vector<Panel, 8> panels_;
  boost::container::small_vector<std::uint32_t, 16> panel_; // of each triangle
  boost::container::small_vector<Wide, 8> squares_;
  Vector ruling_{};
  std::array<Integer, 4> x_;
  std::array<Roots, 4> y_;
  bool is_valid_ = false;
};

// The positions in space of the points of an unfolded diamond.
class Strip_points {
public:
  Strip_points(const Input_metric& input, const Unfolded_diamond& diamond) {
    const auto add_corner = [&](const Face_side& s, std::uint32_t k) {
      add(input.points()[input.sides(s.face)[(s.slot + k) % 3]]);
    };
    add_corner(diamond.triangles[0].side, 0);
    add_corner(diamond.triangles[0].side, 1);
    for (const Unfolded_diamond::Triangle& t : diamond.triangles) add_corner(t.side, 2);
  }

  int width() const { return range_.width(); }

  template <std::size_t words>
  typename Prism<words>::Points integers() const {
    typename Prism<words>::Points result;
    const auto integer = [this](const Binary_double& x) {
      return x.template scaled<Word_integer<words>>(range_.lowest);
    };
    for (const auto& [x, y, z] : points_) result.push_back({integer(x), integer(y), integer(z)});
    return result;
  }

private:
  void add(const Input_metric::Point& p) {
    points_.push_back({Binary_double(p[0]), Binary_double(p[1]), Binary_double(p[2])});
    for (const Binary_double& x : points_.back()) range_.include(x);
  }

  boost::container::small_vector<std::array<Binary_double, 3>, 16> points_;
  Bit_range range_;
};

// calls a function with the prism over which a diamond lies, or returns `other` if triangles are
// folded in another way
template <class Asked, class Function, class Other>
Other with_prism(const Asked& q, const Function& f, const Other& other) {
  if (q.figure.has_inserted_corners() || !q.figure.is_in_space(q.input)) return other;
  const Strip_points points(q.input, q.figure);
  const auto call = [&](const auto& prism) { return prism.is_valid() ? f(prism) : other; };
  if (points.width() <= 58) return call(Prism<2>(q.figure, points.integers<2>()));
  return points.width() <= 122 ? call(Prism<4>(q.figure, points.integers<4>())) : other;
}

template <std::size_t words>
Gmpz to_gmpz(const Word_integer<words>& x) {
  Gmpz result;
  mpz_import(result.mpz(), words, -1, sizeof(std::uint64_t), 0, 0, x.magnitude().words().data());
  return x.sign() < 0 ? -result : result;
}

// whether the expression is zero, see `Prism_in_field_proof`
template <class Asked, class Prism_of_words>
Answer decide_in_field(const Asked& q, const Prism_of_words& prism) {
  using Number = Multiquadratic_number;
  Square_class_basis basis;
  basis.limit_products(thresholds::words_over_prisms);
  std::vector<Number> roots;
  for (const auto& s : prism.squares()) {
    const auto root = basis.sqrt_of(Gmpq(to_gmpz(s)));
    if (!root) return Answer::open;
    roots.emplace_back(basis, *root);
  }
  std::array<Unfolded_diamond::Position<Number>, 4> corners;
  for (std::size_t c = 0; c < 4; ++c) {
    corners[c] = {Number(Gmpq(to_gmpz(prism.x(c)))), Number(0)};
    for (std::size_t n = 0; n < prism.y(c).size(); ++n)
      corners[c].y += Number(prism.y(c)[n]) * roots[n];
  }
  try {
    const auto values = Unfolded_diamond::values_of<Number>(corners, Number(1));
    return q.expression(values).is_zero() ? Answer::zero : Answer::not_zero;
  } catch (const std::length_error&) {
    return Answer::open;
  }
}

} // namespace

} // namespace internal

Answer
Prism_proof::operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const {
  const Zero_meaning meaning = q.expression.zero_meaning();
  if (meaning == Zero_meaning::other) return Answer::open;
  return internal::with_prism(
      q,
      [meaning](const auto& prism) {
        const bool is_zero = meaning == Zero_meaning::cocircular ? prism.is_isosceles_trapezoid()
                             : meaning == Zero_meaning::collinear_at_source
                                 ? prism.is_collinear(2, 0, 3)
                                 : prism.is_collinear(2, 1, 3);
        return is_zero ? Answer::zero : Answer::open;
      },
      Answer::open);
}

Answer Prism_in_field_proof::operator()(
    const Question<Unfolded_diamond, Recorded_diamond_expression>& q) const {
  if (!q.expression.degree() || !q.expression.degree()->is_uniform) return Answer::open;
  return internal::with_prism(
      q, [&](const auto& prism) { return internal::decide_in_field(q, prism); }, Answer::open);
}

} // namespace CGAL::Intrinsic_triangulations

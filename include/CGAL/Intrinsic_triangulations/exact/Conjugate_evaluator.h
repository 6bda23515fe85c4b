// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_EVALUATOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_EVALUATOR_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Gaussian_residue.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Prime_field.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>

#include <CGAL/Gmpz.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief evaluates an unfolded diamond in the field of p^2 elements, for every choice of signs of the
square roots.

A ring homomorphism from Z[1/N][i, sqrt(d_0), sqrt(d_1), ...] to F_p(i), p = 3 modulo 4, maps i to
i and the root of a representative d_g to one of the two roots that d_g has there, of which one is
real or imaginary. Complex numbers z of the plane and their conjugates z' are mapped separately:

    w = (p + i sqrt(D)) / (2 L),   w' = (p - i sqrt(D)) / (2 L),
    |z|^2 = z z',                  2 Im(u' v) = i (u v' - u' v).
*/
class Conjugate_evaluator {
public:
  /// Set of representatives, as bits.
  using Mask = Square_class_basis::Mask;

  /// What is used of a triangle.
  struct Shape {
    const std::array<Gmpz, 3>* squared_lengths; ///< in any unit
    const Gmpz* area_factor;                    ///< times `root`, the quadruple area in that unit
    Square_root root;                           ///< see `area_factor`
  };

  /*!
  \brief prepares the evaluation.
  \param diamond the triangles
  \param shapes one for each triangle
  \param exponent the unit of the first shape: its squared lengths are 4^exponent times the true
  ones
  \param basis made the roots
  \param field where to evaluate
  */
  Conjugate_evaluator(const Unfolded_diamond& diamond, const std::vector<Shape>& shapes,
                      long exponent, const Square_class_basis& basis, const Prime_field& field)
      : diamond_(diamond), field_(field), dimension_(basis.dimension()),
        points_(shapes.size() + 2) {
    if (!find_roots(basis) || !find_ratios(shapes)) return;
    const Element four = field_.element(Gmpz(4));
    unit_ = field_.multiply(
        field_.element((*shapes.front().squared_lengths)[0]),
        exponent < 0 ? field_.power(four, static_cast<std::uint64_t>(-exponent))
                     : field_.power(field_.inverse(four), static_cast<std::uint64_t>(exponent)));
    find_corners();
    is_defined_ = true;
    const Gaussian_residue zero(field_, 0, 0), one(field_, field_.one(), 0);
    points_[0] = {zero, zero};
    points_[1] = {one, one};
    develop(0);
  }

  /// tells whether the homomorphism is defined and no root is zero, which fails for few primes
  /// only.
  bool is_defined() const { return is_defined_; }

  /*!
  \brief evaluates the diamond for the current signs; all are positive first.
  \pre `is_defined()`
  */
  Diamond_values<Gaussian_residue> values() const {
    const Point &i = corner(0), &j = corner(1), &k = corner(2), &m = corner(3);
    const Point ij = j - i, ik = k - i, jk = k - j, im = m - i, jm = m - j;
    return {length(ij), length(jk), length(ik), length(im), length(jm), area(ij, ik), area(jm, ij)};
  }

  /*!
  \brief goes on to the next choice of signs.

  If the root of some representative is imaginary, the first such root keeps its sign: the
  automorphism x + i y -> x - i y of the field changes the signs of all imaginary roots, and
  permutes the values. If every area has an odd number of roots, the first root that is not imaginary
  keeps its sign as well: changing the signs of all roots changes those of all areas and no length,
  hence at most the sign of the value.
  \pre the expressions evaluated are odd or even in the areas, see `Expression_degree`
  \return whether there is one
  */
  bool next() {
    std::size_t first = points_.size();
    do {
      if (++count_ >> dimension_ != 0) return false;
      // the latest generators change most often: early triangles stay
      const auto g = dimension_ - 1 - std::size_t(std::countr_zero(count_));
      first = std::min(first, first_use_[g]);
      for (std::size_t h = g; h < dimension_; ++h) signs_ ^= Mask(1) << h;
    } while ((signs_ & fixed_) != 0);
    develop(first);
    return true;
  }

private:
  using Element = Prime_field::Element;

  struct Point {
    Gaussian_residue z, conjugate;
    friend Point operator-(const Point& a, const Point& b) {
      return {a.z - b.z, a.conjugate - b.conjugate};
    }
  };

  // w = real + i^turns root
  struct Ratio {
    Element real;
    Element root;
    Mask radical;
    bool is_imaginary;
  };

  const Point& corner(std::size_t c) const { return points_[corners_[c]]; }

  Gaussian_residue length(const Point& u) const { return scaled(unit_, u.z * u.conjugate); }
  // i (u v' - u' v), where (u, v) turns to the left
  Gaussian_residue area(const Point& u, const Point& v) const {
    return scaled(unit_, times_i(u.z * v.conjugate - u.conjugate * v.z));
  }

  bool find_roots(const Square_class_basis& basis) {
    roots_.reserve(dimension_);
    for (std::size_t g = 0; g < dimension_; ++g) {
      const Element d = field_.element(basis.representative(g));
      if (d == 0) return false;
      const auto [root, is_imaginary] = field_.root(d);
      roots_.push_back(root);
      if (is_imaginary) imaginary_ |= Mask(1) << g;
    }
    return true;
  }

  bool find_ratios(const std::vector<Shape>& shapes) {
    first_use_.assign(dimension_, shapes.size());
    std::vector<Element> denominators, products;
    ratios_.reserve(shapes.size());
    denominators.reserve(shapes.size());
    products.reserve(shapes.size() + 1);
    products.push_back(field_.one());
    for (std::size_t n = 0; n < shapes.size(); ++n) {
      const unsigned t = diamond_.triangles[n].entry;
      const auto& l = *shapes[n].squared_lengths;
      const Square_root& area = shapes[n].root;
      const Element entry = field_.element(l[t]);
      Element root = field_.element(*shapes[n].area_factor);
      unsigned turns = 1 + unsigned(std::popcount(area.radical & imaginary_));
      for (Mask rest = area.radical; rest != 0; rest &= rest - 1) {
        const auto g = std::size_t(std::countr_zero(rest));
        root = field_.multiply(root, roots_[g]);
        first_use_[g] = std::min(first_use_[g], n);
      }
      if (turns % 4 >= 2) root = field_.negate(root);
      const Element p = field_.subtract(field_.add(entry, field_.element(l[(t + 2) % 3])),
                                        field_.element(l[(t + 1) % 3]));
      Element scale = field_.one();
      if (area.factor != 1) {
        root = field_.multiply(root, field_.element(area.factor.numerator()));
        scale = field_.element(area.factor.denominator());
      }
      ratios_.push_back({field_.multiply(p, scale), root, area.radical, turns % 2 != 0});
      denominators.push_back(field_.multiply(field_.add(entry, entry), scale));
      products.push_back(field_.multiply(products.back(), denominators.back()));
    }
    if (products.back() == 0) return false;
    fixed_ = imaginary_ & (~imaginary_ + 1);
    const Mask all = dimension_ == 64 ? ~Mask(0) : (Mask(1) << dimension_) - 1;
    const Mask real = all & ~imaginary_;
    const bool is_odd = std::all_of(shapes.begin(), shapes.end(), [](const Shape& s) {
      return s.area_factor->sign() == ZERO || std::popcount(s.root.radical) % 2 != 0;
    });
    if (is_odd) fixed_ |= real & (~real + 1);
    Element inverse = field_.inverse(products.back()); // of the product of all up to n
    for (std::size_t n = shapes.size(); n-- > 0;) {
      const Element r = field_.multiply(inverse, products[n]);
      ratios_[n].real = field_.multiply(ratios_[n].real, r);
      ratios_[n].root = field_.multiply(ratios_[n].root, r);
      inverse = field_.multiply(inverse, denominators[n]);
    }
    return true;
  }

  // corners that were inserted follow the other points
  void find_corners() {
    Element half = 0;
    if (diamond_.has_inserted_corners())
      half = field_.inverse(field_.add(field_.one(), field_.one()));
    for (std::size_t c = 0; c < 4; ++c) {
      const Unfolded_diamond::Corner& corner = diamond_.corners[c];
      corners_[c] = corner.is_inserted() ? points_.size() : diamond_.point(c);
      if (!corner.is_inserted()) continue;
      points_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        int e = 0; // n / 2^e for an integer n; the weight is not negative and at most 1: e <= 1
        const double n = std::ldexp(std::frexp(corner.weights[k], &e), 53);
        weights_[c][k] = field_.multiply(field_.element(Gmpz(n)),
                                         field_.power(half, static_cast<std::uint64_t>(53 - e)));
      }
    }
  }

  void combine() {
    for (std::size_t c = 0; c < 4; ++c) {
      if (!diamond_.corners[c].is_inserted()) continue;
      const Gaussian_residue zero(field_, 0, 0);
      Point sum{zero, zero};
      const std::array<std::uint32_t, 3> points = diamond_.points(diamond_.corners[c]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point& p = points_[points[k]];
        sum = {sum.z + scaled(weights_[c][k], p.z),
               sum.conjugate + scaled(weights_[c][k], p.conjugate)};
      }
      points_[corners_[c]] = sum;
    }
  }

  void develop(std::size_t first) {
    for (std::size_t n = first; n < ratios_.size(); ++n) {
      const Point& start = points_[diamond_.triangles[n].start()];
      const Point side = points_[diamond_.triangles[n].end()] - start;
      const auto& [real, positive_root, radical, is_imaginary] = ratios_[n];
      const bool is_negative = std::popcount(radical & signs_) % 2 != 0;
      const Element root = is_negative ? field_.negate(positive_root) : positive_root;
      if (is_imaginary) {
        const Gaussian_residue w(field_, real, root), w_(field_, real, field_.negate(root));
        points_[n + 2] = {start.z + side.z * w, start.conjugate + side.conjugate * w_};
      } else {
        points_[n + 2] = {start.z + scaled(field_.add(real, root), side.z),
                          start.conjugate + scaled(field_.subtract(real, root), side.conjugate)};
      }
    }
    combine();
  }

  const Unfolded_diamond& diamond_;
  const Prime_field& field_;
  std::size_t dimension_;
  std::vector<Point> points_;
  std::array<std::size_t, 4> corners_{};            // points
  std::array<std::array<Element, 3>, 4> weights_{}; // of those that were inserted
  std::vector<Element> roots_; // r, where r or i r is the root of a representative
  std::vector<Ratio> ratios_;  // one for each triangle
  std::vector<std::size_t> first_use_;
  Mask imaginary_ = 0; // representatives whose root is i r
  Mask fixed_ = 0;     // representatives whose roots keep their signs, see `next()`
  Mask signs_ = 0;     // roots that are taken negative
  std::uint64_t count_ = 0;
  Element unit_ = 0;
  bool is_defined_ = false;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_CONJUGATE_EVALUATOR_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Conjugate_bound.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Residues.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Faces_in_field.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/images.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Gmpz.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// A part of a figure over which the expression is zero if and only if it is over the figure.
// Convexity at one end does not depend on where the other one is, which may be across hundreds of
// triangles.
template <class Asked>
const typename Asked::Figure& decisive_part(const Asked& q,
                                            std::optional<typename Asked::Figure>& part) {
  if constexpr (std::is_same_v<typename Asked::Figure, Unfolded_diamond>) {
    const Zero_meaning zero = q.expression.zero_meaning();
    if (zero == Zero_meaning::collinear_at_source) part = q.figure.without(1);
    if (zero == Zero_meaning::collinear_at_target) part = q.figure.without(0);
  }
  return part ? *part : q.figure;
}

double log2_of(const Gmpz& n) {
  long exponent = 0;
  const double part = mpz_get_d_2exp(&exponent, n.mpz());
  return std::log2(part) + static_cast<double>(exponent);
}
double log2_of(const Gmpq& x) { return log2_of(x.numerator()) - log2_of(x.denominator()); }
Gmpz times_power_of_two(const Gmpz& x, int exponent) {
  Gmpz result;
  mpz_mul_2exp(result.mpz(), x.mpz(), static_cast<mp_bitcnt_t>(exponent));
  return result;
}
// of the sum of two numbers
double log2_of_sum(double x, double y) {
  return x == y ? x + 1 : std::max(x, y) + std::log2(1 + std::exp2(-std::abs(x - y)));
}

/*
The unfolded triangles of a diamond and their images in finite fields, see `decide_by_images()`.

Squared lengths are integers over 2^s. With these, and the areas that belong to them, in w = (p +
a i) / (2 L), d w is an algebraic integer if 2 L divides d: for all positions, d is the product over
all triangles. A conjugate changes the signs of some areas, hence turns some triangles over: lengths
of sides stay as they are, and bound the distances of all points from the first.
*/
class Unfolded_images {
public:
  using Position = Unfolded_diamond::Position<Residues>;

  Unfolded_images(const Unfolded_diamond& diamond, Faces_in_field& faces) : diamond_(diamond) {
    for (const Unfolded_diamond::Triangle& t : diamond.triangles) {
      const auto& [l, area] = faces(t.side.face);
      if (l[t.side.slot] == Gmpq(0)) throw std::length_error("a side without length");
      steps_.push_back({&l, &area, {}, {}, {}, {}});
      for (const Gmpq& x : l)
        scale_ = std::max(scale_, static_cast<int>(mpz_scan1(x.denominator().mpz(), 0)));
    }
  }

  // binary logarithm of the denominator d
  double bits_of_denominator() const {
    double bits = 0;
    for (std::uint32_t n = 0; n < steps_.size(); ++n) bits += log2_of(length(n, 0)) + scale_ + 1;
    return bits;
  }
  // bounds of the values of the diamond
  Diamond_values<Conjugate_bound> bounds() const {
    std::vector<double> radius{-HUGE_VAL, 0}; // binary logarithms
    std::uint32_t n = 0;
    diamond_.triangles.carry(radius, [&](const auto&, double from, double) {
      return log2_of_sum(from, (log2_of(length(n++, 2)) - log2_of(length(0, 0))) / 2);
    });
    Unfolded_diamond::Positions<Conjugate_bound> z;
    for (const double r : radius) {
      const Conjugate_bound bound(1, 0, std::max(r, 0.0));
      z.push_back({bound, bound});
    }
    return values(z, Conjugate_bound(0, scale_, log2_of(length(0, 0))));
  }

  // how many triangles `at_roots()` computes on average, of so many roots
  double steps(std::size_t roots) const {
    double sum = std::ldexp(static_cast<double>(steps_.size()), -static_cast<int>(roots));
    for (std::size_t g = 0; g < roots; ++g) {
      const auto first = std::find_if(steps_.begin(), steps_.end(), [g](const Step& s) {
        return (s.area->radical >> g & 1U) != 0;
      });
      sum += std::ldexp(static_cast<double>(steps_.end() - first),
                        static_cast<int>(g) - static_cast<int>(roots));
    }
    return sum;
  }
  // in new fields
  void prepare(const std::vector<Residues>& roots) {
    const Residues unit(times_power_of_two(Gmpz(1), scale_));
    std::vector<Residues> product{Residues(1)}; // of the denominators of w up to each triangle
    for (std::uint32_t n = 0; n < steps_.size(); ++n) {
      Step& s = steps_[n];
      s.first = integer(n, 0);
      s.denominator = (s.first + s.first) * Residues(s.area->factor.denominator());
      product.push_back(product.back() * s.denominator);
    }
    Residues inverse = product.back().inverse(); // of all of them in one
    for (std::uint32_t n = static_cast<std::uint32_t>(steps_.size()); n-- > 0;) {
      Step& s = steps_[n];
      const Residues reciprocal = inverse * product[n];
      inverse *= s.denominator;
      s.up = reciprocal * unit * image_of({s.area->factor.numerator(), s.area->radical}, roots);
      s.across = reciprocal * Residues(s.area->factor.denominator()) *
                 (s.first + integer(n, 2) - integer(n, 1));
    }
    unit_ = Residues(length(0, 0));
    z_ = {{Residues(0), Residues(0)}, {Residues(1), Residues(0)}};
  }
  // changes the sign of a root
  void negate(std::size_t root) {
    std::size_t first = steps_.size();
    for (std::size_t n = steps_.size(); n-- > 0;)
      if ((steps_[n].area->radical >> root & 1U) != 0) {
        steps_[n].up = -steps_[n].up;
        first = n;
      }
    if (first + 2 < z_.size()) z_.resize(first + 2);
  }
  Diamond_values<Residues> at_roots() {
    std::size_t n = z_.size() - 2;
    diamond_.triangles.carry(z_, [&](const auto&, const Position& from, const Position& to) {
      const Step& s = steps_[n++];
      return from + (to - from) * Position{s.across, s.up};
    });
    return values(z_, unit_);
  }

private:
  struct Step {
    const std::array<Gmpq, 3>* squared_lengths;
    const Square_root* area;
    Residues first, denominator; // while fields are new
    Residues across, up;         // to the apex, where the first side is 1
  };

  // of a side of a triangle, from its first one on
  const Gmpq& length(std::uint32_t n, std::uint32_t side) const {
    return (*steps_[n].squared_lengths)[(diamond_.triangles[n].side.slot + side) % 3];
  }
  // times 2^s
  Residues integer(std::uint32_t n, std::uint32_t side) const {
    const Gmpq& x = length(n, side);
    const auto twos = static_cast<int>(mpz_scan1(x.denominator().mpz(), 0));
    return Residues(times_power_of_two(x.numerator(), scale_ - twos));
  }
  template <class FT>
  Diamond_values<FT> values(const Unfolded_diamond::Positions<FT>& z, const FT& unit) const {
    return Unfolded_diamond::values_of<FT>({diamond_.position(0, z), diamond_.position(1, z),
                                            diamond_.position(2, z), diamond_.position(3, z)},
                                           unit);
  }

  const Unfolded_diamond& diamond_;
  std::vector<Step> steps_;
  int scale_ = 0;
  Residues unit_;
  Unfolded_diamond::Positions<Residues> z_;
};

// The images of an expression in the values of a figure that is unfolded.
template <class Asked>
class Images_of_figure {
  static constexpr bool are_faces = std::is_same_v<typename Asked::Figure, Unfolded_faces>;

public:
  Images_of_figure(const typename Asked::Figure& figure,
                   const typename Asked::Expression& expression, Faces_in_field& faces)
      : expression_(expression), faces_(faces) {
    if constexpr (are_faces)
      for (const Unfolded_diamond& f : figure.faces) parts_.emplace_back(f, faces);
    else
      parts_.emplace_back(figure, faces);
  }

  // see `decide_by_images()`; nothing is known if the expression has quotients
  double bits() {
    double denominator = 0;
    for (const Unfolded_images& p : parts_) denominator += p.bits_of_denominator();
    try {
      return value([](Unfolded_images& p) { return p.bounds(); }).bits_of_integer(denominator);
    } catch (const std::length_error&) {
      return HUGE_VAL;
    }
  }
  double steps() const {
    double sum = 0;
    for (const Unfolded_images& p : parts_) sum += p.steps(faces_.basis().dimension());
    return sum;
  }
  void prepare(const std::vector<Residues>& roots) {
    for (Unfolded_images& p : parts_) p.prepare(roots);
  }
  void negate(std::size_t root) {
    for (Unfolded_images& p : parts_) p.negate(root);
  }
  Residues at_roots() {
    return value([](Unfolded_images& p) { return p.at_roots(); });
  }

private:
  template <class Values>
  auto value(const Values& values) {
    if constexpr (are_faces) {
      std::vector<decltype(face(values(parts_[0])))> all;
      for (Unfolded_images& p : parts_) all.push_back(face(values(p)));
      return expression_(all);
    } else {
      return expression_(values(parts_[0]));
    }
  }
  template <class FT>
  static Face_values<FT> face(const Diamond_values<FT>& v) {
    return {{v.ij, v.jk, v.ki}, v.area_f};
  }

  const typename Asked::Expression& expression_;
  Faces_in_field& faces_;
  std::vector<Unfolded_images> parts_;
};

Unfolded_diamond unfolded(const Input_diamond& d) {
  Unfolded_diamond result;
  result.triangles.start(d.left);
  result.triangles.enter(0, 0, d.right);
  result.corners = {{{0, 0}, {0, 1}, {0, 2}, {1, 2}}};
  return result;
}

// The value of an expression of a figure whose faces have the given roots as areas.
template <class FT, class Figure, class Expression, class Root>
FT value_of(const Figure& figure, const Expression& expression, Faces_in_field& faces,
            const Root& root) {
  return expression(figure.template values<FT>([&](std::uint32_t f) {
    const auto& [l, area] = faces(f);
    return std::pair(std::array{FT(l[0]), FT(l[1]), FT(l[2])}, root(area));
  }));
}

template <class Figure, class Expression>
Answer decide_by_coefficients(const Figure& figure, const Expression& expression,
                              Faces_in_field& faces, double& steps_left) {
  using Number = Multiquadratic_number;
  constexpr double words_of_step =
      static_cast<double>(thresholds::words_of_coefficients) / thresholds::image_steps;
  const double most =
      std::clamp(words_of_step * steps_left, words_of_step * thresholds::few_image_steps,
                 static_cast<double>(thresholds::words_of_coefficients));
  faces.basis().limit_products(static_cast<std::size_t>(most));
  const auto root = [&](const Square_root& area) { return Number(faces.basis(), area); };
  Answer answer = Answer::open;
  try {
    answer = value_of<Number>(figure, expression, faces, root).is_zero() ? Answer::zero
                                                                         : Answer::not_zero;
  } catch (const std::length_error&) {
  }
  const double cost = (most - static_cast<double>(faces.basis().words_left())) / words_of_step;
  if (cost > thresholds::few_image_steps) steps_left -= cost;
  return answer;
}

// Images first; where their bound asks for too many, as for long coordinates, coefficients.
template <class Asked>
Answer decide_by_triangles(const Asked& q, Faces_in_field& faces, double& steps_left) {
  std::optional<typename Asked::Figure> part;
  const auto& figure = decisive_part(q, part);
  Images_of_figure<Asked> images(figure, q.expression, faces);
  const Answer answer = decide_by_images(faces.basis(), images.bits(), images, steps_left);
  if (answer != Answer::open) return answer;
  return decide_by_coefficients(figure, q.expression, faces, steps_left);
}
Answer decide_by_triangles(const Question<Input_diamond, Recorded_diamond_expression>& q,
                           Faces_in_field& faces, double& steps_left) {
  return decide_by_triangles(Question{q.input, unfolded(q.figure), q.expression}, faces,
                             steps_left);
}

// Flips divide by lengths of edges, of which no bound follows: one image may prove that a value is
// not zero, and coefficients that it is.
template <class Asked>
Answer decide_by_flips(const Asked& q, Faces_in_field& faces, double& steps_left) {
  {
    const Residue_fields scope(0);
    std::vector<Residues> roots;
    const auto root = [&](const Square_root& area) {
      while (roots.size() < faces.basis().dimension())
        roots.push_back(Residues::sqrt_of(faces.basis().representative(roots.size())));
      return image_of(area, roots);
    };
    const auto image = value_of<Residues>(q.figure, q.expression, faces, root);
    if (Residue_fields::are_defined() && !image.is_zero()) return Answer::not_zero;
  }
  return decide_by_coefficients(q.figure, q.expression, faces, steps_left);
}

} // namespace

} // namespace internal

template <class Figure, class Expression>
  requires(!std::is_same_v<Figure, Flat_diamond>)
Answer Field_proof::operator()(const Question<Figure, Expression>& q) const {
  internal::Faces_in_field faces(q.input);
  double enough = thresholds::all_image_steps;
  double& steps_left = image_steps_left != nullptr ? *image_steps_left : enough;
  try {
    if constexpr (std::is_same_v<Figure, Replayed_diamond> ||
                  std::is_same_v<Figure, Replayed_faces>)
      return internal::decide_by_flips(q, faces, steps_left);
    else
      return internal::decide_by_triangles(q, faces, steps_left);
  } catch (const std::length_error&) {
    return Answer::open;
  }
}

template Answer
Field_proof::operator()(const Question<Input_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Replayed_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Unfolded_faces, Recorded_face_expression>&) const;
template Answer
Field_proof::operator()(const Question<Replayed_faces, Recorded_face_expression>&) const;

} // namespace CGAL::Intrinsic_triangulations

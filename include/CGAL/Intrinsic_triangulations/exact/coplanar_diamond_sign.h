// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_COPLANAR_DIAMOND_SIGN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_COPLANAR_DIAMOND_SIGN_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_degree.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class FT>
using Space_vector = std::array<FT, 3>;

template <class FT>
Space_vector<FT> difference(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class FT>
Space_vector<FT> space_cross(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class FT>
FT space_dot(const Space_vector<FT>& a, const Space_vector<FT>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A diamond over input faces in space, as it lies there.
template <class FT>
class Diamond_in_space {
public:
  using Vector = Space_vector<FT>;

  Diamond_in_space(const Input_metric& input, const Unfolded_diamond& d)
      : input_(input), diamond_(d), normal_(normal(d.triangles.front())) {}

  // whether the triangles lie in one plane, in one orientation, as far as `FT` can tell
  bool may_be_flat() const {
    for (std::size_t t = 1; t < diamond_.triangles.size(); ++t) {
      const Unfolded_diamond::Triangle& f = diamond_.triangles[t];
      const FT height =
          space_dot(normal_, difference(point(f, (f.entry + 2) % 3), point(f, f.entry)));
      const FT same = space_dot(normal_, normal(f));
      if (CGAL::certainly(height != FT(0)) || CGAL::certainly(same <= FT(0))) return false;
    }
    return true;
  }

  // The values of the diamond; areas in units of the length of a normal. \pre it is flat
  Diamond_values<FT> values() const {
    const Vector i = corner(0), j = corner(1), k = corner(2), m = corner(3);
    const auto length = [](const Vector& a, const Vector& b) {
      const Vector d = difference(a, b);
      return space_dot(d, d);
    };
    const auto area = [&](const Vector& a, const Vector& b, const Vector& c) {
      return FT(2) * space_dot(normal_, space_cross(difference(b, a), difference(c, a)));
    };
    return {length(i, j), length(j, k),  length(k, i), length(i, m),
            length(m, j), area(i, j, k), area(j, i, m)};
  }

private:
  Vector point(const Unfolded_diamond::Triangle& t, std::uint32_t slot) const {
    const Input_metric::Point& p = input_.points()[input_.sides(t.face)[slot]];
    return {FT(p[0]), FT(p[1]), FT(p[2])};
  }

  Vector normal(const Unfolded_diamond::Triangle& t) const {
    const Vector a = point(t, 0);
    return space_cross(difference(point(t, 1), a), difference(point(t, 2), a));
  }

  Vector corner(std::size_t number) const {
    const Unfolded_diamond::Corner& c = diamond_.corners[number];
    const Unfolded_diamond::Triangle& t = diamond_.triangles[c.triangle];
    if (!c.is_inserted()) return point(t, c.slot);
    Vector sum{FT(0), FT(0), FT(0)};
    for (std::uint32_t k = 0; k < 3; ++k) {
      const Vector p = point(t, (c.slot + k) % 3);
      const FT weight(c.weights[k]);
      for (std::size_t x = 0; x < 3; ++x) sum[x] = sum[x] + weight * p[x];
    }
    return sum;
  }

  const Input_metric& input_;
  const Unfolded_diamond& diamond_;
  Vector normal_;
};

} // namespace internal

/*!
\brief returns the sign of an expression in the values of a diamond that lies in one plane in space, exactly.

There all corners have coordinates that are multiples of a power of two, and areas have one square root as a factor:
no field is extended. Inserted vertices in flat parts of a surface are tied often.
\param input the input, from points in space
\param diamond the diamond
\param expression a polynomial that is linear in the areas, see `Expression_degree`
\return the sign; nothing if the diamond is not in one plane
*/
template <PolynomialExpression Expression>
std::optional<Sign> coplanar_diamond_sign(const Input_metric& input,
                                          const Unfolded_diamond& diamond,
                                          const Expression& expression) {
  if (!internal::Diamond_in_space<Interval_nt<false>>(input, diamond).may_be_flat())
    return std::nullopt;
  const internal::Diamond_in_space<Mpzf> exact(input, diamond);
  if (!exact.may_be_flat()) return std::nullopt;
  return CGAL::sign(expression(exact.values()));
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_COPLANAR_DIAMOND_SIGN_H

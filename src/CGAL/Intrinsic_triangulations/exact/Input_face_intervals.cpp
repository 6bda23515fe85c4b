// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

using Double_vector = std::array<double, 3>;
using Long_vector = std::array<Double_double, 3>;

// from one corner of a face to another, if that takes no more than doubles
std::optional<Double_vector> vector_in_doubles(const Input_metric& input, std::uint32_t f,
                                               unsigned from, unsigned to) {
  const Input_metric::Sides& s = input.sides(f);
  const Input_metric::Point &p = input.points()[s[from]], &q = input.points()[s[to]];
  Double_vector result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Double_double d = Double_double::difference(q[k], p[k]);
    if (!d.is_double()) return std::nullopt;
    result[k] = d.to_double();
  }
  return result;
}

// the same, always
Long_vector long_vector(const Input_metric& input, std::uint32_t f, unsigned from, unsigned to) {
  const Input_metric::Sides& s = input.sides(f);
  const Input_metric::Point &p = input.points()[s[from]], &q = input.points()[s[to]];
  return {Double_double::difference(q[0], p[0]), Double_double::difference(q[1], p[1]),
          Double_double::difference(q[2], p[2])};
}

// The square of the quadruple area of the triangle of two vectors. A component u v - w x of their
// cross product goes through three roundings of at most |u v| + |w x|.
Short_ball long_squared_area(const Long_vector& u, const Long_vector& v) {
  constexpr double e = Double_double::rounding();
  Double_double sum = 0;
  double radius = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
    const Double_double p = u[i] * v[j], q = u[j] * v[i], c = p - q;
    const double error = 4 * e * (std::abs(p.magnitude()) + std::abs(q.magnitude()));
    sum = sum + c * c;
    radius += (2 * std::abs(c.magnitude()) + error) * error;
  }
  return Short_ball::around(sum.scaled(4), 4 * (1 + 0x1p-40) * (radius + 8 * e * sum.magnitude()));
}

Long_vector long_cross_product(const Double_vector& u, const Double_vector& v) {
  const auto component = [&](std::size_t i, std::size_t j) {
    return Double_double::product(u[i], v[j]) - Double_double::product(u[j], v[i]);
  };
  return {component(1, 2), component(2, 0), component(0, 1)};
}

Double_double long_squared_norm(const Double_vector& u) {
  return Double_double::product(u[0], u[0]) + Double_double::product(u[1], u[1]) +
         Double_double::product(u[2], u[2]);
}
Double_double long_squared_norm(const Long_vector& u) {
  return u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
}

// A sum of squares that has gone through six roundings, at most; what underflows is within the
// radius of every ball.
Short_ball enclosed(const Double_double& x) {
  return Short_ball::around(x, 8 * Double_double::rounding() * x.to_double());
}
Long_ball enclosed(const Gmpq& x) {
  return x == Gmpq(0) ? Long_ball(0) : Long_ball::around(Mpfr_number::nearest(x), 0);
}

// The values that `Input_side_values` gives one by one, of a face of points near each other: three
// vectors, where one by one takes five.
std::optional<Input_face_intervals<Short_ball>::Face> face_of_near_points(const Input_metric& input,
                                                                          std::uint32_t f) {
  if (!input.is_embedded() || input.delta() != 0 || input.has_excess(f)) return std::nullopt;
  const auto u = vector_in_doubles(input, f, 0, 1), v = vector_in_doubles(input, f, 1, 2),
             w = vector_in_doubles(input, f, 2, 0);
  if (!u || !v || !w) return std::nullopt;
  const Double_double area = Double_double(4) * long_squared_norm(long_cross_product(*u, *w));
  return Input_face_intervals<Short_ball>::Face{{enclosed(long_squared_norm(*u)),
                                                 enclosed(long_squared_norm(*v)),
                                                 enclosed(long_squared_norm(*w))},
                                                sqrt(enclosed(area))};
}

// as accurate as the bits allow, even for a thin face
Input_face_intervals<Long_ball>::Face wide_face(const Input_metric& input, std::uint32_t f) {
  return {{enclosed(input.squared_length<Gmpq>(f, 0)), enclosed(input.squared_length<Gmpq>(f, 1)),
           enclosed(input.squared_length<Gmpq>(f, 2))},
          sqrt(enclosed(input.squared_quadruple_area<Gmpq>(f)))};
}

// Errors of areas are where most of those of unfolded points come from.
Interval_nt<false> narrow_area(const Input_metric& input, std::uint32_t f) {
  using FT = Interval_nt<false>;
  const auto compute = [&] {
    return Input_side_values<Short_ball>(input).squared_quadruple_area(f);
  };
  const FT squared = to_nearest(compute).interval();
  return squared.sup() - squared.inf() <= 0x1p-50 * squared.sup() ? CGAL::sqrt(squared)
                                                                  : quadruple_area<FT>(input, f);
}

} // namespace

} // namespace internal

template <FieldNumber FT>
FT Input_side_values<FT>::squared_length(Face_side s) const {
  if constexpr (std::is_same_v<FT, Short_ball>)
    if (is_plain_ && !input_.has_excess(s.face)) {
      const unsigned next = (s.slot + 1) % 3;
      if (const auto u = internal::vector_in_doubles(input_, s.face, s.slot, next))
        return internal::enclosed(internal::long_squared_norm(*u));
      return internal::enclosed(
          internal::long_squared_norm(internal::long_vector(input_, s.face, s.slot, next)));
    }
  return input_.squared_length<FT>(s.face, s.slot);
}

template <FieldNumber FT>
FT Input_side_values<FT>::squared_quadruple_area(std::uint32_t f) const {
  if constexpr (std::is_same_v<FT, Short_ball>)
    if (is_plain_ && !input_.has_excess(f)) {
      if (const auto u = internal::vector_in_doubles(input_, f, 0, 1),
          v = internal::vector_in_doubles(input_, f, 0, 2);
          u && v)
        return internal::enclosed(
            Double_double(4) * internal::long_squared_norm(internal::long_cross_product(*u, *v)));
      return internal::long_squared_area(internal::long_vector(input_, f, 0, 1),
                                         internal::long_vector(input_, f, 0, 2));
    }
  return input_.is_embedded() ? internal::Embedded_area<FT>(input_, f).squared
                              : input_.squared_quadruple_area<FT>(f);
}

template class Input_side_values<Short_ball>;
template class Input_side_values<Long_ball>;

template <FieldNumber FT>
typename Input_face_intervals<FT>::Face Input_face_intervals<FT>::face(const Input_metric& input,
                                                                       std::uint32_t f) {
  if constexpr (std::is_same_v<FT, Interval_nt<false>>)
    return {{input.squared_length<FT>(f, 0), input.squared_length<FT>(f, 1),
             input.squared_length<FT>(f, 2)},
            internal::narrow_area(input, f)};
  else {
    if constexpr (std::is_same_v<FT, Long_ball>)
      // beyond the 256 bits of a thread at first
      if (Mpfr_number::rounding() < 0x1p-254) return internal::wide_face(input, f);
    if constexpr (std::is_same_v<FT, Short_ball>)
      if (const auto near = internal::face_of_near_points(input, f)) return *near;
    const Input_side_values<FT> values(input);
    return {{values.squared_length({f, 0}), values.squared_length({f, 1}),
             values.squared_length({f, 2})},
            values.quadruple_area(f)};
  }
}

template Input_face_intervals<Interval_nt<false>>::Face
Input_face_intervals<Interval_nt<false>>::face(const Input_metric&, std::uint32_t);
template Input_face_intervals<Short_ball>::Face
Input_face_intervals<Short_ball>::face(const Input_metric&, std::uint32_t);
template Input_face_intervals<Long_ball>::Face
Input_face_intervals<Long_ball>::face(const Input_metric&, std::uint32_t);

} // namespace CGAL::Intrinsic_triangulations

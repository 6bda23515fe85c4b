// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief encloses squared lengths and quadruple areas of input faces in balls, and remembers nothing: most are asked for once or
twice, when flips are repeated.

Where all differences of coordinates are doubles, as they are of points near each other, values of 106 bits are sums
of exact products, whose errors are known beforehand.
\tparam FT a `Ball`; rounding is to the nearest
*/
template <class FT>
class Input_side_values {
public:
  /// takes the input, which must outlive this object.
  explicit Input_side_values(const Input_metric& input)
      : input_(input), is_plain_(input.is_embedded() && input.delta() == 0) {}

  /// encloses the squared length of a side.
  FT squared_length(Face_side s) const {
    if constexpr (is_short)
      if (is_plain_ && !input_.has_excess(s.face))
        if (const auto u = vector(s.face, s.slot, (s.slot + 1) % 3))
          return enclosed(squared_norm(*u));
    return input_.squared_length<FT>(s.face, s.slot);
  }

  /// encloses the square of the quadruple area of a face.
  FT squared_quadruple_area(std::uint32_t f) const {
    if constexpr (is_short)
      if (is_plain_ && !input_.has_excess(f))
        if (const auto u = vector(f, 0, 1), v = vector(f, 0, 2); u && v)
          return enclosed(Double_double(4) * squared_norm(cross_product(*u, *v)));
    return input_.is_embedded() ? internal::Embedded_area<FT>(input_, f).squared
                                : input_.squared_quadruple_area<FT>(f);
  }

  /// encloses the quadruple area of a face.
  FT quadruple_area(std::uint32_t f) const { return sqrt(squared_quadruple_area(f)); }

private:
  static constexpr bool is_short = std::is_same_v<FT, Ball<Double_double>>;

  using Vector = std::array<double, 3>;
  using Long_vector = std::array<Double_double, 3>;

  // from one corner of a face to another, if that takes no more than doubles
  std::optional<Vector> vector(std::uint32_t f, unsigned from, unsigned to) const {
    const Input_metric::Sides& s = input_.sides(f);
    const Input_metric::Point &p = input_.points()[s[from]], &q = input_.points()[s[to]];
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
      const Double_double d = Double_double::difference(q[k], p[k]);
      if (!d.is_double()) return std::nullopt;
      result[k] = d.to_double();
    }
    return result;
  }

  static Long_vector cross_product(const Vector& u, const Vector& v) {
    const auto component = [&](std::size_t i, std::size_t j) {
      return Double_double::product(u[i], v[j]) - Double_double::product(u[j], v[i]);
    };
    return {component(1, 2), component(2, 0), component(0, 1)};
  }

  static Double_double squared_norm(const Vector& u) {
    return Double_double::product(u[0], u[0]) + Double_double::product(u[1], u[1]) +
           Double_double::product(u[2], u[2]);
  }
  static Double_double squared_norm(const Long_vector& u) {
    return u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
  }

  // A sum of squares that has gone through six roundings, at most; what underflows is within the radius of every ball.
  static FT enclosed(const Double_double& x) {
    return FT::around(x, 8 * Double_double::rounding() * x.to_double());
  }

  const Input_metric& input_;
  bool is_plain_; // whether lengths are distances
};

/*!
\brief encloses the squared lengths and the quadruple areas of input faces, and remembers them.
\tparam FT `Interval_nt<false>` or a `Ball`, of the same precision in all calls; rounding is as the
type asks for
*/
template <class FT>
class Input_face_intervals {
public:
  /// Encloses a number.
  using Number = FT;
  /// Squared lengths and quadruple area of a face.
  using Face = std::pair<std::array<FT, 3>, FT>;

  /// returns a functor from a face to its values; references stay valid until the next call of this
  /// function.
  auto of(const Input_metric& input) {
    if (faces_.size() > maximal_faces) {
      faces_.clear();
      place_.clear();
    }
    place_.resize(input.number_of_faces(), 0);
    return [&input, this](std::uint32_t f) -> const Face& {
      std::uint32_t& place = place_[f];
      if (place == 0) {
        faces_.push_back(face(input, f));
        place = static_cast<std::uint32_t>(faces_.size());
      }
      return faces_[place - 1];
    };
  }

  /// computes the values of a face.
  static Face face(const Input_metric& input, std::uint32_t f) {
    if constexpr (std::is_same_v<FT, Interval_nt<false>>)
      return {lengths(input, f), narrow_area(input, f)};
    else {
      if constexpr (is_long)
        if (Mpfr_number::rounding() < 0x1p-254) return wide_face(input, f);
      const Input_side_values<FT> values(input);
      return {{values.squared_length({f, 0}), values.squared_length({f, 1}),
               values.squared_length({f, 2})},
              values.quadruple_area(f)};
    }
  }

private:
  static constexpr bool is_long = std::is_same_v<FT, Ball<Mpfr_number>>;

  static constexpr std::size_t maximal_faces =
      is_long ? thresholds::remembered_faces : std::size_t(1) << 31;

  // as good as so many bits can be, whatever a thin face loses
  static Face wide_face(const Input_metric& input, std::uint32_t f) {
    const auto enclosed = [](const Gmpq& x) {
      return x == Gmpq(0) ? FT(0) : FT::around(Mpfr_number::nearest(x), 0);
    };
    return {{enclosed(input.squared_length<Gmpq>(f, 0)), enclosed(input.squared_length<Gmpq>(f, 1)),
             enclosed(input.squared_length<Gmpq>(f, 2))},
            sqrt(enclosed(input.squared_quadruple_area<Gmpq>(f)))};
  }

  // Errors of areas are where most of those of unfolded points come from.
  static FT narrow_area(const Input_metric& input, std::uint32_t f) {
    const auto compute = [&] {
      return Input_side_values<Ball<Double_double>>(input).squared_quadruple_area(f);
    };
    const FT squared = internal::to_nearest(compute).interval();
    return squared.sup() - squared.inf() <= 0x1p-50 * squared.sup() ? CGAL::sqrt(squared)
                                                                    : quadruple_area<FT>(input, f);
  }

  static std::array<FT, 3> lengths(const Input_metric& input, std::uint32_t f) {
    return {input.squared_length<FT>(f, 0), input.squared_length<FT>(f, 1),
            input.squared_length<FT>(f, 2)};
  }

  // in the order in which they were first asked for: those that are unfolded together are near each
  // other
  std::deque<Face> faces_;
  std::vector<std::uint32_t> place_; // of each face: its number there and one, or zero
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PLANE_VECTOR_H
#define CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PLANE_VECTOR_H

#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstddef>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a vector or a point of the plane, and the complex number x + i y.
\tparam FT a model of `RingNumber`; division requires a model of `FieldNumber`
\tparam Units any type: the name of the units, so that vectors in different ones do not mix. `void`
  where faces are laid out, which is in scaled units; see `Unscaled_vector` for those of the input
*/
template <RingNumber FT, class Units = void>
struct Plane_vector {
  FT x; ///< first coordinate
  FT y; ///< second coordinate

  /// returns coordinate 0 or 1.
  constexpr const FT& operator[](std::size_t c) const { return c == 0 ? x : y; }
  /// returns coordinate 0 or 1.
  constexpr FT& operator[](std::size_t c) { return c == 0 ? x : y; }

  /// adds
  friend Plane_vector operator+(const Plane_vector& a, const Plane_vector& b) {
    return {a.x + b.x, a.y + b.y};
  }
  /// subtracts
  friend Plane_vector operator-(const Plane_vector& a, const Plane_vector& b) {
    return {a.x - b.x, a.y - b.y};
  }
  /// stretches
  friend Plane_vector operator*(const FT& s, const Plane_vector& a) { return {a.x * s, a.y * s}; }
  /// shrinks
  friend Plane_vector operator/(const Plane_vector& a, const FT& s) { return {a.x / s, a.y / s}; }
  /// multiplies complex numbers: turns and stretches.
  friend Plane_vector operator*(const Plane_vector& a, const Plane_vector& b) {
    return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
  }
  /// tells whether coordinates are equal.
  friend bool operator==(const Plane_vector& a, const Plane_vector& b) {
    return a.x == b.x && a.y == b.y;
  }

  /// returns the inner product.
  friend FT dot(const Plane_vector& a, const Plane_vector& b) { return a.x * b.x + a.y * b.y; }
  /// returns the area that two vectors span: positive if `b` is to the left of `a`.
  friend FT cross(const Plane_vector& a, const Plane_vector& b) { return a.x * b.y - a.y * b.x; }
  /// returns `b` in the frame of `a`, times the length of `a`: along it, and to the left of it.
  friend Plane_vector in_frame(const Plane_vector& a, const Plane_vector& b) {
    return {dot(a, b), cross(a, b)};
  }
};

/// is a vector in the units of the input; `unscaled()` makes one of a vector in scaled units.
using Unscaled_vector = Plane_vector<double, class Units_of_input>;

/// returns a vector in the units of the input. \param v in scaled units
/// \param scale_exponent see `Input::scale_exponent()`
inline Unscaled_vector unscaled(const Plane_vector<double>& v, int scale_exponent) {
  return {std::ldexp(v.x, -scale_exponent), std::ldexp(v.y, -scale_exponent)};
}
/// returns a vector in scaled units; the inverse of `unscaled()`.
inline Plane_vector<double> scaled(const Unscaled_vector& v, int scale_exponent) {
  return {std::ldexp(v.x, scale_exponent), std::ldexp(v.y, scale_exponent)};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_FORMULAS_PLANE_VECTOR_H

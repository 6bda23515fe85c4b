// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_NUMBER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_NUMBER_H

#include <CGAL/Gmpq.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>
#include <functional>

namespace CGAL::Intrinsic_triangulations::internal {

struct Hash_of_rational {
  std::size_t operator()(const Gmpq& x) const { return std::hash<double>()(CGAL::to_double(x)); }
};

// The number x + y sqrt(-q), where a chart or a triangle knows q.
struct Plane_number {
  Gmpq x, y;

  friend Plane_number operator+(const Plane_number& a, const Plane_number& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend Plane_number operator-(const Plane_number& a, const Plane_number& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend Plane_number operator-(const Plane_number& a) { return {-a.x, -a.y}; }
  friend bool operator==(const Plane_number& a, const Plane_number& b) {
    return a.x == b.x && a.y == b.y;
  }
  friend bool operator<(const Plane_number& a, const Plane_number& b) {
    return a.x != b.x ? a.x < b.x : a.y < b.y;
  }
};

inline Gmpq norm(const Plane_number& z, const Gmpq& q) { return z.x * z.x + z.y * z.y * q; }

inline Plane_number product(const Plane_number& a, const Plane_number& b, const Gmpq& q) {
  return {a.x * b.x - a.y * b.y * q, a.x * b.y + a.y * b.x};
}

inline Plane_number quotient(const Plane_number& a, const Plane_number& b, const Gmpq& q) {
  const Gmpq n = norm(b, q);
  const Plane_number c = product(a, {b.x, -b.y}, q);
  return {c.x / n, c.y / n};
}

// A triangle with its first side from 0 to 1, in numbers whose q is its squared quadruple area.
struct Rational_triangle {
  // \param l the squared lengths of its sides
  explicit Rational_triangle(const std::array<Gmpq, 3>& l) : lengths(l) {
    const Gmpq p = l[0] + l[2] - l[1], twice = 2 * l[0];
    squared_area = 4 * l[0] * l[2] - p * p;
    corners = {Plane_number{0, 0}, {1, 0}, {p / twice, 1 / twice}};
  }

  std::array<Gmpq, 3> lengths; // squared
  Gmpq squared_area;           // of the quadruple area
  std::array<Plane_number, 3> corners;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_NUMBER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_NUMBEREDCOMPLEX_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_NUMBEREDCOMPLEX_H

#include <concepts>
#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief asks for a triangulated surface with a metric that is read by the numbers of its elements.

Syntax of \ref ::NumberedComplex, where its meaning is described.
*/
template <class Complex>
concept NumberedComplex = requires(const Complex& c, std::uint32_t i) {
  { c.next(i) } -> std::same_as<std::uint32_t>;
  { c.is_border(i) } -> std::same_as<bool>;
  { c.face(i) } -> std::same_as<std::uint32_t>;
  { c.source(i) } -> std::same_as<std::uint32_t>;
  { c.target(i) } -> std::same_as<std::uint32_t>;
  { c.outgoing_halfedge(i) } -> std::same_as<std::uint32_t>;
  { c.squared_length(i) } -> std::same_as<double>;
  { c.quadruple_area(i) } -> std::same_as<double>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_NUMBEREDCOMPLEX_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVIDE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVIDE_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/extract_subdivision.h>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief extracts the common subdivision of an intrinsic triangulation and its input (§3.6 of the course).
\tparam Triangulation an instance of `Intrinsic_triangulation` with the correspondence
  `Integer_coordinates`, `Explicit_crossings` or `Signposts`
\param t the triangulation
\throws std::length_error if there are more than 2^31 crossings
\throws Invalid_input naming an intrinsic edge whose path signposts do not find
\complexity linear in the size of the result
*/
template <class Triangulation>
Common_subdivision common_subdivision(const Triangulation& t) {
  const auto& c = t.correspondence();
  static_assert(
      requires { c.input(); },
      "without correspondence nothing is known of where edges run on the input; use "
      "Integer_coordinates as third argument of Intrinsic_triangulation");
  if constexpr (requires { c.normal_coordinate(std::uint32_t{}); })
    return extract_subdivision(t, c);
  else if constexpr (requires { c.input(); })
    return extract_subdivision(t, integer_coordinates(t, c)); // found by argument-dependent lookup
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_SUBDIVIDE_H

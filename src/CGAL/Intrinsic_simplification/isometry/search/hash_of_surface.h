// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_HASH_OF_SURFACE_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_HASH_OF_SURFACE_H

#include <cstdint>

namespace CGAL::Intrinsic_triangulations::internal {

class Isometry_run;
class Singular_surface;

// The double nearest to a squared length, in the units of the user. It does not
// depend on the way of computation.
double rounded_squared_length(const Singular_surface& s, std::uint32_t dart);

// See `Canonical_form::hash()`.
std::uint64_t hash_of_surface(const Singular_surface& s, Isometry_run& run);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_HASH_OF_SURFACE_H

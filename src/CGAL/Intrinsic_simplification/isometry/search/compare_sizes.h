// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_COMPARE_SIZES_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_COMPARE_SIZES_H

namespace CGAL::Intrinsic_triangulations::internal {

class Singular_surface;

// Whether areas show that the sizes differ by a factor for which numbers are not made.
bool have_sizes_far_apart(const Singular_surface& a, const Singular_surface& b);
// Whether areas or lengths of borders are different by proof, also where vertices of tessellations
// are arbitrary.
bool have_different_sizes(const Singular_surface& a, const Singular_surface& b);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_SEARCH_COMPARE_SIZES_H

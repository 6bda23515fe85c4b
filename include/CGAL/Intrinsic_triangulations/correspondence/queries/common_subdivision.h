// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H

#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/extract_subdivision.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief extracts the common subdivision of an intrinsic triangulation and its input (§3.6 of the course).

Its connectivity follows from integers alone: it is that of a subdivision of both, whatever rounding
does to the locations of the crossings.
\tparam Triangulation a model of `CorrespondingTriangulation`
\param t the triangulation
\throws std::length_error if there are more than 2^31 crossings
\throws Invalid_input naming an intrinsic edge whose path signposts do not find
\complexity linear in the size of the result
*/
template <internal::Queried_triangulation Triangulation>
Common_subdivision common_subdivision(const Triangulation& t) {
  return internal::extract_subdivision(t, internal::queries(t).curves());
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(common_subdivision)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_COMMON_SUBDIVISION_H

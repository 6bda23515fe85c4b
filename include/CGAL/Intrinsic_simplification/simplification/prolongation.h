// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_PROLONGATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_PROLONGATION_H

#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>

#include <Eigen/SparseCore>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the matrix that takes functions from the coarse vertices to the fine ones, linear in
the coarse faces.
\param s the simplification
\return fine by coarse vertices; no entry is negative, and each row sums to 1, up to rounding; the
  row of an isolated vertex has no entries
\complexity linear
*/
Eigen::SparseMatrix<double> prolongation(const Simplification& s);

/*!
\brief returns the matrix that takes functions from the vertices of one coarse surface to those of a
finer one of the same run, see `hierarchy()`.

It contains the rows of `prolongation(coarser)` of the vertices that the finer surface has: so
`prolongation(finer) * prolongation(finer, coarser)` equals `prolongation(coarser)` in these rows.
In others it is linear in the faces of the finer surface in place of those of the coarser one.
\param finer, coarser elements of what `hierarchy()` returns
\return the vertices of the finer by those of the coarser surface
\complexity linear
*/
Eigen::SparseMatrix<double> prolongation(const Simplification& finer,
                                         const Simplification& coarser);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_PROLONGATION_H

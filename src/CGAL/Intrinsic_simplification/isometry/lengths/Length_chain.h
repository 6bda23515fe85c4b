// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_LENGTH_CHAIN_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_LENGTH_CHAIN_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>

#include <CGAL/Gmpq.h>

#include <cstddef>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
A squared length as a chain of similarities of the plane: unit |f(0)|^2, where f is the
composition of the links, the last one first. Each link belongs to one triangle or chart, and has
its square root only. As a sum of products of roots, the length has 2^n terms for n roots; the
chain has n links.
*/
struct Length_chain {
  // z -> turn z + shift, in the numbers x + y sqrt(-square). The turn is not 0.
  struct Link {
    Gmpq square;
    Plane_number turn, shift;
  };

  Gmpq unit;
  std::vector<Link> links;

  // the same length, from its other end
  Length_chain reversed() const;
};

Length_chain::Link inverse(const Length_chain::Link& link);

/*
Whether two squared lengths are equal whatever the roots are: their difference is the zero
polynomial in roots of different square classes. If not, nothing is known, for roots may depend on
each other.

The links act on the functions u + v x + w y + q (x^2 + y^2) of the plane. So the difference is a
product of matrices of 8 rows, each of which is linear in one root. Where a root has occurred for
the last time, its coefficient has to vanish by itself, so that one vector becomes two; but all
vectors so far span a space of at most 8 dimensions for each product of roots that occur before
and after. A basis of this space goes along both chains (Schuetzenberger 1961 decides the equality
of weighted automata so). \complexity polynomial in the lengths of the chains, if few roots occur
again later on. At most four may do so at a time; with more, nothing is known.
\param words_left how many words of numbers may be multiplied: those that were are taken off. If
  they are used up, nothing is known
*/
bool are_identical(const Length_chain& a, const Length_chain& b, std::size_t& words_left);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_LENGTH_CHAIN_H

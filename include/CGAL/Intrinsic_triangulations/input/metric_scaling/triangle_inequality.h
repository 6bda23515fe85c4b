// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <cstdint>
#include <vector>

/*!
\file
Which faces of a metric given by squared lengths violate the triangle inequality, exactly; and the
greatest lengths below that satisfy it in every face.

With b and c two sides of a face, the third may be as long as

G(b, c) = max(b, c) + (1 - margin) min(b, c).

G increases in both arguments, and G(b, c) >= max(b, c). The largest lengths l with l <= l_0 and l_a
<= G(l_b, l_c) for all sides a of all faces therefore exist, and are what a generalization of
Dijkstra's algorithm finds (D. E. Knuth, *A generalization of Dijkstra's algorithm*, 1977): violated
constraints are settled in the order of the length that they allow. A length set later is never
smaller, so that no edge is set twice. A shortened edge stays at least as long as each of the two
others in the face that required it: nothing collapses, and the shortest edge stays as it is.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells whether the square roots of three numbers satisfy the triangle inequality: no side is
longer than the other two together. Exact.

They do iff (4A)^2 >= 0. `squared_quadruple_area()` in doubles errs by less than 2^-98 of 4yz, with
y and z the two shortest, unless something over- or underflows; what it leaves open is computed in
rationals.
\pre all are finite and not negative
\complexity constant
*/
bool squares_satisfy_triangle_inequality(double L_ij, double L_jk, double L_ki);

namespace internal {

// The edges of the sides of a face, in the order of its halfedges.
inline std::array<std::uint32_t, 3> edges_of_face(const Gluing_map& mesh, std::uint32_t f) {
  const auto [h, n, l] = mesh.sides({f});
  return {h.index / 2, n.index / 2, l.index / 2};
}

} // namespace internal

/*!
\brief lists the faces whose sides violate the triangle inequality. Exact; faces of zero area
satisfy it.
\param mesh the connectivity, oriented or not
\param squared_lengths one squared length per edge of `mesh`, finite and not negative
\return the numbers of the faces, increasing
\complexity linear
*/
std::vector<std::uint32_t>
faces_violating_triangle_inequality(const Gluing_map& mesh,
                                    const std::vector<double>& squared_lengths);

/*!
\brief reports what `shorten_edges()` did.
*/
struct Shortening_report {
  /// Number of edges that are shorter now.
  std::size_t changed_edges = 0;
  /// Largest (l - l') / l, with l the length that an edge had and l' the one that it has.
  double largest_relative_change = 0;
};

/*!
\brief shortens edges until all faces satisfy the triangle inequality strictly: to the greatest
lengths, none above the given one, such that every side is at most the longer of the other two plus
(1 - `margin`) times the shorter.

Needles stay as they are, however thin, since the margin is relative to the shorter side. The
inequality is strict for the rounded squares of the result: all faces have positive area, except
those with a side of length zero, whose other sides become equally long.
\param mesh the connectivity, oriented or not
\param squared_lengths one squared length per edge of `mesh`, finite and not negative; replaced
\param margin above 0, at most 1
\throws std::invalid_argument if `margin` is out of range
\complexity linear, and k log k for k edges that are shortened, each once
*/
Shortening_report shorten_edges(const Gluing_map& mesh, std::vector<double>& squared_lengths,
                                double margin);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_METRIC_SCALING_TRIANGLE_INEQUALITY_H

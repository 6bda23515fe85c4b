// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_EDGE_LISTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_EDGE_LISTS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include <algorithm>
#include <array>
#include <cstdint>

/*!
\file
Which curves a new edge crosses, as ranges of those that cross the sides of the faces that it is drawn
in.

Each function calls `append(h, first, last)` for ranges of curves that cross halfedge `h`, counted from
its source, in the order in which the new edge crosses them, and so that they cross both from the same
side: then the input halfedges of the faces entered are those of `h`.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// The sides of two faces at an edge, in the order of the corners i, j, k and j, i, m.
struct Quad_sides {
  std::array<std::uint32_t, 3> left;  ///< ij, jk, ki
  std::array<std::uint32_t, 3> right; ///< ji, im, mj
};

/*!
\brief finds the curves that cross the edge km which a flip of ij makes.

These are the curves with one end on the path k, i, m around the quad, without k and m, and the other on
the path k, j, m. Seen from ki and im, all do but those arcs about i, counted from i along ij, that are
arcs about i on the other side too, or end there at the opposite corner: they are last on ki and first
on im. Between ki and im the curves from i cross: to jk, along ij, to mj.
\param q the sides
\param f how curves run in the left face
\param g how curves run in the right face
\param append see above
\param append_edge called where the curve along ij is crossed, if there is one
*/
template <class Append, class Append_edge>
void find_crossings_of_flipped_edge(const Quad_sides& q,
                                    const std::array<Normal_coordinate, 3>& left,
                                    const std::array<Normal_coordinate, 3>& right,
                                    const Corner_coordinates& f, const Corner_coordinates& g,
                                    Append append, Append_edge append_edge) {
  const std::uint32_t jk = q.left[1], ki = q.left[2], im = q.right[1], mj = q.right[2];
  const Normal_coordinate n_ki = crossings(left[2]), n_im = crossings(right[1]);
  append(ki, 0, n_ki - std::min(f.cutting[0], g.cutting[1] + g.emanating[2]));
  append(jk ^ 1U, f.cutting[2], f.cutting[2] + f.emanating[0]);
  if (left[0] < 0) append_edge();
  append(mj ^ 1U, g.cutting[0], g.cutting[0] + g.emanating[1]);
  append(im, std::min(g.cutting[1], f.cutting[0] + f.emanating[2]), n_im);
}

/*!
\brief finds the curves that cross the edge from a corner of a face to a vertex inserted in it.

These are the curves between the corner and the region of the vertex: first the arcs about the corner,
then curves that emanate from another one, then the arcs about another corner which cut off the region,
from the outermost one.
\param k the corner
\param sides the sides of the face
\param normal their normal coordinates
\param c how curves run in the face
\param r the region of the vertex
\param append see above
*/
template <class Append>
void find_crossings_of_spoke(unsigned k, const std::array<std::uint32_t, 3>& sides,
                             const std::array<Normal_coordinate, 3>& normal,
                             const Corner_coordinates& c, const Face_region& r, Append append) {
  const unsigned next = (k + 1) % 3, before = (k + 2) % 3;
  append(sides[k], 0, r.cutting[k]);
  const bool on_fan = r.is_on_curve && r.corner == r.fan_corner;
  if (r.fan_corner == before) // its curves leave through the side from k, the first ones first
    append(sides[k], c.cutting[k], c.cutting[k] + r.right_of_fan);
  else if (r.fan_corner == next) { // through the side to k, the last ones first
    const Normal_coordinate crossed = c.emanating[next] - r.right_of_fan - (on_fan ? 1 : 0);
    append(sides[before] ^ 1U, c.cutting[k], c.cutting[k] + crossed);
  }
  for (const unsigned l : {next, before}) {
    const bool on_arc = r.is_on_curve && r.corner == l && r.fan_corner != l;
    const std::uint32_t to_l = l == next ? sides[k] : sides[before] ^ 1U;
    const Normal_coordinate n = crossings(normal[l == next ? k : before]);
    append(to_l, n - c.cutting[l], n - r.cutting[l] - (on_arc ? 1 : 0));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_EDGE_LISTS_H

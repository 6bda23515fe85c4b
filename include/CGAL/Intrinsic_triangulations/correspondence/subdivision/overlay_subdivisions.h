// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_OVERLAY_SUBDIVISIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_OVERLAY_SUBDIVISIONS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstdint>
#include <vector>

/*!
\file
Three triangulations of one surface on each other: two common subdivisions have a triangulation in
common, the middle one.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the common subdivision of an input and the polygons of another common subdivision.

In `subdivision` these polygons have the place of the intrinsic faces, with their own numbers, and
their sides are the intrinsic edges. Vertices of the polygons come first, with their numbers;
crossings of the other subdivision are of the kind `inserted`. Faces of the input have their numbers
there.
*/
struct Overlaid_subdivision {
  Common_subdivision subdivision; ///< the faces, each in one face of all three triangulations
  /// The corner of the other subdivision where each intrinsic halfedge of `subdivision` starts.
  std::vector<std::uint32_t> corner;
};

/*!
\brief overlays two common subdivisions with a triangulation in common.

In a face of the middle triangulation, edges of both others are chords between points of its border.
Two chords cross if and only if their ends alternate along the border. So the connectivity follows
from the order of crossings along each edge of the middle triangulation: each subdivision has the
order of its own, and places along the edge decide between the two. Whatever these places are, the
result is a surface. Chords cross where they do as straight lines in the middle face.
\param first the common subdivision of the input and the middle triangulation
\param second that of the middle triangulation, as its input, and another triangulation
\param input the input
\param middle the middle triangulation, without border; its elements have the numbers of intrinsic
  elements in `first` and of input elements in `second`
\return the overlay; its intrinsic edges have straight pieces in the middle face, with places along
  them in its metric
\throws Invalid_input naming a vertex, edge or face of the middle triangulation with which a
  subdivision disagrees: that of another or of an earlier triangulation, or with inserted vertices
\complexity n log n in the size of the result; and linear for each chord in the number of ends of
  crossed chords between its own
*/
Overlaid_subdivision overlay_subdivisions(const Common_subdivision& first,
                                          const Common_subdivision& second, const Input& input,
                                          const Gluing_map& middle);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_OVERLAY_SUBDIVISIONS_H

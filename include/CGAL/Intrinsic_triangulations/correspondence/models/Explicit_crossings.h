// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief represents how an intrinsic triangulation lies on the input by the crossings themselves (§3.3
of the course): each intrinsic edge lists the input edges that it crosses, in order.

This is the overlay of Fisher et al. 2007 with its faces left implicit: in one intrinsic face the
curves do not cross each other, so that the numbers of crossings on its three sides determine which
of them are joined (Eq. 9 and 10), and thus all vertices, edges and faces of the overlay in it. The
overlay's edges along a side are the gaps of its list, and those along curves join two crossings, or
a corner and a crossing. `Integer_coordinates` store the rest: where curves start from vertices, and
along which edges they run.

In this form, the overlay has all moves; the literature only describes flips. A flip of ij to km
changes the list of that edge alone: a curve crosses km if it joins the two sides of the quad that
km separates, and where it meets those sides it is in their lists, in the order along km. A vertex
inserted in a face lies in one of the overlay's faces there, or on a curve: an edge from a corner to
it crosses the curves that separate the two, which meet the sides of the face, and runs along the
curve if that starts from the corner. Removal of a vertex of degree three undoes this. A vertex on
an edge is one in a face of no area, followed by a flip; a vertex on the border needs one new edge,
which is found in the same way. Whatever the new edge, its list is made of a few ranges of the lists
of sides of faces. A vertex on a curve cuts it in two; lists stay, since they name the input edge.

Flips cost time linear in the lists that they change. In return, the crossings of an edge are found
without following curves; see `trace_edge()`.

\cgalModels{CurveCoordinates}
*/
class Explicit_crossings : public Integer_coordinates {
public:
  /// Name of the representation in programs.
  static constexpr const char* name = "crossings";

  /// observes the triangulation that the input is: every edge runs along itself.
  /// \complexity linear
  template <class Triangulation>
  void start(const Triangulation& t) {
    Integer_coordinates::start(t);
    kept_.keep_always(number_of_edges());
  }

  /// takes coordinates of a triangulation that is restored, and follows all curves.
  /// \throws std::length_error see `edge_crossings()` \complexity linear in the number of edges and
  /// crossings
  template <class Triangulation>
  void restore(const Triangulation& t, Integer_coordinates coordinates) {
    const Edge_crossings all =
        edge_crossings(t, coordinates); // may throw: nothing has changed then
    Integer_coordinates::restore(t, std::move(coordinates));
    kept_.keep_always(fans(), all);
  }

  /// returns the input halfedge that intrinsic halfedge `h` runs along, or along a part of which;
  /// none if it runs across faces.
  std::uint32_t along(std::uint32_t h) const {
    return normal_coordinate(h / 2) < 0 ? fans().halfedge(roundabout(h)) : Gluing::none;
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TRIANGULATION_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <utility>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief builds the intrinsic Delaunay triangulation of a surface, in one call: exact, and with its
place on the input. With it, most functions of the package are one statement on a mesh:

    const Uniformization map = uniformize(delaunay_triangulation(mesh));

\param input see `Intrinsic_input`: arrays, lengths, or a domain, which `make_domain()` makes of any
  faces
\return the triangulation, of which `flip_to_delaunay()` has made a Delaunay one
\throws Invalid_input
\complexity see `flip_to_delaunay()`
*/
inline Corresponding_triangulation delaunay_triangulation(Intrinsic_input input) {
  Corresponding_triangulation t(std::move(input));
  flip_to_delaunay(t);
  return t;
}

/*!
\brief builds the intrinsic Delaunay triangulation of a mesh in space.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
*/
template <class FaceGraph>
  requires internal::Surface_in_space<FaceGraph> Corresponding_triangulation delaunay_triangulation(
      const FaceGraph& mesh, Mollification mollification = Mollification::automatic) {
    return delaunay_triangulation(Intrinsic_input(mesh, mollification));
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_TRIANGULATION_H

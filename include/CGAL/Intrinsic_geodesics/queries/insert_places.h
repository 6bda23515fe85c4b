// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_PLACES_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_PLACES_H

#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/queries/Copies_of_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds or inserts a vertex at each of the places through which a curve leads.

On a cover it chooses among the copies of each place, so that the curve is short.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation; flip it to Delaunay before
\param places the places, as users name them
\param is_loop whether the curve returns to the first place
\return the vertices, in the order of the places
\throws Invalid_input as `insert_place()`
\complexity that of `insert_place()` for each place; on a cover, also exact distances between all
  copies of consecutive places
*/
template <RefinableTriangulation Triangulation>
std::vector<typename Triangulation::vertex_descriptor>
insert_places(Triangulation& t, const std::vector<Place>& places, bool is_loop = false) {
  std::vector<std::vector<typename Triangulation::vertex_descriptor>> copies;
  for (const Place& p : places) copies.push_back(insert_place(t, p));
  if (t.input().names().is_cover())
    return internal::Copies_of_curve<Triangulation>(t, copies, is_loop).chosen();
  std::vector<typename Triangulation::vertex_descriptor> result;
  for (const auto& v : copies) result.push_back(v.front());
  return result;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_INSERT_PLACES_H

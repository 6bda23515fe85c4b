// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_ON_MESH_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_ON_MESH_H

#include <CGAL/Intrinsic_operators/distance/Distance_options.h>
#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// finds distances on the Delaunay triangulation of a mesh: one call of `Distances::from()`, see
/// there. `distances(mesh, {Place::at_vertex(0)})` has those from vertex 0 in its member `by_row`.
/// \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
template <class FaceGraph>
  requires internal::Surface_in_space<FaceGraph> Found_distances
  distances(const FaceGraph& mesh, const std::vector<Place>& sources,
            const Distance_options& options = {}, const std::vector<Place>& targets = {}) {
    return distances(delaunay_triangulation(mesh), sources, options, targets);
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCES_ON_MESH_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POINTS_OF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POINTS_OF_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns the coordinates of the vertices of a mesh, in its order: what functions take that
know vertices by row, such as `Vectors`.
\tparam FaceGraph a model of `FaceListGraph` with a point map of its own
\complexity linear
*/
template <ReadableFaceGraph FaceGraph>
std::vector<std::array<double, 3>> points_of(const FaceGraph& mesh) {
  const auto map = Mesh_adaptor<FaceGraph>::point_map(mesh);
  std::vector<std::array<double, 3>> points;
  for (const typename boost::graph_traits<FaceGraph>::vertex_descriptor v : vertices(mesh))
    points.push_back(Mesh_adaptor<FaceGraph>::coordinates(get(map, v)));
  return points;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_POINTS_OF_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SHORTENING_CERTIFY_GEODESIC_H
#define CGAL_INTRINSIC_GEODESICS_SHORTENING_CERTIFY_GEODESIC_H

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/shortening/is_geodesic.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/is_straight.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <set>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Faces about the vertices of curves whose area is not positive, and edges of curves that are bent.
template <class Triangulation, class Integers, class Here>
std::size_t count_invalid_elements(const Curve_network<Triangulation>& network,
                                   const Integers& integers, const Here& here) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  const Triangulation& t = network.triangulation();
  const typename Integers::Const_session session(integers);
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  std::set<std::uint32_t> edges, faces;
  std::size_t invalid = 0;
  const auto check_face = [&](Halfedge h) {
    if (face(h, t.mesh()) != null && faces.insert(t.index(face(h, t.mesh()))).second &&
        session.orientation(here(h)) != POSITIVE)
      ++invalid;
  };
  for (std::uint32_t c = 0; c < network.number_of_curves(); ++c)
    for (const Halfedge h : network.halfedges(c)) {
      if (edges.insert(t.index(edge(h, t.mesh()))).second && !is_straight(integers, here(h)))
        ++invalid;
      Halfedge g = h;
      do {
        check_face(g);
        g = opposite(next(g, t.mesh()), t.mesh());
      } while (g != h);
    }
  return invalid;
}

} // namespace internal

/*!
\brief decides exactly whether curves from any arithmetic are geodesic.

It does not use the metric: it unfolds the edges from the input (see `Integer_only_triangulation`).
It compares the angles at all joints with pi. Faces about joints must have positive area, and edges
of curves must be straight.
\param network the curves
\throws Invalid_input and std::length_error as the constructor of `Integer_only_triangulation`
\complexity linear in the mesh, which is copied, and in the crossings of edges at the curves
*/
template <CorrespondingTriangulation Triangulation>
Geodesic_report certify_geodesic(const Curve_network<Triangulation>& network) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Integers = Integer_only_triangulation<typename Triangulation::Mesh>;
  const Triangulation& t = network.triangulation();
  const Integers integers(t);
  const typename Integers::Const_session session(integers);
  const auto here = [&](Halfedge h) {
    return integers.numbers().halfedge_at(t.numbers().halfedge(h));
  };
  Geodesic_report report;
  report.joints = internal::Network_joints<Triangulation>(network).reports(
      [&](Halfedge h, Halfedge g) { return session.compare_angle_to_pi(here(h), here(g)); });
  report.invalid_elements = internal::count_invalid_elements(network, integers, here) +
                            integers.metric().statistics().probable_zero;
  return report;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SHORTENING_CERTIFY_GEODESIC_H

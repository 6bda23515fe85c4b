// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_H
#define CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_H

#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Shortening_result.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a tree of edges of an intrinsic triangulation, along which its paths from a source are geodesics.

It refers to the triangulation, whose edges in the tree must not be flipped.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <class Triangulation>
class Geodesic_tree {
  static_assert(GeodesicTriangulation<Triangulation>,
                "curves are on an intrinsic triangulation, not on a mesh: build one of the mesh, "
                "such as Corresponding_triangulation");

public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the triangulation.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// What is known of a vertex.
  struct Branch {
    /// Length of its path, in the units of the input; infinite without one.
    double length = std::numeric_limits<double>::infinity();
    /// Number of the last halfedge of its path; none at the source, and without a path.
    std::uint32_t halfedge = Gluing::none;
  };

  /// gathers what is known. \param t the triangulation \param branches per number of a vertex \param counts what was done
  Geodesic_tree(const Triangulation& t, std::vector<Branch> branches,
                const Shortening_result& counts)
      : t_(&t), branches_(std::move(branches)), counts_(counts) {}

  /// tells what was done to build it, and how that ended.
  const Shortening_result& shortening() const { return counts_; }
  /// returns the length of the path to a vertex, in the units of the input; infinite if there is no path. It is the sum of what doubles
  /// have kept of lengths in the flips; with exact traits the lengths of the edges of `path_to()` are told to 1e-12.
  double length(vertex_descriptor v) const { return branches_[t_->index(v)].length; }
  /// returns the last halfedge of the path to a vertex; a null halfedge at the source, and if there is no path.
  halfedge_descriptor halfedge_to(vertex_descriptor v) const {
    const std::uint32_t h = branches_[t_->index(v)].halfedge;
    return h == Gluing::none ? boost::graph_traits<typename Triangulation::Mesh>::null_halfedge()
                             : t_->numbers().halfedge_at(h);
  }
  /// returns the halfedges of the path to a vertex, from the source; none if there is no path. \complexity linear in their number
  std::vector<halfedge_descriptor> path_to(vertex_descriptor v) const {
    std::vector<halfedge_descriptor> path;
    for (; branches_[t_->index(v)].halfedge != Gluing::none; v = source(path.back(), t_->mesh()))
      path.push_back(halfedge_to(v));
    std::reverse(path.begin(), path.end());
    return path;
  }

private:
  const Triangulation* t_;
  std::vector<Branch> branches_;
  Shortening_result counts_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_H

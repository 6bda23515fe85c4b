// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_EDGE_GRAPH_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_EDGE_GRAPH_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges of a surface as a graph, component by component, with a tree of shortest paths and a
// cotree of faces. Nodes are fans of corners; all fans on one border may be one node.
class Edge_graph {
public:
  static constexpr std::uint32_t none = Gluing::none;

  struct Edge {
    std::uint32_t side;                // one of its sides
    std::array<std::uint32_t, 2> ends; // nodes, along that side
    bool is_on_border, is_kept;
  };
  struct Component {
    std::vector<std::uint32_t> nodes, edges, faces;
    bool has_border = false;
    // of a surface without border
    bool is_sphere() const { return nodes.size() + faces.size() == edges.size() + 2; }
  };

  Edge_graph(const Surface_to_cut& s, bool merges_borders);

  const std::vector<Component>& components() const { return components_; }
  const Edge& edge(std::uint32_t e) const { return edges_[e]; }
  double length(std::uint32_t e) const { return s_.length[edges_[e].side]; }
  std::size_t number_of_nodes() const { return first_.size() - 1; }
  // the node of the corner at the start of a side
  std::uint32_t node_of_corner(std::uint32_t side) const { return node_[side]; }

  // Grows shortest paths from roots to all nodes of their component.
  void grow(const Component& c, std::span<const std::uint32_t> roots);
  // The length of the path to a node, and the last edge of it; `none` for a root.
  double distance(std::uint32_t node) const { return distance_[node]; }
  std::uint32_t last_edge(std::uint32_t node) const { return last_edge_[node]; }
  // The parent of a node in the tree. \pre the node is not a root
  std::uint32_t before(std::uint32_t node) const {
    const auto& [i, j] = edges_[last_edge_[node]].ends;
    return i == node ? j : i;
  }
  std::uint32_t farthest(const Component& c) const;

  // The edges in neither the tree nor a cotree of greatest weight, where the weight of an edge is
  // the length of its loop through the roots.
  // \param spans_border whether the cotree has a node outside of all borders
  std::vector<std::uint32_t> closing_edges(const Component& c, bool spans_border);

private:
  void find_nodes(bool merges_borders);
  void find_edges();
  void find_components();
  void link_edges();
  void check_kept_edges();
  bool join_faces(std::uint32_t e);
  std::uint32_t root_face(std::uint32_t f);

  const Surface_to_cut& s_;
  std::vector<std::uint32_t> node_; // per corner
  std::vector<Edge> edges_;
  std::vector<Component> components_;
  std::vector<std::uint32_t> first_, link_; // the edges at each node, in a row
  std::vector<double> distance_;
  std::vector<std::uint32_t> last_edge_;
  std::vector<std::uint32_t> parent_; // per face, the outside last
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_EDGE_GRAPH_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<std::uint32_t> Metric_triangles::compress() {
  std::vector<std::uint32_t> left, vertex(number_of_vertices(), Gluing::none), halfedges,
      halfedge(number_of_halfedges(), Gluing::none);
  for (std::uint32_t v = 0; v < number_of_vertices(); ++v)
    if (outgoing_[v] != Gluing::none) {
      vertex[v] = static_cast<std::uint32_t>(left.size());
      left.push_back(v);
    }
  for (std::uint32_t h = 0; h < number_of_halfedges(); ++h)
    if (!is_removed(h / 3)) {
      halfedge[h] = static_cast<std::uint32_t>(halfedges.size());
      halfedges.push_back(h);
    }
  Gluing small;
  small.number_of_vertices = static_cast<std::uint32_t>(left.size());
  std::vector<Double_double> squared;
  for (const std::uint32_t h : halfedges) {
    small.origin.push_back(vertex[source(h)]);
    small.glue.push_back(halfedge[opposite(h)]);
    squared.push_back(squared_[h]);
  }
  std::vector<double> stretch;
  for (std::size_t k = 0; k < halfedges.size(); k += 3)
    stretch.push_back(stretch_[halfedges[k] / 3]);
  std::vector<Removed_vertex> removed = std::move(removed_);
  *this = Metric_triangles(std::move(small), std::move(squared));
  stretch_ = std::move(stretch);
  removed_ = std::move(removed);
  if (!removed_.empty()) removed_in_.resize(number_of_faces());
  for (std::uint32_t r = 0; r < removed_.size(); ++r) {
    removed_[r].face = halfedge[3 * removed_[r].face] / 3;
    removed_in_[removed_[r].face].push_back(r);
  }
  return left;
}

} // namespace CGAL::Intrinsic_triangulations::internal

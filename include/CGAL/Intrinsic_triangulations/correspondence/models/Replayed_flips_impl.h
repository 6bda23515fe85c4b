// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Replayed_flips.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Crossing_path.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Replayed_flips::Replayed_flips(Gluing_map mesh, const Exact_euclidean_metric& metric)
    : mesh_(std::move(mesh)), number_(mesh_) {
  const Flip_history& history = metric.versions().history();
  const std::uint32_t faces = mesh_.number_of_faces();
  std::vector<Made> made(faces + 2 * std::size_t{history.number_of_flips()});
  for (std::uint32_t f = 0; f < faces; ++f) {
    const auto& [version, edge] = metric.versions().version(f);
    made[version] = {f, edge};
  }
  for (std::uint32_t n = history.number_of_flips(); n-- > 0;) {
    const std::uint32_t version = history.left_version(n);
    const Made left = made[version], right = made[version + 1];
    const Gluing_map::Halfedge h = halfedge(left);
    flipped_.push_back(h.index);
    flip_edge_back(h, mesh_);
    made[history.left_parent(n).face] = parent(history.left_parent(n), left.face, h);
    made[history.right_parent(n).face] =
        parent(history.right_parent(n), right.face, Gluing_map::Halfedge{h.index ^ 1U});
  }
  for (std::uint32_t f = 0; f < faces; ++f) // slot 0 of an input face is its first side
    mesh_.set_halfedge(Gluing_map::Face{made[f].face}, halfedge(made[f]));
  choose_halfedges_of_vertices();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Replayed_flips::replay(Integer_coordinates& coordinates) {
  for (; !flipped_.empty(); flipped_.pop_back()) {
    const Gluing_map::Halfedge h{flipped_.back()};
    const Flip move = flip_record(h, mesh_, number_);
    if (!coordinates.before(*this, move)) return false;
    CGAL::Euler::flip_edge(h, mesh_);
    coordinates.after(*this, move);
  }
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Gluing_map::Halfedge
Replayed_flips::halfedge(const Made& m) const {
  const Gluing_map::Halfedge h{2 * m.edge};
  return mesh_.face(h).index == m.face ? h : Gluing_map::Halfedge{2 * m.edge + 1};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Replayed_flips::choose_halfedges_of_vertices() {
  for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f)
    for (const Gluing_map::Halfedge h : mesh_.sides({f})) mesh_.set_halfedge(mesh_.target(h), h);
  for (std::uint32_t h = 0; h < mesh_.number_of_halfedges(); ++h)
    if (mesh_.face({h}).index == Gluing::none) mesh_.set_halfedge(mesh_.target({h}), {h});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Replayed_flips::Made
Replayed_flips::parent(const Flip_history::Side& side, std::uint32_t face,
                       Gluing_map::Halfedge h) const {
  for (std::uint32_t slot = side.slot; slot % 3 != 0; ++slot) h = mesh_.next(h);
  return {face, h.index / 2};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_IMPL_H

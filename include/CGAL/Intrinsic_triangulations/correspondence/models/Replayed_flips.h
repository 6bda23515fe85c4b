// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
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

// A triangulation in the order of its flips, so far as coordinates observe it.
class Replayed_flips {
public:
  // undoes the flips of a history
  Replayed_flips(Gluing_map mesh, const Exact_euclidean_metric& metric);

  // the connectivity before them
  const Gluing_map& mesh() const { return mesh_; }

  // makes them again, and lets coordinates follow; whether these stay in bounds
  bool replay(Integer_coordinates& coordinates);

private:
  // a face, and the edge in slot 0
  struct Made {
    std::uint32_t face, edge;
  };

  Gluing_map::Halfedge halfedge(const Made& m) const;

  // whatever flips did
  void choose_halfedges_of_vertices();

  // of the side that is halfedge h
  Made parent(const Flip_history::Side& side, std::uint32_t face, Gluing_map::Halfedge h) const;

  Gluing_map mesh_;
  Mesh_adaptor<Gluing_map> number_;
  std::vector<std::uint32_t> flipped_; // halfedges, the last flip first
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/correspondence/models/Replayed_flips_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_REPLAYED_FLIPS_H

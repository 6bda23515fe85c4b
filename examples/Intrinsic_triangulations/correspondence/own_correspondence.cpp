// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Observes the moves of an intrinsic triangulation: records which edges are flipped, and undoes all
// flips.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

//! [correspondence]
// What is not observed is inherited from the model that observes nothing.
struct Flip_recorder : IT::No_correspondence {
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Flip&) const {
    return true; // false refuses the flip
  }
  template <class Triangulation>
  void make_room(const Triangulation&, const IT::Flip&) {
    IT::reserve_at_least(edges, edges.size() + 1); // the last function that may throw
  }
  template <class Triangulation>
  void after(const Triangulation&, const IT::Flip& flip) noexcept {
    edges.push_back(flip.ij / 2); // halfedges 2e and 2e + 1 are those of edge e
  }
  using IT::No_correspondence::after;
  using IT::No_correspondence::before;
  using IT::No_correspondence::make_room;
  std::vector<std::uint32_t> edges;
};

using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Flip_recorder>;
static_assert(IT::IntrinsicCorrespondence<Flip_recorder, Triangulation>);
//! [correspondence]

std::vector<double> squared_lengths(const Triangulation& t) {
  std::vector<double> result;
  for (const auto e : edges(t.mesh())) result.push_back(t.squared_length(e));
  return result;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  const std::vector<double> start = squared_lengths(t);
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);

  //! [undo]
  const std::vector<std::uint32_t> flipped = t.correspondence().edges; // in the order of time
  std::size_t refused = 0;
  for (std::size_t i = flipped.size(); i-- > 0;) // two flips of an edge turn it round, no more
    if (t.flip_edge(t.numbers().halfedge_at(2 * flipped[i])) != IT::Move_status::done) ++refused;
  //! [undo]

  const std::vector<double> end = squared_lengths(t);
  double difference = 0;
  for (std::size_t e = 0; e < end.size(); ++e)
    difference = std::max(difference, std::abs(end[e] - start[e]) / start[e]);
  std::cout << flipped.size() << " flips recorded and taken back\nsquared lengths differ by "
            << difference << " of themselves\n";
  return flipped.size() == result.flips && refused == 0 && difference < 1e-9 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips a mesh to Delaunay and keeps its sharp edges, in two statements; shows progress, and can be
// cancelled.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <functional>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

//! [visitor]
struct Progress {
  bool progress(const IT::Flip_to_delaunay_result& r) {
    std::cout << r.checks << " edges checked, " << r.flips << " flipped\n";
    return r.flips < 10000000; // false cancels
  }
};
//! [visitor]

int main() {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh("data/part.off", mesh)) return 1;
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 60, is_sharp);
  Progress progress;
  //! [constrained]
  IT::Corresponding_triangulation t(mesh);
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(
      t, IT::parameters::edge_is_constrained_map(IT::constrained_input_edges(t, mesh, is_sharp))
             .visitor(std::ref(progress)));
  //! [constrained]
  std::size_t kept = 0, sharp = 0; // where the mesh has a sharp edge the triangulation has one
  for (const auto e : edges(mesh)) {
    if (!get(is_sharp, e)) continue;
    ++sharp;
    if (IT::trace_input_edge(t, e, mesh).along != IT::Gluing::none) ++kept;
  }
  std::cout << result.flips << " flips; " << kept << " sharp edges of " << sharp << " kept\n";
  return result.status == IT::Status::done && kept == sharp && sharp > 0 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines a mesh and keeps its feature edges: they are split, never flipped.
// Usage: constrained_refinement [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cmath>
#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  auto is_sharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_sharp", false).first;
  CGAL::Polygon_mesh_processing::detect_sharp_edges(mesh, 40, is_sharp);

  IT::Corresponding_triangulation t(mesh);
  //! [map]
  const auto features =
      IT::constrained_input_edges(t, mesh, is_sharp); // grows with the triangulation
  //! [map]
  const auto measure = [&](std::size_t& count) {
    double sum = 0;
    for (const auto e : edges(t.mesh()))
      if (get(features, e)) ++count, sum += std::sqrt(t.squared_length(e));
    return sum;
  };
  std::size_t count = 0, parts = 0;
  const double before = measure(count);
  //! [refine]
  const auto result =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(25).edge_is_constrained_map(features));
  //! [refine]
  const double after = measure(parts);
  bool kept = std::abs(after - before) < 1e-9 * before; // and still on edges of the input:
  for (const auto e : edges(t.mesh()))
    kept &= !get(features, e) || IT::trace_edge(t, e).along != IT::Gluing::none;
  std::cout << result.counts.inserted_vertices() << " vertices inserted\n"
            << count << " feature edges, now " << parts << ", of length " << before << ", now "
            << after << '\n';
  return kept && count > 0 && result.status == IT::Status::done ? 0 : 1;
}

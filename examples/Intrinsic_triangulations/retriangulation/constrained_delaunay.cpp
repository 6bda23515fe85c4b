// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Keeps sharp edges while flipping to Delaunay, shows progress and may be cancelled.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/function_property_map.hpp>

#include <iostream>
#include <vector>

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
  using Triangulation = IT::Intrinsic_triangulation<>;
  Triangulation triangulation(mesh);

  //! [map]
  // before any flip every edge is the one of the mesh between its vertices, unless it cuts a polygon
  const auto in_mesh = [&](Triangulation::vertex_descriptor v) {
    return Mesh::Vertex_index(triangulation.input_vertex(v));
  };
  std::vector<char> is_constrained(num_edges(triangulation.mesh()));
  for (const auto e : edges(triangulation.mesh())) {
    const Mesh::Halfedge_index h = mesh.halfedge(in_mesh(source(e, triangulation.mesh())),
                                                 in_mesh(target(e, triangulation.mesh())));
    is_constrained[triangulation.index(e)] = h != Mesh::null_halfedge() && is_sharp[mesh.edge(h)];
  }
  const auto constrained = boost::make_function_property_map<Triangulation::edge_descriptor, bool>(
      [&](Triangulation::edge_descriptor e) {
        return is_constrained[triangulation.index(e)] != 0;
      });
  //! [map]

  //! [constrained]
  Progress progress;
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(
      triangulation,
      CGAL::parameters::edge_is_constrained_map(constrained).visitor(std::ref(progress)));
  //! [constrained]
  std::cout << result.flips << " flips\n";
  return result.status == IT::Status::done ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Finds geodesics between vertices and between points, then makes a network of two paths and a loop geodesic and certifies it.
// Usage: geodesic_paths [MESH.off]

#include <CGAL/Intrinsic_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  const auto n = static_cast<std::uint32_t>(num_vertices(mesh));
  const Mesh::Vertex_index a(0), b(n / 3), c(2 * n / 3);

  //! [path]
  IT::Geodesic_finder<Triangulation> find(t); // for many queries: each leaves t as it was
  const IT::Geodesic_path path =
      find(IT::vertex_on_intrinsic(t, a, mesh), IT::vertex_on_intrinsic(t, b, mesh));
  const auto line = IT::polyline(t, path, mesh); // points in space
  std::cout << "geodesic of length " << path.length << ", along edges " << path.initial_length
            << ", through " << line.size() << " points and " << path.faces.size() << " faces\n";
  //! [path]

  //! [points]
  const IT::Face_location<Mesh> from(Mesh::Face_index(0), {0.5, 0.25, 0.25}),
      to(Mesh::Face_index(100), {0.25, 0.25, 0.5});
  const IT::Geodesic_path between =
      find({IT::surface_point(t, from, mesh), IT::surface_point(t, to, mesh)});
  const std::vector<IT::Face_location<Mesh>> places = IT::face_locations(t, between, mesh);
  //! [points]
  std::cout << "between points: " << between.length << ", " << places.size() << " places\n";

  //! [network]
  IT::Curve_network<Triangulation> network(t);
  IT::Edge_path_finder<Triangulation> shortest(t);
  const auto u = IT::vertex_on_intrinsic(t, a, mesh), v = IT::vertex_on_intrinsic(t, b, mesh),
             w = IT::vertex_on_intrinsic(t, c, mesh);
  network.fix(v); // a junction: curves may end and turn there
  network.add_path(shortest(u, v));
  network.add_path(shortest(v, w));
  const IT::Shortening_result result = IT::shorten_curves(network); // flips edges of t
  //! [network]
  std::cout << "network of length " << network.length() << " after " << result.flips << " flips\n";

  //! [certify]
  const bool is_geodesic = IT::is_geodesic(network).is_geodesic(); // exact signs of t
  const bool is_certified =
      IT::certify_geodesic(network).is_geodesic(); // integers and the input alone
  //! [certify]
  std::cout << (is_geodesic && is_certified ? "certified\n" : "not geodesic\n");

  //! [delaunay]
  // curves stay where they are while other edges become Delaunay
  IT::flip_to_delaunay(t,
                       IT::parameters::edge_is_constrained_map(network.edge_is_constrained_map()));
  //! [delaunay]
  return path.status == IT::Status::done && result.status == IT::Status::done && is_certified ? 0
                                                                                              : 1;
}

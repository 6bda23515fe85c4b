// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a mesh open along a geodesic loop, and along isolines of its height. Usage:
// cut_along [MESH.off [OUT.ply]]

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;

  //! [curves]
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  IT::Curve_network network(t);
  const auto v = [&](unsigned row) { return IT::vertex_of_row(t, row); };
  IT::add_geodesics(network, std::vector{IT::Curve_through_vertices<Triangulation>{
                                 {v(0), v(40), v(2000)}, true, true}});
  const IT::Cut_surface s = IT::cut_along(network);
  Mesh pieces; // triangles, in which curves are borders
  IT::copy_cut_surface(s, IT::positions(s, mesh), pieces);
  //! [curves]
  std::cout << "along a loop: " << s.number_of_components << " components of " << num_faces(pieces)
            << " triangles, " << s.seams.size() << " edges cut\n";

  //! [isolines]
  Triangulation u(mesh);
  std::vector<double> height, levels{30, 55};
  for (const auto w : vertices(mesh)) height.push_back(mesh.point(w).z());
  const auto labels = IT::insert_isolines(u, IT::isolines(u, height, levels));
  const IT::Cut_surface slices = IT::cut_along(u, labels); // a label is the level, plus one
  const std::vector<double> heights = IT::values_at_vertices(slices, height); // of the slices
  std::vector<double> of_corners; // of the mesh, as texture coordinates may be
  for (const auto f : faces(mesh))
    for (const auto w : vertices_around_face(halfedge(f, mesh), mesh))
      of_corners.push_back(height[w]);
  of_corners = IT::values_at_corners(slices, of_corners);
  //! [isolines]
  std::cout << "along isolines: " << slices.number_of_components << " components, with heights at "
            << heights.size() << " vertices and " << of_corners.size() << " corners\n";
  if (argc > 2) IT::write_cut_surface(argv[2], slices, IT::positions(slices, mesh));
  return slices.number_of_components > 1 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes an ordinary mesh on the same surface that is Delaunay, and compares it with the intrinsic
// triangulation.
// Usage: extrinsic_delaunay [MESH.off [OUT.off]]

#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/extrinsic/extrinsic_delaunay.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <fstream>
#include <iostream>
#include <limits>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  //! [extrinsic]
  const IT::Extrinsic_delaunay_mesh in_space = IT::extrinsic_delaunay(mesh);
  // in_space.points, in_space.triangles: for programs that take nothing else
  //! [extrinsic]
  IT::Intrinsic_triangulation<> intrinsic(mesh);
  IT::flip_to_delaunay(intrinsic);

  std::cout << "Delaunay in space: " << in_space.points.size() << " vertices, "
            << in_space.triangles.size() << " triangles\n"
            << "Delaunay by intrinsic flips: " << intrinsic.number_of_vertices() << " vertices, "
            << num_faces(intrinsic.mesh()) << " triangles\n";
  if (argc > 2) {
    std::ofstream out(argv[2]);
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "OFF\n" << in_space.points.size() << ' ' << in_space.triangles.size() << " 0\n";
    for (const auto& p : in_space.points) out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& t : in_space.triangles)
      out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    if (!out) return 1;
  }
  return in_space.status == IT::Status::done && in_space.points.size() >= num_vertices(mesh) ? 0
                                                                                             : 1;
}

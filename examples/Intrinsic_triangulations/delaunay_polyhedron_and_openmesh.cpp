// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the same intrinsic triangulation from a CGAL::Polyhedron_3 and from an OpenMesh mesh.

#include <CGAL/Intrinsic_triangulations/connectivity/OpenMesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Polyhedron_3_adaptor.h>

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d; // OpenMesh stores float coordinates unless told otherwise
};
using Open_mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;

int main() {
  Polyhedron polyhedron;
  Open_mesh open_mesh;
  if (!CGAL::IO::read_polygon_mesh("data/part.off", polyhedron) ||
      !OpenMesh::IO::read_mesh(open_mesh, "data/part.off"))
    return 1;

  IT::Intrinsic_triangulation<> a(polyhedron);
  // the connectivity that is flipped may be of any type too
  IT::Intrinsic_triangulation<Open_mesh> b(open_mesh);
  const auto flips_a = IT::flip_to_delaunay(a).flips;
  const auto flips_b = IT::flip_to_delaunay(b).flips;
  std::cout << "Polyhedron_3: " << flips_a << " flips, OpenMesh: " << flips_b << " flips\n";
  return IT::is_delaunay(a) && IT::is_delaunay(b) ? 0 : 1;
}

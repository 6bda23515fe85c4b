// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the intrinsic triangulation of an OpenMesh mesh, and flips another OpenMesh mesh to Delaunay. Link
// Intrinsic_triangulations::OpenMesh_support.

//! [include]
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h> // first: it includes OpenMesh

#include <CGAL/Intrinsic_triangulations.h>
//! [include]

#include <cmath>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

//! [type]
struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d; // OpenMesh stores float coordinates unless told otherwise
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
//! [type]

int main() {
  Mesh mesh;
  if (!OpenMesh::IO::read_mesh(mesh, "data/part.off")) {
    std::cerr << "data/part.off cannot be read\n";
    return 1;
  }
  //! [triangulate]
  IT::Intrinsic_triangulation<Mesh> t(mesh); // its connectivity is a Mesh, a copy
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  double length = 0; // of all edges
  for (const auto e : edges(t.mesh())) length += std::sqrt(t.squared_length(e));
  //! [triangulate]

  IT::Intrinsic_triangulation<> own(mesh); // reads OpenMesh, flips a mesh of its own: faster
  const IT::Flip_to_delaunay_result same = IT::flip_to_delaunay(own);
  std::cout << result.flips << " flips in an OpenMesh mesh, " << same.flips
            << " in a Gluing_map\nlength of all edges: " << length << '\n';
  return IT::is_delaunay(t) && IT::is_delaunay(own) ? 0 : 1;
}

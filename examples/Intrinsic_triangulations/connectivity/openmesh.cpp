// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the intrinsic triangulation of an OpenMesh mesh, and flips another OpenMesh mesh to
// Delaunay. Link Intrinsic_triangulations::OpenMesh_support.

//! [include]
// the adaptor comes first: it includes OpenMesh
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h>

#include <CGAL/Intrinsic_triangulations.h>
//! [include]

#include <cmath>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

//! [type]
struct Double_traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d; // by default OpenMesh stores float coordinates
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Double_traits>;
//! [type]

//! [read]
Mesh read_mesh(const std::string& path) { // OpenMesh's reader rounds coordinates to float
  const IT::Triangle_soup soup = IT::read_triangle_soup(path);
  Mesh mesh;
  std::vector<Mesh::VertexHandle> v;
  for (const auto& p : soup.points) v.push_back(mesh.add_vertex({p[0], p[1], p[2]}));
  for (const auto& f : soup.triangles) mesh.add_face(v[f[0]], v[f[1]], v[f[2]]);
  return mesh;
}
//! [read]

int main() {
  const Mesh mesh = read_mesh("data/part.off");
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
  IT::Intrinsic_triangulation<> from_file(IT::read_triangle_soup("data/part.off"));
  const bool is_whole = IT::flip_to_delaunay(from_file).flips == result.flips; // no digit is lost
  return IT::is_delaunay(t) && IT::is_delaunay(own) && is_whole ? 0 : 1;
}

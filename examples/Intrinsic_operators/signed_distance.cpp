// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Cuts a mesh into what is inside and outside of a curve along its edges, by the signed distance from it.

#include <CGAL/Intrinsic_operators/distance/Signed_heat_distance.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/Core>

#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main() {
  Mesh mesh; // a square of 30 x 30 cells
  CGAL::make_grid(
      30, 30, mesh,
      [](std::size_t i, std::size_t j) { return Mesh::Point(double(i), double(j), 0); }, true);
  const IT::Intrinsic_triangulation<Mesh> t(mesh);

  //! [loop]
  std::vector<Mesh::Halfedge_index> loop; // around the faces about the middle: they are on its left
  const auto is_inside = [&](Mesh::Face_index f) {
    for (const auto v : vertices_around_face(halfedge(f, t.mesh()), t.mesh())) {
      const Mesh::Point p = mesh.point(Mesh::Vertex_index(t.input_vertex(v)));
      if (p.x() < 10 || p.x() > 20 || p.y() < 10 || p.y() > 20) return false;
    }
    return true;
  };
  for (const auto h : halfedges(t.mesh()))
    if (!is_border_edge(h, t.mesh()) && is_inside(face(h, t.mesh())) &&
        !is_inside(face(opposite(h, t.mesh()), t.mesh())))
      loop.push_back(h);
  const Eigen::VectorXd d = IT::Signed_heat_distance(t).distances(loop);
  //! [loop]
  std::cout << "from " << d.minCoeff() << " in the middle to " << d.maxCoeff()
            << " in the corners\n";
  return d.minCoeff() < -4 && d.maxCoeff() > 13 && (d.array() == 0).count() == 40 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Bends a thin bar that is meshed with needles: one end is held, the other moved. Then smooths it by a step of mean curvature flow.

#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>
#include <CGAL/Intrinsic_operators/editing/Surface_deformation.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

int main() {
  Mesh mesh;
  const auto corner = [](std::size_t i, std::size_t j) { // faces twenty times as long as wide
    return Point(static_cast<double>(i) / 4, static_cast<double>(j) / 80, 0);
  };
  CGAL::make_grid(40, 80, mesh, corner, true);

  //! [deform]
  IT::Intrinsic_triangulation<> t(mesh);
  IT::flip_to_delaunay(t); // no weight inside is negative now

  std::vector<std::uint32_t> handles;
  for (const Mesh::Vertex_index v : mesh.vertices())
    if (mesh.point(v).x() < 0.3 || mesh.point(v).x() > 9.7) handles.push_back(v);
  const IT::Surface_deformation deformation(t, handles); // factors once

  Eigen::MatrixX3d moved = Eigen::MatrixX3d::Zero(static_cast<Eigen::Index>(handles.size()), 3);
  for (std::size_t i = 0; i < handles.size(); ++i)
    if (mesh.point(Mesh::Vertex_index(handles[i])).x() > 5)
      moved.row(static_cast<Eigen::Index>(i)) << 0, 0, 3; // lift one end
  const Eigen::MatrixXd d = deformation.displacements(moved);
  for (const Mesh::Vertex_index v : mesh.vertices()) {
    const Eigen::RowVectorXd shift = d.row(v);
    mesh.point(v) = Point(mesh.point(v).x() + shift[0], mesh.point(v).y() + shift[1], shift[2]);
  }
  //! [deform]

  //! [smooth]
  IT::Intrinsic_triangulation<> bent(mesh);
  IT::flip_to_delaunay(bent);
  Eigen::MatrixX3d x(static_cast<Eigen::Index>(mesh.number_of_vertices()), 3);
  for (const Mesh::Vertex_index v : mesh.vertices())
    x.row(v) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
  const Eigen::MatrixX3d smooth = IT::Heat_flow(bent, 0.01).step(x);
  //! [smooth]

  const double middle = d(mesh.number_of_vertices() / 2, 2);
  std::cout << "the middle is lifted by " << middle
            << ", the ends by 0 and 3; smoothing moves points by "
            << (smooth - x).rowwise().norm().maxCoeff() << " at most\n";
  return std::abs(middle - 1.5) < 0.1 ? 0 : 1;
}

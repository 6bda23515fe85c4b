// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Shortens two closed curves of edges on a torus: one that runs around the tube becomes a closed
// geodesic, and one that bounds a disk becomes a point.

#include <CGAL/Intrinsic_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

constexpr unsigned rings = 40, sides = 20; // vertices along the torus, and around its tube

Mesh torus() {
  Mesh mesh;
  for (unsigned i = 0; i < rings; ++i)
    for (unsigned j = 0; j < sides; ++j) {
      const double a = 2 * std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / sides;
      const double r = 3 + std::cos(b);
      mesh.add_vertex({r * std::cos(a), r * std::sin(a), std::sin(b)});
    }
  const auto v = [](unsigned i, unsigned j) {
    return Mesh::Vertex_index(i % rings * sides + j % sides);
  };
  for (unsigned i = 0; i < rings; ++i)
    for (unsigned j = 0; j < sides; ++j) {
      mesh.add_face(v(i, j), v(i + 1, j), v(i + 1, j + 1));
      mesh.add_face(v(i, j), v(i + 1, j + 1), v(i, j + 1));
    }
  return mesh;
}

int main() {
  const Mesh mesh = torus();
  Triangulation t(mesh);
  const auto vertex = [&](unsigned i, unsigned j) {
    return IT::vertex_on_intrinsic(t, Mesh::Vertex_index(i % rings * sides + j % sides), mesh);
  };

  //! [loop]
  IT::Edge_path_finder<Triangulation> shortest(t);
  // the halfedges of a closed way through some vertices
  const auto closed_way = [&](const std::vector<Triangulation::vertex_descriptor>& vertices) {
    std::vector<Triangulation::halfedge_descriptor> way;
    for (std::size_t k = 0; k < vertices.size(); ++k)
      for (const auto h : shortest(vertices[k], vertices[(k + 1) % vertices.size()]))
        way.push_back(h);
    return way;
  };
  IT::Curve_network<Triangulation> network(t);
  const auto around = network.add_loop(closed_way({vertex(0, 0), vertex(4, 7), vertex(1, 13)}));
  const auto disk = network.add_loop(closed_way({vertex(20, 0), vertex(23, 3), vertex(20, 3)}));
  const IT::Shortening_result result = IT::shorten_curves(network);
  //! [loop]

  const double ring = 2 * sides * std::sin(std::numbers::pi / sides); // a polygon
  std::cout << "around the tube: " << network.length(around) << ", where a ring of edges has "
            << ring << "; the other " << (network.is_point(disk) ? "is a point" : "is none")
            << '\n';
  return result.status == IT::Status::done && network.is_point(disk) &&
                 std::abs(network.length(around) - ring) < 0.1 &&
                 IT::is_geodesic(network).is_geodesic()
             ? 0
             : 1;
}

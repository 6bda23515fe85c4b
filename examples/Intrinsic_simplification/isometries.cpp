// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Proves that a cube and a cut cube are the same surface, and counts the symmetries.

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

Mesh cube() {
  Mesh mesh;
  CGAL::make_hexahedron(Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0),
                        Point(0, 1, 1), Point(0, 0, 1), Point(1, 0, 1), Point(1, 1, 1), mesh);
  return mesh;
}

int main() {
  Mesh other = cube(); // with a vertex in a face and one on an edge
  const auto middle = [&](const auto v, const auto w) {
    return CGAL::midpoint(other.point(v), other.point(w));
  };
  const auto side = halfedge(*faces(other).begin(), other);
  const Point inside = middle(source(side, other), target(next(side, other), other));
  other.point(target(CGAL::Euler::add_center_vertex(side, other), other)) = inside;
  const auto edge = *halfedges(other).begin();
  const Point on_edge = middle(source(edge, other), target(edge, other));
  other.point(target(CGAL::Euler::split_edge(edge, other), other)) = on_edge;
  for (const auto v : vertices(other)) { // turned
    const Point p = other.point(v);
    other.point(v) = Point(p.y(), p.z(), p.x());
  }
  //! [isometries]
  const IT::Corresponding_triangulation a(cube()), b(other);
  const IT::Canonical_form first = IT::canonical_form(a), second = IT::canonical_form(b);
  const IT::Isometries found = IT::find_isometries(first, second);
  std::cout << IT::name_of(found.answer()) << ", " << found.size() << " isometries, "
            << second.number_of_flat_vertices() << " flat vertices\n";
  const IT::Isometry map = found[0];
  std::cout << "vertex 0 becomes vertex " << map.image_of_vertex(0) << '\n';
  //! [isometries]
  return found.size() == 48 && first.hash() == second.hash() ? 0 : 1;
}

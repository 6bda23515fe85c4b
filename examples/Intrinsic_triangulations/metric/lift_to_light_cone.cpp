// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Lifts triangles of a surface to the light cone of Minkowski space, and tests exactly whether they are a part of a lower hull.
// Usage: lift_to_light_cone [FILE]
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<CGAL::Gmpq>>;
//! [lift]
using Root = Kernel::Vector_2;        // w and -w are the roots of one vector (x, y, t)
Kernel::Point_3 lift(const Root& w) { // of the light cone x^2 + y^2 = t^2
  return {w.x() * w.x() - w.y() * w.y(), 2 * w.x() * w.y(), w * w};
}

struct Lifted_triangle {
  Triangulation::halfedge_descriptor ab, bc, ca;
  Root a, b, c; // det(a, b), det(b, c) and det(a, c) are the lambda lengths of the sides
};

Lifted_triangle lifted(const Triangulation& t, Triangulation::halfedge_descriptor ab, const Root& a,
                       const Root& b) {
  const auto lambda = [&](auto h) { return t.metric().lambda(t.index(edge(h, t.mesh()))); };
  const auto bc = next(ab, t.mesh()), ca = next(bc, t.mesh());
  const CGAL::Gmpq p = lambda(ca) / lambda(ab), q = lambda(bc) / lambda(ab);
  return {ab, bc, ca, a, b, p * b - q * a};
}

std::vector<Lifted_triangle> develop(const Triangulation& t, std::size_t number) {
  const auto h = *halfedges(t.mesh()).begin();
  const Root a(1, 0), b(0, t.metric().lambda(t.index(edge(h, t.mesh()))));
  std::vector<Lifted_triangle> all{lifted(t, h, a, b), lifted(t, opposite(h, t.mesh()), b, -a)};
  for (std::size_t i = 0; all.size() < number; ++i) { // the neighbours of each
    const Lifted_triangle f = all[i];
    all.push_back(lifted(t, opposite(f.bc, t.mesh()), f.c, -f.b));
    all.push_back(lifted(t, opposite(f.ca, t.mesh()), -f.a, -f.c));
  }
  return all;
}

std::size_t number_below(const std::vector<Lifted_triangle>& all) { // vertices below triangles
  std::size_t number = 0;
  for (const Lifted_triangle& f : all)
    for (const Lifted_triangle& g : all)
      number += orientation(lift(f.a), lift(f.b), lift(f.c), lift(g.c)) == CGAL::NEGATIVE ? 1 : 0;
  return number;
}
//! [lift]

int main(int argc, char* argv[]) {
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> mesh;
  CGAL::make_icosahedron(mesh, CGAL::Simple_cartesian<double>::Point_3(0, 0, 0));
  Triangulation t(mesh);
  std::vector<double> factors;
  for (int v = 0; v < 12; ++v) factors.push_back(std::exp(0.8 * std::sin(5 * v)));
  t.scale_vertices(factors); // moves the horocycles
  const std::size_t before = number_below(develop(t, 150));
  const auto flips = IT::flip_to_delaunay(t).flips;
  const std::vector<Lifted_triangle> all = develop(t, 150);
  std::ofstream file(argc > 1 ? argv[1] : ""); // to draw it
  for (const Lifted_triangle& f : all)
    for (const auto& p : {lift(f.a), lift(f.b), lift(f.c)})
      file << to_double(p.x()) << ' ' << to_double(p.y()) << ' ' << to_double(p.z()) << '\n';
  const std::size_t after = number_below(all);
  std::cout << before << " vertices below; after " << flips << " flips " << after << '\n';
  return before > 0 && after == 0 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips each edge whose other diagonal is shorter: a predicate of our own, decided exactly.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Corresponding_triangulation;

//! [predicate]
// Positive if the other diagonal km is shorter: 2 L_ij (L_ij - L_km), by the law of cosines. Any
// polynomial in squared lengths and quadruple areas may stand here.
struct Shorter_diagonal_expression {
  template <class FT>
  FT operator()(const IT::Diamond_values<FT>& d) const {
    const FT p = d.ij + d.ki - d.jk, q = d.ij + d.im - d.mj, rest = d.ij - d.ki - d.im;
    return d.ij * (rest + rest) + p * q - d.area_f * d.area_g;
  }
};

// during a session, since the sign is asked for by numbers of edges
bool has_shorter_diagonal(const Triangulation& t, Triangulation::halfedge_descriptor h) {
  const Triangulation::Mesh& mesh = t.mesh();
  const auto null = boost::graph_traits<Triangulation::Mesh>::null_face();
  return face(h, mesh) != null && face(opposite(h, mesh), mesh) != null &&
         face(h, mesh) != face(opposite(h, mesh), mesh) &&
         t.sign(t.diamond(h), Shorter_diagonal_expression()) == CGAL::POSITIVE;
}
//! [predicate]

int main() {
  Mesh mesh; // a sheared grid on a wave
  const auto place = [](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i), y = static_cast<double>(j);
    return Mesh::Point(x + 3.3 * y, y, std::sin(x / 2) + std::cos(y));
  };
  CGAL::make_grid(20, 20, mesh, place, true);
  Triangulation t(mesh);
  Triangulation::Session session(t);
  std::size_t flips = 0;
  // Each flip makes the sum of all lengths less, and only finitely many geodesics are shorter than
  // a bound: it ends.
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const auto e : edges(t.mesh())) {
      const auto h = halfedge(e, t.mesh());
      if (!has_shorter_diagonal(t, h)) continue;
      if (session.flip_edge(h) != IT::Move_status::done) continue; // not convex
      ++flips;
      is_done = false;
    }
  }
  std::size_t differing = 0; // edges that are short, but not Delaunay
  for (const auto e : edges(t.mesh()))
    if (!session.is_locally_delaunay(halfedge(e, t.mesh()))) ++differing;
  std::cout << flips << " flips to the shorter diagonal; " << differing
            << " edges of the result are not Delaunay\n";
  return flips > 0 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Flips the same mesh with several arithmetics, which differ at exact ties.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

//! [flip]
template <class Traits>
void flip(const char* name, const Mesh& mesh) {
  IT::Intrinsic_triangulation<IT::Gluing_map, Traits> triangulation(mesh);
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(triangulation);
  const auto report = IT::check_delaunay(triangulation);
  std::cout << name << ": " << result.flips << " flips, " << report.cocircular_edges.size()
            << " ties, certified " << triangulation.metric().statistics().certified_zero << '\n';
}
//! [flip]

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  //! [arithmetics]
  flip<IT::Euclidean_traits<double>>("double     ", mesh);
  flip<IT::Euclidean_traits<long double>>("long double", mesh);
  flip<IT::Exact_euclidean_traits>("exact      ", mesh);
  //! [arithmetics]
  return 0;
}

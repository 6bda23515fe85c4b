// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Builds the intrinsic triangulation of a CGAL::Polyhedron_3, and flips in one.

//! [include]
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Polyhedron_3_adaptor.h>

#include <CGAL/Intrinsic_triangulations.h>
//! [include]

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <cstddef>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;

//! [type]
using Kernel = CGAL::Simple_cartesian<double>;
// elements with ids are numbered by them; without ids they are looked up in hash maps, which is
// slower
using Polyhedron = CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>;
//! [type]

int main() {
  Polyhedron polyhedron;
  if (!CGAL::IO::read_polygon_mesh("data/part.off", polyhedron)) {
    std::cerr << "data/part.off cannot be read\n";
    return 1;
  }
  //! [triangulate]
  IT::Intrinsic_triangulation<Polyhedron> t(polyhedron); // its connectivity is a Polyhedron, a copy
  const IT::Flip_to_delaunay_result result = IT::flip_to_delaunay(t);
  std::size_t loops = 0; // edges from a vertex to itself: no polyhedron in space has one
  for (const auto e : edges(t.mesh())) loops += source(e, t.mesh()) == target(e, t.mesh());
  //! [triangulate]

  IT::Intrinsic_triangulation<> own(
      polyhedron); // reads a polyhedron, flips a mesh of its own: faster
  const IT::Flip_to_delaunay_result same = IT::flip_to_delaunay(own);
  std::cout << result.flips << " flips in a Polyhedron_3, " << same.flips << " in a Gluing_map\n"
            << loops << " edges from a vertex to itself\n";
  return IT::is_delaunay(t) && IT::is_delaunay(own) ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines a mesh to a least angle of 30 degrees, in one statement, and reports the shapes of its
// faces before and after.
// Usage: refine [MESH.off]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <fstream>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char** argv) {
  Mesh mesh;
  std::ifstream in(argc > 1 ? argv[1] : "data/part.off");
  if (!in || !CGAL::IO::read_OFF(in, mesh)) {
    std::cerr << "the mesh cannot be read; give an OFF file\n";
    return 1;
  }
  IT::Intrinsic_triangulation<> t(mesh);
  const IT::Quality before = IT::measure_quality(t);
  //! [refine]
  const auto result = IT::delaunay_refine(t, IT::parameters::minimum_angle(30));
  //! [refine]
  const IT::Quality after = IT::measure_quality(t);
  std::cout << result.counts.inserted_vertices() << " vertices inserted, "
            << result.unsatisfied.size() << " faces are left below the bound\nleast angle "
            << before.minimum_angle << ", now " << after.minimum_angle
            << " degrees\ngreatest aspect ratio " << before.maximum_aspect_ratio << ", now "
            << after.maximum_aspect_ratio << '\n';
  return result.status == IT::Status::done ? 0 : 1;
}

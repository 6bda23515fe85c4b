// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures area and curvature of a part before and after intrinsic refinement, which changes
// neither: the vertices that it inserts are flat, and by Gauss and Bonnet the sum over all is 2 pi
// times the Euler characteristic.

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }
  IT::Intrinsic_triangulation<> t(mesh);
  const double area = IT::total_area(t);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));

  //! [curvature]
  double total = 0, of_inserted = 0;
  for (const auto v : vertices(t.mesh())) {
    const double curvature = IT::gaussian_curvature(t, v);
    total += curvature;
    if (t.is_inserted(v)) of_inserted = std::max(of_inserted, std::abs(curvature));
  }
  //! [curvature]
  std::cout << "area " << area << ", of the refinement " << IT::total_area(t)
            << "\ntotal curvature " << total / std::numbers::pi
            << " pi, greatest at inserted vertices " << of_inserted << '\n';
  const bool is_same = std::abs(IT::total_area(t) - area) < 1e-9 * area;
  return is_same && of_inserted < 1e-9 ? 0 : 1;
}

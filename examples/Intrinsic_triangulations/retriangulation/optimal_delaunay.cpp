// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Fills a mesh with vertices at even distances, and reports how much the areas of faces vary before
// and after. Usage: optimal_delaunay [MESH.off]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/optimization/odt_optimize.h>

#include <cmath>
#include <fstream>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

// standard deviation by mean
double variation_of_areas(const Triangulation& t) {
  double n = 0, sum = 0, squares = 0;
  for (const auto f : faces(t.mesh())) {
    const double area = t.area(f);
    n += 1;
    sum += area;
    squares += area * area;
  }
  return std::sqrt(n * squares - sum * sum) / sum;
}

int main(int argc, char** argv) {
  Mesh mesh;
  std::ifstream in(argc > 1 ? argv[1] : "data/part.off");
  if (!in || !CGAL::IO::read_OFF(in, mesh)) {
    std::cerr << "the mesh cannot be read; give an OFF file\n";
    return 1;
  }
  Triangulation t(mesh);
  const double before = variation_of_areas(t);
  //! [odt]
  const auto result = IT::odt_optimize(t, IT::parameters::maximum_edge_length(5));
  //! [odt]
  std::cout << result.splits << " edges split, " << result.moves << " moves; areas varied by "
            << before << " of the mean, now by " << variation_of_areas(t) << "\nenergy "
            << result.energy_before << ", now " << result.energy_after << '\n';
  return result.status == IT::Status::done ? 0 : 1;
}

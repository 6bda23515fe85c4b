// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a closed surface of genus 23 hyperbolic, and unfolds it in Poincaré's disk.

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_disk.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <string>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Ideal = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_ideal_hyperbolic_traits,
                                          IT::Integer_coordinates>;

int main(int argc, char* argv[]) {
  const std::string file = argc > 1 ? argv[1] : "data/part.off";
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh)) {
    std::cerr << file << ": cannot be read\n";
    return 1;
  }

  //! [hyperbolic]
  IT::Corresponding_triangulation surface(mesh);
  IT::flip_to_delaunay(surface);
  Ideal t(IT::ideal_start(surface));
  const IT::Conformal_metric metric = IT::hyperbolic_metric(t, IT::flat_angles(t));
  const IT::Disk_layout layout = IT::lay_out_in_disk(IT::hyperbolic_surface(t));
  //! [hyperbolic]

  std::cout << "angles are right up to " << metric.proven_residual.value_or(1) << " radians; "
            << layout.pairings.seams.size() << " motions generate the group, with relations up to "
            << layout.pairings.largest_relation_error << "; " << layout.flipped_faces
            << " flipped triangles within " << layout.radius << " from the centre\n";
  return metric.status == IT::Status::done && layout.flipped_faces == 0 ? 0 : 1;
}

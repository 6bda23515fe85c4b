// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Measures a mesh by an anisotropic metric, in which lengths around the z-axis count three times, and
// refines it to triangles that are good in that metric. No surface in space need have it.
// Usage: scale_metric [MESH.off]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/scale_metric.h>

#include <array>
#include <cmath>
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
  //! [scale]
  // |v|^2 + 8 <v, w>^2, with w the unit vector around the z-axis at the center of the face
  const auto norm = [&mesh](Mesh::Face_index f, const std::array<double, 3>& v) {
    double x = 0, y = 0;
    for (const Mesh::Vertex_index i : mesh.vertices_around_face(mesh.halfedge(f))) {
      x += mesh.point(i).x();
      y += mesh.point(i).y();
    }
    const double r = std::hypot(x, y), around = r > 0 ? (x * v[1] - y * v[0]) / r : 0;
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2] + 8 * around * around);
  };
  const IT::Scaled_metric scaled =
      IT::scale_by_norm_in_space(mesh, norm, {IT::Triangle_inequality::repair});
  IT::Intrinsic_triangulation<> t(scaled.input);
  const auto result = IT::delaunay_refine(t, {.minimum_angle = 25});
  //! [scale]
  const IT::Quality after = IT::measure_quality(t);
  std::cout << "the new lengths violated the triangle inequality in "
            << scaled.violating_faces.size() << " faces; " << scaled.changed_edges
            << " edges were shortened, by up to " << 100 * scaled.largest_relative_change << " %\n"
            << result.counts.inserted_vertices() << " vertices inserted, "
            << result.unsatisfied.size() << " faces are left below the bound\nleast angle in the "
            << "new metric " << after.minimum_angle << " degrees\n";
  return result.status == IT::Refinement_status::done && scaled.is_metric ? 0 : 1;
}

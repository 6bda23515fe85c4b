// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checks.h"

#include <CGAL/Intrinsic_geodesics.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

// A kite whose long diagonal is flipped; then it is refined.
bool check_everything() {
  namespace IT = CGAL::Intrinsic_triangulations;
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(-3, 0, 0)), b = mesh.add_vertex(Point(0, -1, 0));
  const auto c = mesh.add_vertex(Point(3, 0, 0)), d = mesh.add_vertex(Point(0, 1, 0));
  mesh.add_face(a, b, c);
  mesh.add_face(a, c, d);
  IT::Intrinsic_triangulation<Mesh, IT::Exact_euclidean_traits, IT::Integer_coordinates> t(mesh);
  const IT::Flip_to_delaunay_result flipped = IT::flip_to_delaunay(t);
  const auto refined =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(1));
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const IT::Geodesic geodesic = IT::trace_geodesic_on_input(
      t, {t.input().halfedge_of_face(0), {0.5, 0.25, 0.25}}, {1, 0}, 0.1);
  return geodesic.status == IT::Status::done && flipped.flips == 1 &&
         refined.status == IT::Status::done && refined.counts.inserted_vertices() > 0 &&
         IT::certify_delaunay(t).is_delaunay() && IT::measure_quality(t).minimum_angle >= 25 &&
         s.number_of_vertices() + s.number_of_faces() == s.number_of_edges() + 1;
}

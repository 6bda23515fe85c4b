// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws a geodesic Bezier curve with four control points on a mesh, and proves that the sides of its control polygon are
// geodesics. Usage: bezier_curve [MESH.off]

#include <CGAL/Intrinsic_geodesics.h>
#include <CGAL/Intrinsic_geodesics/bezier/make_bezier_curve.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_geodesics/shortening/certify_geodesic.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const Mesh::size_type n = mesh.number_of_vertices();

  //! [curve]
  std::vector<Triangulation::vertex_descriptor> control_points;
  for (const Mesh::size_type i : {Mesh::size_type{0}, n / 3, n / 2, n - 1})
    control_points.push_back(IT::vertex_on_intrinsic(t, Mesh::Vertex_index(i), mesh));
  const auto curve = IT::make_bezier_curve(t, control_points, IT::parameters::maximum_rounds(4U));
  if (curve.status != IT::Status::done) return 1;
  const IT::Traced_curve way = IT::trace_curve(t, curve.halfedges);
  const std::vector<Point> points = IT::polyline(t, way, mesh);
  //! [curve]
  //! [certificate]
  IT::Curve_network<Triangulation> network(t);
  for (const auto& vertices : {curve.control_points, curve.crossings})
    for (const auto v : vertices) network.fix(v);
  network.add_path(curve.halfedges);
  const bool is_certified = IT::certify_geodesic(network).is_geodesic();
  //! [certificate]
  std::cout << "a curve of length " << curve.length << " with " << curve.control_points.size()
            << " control points crosses " << points.size() - 2 << " edges and vertices\n";
  return is_certified ? 0 : 1;
}

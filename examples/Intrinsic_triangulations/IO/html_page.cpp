// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes a page for the browser: a mesh, its intrinsic Delaunay triangulation, the distance from a
// vertex as colours, and a geodesic.
// Usage: html_page [MESH.off [OUT.html]]

#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations.h>
#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <Eigen/Core>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Corresponding_triangulation;

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const std::filesystem::path file =
      argc > 2 ? argv[2] : std::filesystem::temp_directory_path() / "html_page.html";
  Triangulation t(mesh);
  IT::flip_to_delaunay(t);
  const auto a = IT::vertex_on_intrinsic(t, Mesh::Vertex_index(0), mesh),
             b = IT::vertex_on_intrinsic(t, Mesh::Vertex_index(2000), mesh);
  const Eigen::VectorXd distance = IT::Heat_distance(t).distances(a);
  const IT::Geodesic_path path = IT::Geodesic_finder<Triangulation>(t)(a, b);

  //! [page]
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const std::array fields{IT::interpolated_field("distance", s, distance)};
  std::vector<IT::Polyline> curves(1);
  for (const Point& p : IT::polyline(t, path, mesh))
    curves[0].points.push_back({p.x(), p.y(), p.z()});

  IT::Html_view view;
  view.title = "The part";
  view.fields = fields;
  view.isolines = 20;
  view.has_edges = false; // at first; a click shows them
  view.curves = curves;
  try {
    std::ofstream out(file);
    IT::write_html_view(out, s, IT::positions(s, mesh), view);
  } catch (const IT::Invalid_input& error) { // three.js is not installed
    std::cerr << error.what() << '\n';
  }
  //! [page]
  std::cout << std::filesystem::file_size(file) << " bytes\n";
  if (argc <= 2) std::filesystem::remove(file); // the test leaves nothing behind
  return 0;
}

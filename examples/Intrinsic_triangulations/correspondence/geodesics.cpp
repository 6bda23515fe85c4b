// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Goes straight from a point of the mesh in many directions, for a length: the exponential map.
// Writes the lines for programs that show OBJ. Usage: geodesics [MESH.off [FACE LENGTH LINES.obj]]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;

double length_of(const std::vector<Point>& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(line[i - 1], line[i]));
  return sum;
}

void write_OBJ(const std::string& file, const std::vector<std::vector<Point>>& lines) {
  std::ofstream out(file);
  for (const std::vector<Point>& line : lines) {
    for (const Point& p : line) out << "v " << p << '\n';
    for (std::size_t i = line.size(); i > 1; --i) out << "l -" << i << " -" << i - 1 << '\n';
  }
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  const Mesh::Face_index face(argc > 4 ? static_cast<Mesh::size_type>(std::stoul(argv[2])) : 0);
  const double length = argc > 4 ? std::stod(argv[3]) : 10;
  const IT::Corresponding_triangulation t(mesh);

  std::vector<std::vector<Point>> lines;
  double difference = 0;
  for (int i = 0; i < 360; i += 3) {
    const double angle = i * std::numbers::pi / 180;
    //! [trace]
    // from the middle of a face, in a direction given along halfedge(face, mesh) and to the left of
    // it
    const IT::Geodesic g = IT::trace_geodesic(t, {face, {1. / 3, 1. / 3, 1. / 3}},
                                              {std::cos(angle), std::sin(angle)}, length, mesh);
    std::vector<Point> line;
    for (const IT::Surface_point& p : g.points) line.push_back(IT::point_in_space(t, p, mesh));
    //! [trace]
    if (g.status == IT::Status::done) // others end at the border
      difference = std::max(difference, std::abs(length_of(line) / length - 1));
    lines.push_back(line);
  }
  if (argc > 4) write_OBJ(argv[4], lines);
  std::cout << lines.size() << " geodesics; lengths in space differ from " << length << " by "
            << difference << " of it\n";
  return difference < 1e-9 ? 0 : 1;
}

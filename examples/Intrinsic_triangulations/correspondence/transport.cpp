// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Goes from vertices of the mesh along edges of its intrinsic Delaunay triangulation, which are
// geodesics of the mesh, to their other ends, and takes tangent vectors there: parallel transport.
// Usage: transport [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Complex = std::complex<double>;

template <class Vector>
Complex complex(const Vector& v) {
  return {v[0], v[1]};
}

double distance(const IT::Corresponding_triangulation& t, const Mesh& mesh,
                const IT::Surface_point& p, const IT::Surface_point& q) {
  return std::sqrt(
      CGAL::squared_distance(IT::point_in_space(t, p, mesh), IT::point_in_space(t, q, mesh)));
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  IT::Corresponding_triangulation t(mesh);
  IT::flip_to_delaunay(t);

  double apart = 0, longer = 0;
  for (const auto e : edges(t.mesh())) {
    if (CGAL::is_border(halfedge(e, t.mesh()), t.mesh())) continue;
    //! [start]
    // along a halfedge of the triangulation from its source, which is a vertex of the mesh
    const IT::Tangent_vector along{{2 * t.index(e), {1, 0, 0}}, {1, 0}};
    const auto start = IT::tangent_to_input(t, along);
    const double length = t.length(e);
    const IT::Geodesic g = IT::trace_geodesic_on_input(t, start->point, start->vector, length);
    //! [start]
    //! [transport]
    // a vector keeps its angle to the geodesic; each is a complex number in the frame of its place
    const Complex v(0.6, 0.8);
    const Complex w = v / complex(start->vector) * complex(g.direction);
    const IT::Tangent_vector there{g.points.back(), {w.real(), w.imag()}};
    //! [transport]
    const IT::Surface_point end = IT::trace_edge(t, e).points.back().on_input;
    apart = std::max(apart, distance(t, mesh, there.point, end) / length);
    longer = std::max(longer, std::abs(std::hypot(there.vector[0], there.vector[1]) - 1));
  }
  std::cout << "geodesics miss vertices by at most " << apart
            << " of their lengths; vectors of length 1 change by " << longer << '\n';
  return apart < 1e-6 && longer < 1e-12 ? 0 : 1;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Refines a mesh and keeps its feature edges: they are split, never flipped.
// Usage: constrained_refinement [MESH.off]

#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <unordered_set>

namespace IT = CGAL::Intrinsic_triangulations;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Edge = Triangulation::edge_descriptor;

//! [map]
// an edge map that grows with the triangulation
struct Features {
  using key_type = Edge;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;
  friend bool get(const Features& f, Edge e) { return f.edges->contains(e.index); }
  friend void put(const Features& f, Edge e, bool is_feature) {
    is_feature ? (void)f.edges->insert(e.index) : (void)f.edges->erase(e.index);
  }
  std::unordered_set<std::uint32_t>* edges;
};
//! [map]

// whether the faces at an edge meet at more than 40 degrees; before any flip
bool is_sharp(const Triangulation& t, const Mesh& mesh, Edge e) {
  const auto h = halfedge(e, t.mesh()), o = opposite(h, t.mesh());
  const auto point = [&](auto v) { return mesh.point(Mesh::Vertex_index(t.input_vertex(v))); };
  const Point i = point(source(h, t.mesh())), j = point(target(h, t.mesh()));
  const Point k = point(target(next(h, t.mesh()), t.mesh()));
  const Point m = point(target(next(o, t.mesh()), t.mesh()));
  return CGAL::approximate_angle(CGAL::normal(i, j, k), CGAL::normal(j, i, m)) > 40;
}

int main(int argc, char* argv[]) {
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(argc > 1 ? argv[1] : "data/part.off", mesh)) return 1;
  Triangulation t(mesh);
  std::unordered_set<std::uint32_t> features;
  for (const Edge e : edges(t.mesh()))
    if (!CGAL::is_border(e, t.mesh()) && is_sharp(t, mesh, e)) features.insert(e.index);
  const auto length = [&] {
    double sum = 0;
    for (const std::uint32_t e : features) sum += std::sqrt(t.squared_length(Edge{e}));
    return sum;
  };
  const std::size_t count = features.size();
  const double before = length();
  //! [refine]
  const auto result = IT::delaunay_refine(
      t, IT::parameters::minimum_angle(25).edge_is_constrained_map(Features{&features}));
  //! [refine]
  bool kept = std::abs(length() - before) < 1e-9 * before; // and still on edges of the input:
  for (const std::uint32_t e : features) kept &= t.correspondence().normal_coordinate(e) < 0;
  std::cout << result.counts.inserted_vertices() << " vertices inserted\n"
            << count << " feature edges, now " << features.size() << ", of length " << before
            << ", now " << length() << '\n';
  return kept && result.status == IT::Status::done ? 0 : 1;
}

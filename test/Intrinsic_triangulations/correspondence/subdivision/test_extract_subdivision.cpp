// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include "gallery.h"
#include "meshes.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Common_subdivision;
using meshes::cross, meshes::minus, meshes::norm, meshes::Point;
using subdivision_oracle::Exact;
using subdivision_oracle::Mover;
using subdivision_oracle::none;
using subdivision_oracle::Plane;
using subdivision_oracle::Rounded;

Point combine(const IT::Weighted_vertices& w, const std::vector<Point>& points) {
  Point p{0, 0, 0};
  double sum = 0;
  for (std::size_t i = 0; i < w.size; ++i) {
    sum += w.weights[i];
    for (std::size_t k = 0; k < 3; ++k) p[k] += w.weights[i] * points[w.vertices[i]][k];
  }
  EXPECT_NEAR(sum, 1, 1e-14); // three roundings
  return p;
}

/// What holds on any surface: Euler characteristic, labels of sides, cells on both sides of edges.
template <class T>
void expect_subdivision(const T& t, const Common_subdivision& s, const std::string& name) {
  const IT::Input& input = t.correspondence().input();
  const auto euler = [](std::size_t v, std::size_t e, std::size_t f) {
    return static_cast<std::ptrdiff_t>(v) - static_cast<std::ptrdiff_t>(e) +
           static_cast<std::ptrdiff_t>(f);
  };
  EXPECT_EQ(euler(s.number_of_vertices(), s.number_of_edges(), s.number_of_faces()),
            euler(input.number_of_vertices(), input.number_of_halfedges() / 2,
                  input.mesh().number_of_faces()))
      << name;
  std::size_t visited = 0;
  IT::for_each_subdivision_edge(s, [&](std::uint32_t, std::uint32_t, const auto& side) {
    ++visited;
    EXPECT_TRUE(side.input_edge != none || side.intrinsic_edge != none) << name;
  });
  EXPECT_EQ(visited, s.number_of_edges()) << name;
  // a part of an intrinsic edge between crossings belongs to one edge, and so does one of an input edge
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t k = 0; k < s.face(f).size(); ++k)
      for (const std::size_t end : {k, (k + 1) % s.face(f).size()}) {
        const std::uint32_t v = s.face(f)[end];
        if (v < s.vertices.size()) continue;
        const auto& c = s.crossings[v - s.vertices.size()];
        const auto side = s.sides(f)[k];
        EXPECT_TRUE(side.input_edge == none || side.input_edge == c.on_input.edge) << name;
        EXPECT_TRUE(side.intrinsic_edge == none || side.intrinsic_edge == c.on_intrinsic.edge)
            << name;
      }
}

/// Areas and lengths in space: of cells per face of either, of parts of edges.
template <class T>
void expect_measures(const T& t, const Common_subdivision& s, const std::vector<Point>& points,
                     double tolerance, const std::string& name) {
  const IT::Input& input = t.correspondence().input();
  const std::vector<Point> x = IT::positions(s, points);
  std::vector<double> on_input(input.mesh().number_of_faces(), 0), on_intrinsic, length;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const double a = norm(meshes::area_vector(x, s.face(f)));
    on_input[s.input_face[f]] += a;
    if (s.intrinsic_face[f] >= on_intrinsic.size()) on_intrinsic.resize(s.intrinsic_face[f] + 1, 0);
    on_intrinsic[s.intrinsic_face[f]] += a;
  }
  IT::for_each_subdivision_edge(s, [&](std::uint32_t a, std::uint32_t b, const auto& side) {
    if (side.intrinsic_edge == none) return;
    if (side.intrinsic_edge >= length.size()) length.resize(side.intrinsic_edge + 1, 0);
    length[side.intrinsic_edge] += norm(minus(x[a], x[b]));
  });
  for (std::uint32_t f = 0; f < on_input.size(); ++f)
    EXPECT_NEAR(on_input[f],
                std::ldexp(input.quadruple_area(f), -2 - 2 * t.metric().scale_exponent()),
                tolerance)
        << name << " input face " << f;
  for (const auto f : faces(t.mesh()))
    EXPECT_NEAR(on_intrinsic[t.index(f)], t.area(f), tolerance) << name << " face " << t.index(f);
  for (const auto e : edges(t.mesh()))
    EXPECT_NEAR(length[t.index(e)], std::sqrt(t.squared_length(e)), tolerance)
        << name << " edge " << t.index(e);
}

std::vector<std::pair<std::string, meshes::Mesh>> in_space() {
  return {{"box", meshes::box(2, 1, 1)},       {"l shape", meshes::l_shape(2)},
          {"sphere", meshes::sphere(2)},       {"potato", meshes::potato(2, 3)},
          {"stairs", meshes::stairs(3, 2, 2)}, {"terrain", meshes::integer_terrain(60, 40, 5)},
          {"rough", meshes::rough_grid(6, 7)}};
}

TEST(Extract_subdivision, Of_the_input_with_itself_is_the_input) {
  for (const auto& [name, mesh] : in_space()) {
    const Exact t(subdivision_oracle::input(mesh));
    const Common_subdivision s = IT::common_subdivision(t);
    EXPECT_EQ(s.number_of_vertices(), mesh.points.size()) << name;
    EXPECT_EQ(s.number_of_faces(), mesh.triangles.size()) << name;
    EXPECT_EQ(s.input_face, s.intrinsic_face) << name;
    expect_subdivision(t, s, name);
    expect_measures(t, s, mesh.points, 1e-12, name);
  }
}

TEST(Extract_subdivision, Measures_what_both_triangulations_measure) {
  for (const auto& [name, mesh] : in_space()) {
    Exact t(subdivision_oracle::input(mesh));
    Mover<Exact> mover(t, 1);
    for (int i = 0; i < 60; ++i) t.flip_edge({mover.halfedge(false)});
    for (int i = 0; i < 60; ++i) mover.move(true);
    const Common_subdivision s = IT::common_subdivision(t);
    expect_subdivision(t, s, name);
    // coordinates are up to 40, and 1e-8 is far above what a strip of some tens of faces loses
    expect_measures(t, s, mesh.points, 1e-8, name);
  }
}

TEST(Extract_subdivision, Measures_what_both_measure_after_flips_to_delaunay_in_doubles) {
  for (const auto& [name, mesh] : in_space()) {
    Rounded t(subdivision_oracle::input(mesh));
    IT::flip_to_delaunay(t);
    Mover<Rounded> mover(t, 2);
    for (int i = 0; i < 20; ++i) t.insert_vertex({mover.halfedge(true)}, mover.weights(i % 2 == 0));
    const Common_subdivision s = IT::common_subdivision(t);
    expect_subdivision(t, s, name);
    expect_measures(t, s, mesh.points, 1e-7, name);
  }
}

TEST(Extract_subdivision, Keeps_the_topology_on_the_gallery) {
  for (const gallery::Surface& g : gallery::oriented()) {
    Exact t(gallery::input(g));
    Mover<Exact> mover(t, 3);
    for (int i = 0; i < 30; ++i) {
      mover.move(true);
      if (i % 3 == 0) expect_subdivision(t, IT::common_subdivision(t), g.name);
    }
  }
}

TEST(Extract_subdivision, Lies_in_the_faces_that_its_labels_name_in_the_plane) {
  for (const auto& [name, mesh] :
       {std::pair{"grid", meshes::grid(3, 3)}, std::pair{"parabola", meshes::parabola_fan(7)},
        std::pair{"random", meshes::random_planar(20, 64, 1)}}) {
    Plane<Exact> p(mesh);
    Mover<Exact> mover(p.t, 4);
    for (int i = 0; i < 60; ++i)
      mover.move(
          true, [&](std::uint32_t h, const auto& w) { return p.insert(h, w); },
          [&](IT::Gluing_map::Vertex v, std::uint32_t h, const auto& w) {
            return p.reposition(v, h, w);
          });
    const Common_subdivision s = IT::common_subdivision(p.t);
    expect_subdivision(p.t, s, name);
    std::vector<Point> intrinsic(p.t.number_of_vertices()); // by row
    for (const auto v : vertices(p.t.mesh())) {
      const auto& q = p.position[p.t.index(v)];
      intrinsic[p.t.input_vertex(v)] = {CGAL::to_double(q[0]), CGAL::to_double(q[1]), 0};
    }
    const std::vector<Point> x = IT::positions(s, mesh.points);
    for (std::size_t v = 0; v < x.size(); ++v) // coordinates up to 64
      ASSERT_LE(norm(minus(x[v], combine(s.on_intrinsic(v), intrinsic))), 1e-9) << name << ' ' << v;
    const IT::Intrinsic_view<Exact> view(p.t);
    for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
      const auto cell = s.face(f);
      Point centre{0, 0, 0};
      double signed_area = 0;
      for (std::size_t k = 0; k < cell.size(); ++k) {
        const Point &a = x[cell[k]], &b = x[cell[(k + 1) % cell.size()]],
                    &c = x[cell[(k + 2) % cell.size()]];
        EXPECT_GE(cross(minus(b, a), minus(c, b))[2], -1e-9) << name << ' ' << f;
        signed_area += cross(a, b)[2] / 2;
        for (std::size_t i = 0; i < 3; ++i) centre[i] += a[i] / static_cast<double>(cell.size());
      }
      EXPECT_GE(signed_area, -1e-9) << name << ' ' << f;
      const auto inside = [&](const std::array<Point, 3>& c) {
        for (std::size_t k = 0; k < 3; ++k)
          if (cross(minus(c[(k + 1) % 3], c[k]), minus(centre, c[k]))[2] < -1e-9) return false;
        return true;
      };
      const auto& tri = mesh.triangles[s.input_face[f]];
      EXPECT_TRUE(inside({mesh.points[tri[0]], mesh.points[tri[1]], mesh.points[tri[2]]}))
          << name << ' ' << f;
      const auto h = IT::sides_of_face(view, view.halfedge_of_face(s.intrinsic_face[f]));
      const auto source = [&](std::uint32_t side) {
        return intrinsic[p.t.input_vertex(IT::Gluing_map::Vertex{view.source(side)})];
      };
      EXPECT_TRUE(inside({source(h[0]), source(h[1]), source(h[2])})) << name << ' ' << f;
    }
  }
}

} // namespace

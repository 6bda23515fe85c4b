// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "meshes.h"
#include "operator_test_meshes.h"
#include "refined_meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>
#include <vector>

// Maps of surfaces that are no disks, after a cut: flat ones keep all lengths.

namespace {

using namespace operator_test;
using Map = Eigen::MatrixX2d;

double distance(const std::array<double, 3>& p, const std::array<double, 3>& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Corners on both sides of an edge have the same place, unless the edge is cut; faces have their
// corners in the order of their sides.
void expect_seams_only_at_cuts(const IT::Intrinsic_input& in, const std::vector<char>& is_cut,
                               const IT::Opened_input& opened) {
  std::size_t seams = 0;
  std::vector<std::array<std::uint32_t, 2>> ends(in.mesh.number_of_edges(),
                                                 {IT::Gluing::none, IT::Gluing::none});
  for (std::uint32_t f = 0; f < in.mesh.number_of_faces(); ++f) {
    std::uint32_t k = 0;
    for (const IT::Gluing_map::Halfedge h : in.mesh.sides({f})) {
      std::array<std::uint32_t, 2> side{opened.corners[f][k], opened.corners[f][(k + 1) % 3]};
      ++k;
      EXPECT_EQ(opened.original_vertex[side[0]], in.mesh.source(h).index);
      if (h.index % 2 != 0) std::swap(side[0], side[1]);
      auto& seen = ends[h.index / 2];
      if (seen[0] == IT::Gluing::none)
        seen = side;
      else if (is_cut[h.index / 2] == 0)
        EXPECT_EQ(seen, side);
      else
        seams += seen == side ? 0 : 1;
    }
  }
  EXPECT_EQ(seams, static_cast<std::size_t>(std::ranges::count(is_cut, 1)));
}

// Distances between the corners of faces are those on the surface.
void expect_isometric(const IT::Opened_input& disk, const Map& uv) {
  const IT::Gluing_map& mesh = disk.input.mesh;
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    const std::uint32_t i = mesh.source(IT::Gluing_map::Halfedge{2 * e}).index,
                        j = mesh.target(IT::Gluing_map::Halfedge{2 * e}).index;
    const double length = disk.input.points.empty()
                              ? std::sqrt(disk.input.squared_lengths[e])
                              : distance(disk.input.points[i], disk.input.points[j]);
    EXPECT_NEAR((uv.row(i) - uv.row(j)).norm(), length, 1e-8);
  }
}

} // namespace

TEST(Maps_of_cut_surfaces, Flat_tori_are_unrolled) {
  for (const double shear : {0., 0.3, 1.7})
    for (const std::uint32_t n : {3U, 7U}) {
      const IT::Intrinsic_input in = torus(n, shear);
      const std::vector<char> is_cut = IT::cut_to_disk(in);
      const IT::Opened_input disk = IT::cut_open(in, is_cut);
      expect_seams_only_at_cuts(in, is_cut, disk);
      const Double t(disk.input);
      for (const Map& uv : {IT::least_squares_conformal_map(t), IT::spectral_conformal_map(t)}) {
        expect_isometric(disk, uv);
        EXPECT_TRUE(IT::certify_map(t, uv).is_locally_injective());
        EXPECT_TRUE(IT::certify_map(disk.corners, uv).is_locally_injective());
      }
    }
}

TEST(Maps_of_cut_surfaces, A_cylinder_becomes_a_rectangle) {
  const meshes::Mesh m = meshes::walls({{0, 0}, {3, 0}, {3, 2}, {1, 4}, {0, 4}}, 6);
  const IT::Intrinsic_input in = m.input();
  const std::vector<char> is_cut = IT::cut_to_disk(in);
  const IT::Opened_input disk = IT::cut_open(in, is_cut);
  expect_seams_only_at_cuts(in, is_cut, disk);
  const Exact t(disk.input);
  const Map uv = IT::least_squares_conformal_map(t);
  expect_isometric(disk, uv);
  EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
  const double around = 3 + 2 + std::sqrt(8.) + 1 + 4; // both sides of the seam are so far apart
  for (std::size_t v = m.points.size(); v < disk.original_vertex.size(); ++v)
    EXPECT_NEAR((uv.row(static_cast<Eigen::Index>(v)) - uv.row(disk.original_vertex[v])).norm(),
                around, 1e-8);
}

TEST(Maps_of_cut_surfaces, Cutting_keeps_exact_lengths_polygons_and_names) {
  IT::Triangle_soup soup; // a cube without a floor, of squares
  const Shape s = cube();
  soup.points = s.points;
  soup.triangles.assign(s.triangles.begin() + 2, s.triangles.end());
  for (std::uint32_t f = 0; f < 10; ++f) soup.polygon_of_triangle.push_back(f / 2);
  soup.input_faces = 5;
  const IT::Intrinsic_input in = IT::make_domain(soup).input;
  const std::vector<std::uint32_t> through{0, 1, 2, 3, 4, 5, 6, 7};
  const std::vector<char> is_cut = IT::cut_to_disk(in, through);
  EXPECT_EQ(std::ranges::count(is_cut, 1), 4); // to the four vertices that are not on the border
  for (std::uint32_t e = 0; e < is_cut.size(); ++e) {
    const auto &p = in.points[in.mesh.source(IT::Gluing_map::Halfedge{2 * e}).index],
               &q = in.points[in.mesh.target(IT::Gluing_map::Halfedge{2 * e}).index];
    EXPECT_TRUE(is_cut[e] == 0 || distance(p, q) == 1);
  }
  const IT::Opened_input disk = IT::cut_open(in, is_cut);
  expect_seams_only_at_cuts(in, is_cut, disk);
  EXPECT_EQ(disk.input.names.polygon_of_triangle, in.names.polygon_of_triangle);
  EXPECT_NEAR(IT::total_area(Exact(disk.input)), 5, 1e-12);
  IT::Intrinsic_input cover = in;
  cover.names.sheets = 2;
  EXPECT_THROW(IT::cut_open(cover, is_cut), IT::Invalid_input);
  EXPECT_THROW(IT::cut_to_disk(cover), IT::Invalid_input);
  EXPECT_THROW(IT::cut_open(in, std::vector<char>(3, 0)), IT::Invalid_input);
}

TEST(Maps_of_cut_surfaces, Rough_tori_are_mapped_injectively) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const IT::Intrinsic_input in = rough_torus(12, 0.3, seed).input();
    const IT::Opened_input disk = IT::cut_open(in, IT::cut_to_disk(in));
    Exact t(disk.input);
    const IT::Injective_map map = IT::injective_harmonic_map(t);
    EXPECT_EQ(map.status, IT::Status::done);
    EXPECT_TRUE(map.certificate.is_injective());
  }
}

// Pages of a book, flat squares that share a side, some of them turned around.
TEST(Maps_of_cut_surfaces, Faces_below_a_tufted_cover_are_mapped_once) {
  for (const std::uint32_t pages : {1U, 2U, 3U, 4U}) {
    SCOPED_TRACE("pages " + std::to_string(pages));
    IT::Triangle_soup soup;
    for (std::uint32_t p = 0; p < pages; ++p) {
      const Shape s = grid(3);
      std::vector<std::uint32_t> number;
      for (const auto& [x, y, z] : s.points) {
        const bool is_new = p == 0 || x > 0;
        number.push_back(is_new ? static_cast<std::uint32_t>(soup.points.size())
                                : static_cast<std::uint32_t>(4 * y));
        const double angle = 1.5 * p;
        if (is_new) soup.points.push_back({x * std::cos(angle), y, x * std::sin(angle)});
      }
      for (std::size_t f = 0; f < s.triangles.size(); ++f) {
        const auto& [a, b, c] = s.triangles[f];
        soup.triangles.push_back({number[a], number[b], number[c]});
        if (f % 3 == p) std::swap(soup.triangles.back()[0], soup.triangles.back()[1]);
      }
    }
    soup.input_faces = soup.triangles.size();
    const IT::Domain domain = IT::make_domain(soup, IT::Domain_kind::tufted_cover);
    const IT::Intrinsic_input sheet = IT::sheet_of_cover(domain.input);
    EXPECT_EQ(sheet.points, soup.points);
    ASSERT_EQ(sheet.mesh.number_of_faces(), soup.triangles.size());
    const IT::Opened_input disks = IT::cut_open(sheet, IT::cut_to_disk(sheet));
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
      std::array<std::uint32_t, 3> corners = disks.corners[f];
      for (std::uint32_t& v : corners) v = disks.original_vertex[v];
      if (disks.reversed_faces[f] != 0) std::swap(corners[1], corners[2]);
      EXPECT_EQ(corners, soup.triangles[f]);
    }
    const Exact t(disks.input);
    const Map uv = IT::least_squares_conformal_map(t);
    expect_isometric(disks, uv);
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
    EXPECT_EQ(IT::connected_components(disks.input.mesh).count, pages < 3 ? 1 : pages);
  }
  EXPECT_THROW(IT::sheet_of_cover(IT::make_point_cloud(grid(4).points, 8).input),
               IT::Invalid_input);
}

TEST(Maps_of_cut_surfaces, A_flat_Moebius_strip_is_unrolled) {
  IT::Gluing g; // squares in a row, of two triangles each; the last side is glued to the first
  constexpr std::uint32_t squares = 5;
  for (std::uint32_t i = 0; i < squares; ++i) {
    const auto vertex = [](std::uint32_t column, std::uint32_t row) {
      return column < squares ? 2 * column + row : 1 - row;
    };
    const std::uint32_t a = vertex(i, 0), b = vertex(i + 1, 0), c = vertex(i + 1, 1),
                        d = vertex(i, 1), f = 6 * i;
    for (const std::uint32_t v : {a, b, c, a, c, d}) g.origin.push_back(v);
    const std::uint32_t before = i == 0 ? IT::Gluing::reversed(6 * squares - 5) : f - 5,
                        after = i + 1 == squares ? IT::Gluing::reversed(5) : f + 11;
    for (const std::uint32_t h : {IT::Gluing::none, after, f + 3, f + 2, IT::Gluing::none, before})
      g.glue.push_back(h);
  }
  g.number_of_vertices = 2 * squares;
  IT::Gluing_map map(g);
  std::vector<double> squared(map.number_of_edges());
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k)
      squared[map.sides({f})[k].index / 2] = k == (f % 2 == 0 ? 2 : 0) ? 2 : 1;
  const IT::Intrinsic_input in(std::move(map), squared);
  for (const IT::Domain_kind kind : {IT::Domain_kind::automatic, IT::Domain_kind::tufted_cover}) {
    const IT::Domain domain = IT::make_domain(in, kind);
    ASSERT_EQ(domain.report.sheets, 2U);
    const IT::Intrinsic_input sheet = IT::sheet_of_cover(domain.input);
    EXPECT_EQ(IT::gluing_from_map(sheet.mesh).glue, g.glue);
    EXPECT_EQ(IT::gluing_from_map(sheet.mesh).origin, g.origin);
    const IT::Opened_input disk = IT::cut_open(sheet, IT::cut_to_disk(sheet));
    const Exact t(disk.input);
    const Map uv = IT::least_squares_conformal_map(t);
    expect_isometric(disk, uv);
    EXPECT_TRUE(IT::certify_map(t, uv).is_injective());
  }
}

#ifdef INTRINSIC_TRIANGULATIONS_CGAL_MESH_DIR
// Tutte: the map is injective, unless the surface has tips that no triangulation can hold, or faces
// are smaller than rounding; then the status says so.
TEST(Maps_of_cut_surfaces, All_connected_oriented_meshes_of_CGAL) {
  std::size_t mapped = 0, all = 0;
  for (const auto& file : refined::files(2'000'000)) {
    SCOPED_TRACE(file.string());
    IT::Intrinsic_input in;
    try {
      in = IT::make_domain(IT::read_triangle_soup(file), IT::Domain_kind::manifold).input;
    } catch (const std::exception&) {
      continue; // no oriented manifold
    }
    if (IT::connected_components(in.mesh).count != 1) continue;
    const IT::Opened_input disk = IT::cut_open(in, IT::cut_to_disk(in, {}, 2));
    Exact t(disk.input);
    if (t.report().degenerate_faces > 0) continue;
    const IT::Injective_map map = IT::injective_harmonic_map(t);
    ++all;
    EXPECT_EQ(map.status == IT::Status::done, map.certificate.is_injective());
    EXPECT_TRUE(map.status == IT::Status::done || map.status == IT::Status::inaccurate);
    if (map.status == IT::Status::done) ++mapped;
  }
  EXPECT_GE(mapped + 4, all); // camel, cheese, diplodocus, femur
}
#endif

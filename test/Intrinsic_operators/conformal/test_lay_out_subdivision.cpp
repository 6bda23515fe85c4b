// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/conformal/lay_out_subdivision.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include "flat_surfaces.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

// Layouts of common subdivisions of flat surfaces: isometric on the input, whatever the
// triangulation.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

// A flat surface as input of a triangulation, that keeps its numbers.
IT::Intrinsic_input input_of(const flat::Surface& s) {
  IT::Gluing_map map(s.gluing);
  std::vector<double> squares(map.number_of_edges());
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f)
    for (std::uint32_t k = 0; k < 3; ++k)
      squares[map.sides({f})[k].index / 2] = std::pow(s.length[3 * f + k], 2);
  IT::Intrinsic_input in(std::move(map), std::move(squares));
  in.may_renumber = false;
  return in;
}

void flip_at_random(Triangulation& t, std::mt19937& random, int flips) {
  std::vector<Triangulation::edge_descriptor> all(edges(t.mesh()).begin(), edges(t.mesh()).end());
  for (int i = 0; i < flips; ++i) {
    const auto h = halfedge(all[random() % all.size()], t.mesh());
    t.flip_edge(h); // or it is refused
  }
}

struct Laid_out {
  IT::Intrinsic_input in;
  std::vector<char> is_cut;
  IT::Subdivision_layout layout;
};

Laid_out lay_out(const flat::Surface& s, std::mt19937& random, int flips,
                 const std::vector<char>& is_wanted = {}, std::vector<char> is_cut = {}) {
  Laid_out r{input_of(s), std::move(is_cut), {}};
  if (r.is_cut.empty()) r.is_cut = IT::cut_to_disk(r.in, s.cones());
  Triangulation t(r.in);
  flip_at_random(t, random, flips);
  if (flips == 0) IT::flip_to_delaunay(t);
  std::vector<std::uint32_t> side;
  IT::Surface_to_cut flat = IT::internal::surface_to_cut(t, side);
  for (const auto f : faces(t.mesh())) { // after many flips the stored values are vague
    const auto values = IT::internal::accurate_values(t, f);
    for (std::size_t k = 0; k < 3; ++k)
      flat.length[side[t.mesh().sides(f)[k].index]] =
          std::ldexp(std::sqrt(values.squared_lengths[k]), -t.metric().scale_exponent());
  }
  const IT::Common_subdivision subdivision = IT::common_subdivision(t);
  IT::Flat_subdivision arrays{subdivision, flat, side, r.is_cut, is_wanted, {}, {}};
  for (const double l : r.in.squared_lengths) arrays.input_lengths.push_back(std::sqrt(l));
  r.layout = IT::lay_out_subdivision(arrays);
  return r;
}

// Faces of the input that are laid out have their lengths, and neighbours meet but at cuts.
void expect_isometric(const Laid_out& r, double error) {
  const IT::Gluing_map& map = r.in.mesh;
  const auto uv = IT::corner_coordinates(r.layout, map.number_of_halfedges());
  for (std::uint32_t h = 0; h < map.number_of_halfedges(); ++h) {
    const auto &p = uv[h], &q = uv[map.next({h}).index];
    if (std::isnan(p[0])) continue;
    EXPECT_NEAR(std::hypot(q[0] - p[0], q[1] - p[1]), std::sqrt(r.in.squared_lengths[h / 2]),
                error);
    const auto &a = uv[h ^ 1U], &b = uv[map.next({h ^ 1U}).index];
    if (r.is_cut[h / 2] != 0) continue;
    EXPECT_EQ(p, b);
    EXPECT_EQ(q, a);
  }
  EXPECT_LE(r.layout.largest_side_error, 1e-3); // relative to the size of small faces
  ASSERT_EQ(r.layout.weights.size(), r.layout.positions.rows());
}

TEST(LayOutSubdivision, isIsometricOnTheMeshWhateverTheTriangulation) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    for (const int flips : {0, 20}) { // more make caps, whose lengths in doubles are vague
      SCOPED_TRACE("seed " + std::to_string(seed) + " flips " + std::to_string(flips));
      std::mt19937 random(seed);
      flat::Surface s = seed % 3 == 0   ? flat::cube()
                        : seed % 3 == 1 ? flat::tetrahedron()
                                        : flat::Surface::torus(1, flat::Complex(0.3, 0.9), seed);
      s.mix(random, 40, 300);
      const Laid_out r = lay_out(s, random, flips);
      expect_isometric(r, 1e-9);
      const IT::Map_certificate c = IT::certify_map(r.layout);
      EXPECT_TRUE(c.is_locally_injective()) << c.flipped << ' ' << c.degenerate;
    }
}

TEST(LayOutSubdivision, laysTriangulationsOfOneVertexOut) {
  std::mt19937 random(3);
  const flat::Surface s = flat::Surface::torus(1, flat::Complex(0.3, 0.9), 1);
  const Laid_out r = lay_out(s, random, 10);
  expect_isometric(r, 1e-9);
  EXPECT_EQ(r.layout.subdivision.vertices.size(), 4U); // a parallelogram
}

TEST(LayOutSubdivision, laysHalfOfADoubledPolygonOut) {
  for (const unsigned n : {3U, 5U, 8U}) {
    SCOPED_TRACE("corners " + std::to_string(n));
    std::vector<flat::Complex> corners;
    for (unsigned k = 0; k < n; ++k)
      corners.push_back(std::polar(1., 2 * std::numbers::pi * k / n + 0.2 * std::sin(k * k)));
    const flat::Surface s = flat::Surface::doubled_polygon(corners);
    const std::size_t half = s.number_of_faces() / 2;
    std::vector<char> front(2 * half, 0), mirror(input_of(s).mesh.number_of_edges(), 0);
    for (std::size_t f = 0; f < half; ++f) front[f] = 1;
    const IT::Intrinsic_input in = input_of(s);
    for (std::uint32_t e = 0; e < mirror.size(); ++e)
      mirror[e] = front[in.mesh.face(IT::Gluing_map::Halfedge{2 * e}).index] !=
                  front[in.mesh.face(IT::Gluing_map::Halfedge{2 * e + 1}).index];
    std::mt19937 random(n);
    const Laid_out r = lay_out(s, random, 20, front, mirror);
    expect_isometric(r, 1e-9);
    EXPECT_EQ(r.layout.subdivision.vertices.size(), n);
    EXPECT_TRUE(IT::certify_map(r.layout).is_injective());
  }
}

TEST(LayOutSubdivision, writesTextureCoordinates) {
  std::mt19937 random(1);
  flat::Surface s = flat::Surface::torus(1, flat::Complex(0, 1), 3);
  const Laid_out r = lay_out(s, random, 30);
  const std::vector<IT::Subdivision_field> fields = IT::fields_of_layout(r.layout);
  ASSERT_EQ(fields.size(), 3U);
  const std::vector<std::array<double, 3>> points(r.layout.subdivision.number_of_vertices());
  for (const char* extension : {"obj", "vtp", "ply"}) {
    std::ostringstream out;
    IT::write_common_subdivision(out, extension, r.layout.subdivision, points, fields);
    EXPECT_NE(out.str().find(extension == std::string("obj") ? "vt " : "homogeneous_uv"),
              std::string::npos);
  }
}

TEST(LayOutSubdivision, refusesArraysThatAreTooShort) {
  std::mt19937 random(1);
  const flat::Surface s = flat::tetrahedron();
  EXPECT_THROW(lay_out(s, random, 1, {}, {1, 1}), IT::Invalid_input);
}

} // namespace

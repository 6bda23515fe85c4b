// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_subdivision.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_input.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_round_disk.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/ideal_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include "flat_surfaces.h"
#include "hyperbolic_surfaces.h"
#include "surface_to_cut.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <span>
#include <sstream>
#include <string>
#include <vector>

// Layouts of common subdivisions of flat surfaces: isometric on the input, whatever the
// triangulation.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;

using flat::flip_at_random;

struct Laid_out {
  IT::Intrinsic_input in;
  std::vector<char> is_cut;
  IT::Subdivision_layout layout;
};

Laid_out lay_out(const flat::Surface& s, std::mt19937& random, int flips,
                 const std::vector<char>& is_wanted = {}, std::vector<char> is_cut = {},
                 const std::function<void(IT::Common_subdivision&)>& change = {}) {
  Laid_out r{input_of(s), std::move(is_cut), {}};
  if (r.is_cut.empty()) r.is_cut = IT::cut_to_disk(r.in, s.cones());
  Triangulation t(r.in);
  flip_at_random(t, random, flips);
  if (flips == 0) IT::flip_to_delaunay(t);
  const IT::Surface_to_cut flat = surface_to_cut(t);
  IT::Common_subdivision subdivision = IT::common_subdivision(t);
  if (change) change(subdivision);
  IT::Flat_subdivision arrays{subdivision, flat, r.is_cut, is_wanted, {}, {}};
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

// As where scale factors differ by many powers of ten: on cheese.off with four cones.
TEST(LayOutSubdivision, CrossingsThatRoundToVerticesHaveFinitePlaces) {
  for (const double end : {0., 1.}) {
    std::mt19937 random(1);
    flat::Surface s = flat::tetrahedron();
    s.mix(random, 40, 300);
    const Laid_out r = lay_out(s, random, 20, {}, {}, [&](IT::Common_subdivision& c) {
      ASSERT_GT(c.crossings.size(), 1U);
      c.crossings.front().on_intrinsic.parameter = end;
      c.crossings.back().on_input.parameter = end;
    });
    EXPECT_TRUE(r.layout.positions.allFinite());
    EXPECT_TRUE(r.layout.weights.allFinite());
    EXPECT_GT(r.layout.weights.minCoeff(), 0);
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

template <class Correspondence>
using Ideal_triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Ideal_hyperbolic_traits<double>,
                                Correspondence>;

// A torus that is flat after scaling and Ptolemy's flips.
struct Flattened {
  std::vector<double> factors;
  IT::Common_subdivision subdivision;
  IT::Ideal_crossing_parameters crossings;
  IT::Subdivision_layout layout;
};

Flattened flatten(std::mt19937& random) {
  std::uniform_real_distribution<double> logarithm(-1, 1);
  const flat::Surface s = flat::Surface::torus(1, flat::Complex(-0.3, 0.9), 6); // Delaunay
  Ideal_triangulation<IT::No_correspondence> start(input_of(s));
  for (int i = 0; i < 60; ++i)
    start.flip_edge({static_cast<std::uint32_t>(random() % start.mesh().number_of_halfedges())});
  Flattened r;
  for (std::uint32_t v = 0; v < s.gluing.number_of_vertices; ++v)
    r.factors.push_back(std::exp(logarithm(random)));
  IT::Intrinsic_input in(start.mesh(), std::vector<double>(start.mesh().number_of_edges()));
  in.mollification = IT::Mollification::none;
  in.may_renumber = false;
  for (std::uint32_t e = 0; e < in.squared_lengths.size(); ++e) {
    const IT::Gluing_map::Halfedge h{2 * e};
    const double w = r.factors[in.mesh.source(h).index] * r.factors[in.mesh.target(h).index];
    in.squared_lengths[e] = std::pow(start.lambda({e}) / w, 2);
  }
  Ideal_triangulation<IT::Integer_coordinates> t(in);
  t.scale_vertices(r.factors);
  IT::flip_to_delaunay(t);
  r.subdivision = IT::common_subdivision(t);
  r.crossings = IT::ideal_crossing_parameters(t, t.correspondence(),
                                              IT::edge_crossings(t, t.correspondence()));
  const IT::Surface_to_cut flat = IT::flat_surface(t);
  const std::vector<char> is_cut = IT::cut_to_disk(in);
  IT::Flat_subdivision arrays{r.subdivision, flat, is_cut, {}, r.factors, {}};
  for (const double l : in.squared_lengths) arrays.input_lengths.push_back(std::sqrt(l));
  r.layout = IT::lay_out_subdivision(arrays);
  return r;
}

// Homogeneous coordinates are linear functions of barycentric coordinates on the input. Returns
// whether the vertices of the face's triangle are different, and it could be checked.
bool expect_projective(const IT::Subdivision_layout& layout, std::size_t f) {
  const std::span<const std::uint32_t> corners = layout.subdivision.face(f);
  const std::vector<double> values = IT::fields_of_layout(layout).at(2).values;
  const Eigen::Map<const Eigen::Matrix3Xd> homogeneous(values.data(), 3, layout.weights.size());
  std::map<std::uint32_t, Eigen::Index> place;
  Eigen::Matrix3Xd weights = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(corners.size())),
                   images = weights;
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const IT::Weighted_vertices on = layout.subdivision.on_input(corners[c]);
    const auto column = static_cast<Eigen::Index>(c), v = static_cast<Eigen::Index>(corners[c]);
    for (std::size_t i = 0; i < on.size; ++i) {
      const Eigen::Index row =
          place.insert({on.vertices[i], static_cast<Eigen::Index>(place.size())}).first->second;
      if (row > 2 || (i == 1 && on.vertices[0] == on.vertices[1])) return false;
      weights(row, column) = on.weights[i];
    }
    images.col(column) = homogeneous.col(v);
  }
  if (place.size() < 3) return false;
  const Eigen::Matrix3d map =
      images * weights.transpose() * (weights * weights.transpose()).inverse();
  EXPECT_LE((map * weights - images).norm(), 1e-8 * images.norm());
  return true;
}

TEST(LayOutSubdivision, interpolatesProjectivelyBetweenIdealTriangulations) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Flattened r = flatten(random);
    const IT::Common_subdivision& s = r.layout.subdivision;
    const std::vector<double> u = IT::fields_of_layout(r.layout).back().values;
    for (std::size_t v = 0; v < s.number_of_vertices(); ++v) {
      const IT::Weighted_vertices on = s.on_input(v);
      double expected = 0;
      for (std::size_t i = 0; i < on.size; ++i)
        expected += 2 * on.weights[i] * std::log(r.factors[on.vertices[i]]);
      EXPECT_NEAR(u[v], expected, 1e-13);
    }
    EXPECT_GT(s.crossings.size(), 0U);
    ASSERT_EQ(r.layout.weights.size(), r.layout.positions.rows());
    for (std::size_t v = 0; v < s.number_of_vertices(); ++v) {
      const double weight = r.layout.weights[static_cast<Eigen::Index>(v)];
      if (v < s.vertices.size())
        EXPECT_NEAR(weight * std::pow(r.factors[s.vertices[v].intrinsic], 2), 1, 1e-14);
      else
        EXPECT_NEAR(
            weight /
                r.crossings.weight[r.layout.original_vertex[v] - r.subdivision.vertices.size()],
            1, 1e-11);
    }
    for (std::size_t f = 0; f < s.number_of_faces(); ++f)
      if (s.face(f).size() > 3 && expect_projective(r.layout, f)) ++checked;
    EXPECT_TRUE(IT::certify_map(r.layout).is_locally_injective());
    EXPECT_LE(r.layout.largest_side_error, 1e-9);
  }
  EXPECT_GT(checked, 50U);
}

// Surfaces of genus 2 and 3 with random lengths, in Poincaré's disk.
TEST(LayOutSubdivision, interpolatesProjectivelyInTheDisk) {
  std::size_t checked = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> logarithm(-3, 3);
    IT::Intrinsic_input in =
        gallery::input(seed % 2 == 0 ? hyperbolic::bolza() : hyperbolic::klein_quartic());
    for (double& x : in.squared_lengths) x *= std::exp(logarithm(random));
    Ideal_triangulation<IT::Integer_coordinates> t(std::move(in));
    const IT::Surface_to_cut start = IT::flat_surface(t);
    const IT::Conformal_metric m = IT::hyperbolic_metric(
        t, IT::flat_angles(t), IT::parameters::number_of_iterations(12).tolerance(1e-14));
    EXPECT_LE(m.residual, 1e-12);
    const IT::Common_subdivision subdivision = IT::common_subdivision(t);
    const IT::Surface_to_cut s = IT::hyperbolic_surface(t);
    const std::vector<char> cut_sides = IT::cut_to_round_disk(start);
    std::vector<char> is_cut(start.side.size() / 2);
    std::vector<double> lengths(is_cut.size());
    for (std::size_t h = 0; h < start.side.size(); ++h) {
      is_cut[h / 2] = cut_sides[start.side[h]];
      lengths[h / 2] = start.length[start.side[h]];
    }
    const IT::Subdivision_layout layout =
        IT::lay_out_subdivision({subdivision, s, is_cut, {}, m.scale_factors, lengths, true, {}});
    EXPECT_LE(layout.largest_side_error, 1e-7);
    EXPECT_LE(layout.pairings.largest_seam_error, 1e-8);
    EXPECT_LE(layout.pairings.largest_relation_error, 1e-8);
    EXPECT_EQ(IT::flipped_geodesic_triangles(layout), 0U);
    EXPECT_GE(layout.pairings.seams.size(), 4U);
    for (std::size_t f = 0; f < layout.subdivision.number_of_faces(); ++f)
      if (layout.subdivision.face(f).size() > 3 && expect_projective(layout, f)) ++checked;
  }
  EXPECT_GT(checked, 50U);
}

TEST(LayOutSubdivision, writesTextureCoordinates) {
  std::mt19937 random(1);
  flat::Surface s = flat::Surface::torus(1, flat::Complex(0, 1), 3);
  const Laid_out r = lay_out(s, random, 30);
  const std::vector<IT::Subdivision_field> fields = IT::fields_of_layout(r.layout);
  ASSERT_EQ(fields.size(), 4U);
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

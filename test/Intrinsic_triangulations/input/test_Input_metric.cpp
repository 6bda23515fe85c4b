// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <optional>

using namespace CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;

namespace {

TEST(Input_metric, of_points_is_exact_in_an_exact_type) {
  // 0.1 + 1e-9 is not a multiple of a large power of two
  const meshes::Mesh m{{{0.1, 0, 0}, {0.3, 1e-9, 0}, {0, 0.7, 1e9}}, {{0, 1, 2}}};
  const Input_metric metric = Input_metric::from_points(m.map(), m.points, 0);
  const Gmpq x = Gmpq(0.3) - Gmpq(0.1), y(1e-9);
  EXPECT_EQ(metric.squared_length<Gmpq>(0, 0), x * x + y * y);
  EXPECT_TRUE(metric.is_embedded());
  EXPECT_EQ(metric.number_of_faces(), 1U);
}

TEST(Input_metric, both_faces_agree_on_the_length_of_the_edge_between_them) {
  const meshes::Mesh m = meshes::rough_grid(4, 1);
  const Gluing_map map = m.map();
  const Input_metric metric = Input_metric::from_points(map, m.points, 0);
  std::vector<Gmpq> length(map.number_of_edges(), Gmpq(-1));
  for (std::uint32_t f = 0; f < map.number_of_faces(); ++f) {
    Gluing_map::Halfedge h = map.halfedge(Gluing_map::Face{f});
    for (unsigned k = 0; k < 3; ++k, h = map.next(h)) {
      Gmpq& l = length[h.index / 2];
      if (l != Gmpq(-1)) {
        EXPECT_EQ(l, metric.squared_length<Gmpq>(f, k));
      }
      l = metric.squared_length<Gmpq>(f, k);
    }
  }
}

TEST(Input_metric, of_lengths_needs_no_points) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const Gluing_map map(s.gluing);
    const Input_metric metric =
        Input_metric::from_squared_lengths(map, gallery::squared_lengths(s), 0);
    EXPECT_FALSE(metric.is_embedded());
    for (std::uint32_t f = 0; f < map.number_of_faces(); ++f)
      for (unsigned k = 0; k < 3; ++k)
        EXPECT_EQ(metric.squared_length<double>(f, k), s.squared_length_of_side[3 * f + k]) << s;
  }
}

TEST(Input_metric, finds_a_side_by_the_names_from_it_on) {
  const meshes::Mesh m{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const Input_metric metric = Input_metric::from_points(m.map(), m.points, 0);
  const auto [a, b, c] = metric.sides(0);
  EXPECT_EQ(metric.slot(0, {a, b, c}), 0U);
  EXPECT_EQ(metric.slot(0, {b, c, a}), 1U);
  EXPECT_EQ(metric.slot(0, {c, a, b}), 2U);
  EXPECT_EQ(metric.slot(0, {a, c, b}), std::nullopt) << "turned around";
}

TEST(Input_metric, squared_area_of_a_3_4_5_triangle_is_24_squared) {
  const meshes::Mesh m{{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}, {{0, 1, 2}}};
  const Input_metric metric = Input_metric::from_points(m.map(), m.points, 0);
  EXPECT_EQ(metric.squared_quadruple_area<Gmpq>(0), 24 * 24);
}

TEST(Input_metric, delta_is_added_to_every_squared_length_exactly) {
  const meshes::Mesh m{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  Input_metric metric = Input_metric::from_points(m.map(), m.points, 0);
  EXPECT_EQ(metric.squared_quadruple_area<Gmpq>(0), 0);
  metric.set_delta(0x1p-60);
  EXPECT_EQ(metric.squared_length<Gmpq>(0, 0), Gmpq(1) + Gmpq(0x1p-60));
  EXPECT_EQ(metric.squared_length<Gmpq>(0, 2), Gmpq(4) + Gmpq(0x1p-60));
  // 2 delta (1 + 1 + 4) + 3 delta^2
  EXPECT_EQ(metric.squared_quadruple_area<Gmpq>(0),
            Gmpq(12) * Gmpq(0x1p-60) + Gmpq(3) * Gmpq(0x1p-120));
}

TEST(Input_metric, is_restored_from_its_accessors) {
  const meshes::Mesh m = meshes::box(1, 2, 3);
  Input_metric a = Input_metric::from_points(m.map(), m.points, 5);
  a.set_delta(0.25);
  std::vector<Input_metric::Sides> sides;
  for (std::uint32_t f = 0; f < a.number_of_faces(); ++f) sides.push_back(a.sides(f));
  const Input_metric b(a.points(), a.squared_lengths(), sides, a.delta(), a.scale_exponent());
  EXPECT_EQ(b.scale_exponent(), 5);
  for (std::uint32_t f = 0; f < a.number_of_faces(); ++f)
    for (unsigned k = 0; k < 3; ++k)
      EXPECT_EQ(a.squared_length<double>(f, k), b.squared_length<double>(f, k));
}

} // namespace

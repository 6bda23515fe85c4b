// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include "operator_test_meshes.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

// Maps of surfaces of several disks: each one is mapped as if it were alone, and they lie beside
// each other.

namespace {

using namespace operator_test;
using Map = Eigen::MatrixX2d;

Shape scaled(Shape s, double factor) {
  for (auto& p : s.points)
    for (double& x : p) x *= factor;
  return s;
}

// Disks of different sizes, and an isolated vertex between them.
struct Disks {
  std::vector<Shape> parts{rough_grid(6, 0.3, 0.5, 1), scaled(grid(3), 0.5), grid(1)};
  Shape all;

  Disks() {
    all = parts[0];
    all.points.push_back({90, 0, 0});
    for (std::size_t i = 1; i < parts.size(); ++i)
      all = beside(all, parts[i], 20 * static_cast<double>(i));
  }
  Eigen::Index size(std::size_t i) const {
    return static_cast<Eigen::Index>(parts[i].points.size());
  }
  Eigen::Index first(std::size_t i) const { // row
    Eigen::Index row = i == 0 ? 0 : 1;
    for (std::size_t j = 0; j < i; ++j) row += size(j);
    return row;
  }
};

// The rows of a part are those of its own map, scaled and moved.
void expect_scaled_and_moved(const Map& part, const Map& rows, double factor, double error) {
  const Map move = rows - factor * part;
  EXPECT_LE((move.rowwise() - move.row(0)).cwiseAbs().maxCoeff(), error);
}

} // namespace

TEST(Maps_of_several_disks, are_those_of_each_one) {
  const Disks d;
  const Exact all(d.all.input());
  double largest = 0;
  for (const Shape& s : d.parts) largest = std::max(largest, IT::total_area(Exact(s.input())));
  const Map harmonic = IT::harmonic_map(all), lscm = IT::least_squares_conformal_map(all),
            spectral = IT::spectral_conformal_map(all);
  for (std::size_t i = 0; i < d.parts.size(); ++i) {
    const Exact t(d.parts[i].input());
    const auto rows = [&](const Map& uv) { return Map(uv.middleRows(d.first(i), d.size(i))); };
    const double radius = std::sqrt(IT::total_area(t) / largest);
    expect_scaled_and_moved(IT::harmonic_map(t), rows(harmonic), radius, 1e-12);
    expect_scaled_and_moved(IT::least_squares_conformal_map(t), rows(lscm), 1, 1e-9);
    expect_scaled_and_moved(IT::spectral_conformal_map(t), rows(spectral), 1, 1e-6);
  }
  for (const Map& uv : {harmonic, lscm, spectral}) {
    EXPECT_EQ(uv.row(d.size(0)).norm(), 0); // the isolated vertex
    EXPECT_TRUE(IT::certify_map(all, uv).is_injective());
    EXPECT_TRUE(IT::certify_map(d.all.triangles, uv).is_injective());
  }
}

TEST(Maps_of_several_disks, are_certified_only_beside_each_other) {
  const Disks d;
  const Exact t(d.all.input());
  Map uv = IT::harmonic_map(t);
  const auto second = uv.middleRows(d.first(1), d.size(1));
  const Eigen::RowVector2d move = uv.row(0) - second.row(0);
  uv.middleRows(d.first(1), d.size(1)).rowwise() += move;
  for (const IT::Map_certificate& c :
       {IT::certify_map(t, uv), IT::certify_map(d.all.triangles, uv)}) {
    EXPECT_TRUE(c.is_locally_injective());
    EXPECT_FALSE(c.border_is_simple);
  }
  // a strip that closes to a ring has two borders
  std::vector<std::array<std::uint32_t, 3>> triangles = grid(1).triangles;
  for (std::uint32_t i = 0; i < 4; ++i) {
    triangles.push_back({4 + i, 4 + (i + 1) % 4, 8 + i});
    triangles.push_back({4 + (i + 1) % 4, 8 + (i + 1) % 4, 8 + i});
  }
  EXPECT_FALSE(IT::certify_map(triangles, Map::Zero(12, 2)).border_is_simple);
}

TEST(Maps_of_several_disks, go_to_polygons_and_are_refined_until_they_are_injective) {
  const Shape s = beside(rough_grid(5, 0.3, 0.5, 2), grid(4), 20);
  Exact t(s.input());
  const IT::Border_map border = IT::polygonal_border(t, {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_EQ(border.rows.size(), 20U + 16U);
  const IT::Injective_map map = IT::injective_harmonic_map(t, border);
  EXPECT_EQ(map.status, IT::Status::done);
  EXPECT_TRUE(map.certificate.is_injective());
  for (std::size_t i = 0; i < border.rows.size(); ++i)
    EXPECT_EQ(map.uv.row(border.rows[i]), border.positions.row(static_cast<Eigen::Index>(i)));
}

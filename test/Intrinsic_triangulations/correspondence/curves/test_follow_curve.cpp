// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>

#include "meshes.h"
#include "subdivision_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;

// What each curve across a halfedge ends in, found alone and in company; any part of the curves may
// be requested.
void expect_same_ends(const Exact& t, std::size_t& curves) {
  const IT::Intrinsic_view<Exact> view(t);
  const auto& c = t.correspondence();
  std::vector<IT::Curve_bundle> stack;
  for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); ++h) {
    if (view.is_border(h ^ 1U)) continue; // nothing to enter
    const IT::Normal_coordinate n = IT::crossings(c.normal_coordinate(h / 2));
    const IT::Normal_coordinate first = n / 3, count = n - first;
    std::vector<int> visits(static_cast<std::size_t>(count), 0);
    IT::follow_curves(view, c, {h, first, count, 0}, stack,
                      [&](IT::Normal_coordinate i, const IT::Curve_end& end) {
                        const IT::Curve_end alone = IT::follow_curve(
                            view, c, IT::Curve_crossing{h, first + i}, [](const auto&) {});
                        EXPECT_EQ(end.halfedge, alone.halfedge);
                        EXPECT_EQ(end.index, alone.index);
                        ++visits[static_cast<std::size_t>(i)];
                      });
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), count);
    curves += visits.size();
  }
}

TEST(Follow_curves, ends_where_each_curve_ends_alone) {
  for (const meshes::Mesh& m : {meshes::box(2, 2, 2), meshes::rough_grid(5, 1),
                                meshes::potato(2, 2), meshes::sheared_grid(6, 6, 9)}) {
    Exact t(m.input());
    std::mt19937 random(1);
    std::size_t curves = 0;
    for (int round = 0; round < 4; ++round) {
      for (int i = 0; i < 100; ++i)
        t.flip_edge({static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())});
      expect_same_ends(t, curves);
    }
    EXPECT_GT(curves, 100U);
  }
}

TEST(Follow_curves, does_nothing_without_curves) {
  const Exact t(meshes::grid(1, 1).input());
  const IT::Intrinsic_view<Exact> view(t);
  std::vector<IT::Curve_bundle> stack;
  IT::follow_curves(view, t.correspondence(), {0, 0, 0, 0}, stack,
                    [](IT::Normal_coordinate, const IT::Curve_end&) { FAIL(); });
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/metric/Tolerant_traits.h>

#include "meshes.h"
#include "properties.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <ratio>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

template <class Tolerance, class FT = double>
using Triangulation =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Tolerant_traits<FT, Tolerance>>;

static_assert(IT::IntrinsicTriangulationTraits<IT::Tolerant_traits<double, std::micro>>);
static_assert(IT::IntrinsicTriangulationTraits<IT::Tolerant_traits<long double, std::pico>>);
// Every tolerance is a type, which takes seconds to compile: few are tested, on many meshes.
using Quarter = std::ratio<1, 4>;
static_assert(!Triangulation<Quarter>::Metric::is_exact);

// The edge from (-1, 0) to (1, 0) with the corners (0, 1) and (0, -b) opposite: cot k = 0 and
// cot m = (b^2 - 1) / (2 b), which for b = (sqrt(17) - 1) / 4 = 0.780776 is -1/4.
meshes::Mesh nearly_cocircular(double b) {
  return {{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -b, 0}}, {{0, 1, 2}, {1, 0, 3}}};
}
const meshes::Mesh tolerated = nearly_cocircular(0.78078), beyond = nearly_cocircular(0.78077);

template <class Tolerance>
std::uint64_t flips_of(const meshes::Mesh& m) {
  Triangulation<Tolerance> t(m.input());
  const IT::Flip_to_delaunay_result r = IT::flip_to_delaunay(t);
  EXPECT_EQ(r.status, IT::Status::done);
  EXPECT_TRUE(IT::is_delaunay(t));
  EXPECT_EQ(IT::check_delaunay(t).non_delaunay_edges, 1 - r.flips);
  return r.flips;
}

TEST(Tolerant_traits, tolerate_a_sum_of_cotangents_above_minus_the_tolerance_and_no_other) {
  EXPECT_EQ(flips_of<Quarter>(nearly_cocircular(1 - 0x1p-10)), 0U);
  EXPECT_EQ(flips_of<Quarter>(tolerated), 0U);
  EXPECT_EQ(flips_of<Quarter>(beyond), 1U);
  EXPECT_EQ(flips_of<std::pico>(tolerated), 1U);
  EXPECT_EQ(flips_of<std::pico>(nearly_cocircular(1 - 0x1p-10)), 1U);
}

TEST(Tolerant_traits, decide_alike_at_every_scale) {
  for (const double scale : {0x1p-100, 1e-3, 3.0, 0x1p100}) {
    EXPECT_EQ(flips_of<Quarter>(meshes::scaled(tolerated, scale)), 0U) << scale;
    EXPECT_EQ(flips_of<Quarter>(meshes::scaled(beyond, scale)), 1U) << scale;
  }
}

TEST(Tolerant_traits, leave_no_edge_beyond_the_tolerance) {
  Triangulation<Quarter> t(meshes::rough_grid(12, 3).input());
  IT::flip_to_delaunay(t);
  double least = 0;
  for (const auto h : properties::flippable_by_connectivity(t))
    least = std::min(least, 2 * t.metric().cotangent_weight(t.diamond(h)));
  EXPECT_GE(least, -0.25 - 1e-12); // weights of ordinary faces are good to 1e-14
  EXPECT_LT(least, -0.01);         // and the tolerance is made use of
}

TEST(Tolerant_traits, agree_with_exact_ones_away_from_ties) {
  for (const meshes::Mesh& m : {meshes::rough_grid(8, 1), meshes::potato(3, 2)}) {
    Triangulation<std::pico> t(m.input());
    IT::Intrinsic_triangulation<> expected(m.input());
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, IT::flip_to_delaunay(expected).flips);
    properties::expect_same_tessellation(properties::tessellation(t),
                                         properties::tessellation(expected), 1e-10);
  }
}

TEST(Tolerant_traits, do_not_tolerate_caps) {
  // the cotangent in a face without area is infinite
  Triangulation<std::ratio<1000>> t(meshes::with_cap(meshes::box(2, 1, 1), 4).input());
  EXPECT_EQ(IT::flip_to_delaunay(t).flips, 1U);
  for (std::uint32_t f = 0; f < num_faces(t.mesh()); ++f) EXPECT_FALSE(t.metric().is_degenerate(f));
}

TEST(Tolerant_traits, count_checks) {
  Triangulation<Quarter> t(meshes::rough_grid(4, 1).input());
  const IT::Flip_to_delaunay_result r = IT::flip_to_delaunay(t);
  EXPECT_GT(r.checks, 0U);
  EXPECT_LE(t.metric().statistics().checks, r.checks); // those on the border need no predicate
}

} // namespace

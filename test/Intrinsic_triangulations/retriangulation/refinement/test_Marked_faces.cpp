// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/adaptive_refine.h>

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Positions = std::vector<std::size_t>;
using Triangulation = IT::Intrinsic_triangulation<>;

TEST(Mark_bulk, takes_the_largest_numbers_until_their_squares_reach_the_share) {
  const std::vector<double> x{1, 3, 0, 2, 1}; // squares 1, 9, 0, 4, 1: 15 in all
  EXPECT_EQ(IT::internal::mark_bulk(x, 0.6), (Positions{1}));
  EXPECT_EQ(IT::internal::mark_bulk(x, 0.61), (Positions{1, 3}));
  EXPECT_EQ(IT::internal::mark_bulk(x, 13. / 15), (Positions{1, 3}));
  EXPECT_EQ(IT::internal::mark_bulk(x, 0.9), (Positions{1, 3, 0}));
  EXPECT_EQ(IT::internal::mark_bulk(x, 1), (Positions{1, 3, 0, 4}));
}

TEST(Mark_bulk, takes_nothing_where_all_is_zero) {
  EXPECT_TRUE(IT::internal::mark_bulk({}, 0.5).empty());
  EXPECT_TRUE(IT::internal::mark_bulk({0, 0, 0}, 1).empty());
}

TEST(Mark_bulk, takes_no_more_than_any_other_set_needs) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> x(10);
    for (double& y : x) y = static_cast<double>(random() % 100);
    double all = 0;
    for (const double y : x) all += y * y; // integers: exact
    const double share = (1 + static_cast<double>(random() % 999)) / 1000;
    std::size_t fewest = x.size();
    for (unsigned set = 0; set < 1U << x.size(); ++set) {
      double sum = 0;
      std::size_t n = 0;
      for (std::size_t i = 0; i < x.size(); ++i)
        if ((set >> i & 1U) != 0) {
          sum += x[i] * x[i];
          ++n;
        }
      if (sum >= share * all) fewest = std::min(fewest, n);
    }
    EXPECT_EQ(IT::internal::mark_bulk(x, share).size(), fewest) << "trial " << trial;
  }
}

TEST(Mark_bulk, refuses_shares_and_numbers_that_make_no_sense) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double share : {0., -1., 1.01, nan})
    EXPECT_THROW(IT::internal::mark_bulk({1}, share), std::invalid_argument);
  for (const double x : {-1., nan, std::numeric_limits<double>::infinity()})
    EXPECT_THROW(IT::internal::mark_bulk({1, x}, 0.5), std::invalid_argument);
}

TEST(Marked_faces, are_bad_and_others_are_not) {
  Triangulation t(meshes::rough_grid(5, 3).input());
  IT::internal::Marked_faces<Triangulation> marked(t, {7, 11});
  for (const auto f : faces(t.mesh()))
    EXPECT_EQ(marked.is_bad(t, f), t.index(f) == 7 || t.index(f) == 11);
}

TEST(Marked_faces, are_gone_after_refinement_of_every_delta_complex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Triangulation t(gallery::input(s));
    IT::delaunay_refine(t);
    const std::size_t before = num_vertices(t.mesh());
    IT::internal::Marked_faces<Triangulation> marked(t, {t.index(*faces(t.mesh()).begin())});
    const auto result = IT::delaunay_refine(t, IT::parameters::visitor(std::ref(marked)));
    EXPECT_EQ(result.status, IT::Status::done);
    EXPECT_GT(num_vertices(t.mesh()), before);
    for (const auto f : faces(t.mesh())) EXPECT_FALSE(marked.is_bad(t, f));
  }
}

TEST(Marked_faces, ask_for_little_more_than_a_vertex_each) {
  Triangulation t(meshes::sphere(3).input());
  IT::delaunay_refine(t);
  Positions all;
  for (const auto f : faces(t.mesh())) all.push_back(t.index(f));
  const std::size_t before = num_vertices(t.mesh());
  IT::internal::Marked_faces<Triangulation> marked(t, all);
  IT::delaunay_refine(t, IT::parameters::visitor(std::ref(marked)));
  const std::size_t inserted = num_vertices(t.mesh()) - before;
  // an insertion destroys at least the face itself
  EXPECT_LE(inserted, all.size() + all.size() / 4);
  EXPECT_GE(inserted, all.size() / 8);
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::Flip_history;
using Side = Flip_history::Side;

bool is(Side s, std::uint32_t version, std::uint32_t slot) {
  return s.face == version && s.slot == slot;
}

TEST(Flip_history, numbers_the_versions_of_faces) {
  Flip_history history(4);
  EXPECT_EQ(history.record_flip({0, 1}, {2, 0}), 4U);
  EXPECT_EQ(history.record_flip({4, 1}, {1, 2}), 6U);
  EXPECT_EQ(history.number_of_flips(), 2U);
  EXPECT_TRUE(history.is_input(3));
  EXPECT_FALSE(history.is_input(4));
  EXPECT_EQ(history.flip_of(5), 0U);
  EXPECT_EQ(history.flip_of(6), 1U);
  EXPECT_EQ(history.left_version(1), 6U);
  EXPECT_TRUE(is(history.left_parent(1), 4, 1));
  EXPECT_TRUE(is(history.right_parent(1), 1, 2));
}

TEST(Flip_history, finds_where_sides_were_made) {
  Flip_history history(2);
  history.record_flip({0, 0}, {1, 0}); // faces km, mj, jk and mk, ki, im
  EXPECT_TRUE(is(history.origin({0, 2}), 0, 2));
  EXPECT_TRUE(is(history.origin({2, 0}), 2, 0));
  EXPECT_TRUE(is(history.origin({2, 1}), 1, 2)); // mj
  EXPECT_TRUE(is(history.origin({2, 2}), 0, 1)); // jk
  EXPECT_TRUE(is(history.origin({3, 1}), 0, 2)); // ki
  EXPECT_TRUE(is(history.origin({3, 2}), 1, 1)); // im
  history.record_flip({2, 0}, {3, 0});
  EXPECT_TRUE(is(history.origin({4, 1}), 1, 1)); // im is mj of the diamond of km
  EXPECT_TRUE(is(history.origin({4, 2}), 1, 2));
}

TEST(Flip_history, lists_ancestors_before_descendants_and_leaves_out_what_is_known) {
  Flip_history history(6);
  history.record_flip({0, 0}, {1, 0}); // 6, 7
  history.record_flip({2, 0}, {3, 0}); // 8, 9
  history.record_flip({4, 0}, {5, 0}); // 10, 11
  history.record_flip({6, 1}, {8, 1}); // 12, 13
  const auto none = [](std::uint32_t) { return false; };
  EXPECT_EQ(history.ancestors(12, 7, none), (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(history.ancestors(1, 2, none), std::vector<std::uint32_t>{});
  EXPECT_EQ(history.ancestors(12, 11, [](std::uint32_t n) { return n < 2; }),
            (std::vector<std::uint32_t>{2, 3}));
  EXPECT_EQ(history.ancestors({12, 7}, none, 3), (std::vector<std::uint32_t>{0, 1, 3}));
  EXPECT_EQ(history.ancestors({12, 7}, none, 2).size(), 3U) << "one more says that there are more";
  EXPECT_EQ(history.ancestors({12, 7}, none, 0).size(), 1U);
}

TEST(Flip_history, lists_a_million_ancestors_without_recursion) {
  Flip_history history(2);
  std::uint32_t v = 0;
  history.record_flip({0, 0}, {1, 0});
  for (std::uint32_t n = 0; n < 1000000; ++n) {
    v = history.left_version(n);
    history.record_flip({v, 0}, {v + 1, 0});
  }
  EXPECT_EQ(history.ancestors(v, v + 1, [](std::uint32_t) { return false; }).size(), 1000000U);
}

} // namespace

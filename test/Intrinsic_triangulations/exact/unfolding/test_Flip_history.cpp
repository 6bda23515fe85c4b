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
}

TEST(Flip_history, numbers_what_vertex_moves_make_and_finds_where_sides_were_made) {
  using Kind = Flip_history::Vertex_move::Kind;
  Flip_history history(2);
  // ij is side 1 of face 0: ijp, jkp, kip are 2, 3, 4
  EXPECT_EQ(history.record_vertex_move(Kind::insert_in_face, {Side{0, 1}}, {0.25, 0.25, 0.5}), 2U);
  EXPECT_EQ(history.number_of_nodes(), 2U);
  for (std::uint32_t k = 0; k < 3; ++k) {
    EXPECT_EQ(history.node_of(2 + k), 0U);
    EXPECT_TRUE(is(history.origin({2 + k, 0}), 0, (1 + k) % 3));
    EXPECT_TRUE(is(history.origin({2 + k, 1}), 2 + k, 1));
    EXPECT_EQ(history.made_length({2 + k, 1}), (k + 1) % 3); // jp, kp, ip
    EXPECT_EQ(history.made_length({2 + k, 2}), k);           // pi, pj, pk
  }
  EXPECT_EQ(history.record_flip({2, 0}, {1, 0}), 6U);
  // on side 0 of face 1, as if on the border: ipk, pjk are 8, 9
  EXPECT_EQ(history.record_vertex_move(Kind::insert_in_border_edge, {Side{1, 0}}), 8U);
  EXPECT_TRUE(is(history.origin({8, 2}), 1, 2));
  EXPECT_TRUE(is(history.origin({9, 1}), 1, 1));
  EXPECT_EQ(history.made_length({8, 0}), 0U);
  EXPECT_EQ(history.made_length({9, 0}), 1U);
  EXPECT_EQ(history.made_length({8, 1}), 2U);
  EXPECT_EQ(history.made_length({9, 2}), 2U);
  EXPECT_EQ(history.record_vertex_move(Kind::remove_from_border_edge, {Side{8, 1}, Side{9, 2}}),
            10U);
  EXPECT_TRUE(is(history.origin({10, 0}), 10, 0));
  EXPECT_TRUE(is(history.origin({10, 1}), 1, 1));
  EXPECT_TRUE(is(history.origin({10, 2}), 1, 2));
  EXPECT_EQ(
      history.record_vertex_move(Kind::remove_from_face, {Side{2, 0}, Side{3, 0}, Side{4, 0}}),
      12U);
  for (std::uint32_t k = 0; k < 3; ++k) EXPECT_TRUE(is(history.origin({12, k}), 0, (1 + k) % 3));
  EXPECT_EQ(history.number_of_vertex_moves(), 4U);
  EXPECT_EQ(history.number_of_flips(), 1U);
  const auto none = [](std::uint32_t) { return false; };
  EXPECT_EQ(history.ancestors(12, 10, none), (std::vector<std::uint32_t>{0, 3, 4, 5}));
  EXPECT_EQ(history.ancestors(6, 4, none), (std::vector<std::uint32_t>{0, 2}));
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

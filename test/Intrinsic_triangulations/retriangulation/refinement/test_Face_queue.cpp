// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_test.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace {

using CGAL::Intrinsic_triangulations::Face_queue;

std::vector<std::uint32_t> emptied(Face_queue& q) {
  std::vector<std::uint32_t> order;
  while (!q.empty()) order.push_back(q.pop());
  return order;
}

TEST(Face_queue, Gives_the_highest_priority_then_the_first_come) {
  Face_queue q;
  EXPECT_TRUE(q.empty());
  q.push(7, 1);
  q.push(3, 2);
  q.push(5, 1);
  EXPECT_EQ(emptied(q), (std::vector<std::uint32_t>{3, 7, 5}));
}

TEST(Face_queue, Keeps_the_last_priority_of_a_face) {
  Face_queue q;
  q.push(1, 5);
  q.push(2, 4);
  q.push(1, 3);
  q.push(3, 9);
  q.remove(3);
  q.remove(3);
  q.remove(99);
  EXPECT_EQ(emptied(q), (std::vector<std::uint32_t>{2, 1}));
  q.push(3, 1);
  EXPECT_EQ(emptied(q), (std::vector<std::uint32_t>{3}));
}

TEST(Face_queue, Marks_a_face_once) {
  Face_queue q;
  EXPECT_TRUE(q.begin_check(4));
  EXPECT_FALSE(q.begin_check(4));
  q.end_check(4);
  EXPECT_TRUE(q.begin_check(4));
  EXPECT_TRUE(q.empty());
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>

#include "gallery.h"
#include "subdivision_oracle.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using subdivision_oracle::Exact;

IT::Input surface(const gallery::Surface& s) { return Exact(gallery::input(s)).input(); }

TEST(Vertex_fans, Give_every_halfedge_a_slot_of_its_own) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const IT::Input input = surface(s);
    const IT::Vertex_fans fans(input);
    std::set<std::uint32_t> slots;
    for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) {
      EXPECT_EQ(fans.halfedge(fans.slot(h)), h) << s;
      slots.insert(fans.slot(h));
    }
    EXPECT_EQ(slots.size(), input.number_of_halfedges()) << s;
  }
}

TEST(Vertex_fans, Advance_counterclockwise_around_the_vertex) {
  for (const gallery::Surface& s : gallery::oriented()) {
    const IT::Input input = surface(s);
    const IT::Vertex_fans fans(input);
    for (std::uint32_t h = 0; h < input.number_of_halfedges(); ++h) {
      EXPECT_EQ(fans.advance(fans.slot(h), 0), fans.slot(h)) << s;
      std::uint32_t next = h;
      if (input.is_border(h)) // back to the other end of the fan
        while (!input.is_border(next ^ 1U)) next = input.next(next ^ 1U);
      else
        next = input.next(input.next(h)) ^ 1U;
      EXPECT_EQ(fans.halfedge(fans.advance(fans.slot(h), 1)), next) << s << ' ' << h;
      EXPECT_EQ(input.source(next), input.source(h)) << s;
    }
  }
}

TEST(Vertex_fans, Tell_the_distance_that_advancing_takes) {
  const IT::Input input = surface(gallery::two_tetrahedra_sharing_a_vertex());
  const IT::Vertex_fans fans(input);
  for (std::uint32_t a = 0; a < input.number_of_halfedges(); ++a)
    for (std::uint32_t b = 0; b < input.number_of_halfedges(); ++b) {
      const std::uint32_t d = fans.distance(fans.slot(a), fans.slot(b));
      if (input.source(a) != input.source(b)) {
        EXPECT_EQ(d, IT::Gluing::none);
      } else if (d != IT::Gluing::none) { // the vertex of both has two fans
        EXPECT_EQ(fans.advance(fans.slot(a), d), fans.slot(b));
      }
    }
}

TEST(Vertex_fans, Use_the_slots_of_removed_fans_again) {
  const IT::Input input = surface(gallery::tetrahedron());
  IT::Vertex_fans fans(input);
  const std::uint32_t a = fans.add_fan_on_edge(3), b = fans.add_fan_on_edge(4);
  EXPECT_EQ(fans.halfedge(a), 3U);
  EXPECT_EQ(fans.halfedge(a + 1), 2U);
  EXPECT_EQ(fans.advance(a, 1), a + 1);
  EXPECT_EQ(fans.advance(a + 1, 1), a);
  EXPECT_EQ(fans.distance(a, b), IT::Gluing::none);
  fans.remove_fan(a + 1); // of either slot
  EXPECT_EQ(fans.add_fan_on_edge(7), a);
  EXPECT_EQ(fans.halfedge(a), 7U);
  EXPECT_EQ(fans.halfedge(a + 1), 6U);
  EXPECT_EQ(fans.halfedge(b), 4U);
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turn_products.h>

#include "gallery.h"
#include "meshes.h"
#include "subdivision_oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
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

// The triangle of a halfedge, from it on.
IT::Face_values<double> face_at(const IT::Input& input, std::uint32_t h) {
  const auto& points = input.metric().points();
  const auto squared_length = [&](std::uint32_t g) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double x = points[input.target(g)][c] - points[input.source(g)][c];
      sum += x * x;
    }
    return sum;
  };
  const std::uint32_t n = input.next(h), l = input.next(n);
  const double a = squared_length(h), b = squared_length(n), c = squared_length(l), p = a + c - b;
  return {{a, b, c}, std::sqrt(4 * a * c - p * p)};
}

// A tip with n triangles, which are all different.
meshes::Mesh cone(std::uint32_t n) {
  meshes::Mesh m;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double angle = 6.28 * i / n, r = 1 + 0.3 * std::sin(5.1 * i);
    m.points.push_back({r * std::cos(angle), r * std::sin(angle), 0.2 * std::cos(2.3 * i)});
    m.triangles.push_back({i, (i + 1) % n, n});
  }
  m.points.push_back({0.1, 0.05, 3});
  return m;
}

TEST(Turn_products, do_not_depend_on_earlier_ones) {
  using Turn = std::complex<double>;
  const meshes::Mesh m = cone(37);
  const IT::Input input = Exact(m.input()).input();
  const IT::Vertex_fans fans(input);
  const auto values = [&](std::uint32_t h) { return face_at(input, h); };
  std::uint32_t first = 0; // at the tip
  while (fans.degree(fans.slot(first)) < 37) ++first;
  IT::Turn_products<double> used;
  for (const std::uint32_t count : {36U, 37U, 5U, 17U, 90U, 1U})
    for (std::uint32_t n = 0; n < 37; n += 3) {
      const std::uint32_t slot = fans.advance(fans.slot(first), n);
      IT::Turn_products<double> fresh;
      const auto x = fresh(input, fans, values, slot, count),
                 y = used(input, fans, values, slot, count);
      EXPECT_EQ(x.x, y.x);
      EXPECT_EQ(x.y, y.y);
      double angle = 0, size = 1;
      for (std::uint32_t i = 0; i < count; ++i) {
        const auto f = values(fans.halfedge(fans.advance(slot, i)));
        const auto& l = f.squared_lengths;
        angle += std::atan2(f.quadruple_area, l[0] + l[2] - l[1]);
        size *= std::sqrt(l[2] / l[0]);
      }
      EXPECT_LT(std::abs(Turn(y.x, y.y) - std::polar(size, angle)), 1e-12 * size);
    }
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/deciding/Euclidean_decider.h>

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Mover.h>

#include "gallery.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<>;
using Counted = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                            IT::Integer_coordinates>;

// two facing chains on parabolas, triangulated as badly as can be: quadratically many flips
meshes::Mesh two_parabolas(std::uint32_t n, double slope) {
  meshes::Mesh m;
  const double half = n / 2.0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double x = i - half;
    m.points.push_back({x, 0.1 * x * x / n, 0});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const double x = i - half, y = 0.5 * n - 0.1 * x * x / n;
    m.points.push_back({x + 0.25, y, slope * y});
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) {
    m.triangles.push_back({i, i + 1, n});
    m.triangles.push_back({n - 1, n + i + 1, n + i});
  }
  return m;
}

std::size_t multi_precision(const IT::Predicate_statistics& s) {
  std::size_t n = 0;
  for (const auto& [bits, count] : s.escalations)
    if (bits > 106) n += count;
  return n;
}

TEST(Euclidean_decider,
     find_flat_parts_so_that_quadratically_many_flips_need_no_more_than_doubles) {
  for (const double slope : {0.0, 0.5}) {
    Exact t(two_parabolas(100, slope).input());
    Counted u(two_parabolas(100, slope).input());
    const auto r = IT::flip_to_delaunay(t), s = IT::flip_to_delaunay(u);
    EXPECT_GT(r.flips, 4000U);
    EXPECT_EQ(r.flips, s.flips);
    EXPECT_EQ(multi_precision(t.metric().statistics()), 0U);
    EXPECT_EQ(multi_precision(u.metric().statistics()), 0U);
  }
}

std::size_t long_sharpenings(const IT::Predicate_statistics& s) {
  std::size_t n = 0;
  for (const auto& [bits, count] : s.sharpenings)
    if (bits > 106) n += count;
  return n;
}

// All faces together lie over eight triangles per flip, so that flips are repeated first; errors of
// a hundred flips in a row exceed 106 bits.
TEST(Euclidean_decider, unfold_faces_where_errors_of_repeated_flips_exceed_106_bits) {
  Exact t(two_parabolas(100, 0.5).input());
  Counted u(two_parabolas(100, 0.5).input());
  const auto check = [](auto& x) {
    IT::flip_to_delaunay(x);
    const typename std::decay_t<decltype(x)>::Metric::Scope scope;
    std::vector<IT::Indexed_face> all;
    for (const auto f : faces(x.mesh())) {
      const auto h = halfedge(f, x.mesh()), n = next(h, x.mesh()), l = next(n, x.mesh());
      all.push_back({x.index(f), {h.index / 2, n.index / 2, l.index / 2}});
    }
    x.decider().sharpen(all);
    for (const IT::Indexed_face& f : all) EXPECT_TRUE(x.metric().is_narrow(f));
    const IT::Predicate_statistics& s = x.metric().statistics();
    EXPECT_GT(s.sharpenings.at(106), all.size()); // once by flips, then by unfolding
    EXPECT_EQ(long_sharpenings(s), 0U);
  };
  check(t);
  check(u);
}

// Cotangents near 1e7 cancel: the double nearest to their sum takes 256 bits.
TEST(Euclidean_decider, take_no_more_than_106_bits_for_weights_in_statistics) {
  meshes::Mesh m = meshes::potato(2, 1);
  for (auto& p : m.points) p[0] *= 1e7;
  Exact t(m.input());
  IT::flip_to_delaunay(t);
  const Exact::Const_session session(t);
  std::vector<double> rough;
  for (const auto e : edges(t.mesh()))
    rough.push_back(session.cotangent_weight(e, IT::statistics_tolerance));
  EXPECT_EQ(long_sharpenings(t.metric().statistics()), 0U);
  std::size_t i = 0;
  for (const auto e : edges(t.mesh()))
    EXPECT_NEAR(rough[i++] / session.cotangent_weight(e), 1, IT::statistics_tolerance);
  EXPECT_GT(long_sharpenings(t.metric().statistics()), 0U);
}

// Two long sides of a beam, each a fan of needles from one end of the edge between them.
meshes::Mesh beam(std::uint32_t n) {
  meshes::Mesh m;
  for (std::uint32_t i = 0; i <= n; ++i) m.points.push_back({.1 * i, .5, 0});
  for (std::uint32_t i = 0; i <= n; ++i) m.points.push_back({.1 * i, -.3, .4});
  const std::uint32_t first = 2 * n + 2, last = first + 1;
  m.points.insert(m.points.end(), {{0, 0, 0}, {.1 * n, 0, 0}});
  m.triangles = {{first, last, 0}, {first, n + 1, last}};
  for (std::uint32_t i = 0; i < n; ++i) {
    m.triangles.push_back({last, i + 1, i});
    m.triangles.push_back({last, n + 1 + i, n + 2 + i});
  }
  return m;
}

// Faces cross hundreds of needles, and a third of them have wide intervals after refinement. Against
// values from the input alone, in 512 bits.
TEST(Euclidean_decider, unfold_few_faces_over_needles_for_statistics_after_refinement) {
  Counted t(beam(200).input());
  IT::flip_to_delaunay(t);
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  auto& sharpenings = t.metric().statistics().sharpenings;
  const auto before = sharpenings[53], known = sharpenings[106];
  IT::measure_quality(t);
  EXPECT_LT(sharpenings[53] - before, 50U);
  EXPECT_GT(sharpenings[106] - known, 200U);

  const Counted::Metric::Scope scope;
  const IT::Intrinsic_view<Counted> view(t);
  IT::Diamond_unfolder unfolder;
  IT::Exact_ladder ladder;
  for (const auto f : faces(t.mesh())) {
    const std::uint32_t h = halfedge(f, t.mesh()).index, n = view.next(h);
    const IT::Indexed_face face{t.index(f), {h / 2, n / 2, view.next(n) / 2}};
    const IT::Unfolded_faces one{{unfolder.face(view, t.correspondence(), h)}};
    const auto exact = ladder.enclosures(t.input().metric(), one, 512).front(),
               stored = t.metric().enclosure(face);
    EXPECT_TRUE(t.metric().is_narrow(face, IT::statistics_tolerance));
    EXPECT_TRUE(stored.quadruple_area.do_overlap(exact.quadruple_area));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_TRUE(stored.squared_lengths[k].do_overlap(exact.squared_lengths[k]));
  }
}

// flips edges that can be, at random
template <class T>
void flip_at_random(T& t, std::mt19937& random, std::size_t tries) {
  typename T::Session session(t);
  for (std::size_t i = 0; i < tries; ++i)
    session.flip_edge(typename T::halfedge_descriptor{
        static_cast<std::uint32_t>(random() % t.mesh().number_of_halfedges())});
}

// signs that the metric gives, against those of weights in 512 bits
template <class T>
std::size_t check_signs(const T& t) {
  const typename T::Metric::Scope scope;
  const IT::Intrinsic_view<T> view(t);
  IT::Diamond_unfolder unfolder;
  IT::Exact_ladder ladder;
  IT::Predicate_statistics statistics;
  std::size_t certain = 0;
  for (std::uint32_t h = 0; h < t.mesh().number_of_halfedges(); h += 2) {
    if (view.is_border(h) || view.is_border(h ^ 1U) || view.face(h) == view.face(h ^ 1U)) continue;
    const auto& d = unfolder(view, t.correspondence(), h);
    const std::optional<double> weight =
        ladder.weight(t.input().metric(), d, statistics, 0, 512, 512);
    const auto left = ladder.enclosures(t.input().metric(), IT::Unfolded_faces{{d}}, 512).front(),
               wide = ladder.enclosures(t.input().metric(), IT::Unfolded_faces{{d}}, 53).front();
    // by the strip under the edge alone
    const CGAL::Interval_nt<false> length =
        ladder.squared_length(t.input().metric(), unfolder.strip(view, t.correspondence(), h), 512);
    EXPECT_TRUE(length.do_overlap(left.squared_lengths[0]));
    EXPECT_TRUE(wide.squared_lengths[0].do_overlap(length) &&
                wide.quadruple_area.do_overlap(left.quadruple_area));
    EXPECT_LE(CGAL::width(length), 0x1p-51 * CGAL::magnitude(length));
    const CGAL::Sign s = t.sign(t.diamond({h}), IT::Delaunay_expression());
    EXPECT_EQ(s, weight ? CGAL::sign(*weight) : CGAL::ZERO);
    certain += weight ? 1U : 0U;
  }
  return certain;
}

TEST(Euclidean_decider, decide_as_many_bits_do_after_random_flips_over_flat_and_bent_parts) {
  std::mt19937 random(1);
  meshes::Mesh almost_flat = meshes::grid(3, 3);
  almost_flat.points[5][2] = 0x1p-60;
  for (const meshes::Mesh& m :
       {almost_flat, meshes::box(3, 3, 3), meshes::stairs(3, 3), meshes::l_shape(3),
        meshes::sheared_grid(4, 4, 5), meshes::folded_lattice(3, 4, 1), meshes::rough_grid(4, 3)}) {
    Counted t(m.input());
    std::size_t certain = 0;
    for (int round = 0; round < 6; ++round) {
      flip_at_random(t, random, 60);
      certain += check_signs(t);
    }
    EXPECT_GT(certain, 0U);
  }
}

TEST(Euclidean_decider, repeat_flips_where_normal_coordinates_cannot_count) {
  // each flip of the three edges of a flat torus in turn makes the next edge longer by the golden ratio
  const gallery::Surface s = gallery::one_vertex_torus();
  for (const bool asks_early : {false, true}) {
    Exact t(gallery::input(s));
    for (std::uint32_t i = 0; i < 60; ++i) {
      if (asks_early && i % 7 == 3) {
        EXPECT_GT(t.area({0}), 0);
      }
      Exact::Session session(t);
      EXPECT_EQ(session.flip_convex_edge({2 * (i % 3)}), IT::Move_status::done);
    }
    // the area of each face stays exactly the same
    Exact input(gallery::input(s));
    EXPECT_NEAR(t.area({0}) / input.area({0}), 1, 1e-12);
    EXPECT_NEAR(t.area({1}) / input.area({1}), 1, 1e-12);
    // as all that makes a torus longer can be undone
    IT::flip_to_delaunay(t);
    for (const auto e : edges(t.mesh())) EXPECT_LT(t.length(e), 3 * input.length({0}));
  }
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "properties.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <vector>

// Insertions and removals of vertices with exact traits: vertices are exactly at their places, and these are where they
// were asked for, within rounding.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Gluing_map;
using IT::Move_status;
using Exact =
    IT::Intrinsic_triangulation<Gluing_map, IT::Exact_euclidean_traits, IT::Integer_coordinates>;
using Halfedge = Exact::halfedge_descriptor;
using Vertex = Exact::vertex_descriptor;
using places::Position;

std::vector<Halfedge> halfedges_with_face(const Exact& t) {
  std::vector<Halfedge> result;
  for (const Halfedge h : halfedges(t.mesh()))
    if (face(h, t.mesh()) != boost::graph_traits<Gluing_map>::null_face()) result.push_back(h);
  return result;
}

using Planar = subdivision_oracle::Plane<Exact>;
using subdivision_oracle::Mover;

/// Random flips, insertions in faces, on edges and on the border, removals and repositions.
void move_at_random(Planar& p, Mover<Exact>& mover, int moves) {
  for (int i = 0; i < moves; ++i) {
    mover.is_simple = i % 2 == 0;
    p.t.flip_edge({mover.halfedge(false)});
    mover.move(
        false, [&](std::uint32_t h, const auto& w) { return p.insert(h, w); },
        [&](Vertex v, std::uint32_t h, const auto& w) { return p.reposition(v, h, w); });
  }
  EXPECT_LT(p.deviation, 0x1p-40 * 64); // heights of input faces are less than 64
}

Position at(const Planar& p, Vertex v) { return p.position[p.t.index(v)]; }

IT::Indexed_face indexed_face(const Exact& t, Halfedge h) {
  const Halfedge n = next(h, t.mesh());
  const auto number = [&t](Halfedge x) { return t.index(edge(x, t.mesh())); };
  return {t.index(face(h, t.mesh())), {number(h), number(n), number(next(n, t.mesh()))}};
}

Gmpq power_of_four(int exponent) {
  return exponent < 0 ? Gmpq(1) / power_of_four(-exponent) : Gmpq(std::ldexp(1.0, 2 * exponent));
}

// lengths from h on, then the area
std::array<Gmpq, 4> from_positions(const Planar& p, Halfedge h) {
  const Gmpq scale = power_of_four(p.t.metric().scale_exponent());
  std::array<Position, 3> corners;
  for (Position& c : corners) {
    c = at(p, source(h, p.t.mesh()));
    h = next(h, p.t.mesh());
  }
  const auto difference = [&](std::size_t i, std::size_t j) {
    return Position{corners[j][0] - corners[i][0], corners[j][1] - corners[i][1]};
  };
  std::array<Gmpq, 4> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const Position d = difference(k, (k + 1) % 3);
    result[k] = (d[0] * d[0] + d[1] * d[1]) * scale;
  }
  const Position u = difference(0, 1), v = difference(0, 2);
  result[3] = 2 * (u[0] * v[1] - u[1] * v[0]) * scale;
  return result;
}

std::array<Gmpq, 4> from_unfolding(const Exact& t, Halfedge h) {
  const places::Exact_input input(t.input().metric());
  const auto face = places::Unfolded<Exact>(t).exact(h.index, input);
  std::array<Gmpq, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& x = k < 3 ? face.squared_lengths[k] : face.quadruple_area;
    EXPECT_TRUE(x.is_rational());
    result[k] = x.coefficient(0);
  }
  return result;
}

void expect_stored(const Exact& t, Halfedge h, const std::array<Gmpq, 4>& exact) {
  const IT::Indexed_face f = indexed_face(t, h);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& x =
        k < 3 ? t.metric().squared_length(f.edges[k]) : t.metric().quadruple_area(f.face);
    const double near = k < 3 ? t.metric().approximate_squared_length(f.edges[k])
                              : t.metric().approximate_quadruple_area(f.face);
    EXPECT_LE(Gmpq(x.inf()), exact[k]);
    EXPECT_GE(Gmpq(x.sup()), exact[k]);
    EXPECT_GE(near, x.inf());
    EXPECT_LE(near, x.sup());
  }
}

void expect_true_values(const Planar& p) {
  for (const Halfedge h : halfedges_with_face(p.t)) {
    const auto exact = from_positions(p, h);
    EXPECT_EQ(from_unfolding(p.t, h), exact);
    EXPECT_GT(exact[3], Gmpq(0));
    expect_stored(p.t, h, exact);
  }
}

TEST(Exact_vertex_moves, values_are_those_of_the_plane_after_random_moves) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Planar p(seed % 2 == 0 ? meshes::grid(2, 3) : meshes::random_planar(12, 50, seed));
    Mover<Exact> mover(p.t, seed);
    for (int i = 0; i < 12; ++i) {
      move_at_random(p, mover, 4);
      expect_true_values(p);
      if (HasFailure()) {
        ADD_FAILURE() << "seed " << seed << " round " << i;
        return;
      }
    }
    EXPECT_GT(mover.done[0], 10);
  }
}

std::vector<IT::Intrinsic_input> curved_inputs() {
  std::vector<IT::Intrinsic_input> all;
  for (const gallery::Surface& s : gallery::oriented()) all.push_back(gallery::input(s));
  for (const meshes::Mesh& m :
       {meshes::box(1, 2, 1), meshes::rough_grid(2, 3), meshes::potato(1, 4)})
    all.push_back(m.input());
  return all;
}

using Exact_values = std::map<std::uint32_t, std::array<Gmpq, 3>>;

// by edge: squared length, squares of the areas on both sides, -1 where irrational
Exact_values exact_values(const Exact& t) {
  const places::Exact_input input(t.input().metric());
  places::Unfolded<Exact> unfolded(t);
  const auto rational = [](const IT::Multiquadratic_number& x) {
    return x.is_rational() ? x.coefficient(0) : Gmpq(-1);
  };
  Exact_values result;
  for (const Halfedge h : properties::flippable_by_connectivity(t)) {
    const auto f = unfolded.exact(h.index, input), g = unfolded.exact(h.index ^ 1U, input);
    EXPECT_TRUE((f.squared_lengths[0] - g.squared_lengths[0]).is_zero());
    result[t.index(edge(h, t.mesh()))] = {rational(f.squared_lengths[0]),
                                          rational(f.quadruple_area * f.quadruple_area),
                                          rational(g.quadruple_area * g.quadruple_area)};
  }
  return result;
}

TEST(Exact_vertex_moves, a_vertex_inserted_in_a_face_and_removed_leaves_the_exact_values) {
  for (const IT::Intrinsic_input& in : curved_inputs()) {
    Exact t(in);
    const Exact_values before = exact_values(t);
    for (const Halfedge h : halfedges_with_face(Exact(in))) {
      const auto n = t.insert_vertex(h, {0.25, 0.125, 0.625});
      ASSERT_EQ(n.status, Move_status::done);
      ASSERT_EQ(t.remove_vertex(n.vertex), Move_status::done);
    }
    EXPECT_EQ(exact_values(t), before);
    EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
  }
}

TEST(Exact_vertex_moves, stored_intervals_contain_what_places_say_on_any_surface) {
  std::mt19937 random(20261121);
  for (const IT::Intrinsic_input& in : curved_inputs()) {
    Exact t(in);
    std::vector<Vertex> inserted;
    for (int i = 0; i < 40; ++i) {
      const auto all = halfedges_with_face(t);
      const Halfedge h = all[random() % all.size()];
      const auto kind = random() % 6;
      if (kind < 2) {
        const auto n = kind == 0 ? t.split_edge(h, 0.375) : t.insert_vertex(h, {0.25, 0.25, 0.5});
        if (n.status == Move_status::done) inserted.push_back(n.vertex);
      } else if (kind == 2 && !inserted.empty()) {
        if (t.remove_vertex(inserted.back()) == Move_status::done) inserted.pop_back();
      } else
        t.flip_edge(h);
    }
    EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
  }
}

TEST(Exact_vertex_moves, removing_all_vertices_inserted_gives_the_delaunay_tessellation_back) {
  const auto tessellation = [](Exact& t) {
    IT::flip_to_delaunay(t);
    std::vector<properties::Tessellation_edge> result;
    for (const Halfedge h : properties::flippable_by_connectivity(t)) {
      if (t.delaunay_sign(h) == CGAL::ZERO) continue;
      const auto i = t.input_vertex(source(h, t.mesh())), j = t.input_vertex(target(h, t.mesh()));
      result.emplace_back(std::min(i, j), std::max(i, j), t.squared_length(edge(h, t.mesh())));
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  for (const meshes::Mesh& m :
       {meshes::box(2, 2, 1), meshes::potato(1, 2), meshes::integer_height_field(3, 4, 5)}) {
    std::mt19937 random(7);
    Exact original(m.input()), t(m.input());
    std::vector<Vertex> inserted;
    for (int i = 0; i < 15; ++i) {
      const auto all = halfedges_with_face(t);
      const Halfedge h = all[random() % all.size()];
      const auto n = i % 3 == 0 ? t.split_edge(h, 0.375) : t.insert_vertex(h, {0.25, 0.25, 0.5});
      ASSERT_EQ(n.status, Move_status::done);
      inserted.push_back(n.vertex);
    }
    IT::flip_to_delaunay(t);
    for (const Vertex v : inserted) ASSERT_EQ(t.remove_vertex(v), Move_status::done);
    // squared lengths are 2^-40 apart at most, far more than rounding
    properties::expect_same_tessellation(tessellation(t), tessellation(original), 0x1p-40);
    EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
  }
}

TEST(Exact_vertex_moves, a_vertex_on_an_edge_is_removed_by_a_flip_that_leaves_no_area) {
  for (const double s : {0.5, 0.25, 0.1, 1.0 / 3}) {
    // a diamond that is not convex at the vertex inserted, nor anywhere else on its edge
    Planar p(meshes::Mesh{{{0, 0, 0}, {1, 0, 0}, {-3, 1, 0}, {-2, -3, 0}}, {{0, 1, 2}, {1, 0, 3}}});
    const Halfedge h = properties::flippable_by_connectivity(p.t).at(0);
    const auto n = p.insert(h.index, {1 - s, s, 0});
    ASSERT_EQ(n.status, Move_status::done);
    expect_true_values(p);
    ASSERT_EQ(p.t.remove_vertex(n.vertex), Move_status::done);
    expect_true_values(p);
    EXPECT_EQ(edges(p.t.mesh()).size(), 5U);
  }
}

TEST(Exact_vertex_moves, diamonds_between_centres_of_squares_are_ties_for_certain) {
  for (const meshes::Mesh& m : {meshes::grid(3, 3), meshes::box(2, 2, 1)}) {
    Exact t(m.input());
    std::vector<Halfedge> sides, diagonals;
    for (const Halfedge h : properties::flippable_by_connectivity(t))
      (std::abs(t.squared_length(edge(h, t.mesh())) - 2) < 0.1 ? diagonals : sides).push_back(h);
    for (const Halfedge h : diagonals) ASSERT_EQ(t.split_edge(h, 0.5).status, Move_status::done);
    t.metric().statistics() = {};
    for (const Halfedge h : sides) EXPECT_EQ(t.delaunay_sign(h), CGAL::ZERO);
    const IT::Predicate_statistics& s = t.metric().statistics();
    EXPECT_GT(s.certified_zero,
              sides.size() / 2); // the intervals of the others are zero themselves
    EXPECT_EQ(s.certified_zero, s.filter_failures);
    EXPECT_EQ(s.probable_zero, 0U);
    EXPECT_EQ(IT::flip_to_delaunay(t).flips, 0U);
  }
}

// the orientation of k, m and a point of ij, for faces ijk and jim
struct Orientation {
  double weight; // of j
  template <class FT>
  FT operator()(std::span<const IT::Face_values<FT>> faces) const {
    const auto& [f, area_f] = faces[0];
    const auto& [g, area_g] = faces[1];
    const FT scale = FT(1) / (f[0] + f[0]);
    const FT k_x = (f[0] + f[2] - f[1]) * scale, k_y = area_f * scale;
    const FT m_x = (g[0] + g[1] - g[2]) * scale, m_y = FT(0) - area_g * scale;
    return (m_x - k_x) * (FT(0) - k_y) - (m_y - k_y) * (FT(weight) - k_x);
  }
};

TEST(Exact_vertex_moves, sides_of_unfolded_segments_are_told_exactly) {
  Planar p(meshes::grid(3, 3));
  Mover<Exact> mover(p.t, 3);
  move_at_random(p, mover, 40);
  int ties = 0;
  p.t.metric().statistics() = {};
  for (const Halfedge h : properties::flippable_by_connectivity(p.t)) {
    const Halfedge o = opposite(h, p.t.mesh());
    const std::array faces{indexed_face(p.t, h), indexed_face(p.t, o)};
    const auto apex = [&](Halfedge x) { return at(p, target(next(x, p.t.mesh()), p.t.mesh())); };
    const Position i = at(p, source(h, p.t.mesh())), j = at(p, source(o, p.t.mesh())), k = apex(h),
                   m = apex(o);
    for (int n = 0; n <= 16; ++n) {
      const Gmpq w(n / 16.0);
      const Position q{i[0] + w * (j[0] - i[0]), i[1] + w * (j[1] - i[1])};
      const CGAL::Sign expected =
          CGAL::sign(Gmpq((m[0] - k[0]) * (q[1] - k[1]) - (m[1] - k[1]) * (q[0] - k[0])));
      const CGAL::Protect_FPU_rounding<true> upwards;
      EXPECT_EQ(p.t.sign(faces, Orientation{n / 16.0}), expected);
      ties += expected == CGAL::ZERO ? 1 : 0;
    }
  }
  EXPECT_GT(ties, 0);
  const IT::Predicate_statistics& s = p.t.metric().statistics();
  EXPECT_GT(s.certified_zero, 0U);
  EXPECT_EQ(s.probable_zero, 0U);
}

TEST(Exact_vertex_moves, vague_intervals_of_faces_are_sharpened) {
  Exact t(meshes::sheared_grid(2, 2, 50).input());
  // rounding errors grow with each flip
  for (const Halfedge h : properties::flippable_by_connectivity(t))
    for (int i = 0; i < 40; ++i) t.flip_edge(h);
  const auto width = [](const CGAL::Interval_nt<false>& x) {
    return (x.sup() - x.inf()) / x.sup();
  };
  double widest = 0;
  for (const Halfedge h : halfedges_with_face(t)) {
    const CGAL::Protect_FPU_rounding<true> upwards;
    const IT::Indexed_face f = indexed_face(t, h);
    widest = std::max(widest, width(t.metric().quadruple_area(f.face)));
    t.sharpen(std::span(&f, 1));
    EXPECT_LE(width(t.metric().quadruple_area(f.face)), 0x1p-40);
    for (const std::uint32_t e : f.edges) EXPECT_LE(width(t.metric().squared_length(e)), 0x1p-40);
  }
  EXPECT_GT(widest, 0x1p-40); // there was something to do
  EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
}

} // namespace

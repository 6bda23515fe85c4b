// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/unfolding/unfold_corners.h>

#include "gallery.h"
#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/exact/Conjugate_bound.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/exact/History_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolding.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Diamonds at vertices that were inserted, unfolded from the input, against repeated moves.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using CGAL::Gmpq;
using IT::Move_status;
using IT::Multiquadratic_number;
using Exact = IT::Intrinsic_triangulation<>;
using Metric = IT::Exact_euclidean_metric;
using Halfedge = Exact::halfedge_descriptor;
using Vertex = Exact::vertex_descriptor;
using Side = IT::Flip_history::Side;

/// A triangulation that moves at random, to points with small denominators.
class Walk {
public:
  Walk(IT::Intrinsic_input input, unsigned seed) : t(std::move(input)), random_(seed) {}

  Exact t;

  void step() {
    const Halfedge h = random_halfedge();
    switch (random_() % 4) {
    case 0: {
      const double w = static_cast<double>(random_() % 2 + 1) / 4;
      keep(t.insert_vertex(h, {w, w / 2, 1 - w - w / 2}));
      break;
    }
    case 1:
      keep(t.split_edge(h, static_cast<double>(random_() % 3 + 1) / 4));
      break;
    case 2:
      if (!inserted_.empty()) {
        const std::size_t i = random_() % inserted_.size();
        if (t.remove_vertex(inserted_[i]) == Move_status::done)
          inserted_.erase(inserted_.begin() + static_cast<std::ptrdiff_t>(i));
      }
      break;
    default:
      for (int i = 0; i < 3; ++i) t.flip_edge(random_halfedge());
    }
  }

  std::vector<std::pair<Side, Side>> inner_edges() const {
    std::vector<std::pair<Side, Side>> result;
    for (const Halfedge h : halfedges(t.mesh())) {
      const Halfedge o = opposite(h, t.mesh());
      if (h.index > o.index || is_border(h) || is_border(o) ||
          face(h, t.mesh()) == face(o, t.mesh()))
        continue;
      result.emplace_back(side(h), side(o));
    }
    return result;
  }

private:
  bool is_border(Halfedge h) const {
    return face(h, t.mesh()) == boost::graph_traits<IT::Gluing_map>::null_face();
  }

  Halfedge random_halfedge() {
    std::vector<Halfedge> all;
    for (const Halfedge h : halfedges(t.mesh()))
      if (!is_border(h)) all.push_back(h);
    return all[random_() % all.size()];
  }

  void keep(const Exact::Insertion& i) {
    if (i.status == Move_status::done) inserted_.push_back(i.vertex);
  }

  Side side(Halfedge h) const {
    const auto [version, first] = t.metric().version(face(h, t.mesh()).index);
    const Halfedge n = next(h, t.mesh());
    return {version, first == h.index / 2 ? 0U : first == n.index / 2 ? 2U : 1U};
  }

  std::mt19937 random_;
  std::vector<Vertex> inserted_;
};

IT::Intrinsic_input input_of(const gallery::Surface& s) {
  return {IT::Gluing_map(s.gluing), gallery::squared_lengths(s)};
}

// input faces with exact areas
struct Exact_input {
  const IT::Input_metric& input;
  mutable IT::Square_class_basis basis{};

  IT::History_values<Multiquadratic_number>::Input_face operator()(std::uint32_t f) const {
    const auto root = basis.sqrt_of(input.squared_quadruple_area<Gmpq>(f));
    return {{Multiquadratic_number(input.squared_length<Gmpq>(f, 0)),
             Multiquadratic_number(input.squared_length<Gmpq>(f, 1)),
             Multiquadratic_number(input.squared_length<Gmpq>(f, 2))},
            Multiquadratic_number(basis, root.value())};
  }
};

void expect_same(const IT::Diamond_values<Multiquadratic_number>& x,
                 const IT::Diamond_values<Multiquadratic_number>& y) {
  EXPECT_TRUE((x.ij - y.ij).is_zero());
  EXPECT_TRUE((x.jk - y.jk).is_zero());
  EXPECT_TRUE((x.ki - y.ki).is_zero());
  EXPECT_TRUE((x.im - y.im).is_zero());
  EXPECT_TRUE((x.mj - y.mj).is_zero());
  EXPECT_TRUE((x.area_f - y.area_f).is_zero());
  EXPECT_TRUE((x.area_g - y.area_g).is_zero());
}

// returns the number of diamonds that have inserted vertices
std::size_t check_all_diamonds(const Walk& walk) {
  const auto& metric = walk.t.metric();
  IT::Unfolding unfolding;
  const Exact_input input{metric.input()};
  IT::History_values<Multiquadratic_number> memory;
  IT::History_evaluator<Multiquadratic_number, Exact_input> moves(metric.history(), input, memory);
  std::size_t result = 0;
  for (const auto& [l, r] : walk.inner_edges()) {
    if (l.face == r.face) continue;
    const std::optional<IT::Unfolded_diamond> d = unfolding.diamond(metric.history(), l, r);
    if (!d) {
      ADD_FAILURE() << "a diamond is not unfolded";
      continue;
    }
    expect_same(d->values<Multiquadratic_number>(input), moves.diamond(l, r));
    result += d->combinations.empty() ? 0 : 1;
  }
  return result;
}

TEST(unfold_corners, agrees_exactly_with_repeated_moves_on_meshes) {
  std::size_t checked = 0;
  for (unsigned seed = 1; seed <= 4; ++seed)
    for (const meshes::Mesh& m : {meshes::box(1, 1, 1), meshes::integer_height_field(2, 3, seed)}) {
      Walk walk(m.input(), seed);
      for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 3; ++i) walk.step();
        checked += check_all_diamonds(walk);
      }
    }
  EXPECT_GT(checked, 200U);
}

TEST(unfold_corners, agrees_exactly_with_repeated_moves_on_Delta_complexes) {
  std::size_t checked = 0;
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    Walk walk(input_of(s), 5);
    for (int round = 0; round < 3; ++round) {
      for (int i = 0; i < 2; ++i) walk.step();
      checked += check_all_diamonds(walk);
    }
  }
  EXPECT_GT(checked, 100U);
}

// values that a diamond has for all choices of signs of the roots; the bound is on the value times an
// integer, hence on the value itself
TEST(unfold_corners, gives_diamonds_whose_conjugates_are_bounded) {
  Walk walk(meshes::integer_height_field(2, 3, 7).input(), 7);
  for (int i = 0; i < 14; ++i) walk.step();
  const auto& metric = walk.t.metric();
  IT::Unfolding unfolding;
  IT::Integer_faces integers;
  std::size_t checked = 0;
  for (const auto& [l, r] : walk.inner_edges()) {
    const auto d = l.face == r.face ? std::nullopt : unfolding.diamond(metric.history(), l, r);
    if (!d) continue;
    std::vector<const IT::Integer_face*> faces;
    for (const auto& t : d->triangles) faces.push_back(&integers(metric.input(), t.face));
    const double bits = IT::Conjugate_bound(*d, faces, true).bits(IT::Delaunay_expression());
    for (unsigned signs = 0; signs < 256; ++signs) {
      const auto face = [&](std::uint32_t f) {
        const double area = std::sqrt(metric.input().squared_quadruple_area<double>(f));
        return std::pair<std::array<double, 3>, double>(
            {metric.input().squared_length<double>(f, 0),
             metric.input().squared_length<double>(f, 1),
             metric.input().squared_length<double>(f, 2)},
            (signs >> (f % 8)) % 2 != 0 ? -area : area);
      };
      EXPECT_LE(std::log2(std::abs(IT::Delaunay_expression()(d->values<double>(face)))), bits);
    }
    checked += d->combinations.empty() ? 0 : 1;
  }
  EXPECT_GT(checked, 10U);
}

// an insertion on an edge, and one that is as near to it as weights allow
TEST(unfold_corners, lets_a_zero_test_tell_a_straight_angle_from_one_that_is_bent_by_an_ulp) {
  std::array<std::size_t, 2> straight{};
  for (const bool is_bent : {false, true}) {
    Walk walk(meshes::integer_height_field(2, 3, 11).input(), 11);
    Exact& t = walk.t;
    const Halfedge h = *halfedges(t.mesh()).begin();
    const double w = 0.5, tiny = is_bent ? 0x1p-52 : 0;
    const auto p = t.insert_vertex(h, {w, w - tiny, tiny});
    ASSERT_EQ(p.status, Move_status::done);
    // around p: the sum of the angles between the ends of the edge
    std::size_t zeros = 0, others = 0;
    IT::Exact_evaluation evaluation;
    for (const auto& [l, r] : walk.inner_edges()) {
      const auto answer = evaluation.zero_answer(t.input().metric(), t.metric().history(), l, r,
                                                 IT::Convexity_at_source_expression());
      EXPECT_NE(answer, IT::Zero_answer::probably_zero);
      const auto oracle = IT::History_zero_test(t.input().metric(), t.metric().history(), l,
                                                r)(IT::Convexity_at_source_expression());
      EXPECT_EQ(answer, oracle);
      ++(answer == IT::Zero_answer::zero ? zeros : others);
    }
    EXPECT_GT(others, 0U);
    straight[is_bent ? 1 : 0] = zeros;
  }
  EXPECT_LT(straight[1], straight[0]);
}

} // namespace

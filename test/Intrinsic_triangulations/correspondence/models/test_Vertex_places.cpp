// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "properties.h"
#include "subdivision_oracle.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// What exact traits say of inserted vertices must follow from their places on the input, and from nothing else.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using subdivision_oracle::input;
using subdivision_oracle::Mover;
using Integers = IT::Integer_only_triangulation<>;

template <class Correspondence>
using Exact =
    IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Correspondence>;
using With_integers = Exact<IT::Integer_coordinates>;

std::vector<meshes::Mesh> surfaces() {
  return {meshes::rough_grid(4, 2),
          meshes::box(2, 2, 1),
          meshes::potato(2, 3),
          meshes::integer_terrain(30, 20, 5),
          meshes::folded_lattice(4, 4, 1),
          meshes::sheared_grid(4, 4, 5),
          meshes::integer_height_field(4, 3, 2)};
}

// makes random moves, the same on triangulations that are the same; returns how often each status came
template <class T>
std::array<int, 10> move_at_random(T& t, unsigned seed, int moves) {
  Mover<T> mover(t, seed);
  for (int i = 0; i < moves; ++i) mover.move(true);
  return mover.statuses;
}

// signs of all inner edges, by number
template <class T>
std::vector<CGAL::Sign> signs(const T& t) {
  std::vector<CGAL::Sign> result;
  const typename T::Const_session session(t);
  for (const auto h : properties::flippable_by_connectivity(t))
    result.push_back(session.delaunay_sign(h));
  return result;
}

// by integers and the input alone: every face is positive, and of every edge the sign is the one that is expected
void expect_same_by_integers(const With_integers& t) {
  const Integers integers(t);
  const Integers::Const_session session(integers);
  for (const std::uint32_t h : places::halfedges_of_faces(t)) {
    const IT::Intrinsic_view<With_integers> view(t);
    const std::uint32_t inner = view.is_border(h ^ 1U) ? IT::Gluing::none : h;
    if (inner != IT::Gluing::none && view.face(h) != view.face(h ^ 1U)) {
      EXPECT_EQ(session.orientation({h}), CGAL::POSITIVE);
    }
  }
  EXPECT_EQ(signs(integers), signs(t));
  EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
}

TEST(Vertex_places, define_all_values_and_signs_after_random_moves) {
  for (const meshes::Mesh& m : surfaces()) {
    With_integers t(input(m));
    const double before = properties::total_area(t);
    for (unsigned round = 1; round <= 4; ++round) {
      move_at_random(t, round, 40);
      EXPECT_NEAR(properties::total_area(t), before, 1e-12 * before);
      expect_same_by_integers(t);
      IT::flip_to_delaunay(t);
      EXPECT_TRUE(IT::is_delaunay(Integers(t)));
      expect_same_by_integers(t);
      if (HasFailure()) return;
    }
  }
}

// rounding of a place in an input face may put it outside of a thin intrinsic face, or on an input edge beyond it
TEST(Vertex_places, are_found_for_points_near_sides_of_every_face_that_is_wide_enough) {
  int inserted = 0;
  for (const double height : {1., 0.1, 1e-2, 1e-3, 1e-4})
    for (unsigned seed = 1; seed <= 10; ++seed) {
      With_integers t(input(meshes::grid(2, 8, 1, height)));
      Mover<With_integers> random(t, seed);
      for (int i = 0; i < 60; ++i) {
        if (i % 10 == 9) IT::flip_to_delaunay(t);
        const std::uint32_t h = random.halfedge(i % 2 == 0);
        const auto weights =
            i % 5 == 4 ? std::array{0.5, 0.5 - 1e-13, 1e-13} : random.weights(i % 3 == 0);
        const IT::Intrinsic_view<With_integers> view(t);
        const double area = view.quadruple_area(view.face(h)),
                     length = std::sqrt(view.squared_length(h / 2));
        const Move_status status = t.insert_vertex({h}, weights).status;
        inserted += status == Move_status::done ? 1 : 0;
        if (status != Move_status::not_traceable) continue;
        // 2^-28 of the height, by which points of sides are moved, is less than the unit of weights, 2^-52
        EXPECT_LT(area, 0x1p-22 * length) << height << ' ' << seed << ' ' << i;
      }
      EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none) << height << ' ' << seed;
    }
  EXPECT_GT(inserted, 2500);
}

TEST(Vertex_places, define_all_values_and_signs_on_Delta_complexes) {
  for (const gallery::Surface& s : gallery::oriented()) {
    SCOPED_TRACE(s.name);
    With_integers t(gallery::input(s));
    const double before = properties::total_area(t);
    for (unsigned round = 1; round <= 3; ++round) {
      move_at_random(t, round, 15);
      EXPECT_NEAR(properties::total_area(t), before, 1e-12 * before);
      expect_same_by_integers(t);
    }
  }
}

TEST(Vertex_places, are_the_same_whatever_else_observes_the_moves) {
  for (const meshes::Mesh& m : surfaces()) {
    With_integers t(input(m));
    Exact<IT::No_correspondence> none(input(m));
    Exact<IT::Explicit_crossings> crossings(input(m));
    Exact<IT::Signposts> signposts(input(m));
    // flips that the hidden coordinates must replay
    std::mt19937 random(3);
    for (int i = 0; i < 50; ++i) {
      const auto edges = properties::flippable_by_connectivity(t);
      const auto h = edges[random() % edges.size()];
      const Move_status s = t.flip_edge(h);
      ASSERT_EQ(none.flip_edge(h), s);
      ASSERT_EQ(crossings.flip_edge(h), s);
      ASSERT_EQ(signposts.flip_edge(h), s);
    }
    const auto statuses = move_at_random(t, 5, 80);
    EXPECT_GT(statuses[0], 30);
    EXPECT_EQ(move_at_random(none, 5, 80), statuses);
    EXPECT_EQ(move_at_random(crossings, 5, 80), statuses);
    EXPECT_EQ(move_at_random(signposts, 5, 80), statuses);
    const auto expected = properties::values(t);
    EXPECT_EQ(properties::values(none), expected);
    EXPECT_EQ(properties::values(crossings), expected);
    EXPECT_EQ(properties::values(signposts), expected);
    EXPECT_EQ(signs(none), signs(t));
    EXPECT_EQ(signs(crossings), signs(t));
    EXPECT_EQ(signs(signposts), signs(t));
  }
}

// The weights of all inner edges with the rows of their ends; their signs are checked.
struct Weights {
  std::vector<std::array<double, 3>> values;
  std::size_t sharpened = 0, zero = 0;
};

template <class Correspondence>
Weights weights(const meshes::Mesh& m, bool is_refined) {
  Exact<Correspondence> t(input(m));
  if (is_refined)
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25.));
  else
    IT::flip_to_delaunay(t);
  Weights result;
  for (const auto e : edges(t.mesh())) {
    if (CGAL::is_border(e, t.mesh())) continue;
    const double w = typename Exact<Correspondence>::Const_session(t).cotangent_weight(e);
    result.values.push_back({static_cast<double>(t.input_vertex(source(e, t.mesh()))),
                             static_cast<double>(t.input_vertex(target(e, t.mesh()))), w});
    if (w == 0) ++result.zero;
    EXPECT_EQ(CGAL::sign(w), t.delaunay_sign(halfedge(e, t.mesh())));
  }
  for (const auto& [bits, count] : t.metric().statistics().sharpenings) result.sharpened += count;
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
  return result;
}

TEST(Vertex_places, give_the_same_weights_to_all_correspondences_bit_by_bit) {
  std::size_t sharpened = 0, zero = 0;
  const auto check = [&](const meshes::Mesh& m, bool is_refined) {
    const Weights expected = weights<IT::No_correspondence>(m, is_refined);
    EXPECT_EQ(weights<IT::Integer_coordinates>(m, is_refined).values, expected.values);
    EXPECT_EQ(weights<IT::Explicit_crossings>(m, is_refined).values, expected.values);
    EXPECT_EQ(weights<IT::Signposts>(m, is_refined).values, expected.values);
    sharpened += expected.sharpened;
    zero += expected.zero;
  };
  for (const meshes::Mesh& m : surfaces()) check(m, true);
  for (const double noise : {0., 1e-15, 1e-12, 1e-6, 1e-3})
    for (meshes::Mesh m : {meshes::sheared_grid(12, 12, 7), meshes::folded_lattice(8, 9, 5),
                           meshes::box(6, 5, 4), meshes::stairs(9, 3, 5), meshes::potato(3, 3)}) {
      std::mt19937 random(8);
      std::uniform_real_distribution<double> shift(-1, 1);
      for (auto& p : m.points)
        for (double& x : p) x += noise * shift(random);
      check(m, false);
    }
  EXPECT_GT(sharpened, 300U); // where values do not follow flips
  EXPECT_GT(zero, 150U);
}

// many ties, which stored values cannot tell
template <class T>
T with_ties() {
  T t(input(meshes::box(2, 2, 1)));
  Mover<T> mover(t, 1);
  for (int i = 0; i < 8; ++i) mover.move(true);
  for (const auto h : properties::flippable_by_connectivity(t))
    if (std::abs(t.squared_length(edge(h, t.mesh())) - 2) < 1e-6) t.split_edge(h, 0.5);
  return t;
}

template <class T>
void expect_decides(const T& t, const std::vector<CGAL::Sign>& expected) {
  t.metric().statistics() = {};
  EXPECT_EQ(signs(t), expected);
  EXPECT_GT(t.metric().statistics().certified_zero, 0U);
  EXPECT_EQ(t.metric().statistics().probable_zero, 0U);
}

template <class Correspondence>
class Vertex_places_of : public testing::Test {};
using Correspondences = testing::Types<IT::No_correspondence, IT::Integer_coordinates,
                                       IT::Explicit_crossings, IT::Signposts>;
TYPED_TEST_SUITE(Vertex_places_of, Correspondences);

TYPED_TEST(Vertex_places_of, copies_moves_and_assignments_keep_deciding) {
  using T = Exact<TypeParam>;
  const T original = with_ties<T>();
  const auto expected = signs(original);
  expect_decides(original, expected);

  T changing = original;
  const T copy(changing); // must not ask what it was copied from
  EXPECT_GT(move_at_random(changing, 9, 60)[0], 20);
  expect_decides(copy, expected);

  std::vector<T> copies; // that change their addresses
  for (int i = 0; i < 9; ++i) copies.push_back(original);
  for (const T& t : copies) expect_decides(t, expected);

  T assigned(input(meshes::grid(2, 2)));
  assigned = copies.front();
  T moved = std::move(copies.back());
  copies.clear();
  expect_decides(assigned, expected);
  expect_decides(moved, expected);
  std::swap(assigned, moved);
  expect_decides(assigned, expected);
  expect_decides(moved, expected);

  // and go their own ways
  T other = original;
  EXPECT_EQ(move_at_random(moved, 7, 30), move_at_random(assigned, 7, 30));
  EXPECT_EQ(signs(moved), signs(assigned));
  EXPECT_EQ(properties::values(moved), properties::values(assigned));
  expect_decides(other, expected);
  expect_decides(original, expected);
  IT::flip_to_delaunay(moved);
  EXPECT_TRUE(IT::is_delaunay(moved));
  // over what had no insertion, and had another input
  other = T(input(meshes::grid(2, 2)));
  EXPECT_EQ(other.insert_vertex({0}, {0.25, 0.25, 0.5}).status, Move_status::done);
  EXPECT_TRUE(IT::flip_to_delaunay(other).status == IT::Status::done);
}

TYPED_TEST(Vertex_places_of, refinement_of_noisy_meshes_needs_no_more_than_doubles) {
  for (const meshes::Mesh& m :
       {meshes::rough_grid(20, 3), meshes::rough_grid(15, 4, 2.0), meshes::potato(4, 7)}) {
    Exact<TypeParam> t(input(m));
    const auto result = IT::delaunay_refine(t, IT::parameters::minimum_angle(25.));
    EXPECT_EQ(result.status, IT::Status::done);
    EXPECT_GT(result.counts.inserted_vertices(), 20U);
    const IT::Predicate_statistics& s = t.metric().statistics();
    for (const auto& [bits, count] : s.escalations) EXPECT_EQ(bits, 53U) << count;
    EXPECT_TRUE(s.sharpenings.empty());
    EXPECT_EQ(s.certified_zero + s.probable_zero, 0U);
  }
}

} // namespace

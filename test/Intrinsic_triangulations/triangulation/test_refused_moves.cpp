// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "meshes.h"
#include "places.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <random>
#include <type_traits>
#include <vector>

// A move that an observer refuses leaves everything as it was, but caches and statistics.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;

// How often moves are refused, in percent.
int refused_percentage = 0;
std::mt19937 coin(1);

/// Refuses moves at random, after its base has agreed.
template <class Base>
class Refusing : public Base {
public:
  using Base::after;
  template <class Triangulation, class Move>
  bool before(const Triangulation& t, const Move& move) {
    return Base::before(t, move) && static_cast<int>(coin() % 100) >= refused_percentage;
  }
};

// ---- the state of a triangulation, but caches and statistics

using State = std::vector<std::uint64_t>;

template <class T>
void add_connectivity(const T& t, State& s) {
  const IT::Intrinsic_view<T> view(t);
  for (const auto v : vertices(t.mesh())) {
    s.push_back(t.index(v));
    s.push_back(t.numbers().halfedge(halfedge(v, t.mesh())));
    s.push_back(t.input_vertex(v));
  }
  for (const auto e : edges(t.mesh()))
    for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1}) {
      s.push_back(h);
      s.push_back(view.next(h));
      s.push_back(view.target(h));
      s.push_back(view.face(h));
    }
  for (const auto f : faces(t.mesh())) {
    s.push_back(t.index(f));
    s.push_back(t.numbers().halfedge(halfedge(f, t.mesh())));
  }
  s.push_back(t.number_of_vertices());
}

template <class T>
void add_coordinates(const T& t, const IT::Integer_coordinates& c, State& s) {
  for (const auto e : edges(t.mesh())) {
    const std::uint32_t i = t.index(e);
    s.push_back(static_cast<std::uint64_t>(c.normal_coordinate(i)));
    for (const std::uint32_t h : {2 * i, 2 * i + 1}) {
      s.push_back(c.roundabout(h));
      if (c.roundabout(h) != IT::Gluing::none) s.push_back(c.fans().halfedge(c.roundabout(h)));
    }
    if (c.knows_crossings())
      for (const std::uint32_t x : c.entered_on(i)) s.push_back(x);
  }
}

template <class T, class Places>
void add_places(const T& t, const Places& c, State& s) {
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) {
      const IT::Surface_point& p = c.location(t.index(v));
      s.push_back(p.halfedge);
      for (const double w : p.weights) s.push_back(std::bit_cast<std::uint64_t>(w));
    }
}

template <class T>
State state(const T& t) {
  State s;
  add_connectivity(t, s);
  // intervals of an exact metric are a cache
  if constexpr (!T::Metric::is_exact) {
    for (const auto e : edges(t.mesh()))
      s.push_back(std::bit_cast<std::uint64_t>(t.metric().squared_length(t.index(e))));
    for (const auto f : faces(t.mesh()))
      s.push_back(std::bit_cast<std::uint64_t>(t.metric().quadruple_area(t.index(f))));
  }
  if (const IT::Integer_coordinates* const c = t.places()) {
    add_coordinates(t, *c, s);
    add_places(t, *c, s);
  }
  if constexpr (requires { t.correspondence().angle(0U); }) {
    for (const auto e : edges(t.mesh()))
      for (const std::uint32_t h : {2 * t.index(e), 2 * t.index(e) + 1})
        s.push_back(std::bit_cast<std::uint64_t>(t.correspondence().angle(h)));
    add_places(t, t.correspondence(), s);
  }
  return s;
}

// ---- moves at random

template <class T>
class Random_moves {
public:
  explicit Random_moves(T& t) : t_(t) {}

  // Makes moves of which each may be refused, and expects that nothing has changed then; returns how
  // many were refused by each kind.
  std::array<int, 4> operator()(int moves, std::size_t most_inserted) {
    std::array<int, 4> refused{};
    State before = state(t_);
    for (int i = 0; i < moves && !testing::Test::HasFailure(); ++i) {
      const std::size_t kind = inserted_.size() < most_inserted ? random_() % 4 : 1 + random_() % 3;
      const Move_status s = move(kind);
      State after = state(t_);
      if (s != Move_status::done) {
        ++refused[kind];
        EXPECT_TRUE(before == after) << "move " << i << " of kind " << kind << ": " << int(s);
      }
      before = std::move(after);
    }
    return refused;
  }

private:
  using Halfedge = typename T::halfedge_descriptor;
  using Vertex = typename T::vertex_descriptor;

  Halfedge halfedge_of_face() {
    auto f = faces(t_.mesh()).begin();
    std::advance(f, random_() % num_faces(t_.mesh()));
    Halfedge h = halfedge(*f, t_.mesh());
    for (std::size_t k = random_() % 3; k > 0; --k) h = next(h, t_.mesh());
    return h;
  }
  std::array<double, 3> weights() {
    const auto a = static_cast<double>(1 + random_() % 14) / 16;
    if (random_() % 3 == 0) return {1 - a, a, 0};
    return {(1 - a) / 2, (1 - a) / 2, a};
  }

  Move_status move(std::size_t kind) {
    const Halfedge h = halfedge_of_face();
    if (kind == 0) {
      const auto n = t_.insert_vertex(h, weights());
      if (n.status == Move_status::done) inserted_.push_back(n.vertex);
      return n.status;
    }
    if (kind == 1 || inserted_.empty()) return t_.flip_edge(h);
    const std::size_t i = random_() % inserted_.size();
    if (kind == 2) {
      const Move_status s = t_.remove_vertex(inserted_[i]);
      if (s == Move_status::done) inserted_.erase(inserted_.begin() + static_cast<long>(i));
      return s;
    }
    const auto n = t_.reposition_vertex(inserted_[i], h, weights());
    if (n.status == Move_status::done) inserted_[i] = n.vertex;
    return n.status;
  }

  T& t_;
  std::mt19937 random_{2};
  std::vector<Vertex> inserted_;
};

template <class Traits, class Correspondence>
void expect_no_change_by_refused_moves(int moves) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Refusing<Correspondence>>;
  std::array<int, 4> refused{};
  const auto run = [&](IT::Intrinsic_input input, std::size_t most_inserted) {
    for (const int percentage : {0, 10, 50}) { // of elementary moves: others consist of many
      refused_percentage = 0;
      T t(input);
      Random_moves<T> random(t);
      refused_percentage = percentage;
      const std::array<int, 4> r = random(moves, most_inserted);
      for (std::size_t k = 0; k < 4; ++k) refused[k] += r[k];
      refused_percentage = 0;
      EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    }
  };
  for (const meshes::Mesh& m : {meshes::rough_grid(4, 2), meshes::box(2, 2, 1),
                                meshes::integer_terrain(12, 20, 5)})
    run(m.input(), 12);
  for (const gallery::Surface& s : gallery::oriented()) run(gallery::input(s), 4);
  for (const int n : refused) EXPECT_GT(n, moves / 10);
}

TEST(Refused_moves, change_nothing_of_exact_triangulations) {
  expect_no_change_by_refused_moves<IT::Exact_euclidean_traits, IT::No_correspondence>(250);
  expect_no_change_by_refused_moves<IT::Exact_euclidean_traits, IT::Integer_coordinates>(250);
  expect_no_change_by_refused_moves<IT::Exact_euclidean_traits, IT::Explicit_crossings>(250);
  expect_no_change_by_refused_moves<IT::Exact_euclidean_traits, IT::Signposts>(250);
}

TEST(Refused_moves, change_nothing_of_triangulations_in_doubles) {
  expect_no_change_by_refused_moves<IT::Euclidean_traits<double>, IT::No_correspondence>(250);
  expect_no_change_by_refused_moves<IT::Euclidean_traits<double>, IT::Integer_coordinates>(250);
  expect_no_change_by_refused_moves<IT::Euclidean_traits<double>, IT::Explicit_crossings>(250);
  expect_no_change_by_refused_moves<IT::Euclidean_traits<double>, IT::Signposts>(250);
}

/// Refuses removals only.
struct Keeps_vertices : IT::No_correspondence {
  using IT::No_correspondence::before;
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Removal_from_face&) {
    return false;
  }
};

TEST(Refused_moves, leave_the_places_of_vertices_that_are_not_removed) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Keeps_vertices>;
  T t(meshes::potato(3, 3).input());
  const auto n = static_cast<std::uint32_t>(num_faces(t.mesh()));
  for (std::uint32_t f = 0; f < n; f += 7) {
    const auto p = t.insert_vertex(halfedge(T::face_descriptor{f}, t.mesh()), {0.3, 0.3, 0.4});
    ASSERT_EQ(p.status, Move_status::done);
    const State before = state(t);
    EXPECT_EQ(t.remove_vertex(p.vertex), Move_status::not_removable);
    ASSERT_TRUE(state(t) == before);
  }
  EXPECT_EQ(places::first_wrong_value(t), IT::Gluing::none);
}

} // namespace

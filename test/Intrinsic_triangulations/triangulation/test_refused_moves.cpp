// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// A move that an observer refuses leaves everything as it was: connectivity, lengths, and where
// vertices and edges are on the input.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;

/// Refuses removals only.
struct Keeps_vertices : IT::No_correspondence {
  using IT::No_correspondence::before;
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Removal_from_face&) const {
    return false;
  }
};

/// Refuses moves of any kind at random.
template <class Correspondence>
struct Moody : Correspondence {
  template <class Triangulation, class Move>
    requires requires(const Correspondence& c, const Triangulation& t, const Move& move) {
      c.before(t, move);
    }
  bool before(const Triangulation& t, const Move& move) const {
    return Correspondence::before(t, move) && random() % 4 != 0;
  }
  mutable std::minstd_rand random{1};
};

// where edges run on the input, by number
std::vector<std::uint32_t> coordinates(const auto& t) {
  std::vector<std::uint32_t> s;
  const IT::Integer_coordinates& c = *t.places();
  for (const auto e : edges(t.mesh())) {
    s.push_back(static_cast<std::uint32_t>(c.normal_coordinate(t.index(e))));
    s.push_back(c.roundabout(2 * t.index(e)));
    s.push_back(c.roundabout(2 * t.index(e) + 1));
  }
  return s;
}

/// A checksum of everything but caches and statistics, see FNV.
class Checksum {
public:
  void add(std::uint64_t x) { sum_ = (sum_ ^ x) * 0x100000001b3; }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const IT::Surface_point& p) {
    add(std::uint64_t{p.halfedge});
    for (const double w : p.weights) add(w);
  }
  std::uint64_t sum() const { return sum_; }

private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

void add_places(Checksum& s, const auto& t) {
  for (const std::uint32_t x : coordinates(t)) s.add(std::uint64_t{x});
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) s.add(t.places()->location(t.index(v)));
}

// what the model says of an edge
void add_edge(Checksum& s, const IT::Explicit_crossings& c, std::uint32_t e) {
  for (const std::uint32_t x : c.entered_on(e)) s.add(std::uint64_t{x});
}
// no more than has been added
void add_edge(Checksum&, const IT::Integer_coordinates&, std::uint32_t) {}
void add_edge(Checksum& s, const IT::Signposts& c, std::uint32_t e) {
  for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
    s.add(c.angle(h));
    s.add(c.fan(h).angle);
  }
}
void add_edge(Checksum&, const IT::No_correspondence&, std::uint32_t) {}

std::uint64_t checksum(const auto& t) {
  using T = std::remove_cvref_t<decltype(t)>;
  const IT::Intrinsic_view view(t);
  Checksum s;
  if (t.places() != nullptr) add_places(s, t);
  for (const auto v : vertices(t.mesh())) s.add(std::uint64_t{t.input_vertex(v)});
  for (const auto h : halfedges(t.mesh())) {
    const std::uint32_t n = t.numbers().halfedge(h);
    for (const std::uint32_t x : {n, view.next(n), view.target(n), view.face(n)})
      s.add(std::uint64_t{x});
  }
  for (const auto e : edges(t.mesh())) add_edge(s, t.correspondence(), t.index(e));
  // exact traits have caches of values, which places define
  if constexpr (!T::Metric::is_exact) {
    for (const auto e : edges(t.mesh())) s.add(t.metric().squared_length(t.index(e)));
    for (const auto f : faces(t.mesh())) s.add(t.metric().quadruple_area(t.index(f)));
  }
  return s.sum();
}

TEST(Refused_moves, leave_the_places_of_vertices_that_are_not_removed) {
  using T = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits, Keeps_vertices>;
  T t(meshes::potato(3, 3).input());
  const auto n = static_cast<std::uint32_t>(num_faces(t.mesh()));
  for (std::uint32_t f = 0; f < n; f += 7) {
    const auto p = t.insert_vertex(halfedge(T::face_descriptor{f}, t.mesh()), {0.3, 0.3, 0.4});
    ASSERT_EQ(p.status, Move_status::done);
    const std::vector<std::uint32_t> before = coordinates(t);
    EXPECT_EQ(t.remove_vertex(p.vertex), Move_status::not_removable);
    ASSERT_TRUE(coordinates(t) == before);
  }
  EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
}

// makes one move at random; what it was, and what came of it
template <class T>
std::pair<std::string, Move_status> move_at_random(T& t, std::minstd_rand& random) {
  std::vector<typename T::vertex_descriptor> inserted;
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) inserted.push_back(v);
  const std::vector<typename T::halfedge_descriptor> all(halfedges(t.mesh()).begin(),
                                                         halfedges(t.mesh()).end());
  const auto h = all[random() % all.size()];
  const double a = 0.25 + 0.25 * static_cast<double>(random() % 3);
  const std::array<double, 3> weights{(1 - a) / 2, a, (1 - a) / 2};
  const auto some = [&] { return inserted[random() % inserted.size()]; };
  switch (inserted.size() < 3 ? random() % 3 : random() % (inserted.size() > 12 ? 6 : 5)) {
  case 0:
    return {"flip", t.flip_edge(h)};
  case 1:
    return {"insertion", t.insert_vertex(h, weights).status};
  case 2:
    return {"split", t.split_edge(h, a).status};
  case 3:
    return {"reposition", t.reposition_vertex(some(), h, weights).status};
  default:
    return {"removal", t.remove_vertex(some())};
  }
}

template <class Case>
class Refused_moves_of : public ::testing::Test {};
template <class Traits, class Correspondence>
using With = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Moody<Correspondence>>;
using Exact = IT::Exact_euclidean_traits;
using Rounding = IT::Euclidean_traits<double>;
using Cases =
    ::testing::Types<With<Exact, IT::No_correspondence>, With<Exact, IT::Integer_coordinates>,
                     With<Exact, IT::Explicit_crossings>, With<Exact, IT::Signposts>,
                     With<Rounding, IT::No_correspondence>, With<Rounding, IT::Integer_coordinates>,
                     With<Rounding, IT::Explicit_crossings>, With<Rounding, IT::Signposts>>;
TYPED_TEST_SUITE(Refused_moves_of, Cases);

TYPED_TEST(Refused_moves_of, any_kind_change_nothing) {
  std::minstd_rand random(5);
  std::map<std::string, int> refused, done;
  for (int start = 0; start < 70; ++start) {
    TypeParam t(start % 2 == 0 ? meshes::rough_grid(3, 1).input() : meshes::box(2, 2, 1).input());
    std::uint64_t before = checksum(t);
    for (int i = 0; i < 200; ++i) {
      const auto [kind, status] = move_at_random(t, random);
      const std::uint64_t now = checksum(t);
      if (status != Move_status::done) {
        ASSERT_EQ(now, before) << kind << " " << i;
      }
      ++(status == Move_status::done ? done : refused)[kind];
      before = now;
    }
    if constexpr (TypeParam::Metric::is_exact) {
      EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    }
  }
  for (const char* kind : {"flip", "insertion", "split", "reposition", "removal"}) {
    EXPECT_GT(done[kind], 10) << kind;
    EXPECT_GT(refused[kind], 10) << kind;
  }
}

} // namespace

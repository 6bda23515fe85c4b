// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

// A move that an observer refuses leaves everything as it was: connectivity, lengths, and where vertices and
// edges are on the input.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;

/// Refuses removals only.
struct Keeps_vertices : IT::No_correspondence {
  using IT::No_correspondence::before;
  template <class Triangulation>
  bool before(const Triangulation&, const IT::Removal_from_face&) {
    return false;
  }
};

/// Refuses moves of any kind at random.
template <class Correspondence>
struct Moody : Correspondence {
  template <class Triangulation, class Move>
    requires requires(Correspondence& c, const Triangulation& t, const Move& move) {
      c.before(t, move);
    }
  bool before(const Triangulation& t, const Move& move) {
    return Correspondence::before(t, move) && random() % 3 != 0;
  }
  std::mt19937 random{1};
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

// all but lengths and areas
std::vector<std::uint32_t> state(const auto& t) {
  const IT::Intrinsic_view view(t);
  std::vector<std::uint32_t> s;
  if (t.places() != nullptr) s = coordinates(t);
  for (const auto h : halfedges(t.mesh()))
    for (const std::uint32_t x :
         {t.numbers().halfedge(h), view.next(t.numbers().halfedge(h)),
          view.target(t.numbers().halfedge(h)), view.face(t.numbers().halfedge(h))})
      s.push_back(x);
  for (const auto v : vertices(t.mesh())) s.push_back(t.input_vertex(v));
  return s;
}

std::vector<double> values(const auto& t) {
  std::vector<double> s;
  for (const auto e : edges(t.mesh())) s.push_back(t.squared_length(e));
  for (const auto f : faces(t.mesh())) s.push_back(t.area(f));
  return s;
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
std::pair<std::string, Move_status> move_at_random(T& t, std::mt19937& random) {
  const std::vector<typename T::halfedge_descriptor> all(halfedges(t.mesh()).begin(),
                                                         halfedges(t.mesh()).end());
  std::vector<typename T::vertex_descriptor> inserted;
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) inserted.push_back(v);
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
using Cases = ::testing::Types<With<IT::Exact_euclidean_traits, IT::No_correspondence>,
                               With<IT::Exact_euclidean_traits, IT::Integer_coordinates>,
                               With<IT::Exact_euclidean_traits, IT::Signposts>,
                               With<IT::Euclidean_traits<double>, IT::No_correspondence>,
                               With<IT::Euclidean_traits<double>, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(Refused_moves_of, Cases);

TYPED_TEST(Refused_moves_of, any_kind_change_nothing) {
  std::mt19937 random(5);
  std::map<std::string, int> refused, done;
  for (const meshes::Mesh& m : {meshes::rough_grid(3, 1), meshes::box(2, 2, 1)}) {
    TypeParam t(m.input());
    for (int i = 0; i < 10000; ++i) {
      const auto before = state(t);
      const auto lengths = values(t);
      const auto [kind, status] = move_at_random(t, random);
      if (status == Move_status::done) {
        ++done[kind];
        continue;
      }
      ++refused[kind];
      ASSERT_EQ(state(t), before) << kind << " " << i;
      const auto now = values(t);
      for (std::size_t k = 0; k < now.size(); ++k)
        ASSERT_NEAR(now[k], lengths[k], 1e-9 * lengths[k]) << kind << " " << i; // insertions round
    }
  }
  for (const char* kind : {"flip", "insertion", "split", "reposition", "removal"}) {
    EXPECT_GT(done[kind], 10) << kind;
    EXPECT_GT(refused[kind], 10) << kind;
  }
}

} // namespace

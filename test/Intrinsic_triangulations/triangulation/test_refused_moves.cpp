// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checksum.h"
#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
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

/// Refuses moves of any kind at random, or all removals and nothing else.
template <class Correspondence>
struct Moody : Correspondence {
  template <class Triangulation, class Move>
    requires requires(const Correspondence& c, const Triangulation& t, const Move& move) {
      c.before(t, move);
    }
  bool before(const Triangulation& t, const Move& move) const {
    const bool refuses =
        keeps_vertices ? std::is_same_v<Move, IT::Removal_from_face> : random() % 4 == 0;
    return Correspondence::before(t, move) && !refuses;
  }
  mutable std::minstd_rand random{1};
  mutable bool keeps_vertices = false; // triangulations give access to what is const only
};

template <class Traits, class Correspondence>
using With = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Moody<Correspondence>>;
using Exact = IT::Exact_euclidean_traits;
using Rounding = IT::Euclidean_traits<double>;

TEST(Refused_moves, leave_the_places_of_vertices_that_are_not_removed) {
  using T = With<Exact, IT::Integer_coordinates>;
  T t(meshes::potato(3, 3).input());
  t.correspondence().keeps_vertices = true;
  const auto n = static_cast<std::uint32_t>(num_faces(t.mesh()));
  for (std::uint32_t f = 0; f < n; f += 7) {
    const auto p = t.insert_vertex(halfedge(T::face_descriptor{f}, t.mesh()), {0.3, 0.3, 0.4});
    ASSERT_EQ(p.status, Move_status::done);
    const std::vector<std::uint32_t> before = checksums::coordinates(t);
    EXPECT_EQ(t.remove_vertex(p.vertex), Move_status::not_removable);
    ASSERT_TRUE(checksums::coordinates(t) == before);
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
// Each correspondence once: what a metric undoes does not depend on it, but for the places of
// vertices, which exact metrics share with integer coordinates only.
using Cases =
    ::testing::Types<With<Exact, IT::Integer_coordinates>, With<Exact, IT::Signposts>,
                     With<Rounding, IT::No_correspondence>, With<Rounding, IT::Explicit_crossings>>;
TYPED_TEST_SUITE(Refused_moves_of, Cases);

TYPED_TEST(Refused_moves_of, any_kind_change_nothing) {
  std::minstd_rand random(5);
  std::map<std::string, int> refused, done;
  for (int start = 0; start < 70; ++start) {
    TypeParam t(start % 2 == 0 ? meshes::rough_grid(3, 1).input() : meshes::box(2, 2, 1).input());
    std::uint64_t before = checksums::checksum(t);
    for (int i = 0; i < 200; ++i) {
      const auto [kind, status] = move_at_random(t, random);
      const std::uint64_t now = checksums::checksum(t);
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

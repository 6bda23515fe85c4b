// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

// A move that an observer refuses leaves the places of vertices and edges as they were.

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

// where edges run on the input, by number
template <class T>
std::vector<std::uint32_t> coordinates(const T& t) {
  std::vector<std::uint32_t> s;
  const IT::Integer_coordinates& c = *t.places();
  for (const auto e : edges(t.mesh())) {
    s.push_back(static_cast<std::uint32_t>(c.normal_coordinate(t.index(e))));
    s.push_back(c.roundabout(2 * t.index(e)));
    s.push_back(c.roundabout(2 * t.index(e) + 1));
  }
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

} // namespace

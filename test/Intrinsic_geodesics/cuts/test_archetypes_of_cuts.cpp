// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_geodesics/cuts/flip_to_geodesic_cut.h>

#include "operator_test_meshes.h"
#include "triangulation_archetypes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

// The concepts list all that cuts require of a triangulation: archetypes have nothing else, and get
// the cuts of the triangulation that they wrap.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

archetypes::Wrapped torus() {
  return archetypes::Wrapped(operator_test::rough_torus(7, 0.3, 1).input());
}

template <class Triangulation, class Marks>
std::vector<char> marks_of(const Triangulation& t, const Marks& marks) {
  std::vector<char> result;
  for (const auto e : edges(t.mesh())) result.push_back(get(marks, e) ? 1 : 0);
  return result;
}

} // namespace

TEST(Archetypes_of_cuts, Numbered_triangulation_is_enough_for_cuts_to_disks) {
  archetypes::Wrapped all = torus();
  const archetypes::Numbered_triangulation t(all);
  const std::vector through{t.numbers().vertex_at(5)};
  const auto cut = IT::cut_to_disk(t, through);
  const auto expected = IT::cut_to_disk(all, through);
  EXPECT_EQ(marks_of(t, cut), marks_of(all, expected));
  const IT::Opened_surface opened = IT::cut_open(t, cut);
  EXPECT_EQ(opened.gluing.origin, IT::cut_open(all, expected).gluing.origin);
  EXPECT_EQ(opened.gluing.glue, IT::cut_open(all, expected).gluing.glue);
  EXPECT_EQ(IT::homology_generators(t), IT::homology_generators(all));
}

TEST(Archetypes_of_cuts, Corresponding_triangulation_is_enough_for_pieces_of_the_mesh) {
  archetypes::Wrapped all = torus();
  const archetypes::Corresponding_triangulation t(all);
  const IT::Cut_surface pieces = IT::cut_along(t, IT::cut_to_disk(t)),
                        expected = IT::cut_along(all, IT::cut_to_disk(all));
  EXPECT_EQ(pieces.input_triangle, expected.input_triangle);
  EXPECT_EQ(pieces.vertices.size(), expected.vertices.size());
}

TEST(Archetypes_of_cuts, Geodesic_triangulation_is_enough_for_geodesic_cuts) {
  archetypes::Wrapped all = torus(), hidden = torus();
  archetypes::Geodesic_triangulation t(hidden);
  const auto cut = IT::flip_to_geodesic_cut(t);
  const auto expected = IT::flip_to_geodesic_cut(all);
  EXPECT_EQ(cut.shortening.status, IT::Status::done);
  EXPECT_EQ(marks_of(t, cut.edges), marks_of(all, expected.edges));
}

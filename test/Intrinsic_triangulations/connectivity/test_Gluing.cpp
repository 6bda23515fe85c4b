// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include "gallery.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>

#include <gtest/gtest.h>

#include <string>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

void expect_error(const IT::Gluing& g, IT::Element_kind kind, std::size_t index,
                  const std::string& part) {
  refusals::expect_invalid([&] { IT::validate(g); }, kind, index, {part});
}

IT::Gluing good() { return gallery::tetrahedron().gluing; }

} // namespace

TEST(Gluing, entries_hold_a_halfedge_and_a_direction) {
  EXPECT_FALSE(IT::Gluing::is_reversed(7));
  EXPECT_TRUE(IT::Gluing::is_reversed(IT::Gluing::reversed(7)));
  EXPECT_EQ(IT::Gluing::partner(IT::Gluing::reversed(7)), 7U);
  EXPECT_EQ(IT::Gluing::partner(7), 7U);
  EXPECT_FALSE(IT::Gluing::is_reversed(IT::Gluing::none));
  EXPECT_EQ(IT::Gluing::partner(IT::Gluing::none), IT::Gluing::none);
}

TEST(Gluing, next_goes_around_a_face) {
  EXPECT_EQ(IT::Gluing::next(3), 4U);
  EXPECT_EQ(IT::Gluing::next(4), 5U);
  EXPECT_EQ(IT::Gluing::next(5), 3U);
}

TEST(Gluing, whole_gallery_is_valid) {
  for (const gallery::Surface& s : gallery::all()) {
    EXPECT_NO_THROW(IT::validate(s.gluing)) << s.name;
    EXPECT_EQ(s.gluing.number_of_faces(), s.expected.faces) << s.name;
    EXPECT_EQ(s.gluing.number_of_vertices, s.expected.vertices) << s.name;
  }
}

TEST(Gluing, empty_gluing_is_valid) { EXPECT_NO_THROW(IT::validate(IT::Gluing())); }

TEST(Gluing, comes_back_from_a_gluing_map) {
  for (const gallery::Surface& s : gallery::all()) {
    const IT::Gluing g = IT::gluing_from_map(IT::Gluing_map(s.gluing));
    EXPECT_EQ(g.number_of_vertices, s.gluing.number_of_vertices) << s.name;
    EXPECT_EQ(g.origin, s.gluing.origin) << s.name;
    EXPECT_EQ(g.glue, s.gluing.glue) << s.name;
  }
}

TEST(Gluing_errors, arrays_of_wrong_size_are_refused) {
  IT::Gluing g = good();
  g.origin.pop_back();
  expect_error(g, IT::Element_kind::none, 0, "11 origins and 12 gluings");
  g = good();
  g.glue.resize(9);
  expect_error(g, IT::Element_kind::none, 0, "12 origins and 9 gluings");
}

TEST(Gluing_errors, vertex_out_of_range_is_named) {
  IT::Gluing g = good();
  g.origin[0] = 4;
  expect_error(g, IT::Element_kind::halfedge, 0, "side 0 of face 0) starts from vertex 4");
}

TEST(Gluing_errors, halfedge_glued_to_itself_or_to_nothing_is_named) {
  IT::Gluing g = good();
  g.glue[0] = 0;
  expect_error(g, IT::Element_kind::halfedge, 0, "glued to itself");
  g = good();
  g.glue[5] = 12;
  const std::uint32_t before = IT::Gluing::partner(good().glue[5]);
  g.glue[before] = before < 5 ? IT::Gluing::none : g.glue[before];
  expect_error(g, IT::Element_kind::halfedge, 5, "glued to halfedge 12, which does not exist");
}

TEST(Gluing_errors, gluing_that_is_not_mutual_is_named) {
  IT::Gluing g = good();
  g.glue[g.glue[0]] = IT::Gluing::none;
  expect_error(g, IT::Element_kind::halfedge, 0, "which is not glued back to it");
  g = good();
  g.glue[0] = IT::Gluing::reversed(g.glue[0]);
  expect_error(g, IT::Element_kind::halfedge, 0, "which is not glued back to it");
}

TEST(Gluing_errors, glued_sides_with_different_ends_are_named) {
  IT::Gluing g = good();
  const std::uint32_t p = g.glue[0];
  g.glue[0] = IT::Gluing::reversed(p);
  g.glue[p] = IT::Gluing::reversed(0);
  expect_error(g, IT::Element_kind::halfedge, 0, "have different end vertices");
}

TEST(Gluing_errors, gluing_against_vertices_of_the_second_end_is_found_too) {
  IT::Gluing g; // sides 0 and 3 share one end only
  g.number_of_vertices = 5;
  g.origin = {0, 1, 2, 3, 0, 4};
  g.glue.assign(6, IT::Gluing::none);
  g.glue[0] = 3;
  g.glue[3] = 0;
  expect_error(g, IT::Element_kind::halfedge, 3, "have different end vertices");
}

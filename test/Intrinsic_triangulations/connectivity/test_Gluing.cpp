// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include "gallery.h"
#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

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

TEST(Gluing, names_the_first_side_that_is_wrong) {
  const auto expect_error = [](IT::Element_kind kind, std::size_t index, const std::string& part,
                               const auto& spoil) {
    IT::Gluing g = gallery::tetrahedron().gluing;
    spoil(g);
    refusals::expect_invalid([&] { IT::validate(g); }, kind, index, {part});
  };
  using IT::Element_kind, IT::Gluing;
  expect_error(Element_kind::none, 0, "11 origins and 12 gluings",
               [](Gluing& g) { g.origin.pop_back(); });
  expect_error(Element_kind::none, 0, "12 origins and 9 gluings",
               [](Gluing& g) { g.glue.resize(9); });
  expect_error(Element_kind::halfedge, 0, "side 0 of face 0) starts from vertex 4",
               [](Gluing& g) { g.origin[0] = 4; });
  expect_error(Element_kind::halfedge, 0, "glued to itself", [](Gluing& g) { g.glue[0] = 0; });
  expect_error(Element_kind::halfedge, 5, "glued to halfedge 12, which does not exist",
               [](Gluing& g) {
                 const std::uint32_t before = Gluing::partner(g.glue[5]);
                 g.glue[5] = 12;
                 if (before < 5) g.glue[before] = Gluing::none;
               });
  expect_error(Element_kind::halfedge, 0, "which is not glued back to it",
               [](Gluing& g) { g.glue[g.glue[0]] = Gluing::none; });
  expect_error(Element_kind::halfedge, 0, "which is not glued back to it",
               [](Gluing& g) { g.glue[0] = Gluing::reversed(g.glue[0]); });
  expect_error(Element_kind::halfedge, 0, "have different end vertices", [](Gluing& g) {
    const std::uint32_t p = g.glue[0];
    g.glue[0] = Gluing::reversed(p);
    g.glue[p] = Gluing::reversed(0);
  });
  // sides 0 and 3 share one end only
  expect_error(Element_kind::halfedge, 3, "have different end vertices", [](Gluing& g) {
    g = {5, {0, 1, 2, 3, 0, 4}, std::vector<std::uint32_t>(6, Gluing::none)};
    g.glue[0] = 3;
    g.glue[3] = 0;
  });
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/count_elements.h>

#include "gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

// Oracle: the known properties of the surfaces, and the sides without a neighbour.
TEST(count_elements, knows_all_surfaces_of_the_gallery) {
  for (const gallery::Surface& s : gallery::all()) {
    SCOPED_TRACE(s.name);
    const IT::Element_counts n = IT::count_elements(IT::Gluing_map(s.gluing));
    EXPECT_EQ(n.vertices, s.expected.vertices);
    EXPECT_EQ(n.edges, s.expected.edges);
    EXPECT_EQ(n.faces, s.expected.faces);
    EXPECT_EQ(n.boundary_loops, s.expected.boundary_loops);
    EXPECT_EQ(n.components, s.expected.components);
    EXPECT_EQ(n.nonmanifold_vertices, s.expected.nonmanifold_vertices);
    EXPECT_EQ(n.isolated_vertices, s.expected.isolated_vertices);
    const auto open = std::ranges::count(s.gluing.glue, IT::Gluing::none);
    EXPECT_EQ(n.boundary_edges, static_cast<std::size_t>(open));
    EXPECT_EQ(n.genus, s.expected.is_orientable ? std::optional<std::size_t>(s.expected.genus)
                                                : std::nullopt);
  }
}

} // namespace

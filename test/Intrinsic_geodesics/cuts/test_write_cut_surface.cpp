// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/write_cut_surface.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include "meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <span>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

struct Written : ::testing::Test {
  meshes::Mesh m = meshes::sphere(3);
  IT::Corresponding_triangulation t{m.input()};
  IT::Cut_surface s = cut();
  std::vector<std::array<double, 3>> points = IT::positions(s, m.points);

  IT::Cut_surface cut() {
    std::vector<double> z;
    for (const meshes::Point& p : m.points) z.push_back(p[2]);
    return IT::cut_along(t, IT::insert_isolines(t, IT::isolines(t, z, std::array{-0.3, 0.2})));
  }
  std::string text(const std::string& extension, std::span<const std::array<double, 2>> uv = {}) {
    std::ostringstream out;
    IT::write_cut_surface(out, extension, s, points, uv);
    return out.str();
  }
};

TEST_F(Written, reads_back_as_the_same_triangles_from_ply_obj_and_off) {
  for (const char* extension : {"ply", "obj", "off"}) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / (std::string("cut_surface.") + extension);
    IT::write_cut_surface(path, s, points);
    const IT::Triangle_soup soup = IT::read_triangle_soup(path);
    EXPECT_EQ(soup.points, points) << extension;
    ASSERT_EQ(soup.triangles.size(), s.input_face.size());
    for (std::size_t f = 0; f < soup.triangles.size(); ++f)
      EXPECT_TRUE(std::ranges::equal(soup.triangles[f], s.face(f)));
    std::filesystem::remove(path);
  }
}

TEST_F(Written, has_labels_in_ply_and_vtp_groups_in_obj_and_colours_in_off) {
  for (const char* name : {"original_vertex", "input_vertex", "input_edge", "input_face",
                           "component", "vertex_indices", "curve"})
    EXPECT_NE(text(".PLY").find(name), std::string::npos) << name;
  for (const char* name : {"original_vertex", "input_vertex", "component", "input_face"})
    EXPECT_NE(text("vtp").find(std::string("Name=\"") + name), std::string::npos) << name;
  for (std::uint32_t c = 0; c < s.number_of_components; ++c)
    EXPECT_NE(text("obj").find("g component_" + std::to_string(c) + "\n"), std::string::npos);
  std::istringstream off(text("off"));
  std::string line;
  std::set<std::string> colors;
  for (std::size_t i = 0; std::getline(off, line); ++i)
    if (i >= 2 + points.size()) {
      std::istringstream words(line);
      std::string n, a, b, c, color;
      words >> n >> a >> b >> c;
      std::getline(words, color);
      colors.insert(color);
    }
  EXPECT_EQ(colors.size(), s.number_of_components);
}

TEST_F(Written, has_a_place_in_the_plane_for_each_corner) {
  std::vector<std::array<double, 2>> uv;
  for (const std::array<double, 3>& w : s.weights) uv.push_back({w[1], w[2]});
  const std::string obj = text("obj", uv);
  EXPECT_NE(obj.find("vt "), std::string::npos);
  EXPECT_NE(obj.find("f " + std::to_string(s.face(0)[0] + 1) + "/1 "), std::string::npos);
  EXPECT_NE(text("ply", uv).find("property list uchar double texcoord"), std::string::npos);
}

TEST_F(Written, is_drawn_with_each_cut_and_edge_of_the_mesh_once) {
  const IT::Common_subdivision drawn = IT::drawn_as_subdivision(s);
  std::size_t cuts = 0, all = 0;
  IT::for_each_subdivision_edge(
      drawn, [&](std::uint32_t, std::uint32_t, const IT::Common_subdivision::Side& side) {
        ++all;
        if (side.intrinsic_edge != IT::Common_subdivision::none) ++cuts;
      });
  EXPECT_EQ(cuts, 2 * s.seams.size()); // on either side
  EXPECT_EQ(all, (3 * s.input_face.size() + cuts) / 2);
  EXPECT_EQ(drawn.number_of_edges(), all);
}

TEST_F(Written, refuses_other_formats_and_points_or_places_that_are_too_few) {
  EXPECT_THROW(text("stl"), IT::Invalid_input);
  EXPECT_THROW(text("obj", std::vector<std::array<double, 2>>(3)), IT::Invalid_input);
  points.pop_back();
  EXPECT_THROW(text("ply"), IT::Invalid_input);
}

} // namespace

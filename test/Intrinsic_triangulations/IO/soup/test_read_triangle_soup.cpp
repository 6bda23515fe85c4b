// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/read_polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>

#include "refusals.h"

#include <gtest/gtest.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

namespace {

using CGAL::Intrinsic_triangulations::Element_kind;
using CGAL::Intrinsic_triangulations::File_faces;
using CGAL::Intrinsic_triangulations::has_extension;
using CGAL::Intrinsic_triangulations::Invalid_input;
using CGAL::Intrinsic_triangulations::mesh_extensions;
using CGAL::Intrinsic_triangulations::Nonplanar_polygons;
using CGAL::Intrinsic_triangulations::point_set_extensions;
using CGAL::Intrinsic_triangulations::Polygon_soup;
using CGAL::Intrinsic_triangulations::read_polygon_soup;
using CGAL::Intrinsic_triangulations::read_triangle_soup;
using CGAL::Intrinsic_triangulations::Triangle_soup;

/// Whatever is written to a file descriptor while it lives.
class Written {
public:
  explicit Written(int descriptor)
      : descriptor_(descriptor), original_(dup(descriptor)), file_(std::tmpfile()) {
    std::cout.flush();
    std::fflush(nullptr);
    dup2(fileno(file_), descriptor_);
  }
  ~Written() {
    std::fflush(nullptr);
    dup2(original_, descriptor_);
    close(original_);
    std::fclose(file_);
  }
  Written(const Written&) = delete;
  Written& operator=(const Written&) = delete;

  std::string text() const {
    std::cout.flush();
    std::fflush(nullptr);
    std::rewind(file_);
    std::string result;
    for (int c = std::fgetc(file_); c != EOF; c = std::fgetc(file_))
      result.push_back(static_cast<char>(c));
    return result;
  }

private:
  int descriptor_, original_;
  std::FILE* file_;
};

// Each test has a directory of its own, removed at the end; nothing may be printed.
class Read_triangle_soup : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = std::filesystem::temp_directory_path() /
                 (std::string("read_triangle_soup_") + test->name());
    std::filesystem::create_directories(directory_);
  }

  void TearDown() override {
    EXPECT_EQ(output_.text(), "");
    EXPECT_EQ(errors_.text(), "");
    std::filesystem::remove_all(directory_);
  }

  std::string file(const std::string& name, const std::string& content) const {
    const std::string path = (directory_ / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  Triangle_soup read(const std::string& name, const std::string& content) const {
    return read_triangle_soup(file(name, content));
  }

  // Expects an error on this element whose message holds the file name and all the given parts.
  void expect_error(const std::string& path, Element_kind kind, std::size_t index,
                    const std::vector<std::string>& parts) const {
    std::vector<std::string> all = parts;
    all.push_back(std::filesystem::path(path).filename().string());
    refusals::expect_invalid([&] { read_triangle_soup(path); }, kind, index, all);
  }

  void expect_error_in(const std::string& name, const std::string& content, Element_kind kind,
                       std::size_t index, const std::vector<std::string>& parts) const {
    expect_error(file(name, content), kind, index, parts);
  }

  std::filesystem::path directory_;
  Written output_{STDOUT_FILENO}, errors_{STDERR_FILENO};
};

const std::string tetrahedron_off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::vector<std::array<std::uint32_t, 3>> tetrahedron_faces{
    {0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

template <class Number>
void append(std::string& out, Number value, std::endian order) {
  char bytes[sizeof(Number)];
  std::memcpy(bytes, &value, sizeof(Number));
  if (order != std::endian::native) std::reverse(bytes, bytes + sizeof(Number));
  out.append(bytes, sizeof(Number));
}

std::string binary_stl(const std::vector<std::array<float, 9>>& facets, std::uint32_t announced) {
  std::string out = "solid but binary";
  out.resize(80, ' ');
  append(out, announced, std::endian::little);
  for (const auto& facet : facets) {
    for (int k = 0; k < 3; ++k) append(out, 0.0F, std::endian::little);
    for (const float x : facet) append(out, x, std::endian::little);
    append(out, std::uint16_t(0), std::endian::little);
  }
  return out;
}

std::string tetrahedron_ply(std::endian order, std::int32_t first_index = 0) {
  std::string out = std::string("ply\nformat binary_") +
                    (order == std::endian::little ? "little" : "big") +
                    "_endian 1.0\ncomment made by a test\nelement vertex 4\nproperty double x\n"
                    "property float y\nproperty uchar red\nproperty short z\nelement face 4\n"
                    "property list uint int vertex_indices\nproperty uchar red\nend_header\n";
  const int points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& p : points) {
    append(out, double(p[0]), order);
    append(out, float(p[1]), order);
    append(out, std::uint8_t(7), order);
    append(out, std::int16_t(p[2]), order);
  }
  for (const auto& t : tetrahedron_faces) {
    append(out, std::uint32_t(3), order);
    for (const std::uint32_t v : t)
      append(out, v == 0 ? first_index : static_cast<std::int32_t>(v), order);
    append(out, std::uint8_t(9), order);
  }
  return out;
}

// Twice the signed area of the projection to the plane z = 0.
double doubled_area(const Triangle_soup& s, const std::array<std::uint32_t, 3>& t) {
  const auto &p = s.points[t[0]], &q = s.points[t[1]], &r = s.points[t[2]];
  return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
}

// The greatest number of triangles around one pair of vertices.
std::size_t greatest_edge_degree(const Triangle_soup& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> degree;
  std::size_t greatest = 0;
  for (const auto& t : s.triangles)
    for (unsigned k = 0; k < 3; ++k)
      greatest = std::max(greatest, ++degree[std::minmax({t[k], t[(k + 1) % 3]})]);
  return greatest;
}

TEST_F(Read_triangle_soup, every_text_format_gives_the_same_tetrahedron) {
  const std::map<std::string, std::string> files{
      {"t.off", tetrahedron_off},
      {"upper_case.OFF", tetrahedron_off},
      {"comments.off", "# made by hand\nOFF 4 4 # counts\n 6\r\n\n0 0 0\r\n1 0 0 # x\n+0 1. 0\n"
                       "0 0 1e0\n3 0 2 1 255 0 0\n3 0 1 3\n\n3 1 2 3 # last but one\n3 2 0 3"},
      {"prefix.off", "STCN4OFF\n4 4 0\n0 0 0 2 9 9 9\n2 0 0 2\n0 2 0 2\n0 0 2 2\n"
                     "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"},
      {"dimension.off", "nOFF 3\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                        "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"},
      {"t.obj",
       "# c\nmtllib a.mtl\nv 0 0 0 0.5 0.5 0.5\nv 1 0 0\nf 1 3 2\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
       "v 0 0 1\ng a\nf 1/1/1 2//1 4/1\nf -3 -2 -1\nf 3 \\\n 1 4\n"},
      {"t.ply",
       "ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement vertex 4\r\nproperty float x\r\n"
       "property float y\r\nproperty float z\r\nelement face 4\r\n"
       "property list uchar int vertex_index\r\nelement edge 1\r\nproperty int a\r\n"
       "end_header\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n3 0 2 1\r\n3 0 1 3\r\n"
       "3 1 2 3\r\n3 2 0 3\r\n5\r\n"},
      {"t.ts",
       "GOCAD TSurf 1\nHEADER {\nname:t\n}\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\n"
       "VRTX 3 0 1 0\nVRTX 4 0 0 1\nTRGL 1 3 2\nTRGL 1 2 4\nTRGL 2 3 4\nTRGL 3 1 4\nEND\n"}};
  for (const auto& [name, content] : files) {
    const Triangle_soup s = read(name, content);
    EXPECT_EQ(s.triangles, tetrahedron_faces) << name;
    ASSERT_EQ(s.points.size(), 4U) << name;
    EXPECT_EQ(s.points[3], (std::array<double, 3>{0, 0, 1})) << name;
    EXPECT_TRUE(s.polygon_of_triangle.empty()) << name;
    EXPECT_EQ(s.input_faces, 4U) << name;
    EXPECT_EQ(s.triangulated_polygons, 0U) << name;
  }
}

// What each format allows, programs write, or editors add.
TEST_F(Read_triangle_soup, unusual_text_gives_the_same_tetrahedron) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n", bom = "\xef\xbb\xbf";
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 4\nproperty list uchar int vertex_index\n"
      "end_header\n" +
      points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const std::string off = tetrahedron_off;
  std::map<std::string, std::string> files{
      {"several_lines.off", "OFF\n4 4 0\n" + points +
                                "3\n0 2 1\n3 0\n1\n3 # two lines above\n"
                                "3 1 2 3\n3 2\n# a comment\n0 3\n"},
      {"one_line.off", "OFF 4 4 0\n" + points + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"},
      {"mixed_colors.off",
       "OFF 4 4 0\n" + points + "3 0 2 1 9 9 9\n3 0\n1 3\n3 1 2 3 7\n3 2 0 3\n"},
      {"unknown.obj", "vendor 1 2 3\n" + obj + "#\nanother_one\n"},
      {"mark.off", bom + off},
      {"mark.obj", bom + obj},
      {"mark.ply", bom + ply}};
  for (const auto& [name, text] : std::map<std::string, std::string>{
           {"off", off}, {"obj", obj}, {"ply", ply}, {"comment.obj", "# v 9 9 9\n" + obj}}) {
    std::string old = text;
    std::replace(old.begin(), old.end(), '\n', '\r');
    files["old_mac." + name] = old;
    files["mark_and_old_mac." + name] = bom + old;
  }
  for (const auto& [name, content] : files) {
    const Triangle_soup s = read(name, content);
    EXPECT_EQ(s.triangles, tetrahedron_faces) << name;
    ASSERT_EQ(s.points.size(), 4U) << name;
    EXPECT_EQ(s.points[3], (std::array<double, 3>{0, 0, 1})) << name;
  }
}

TEST_F(Read_triangle_soup, text_stl_may_be_in_upper_case_with_a_mark_and_any_line_ends) {
  const std::string stl = "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                          "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n";
  std::string upper = stl, old = stl;
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::replace(old.begin(), old.end(), '\n', '\r');
  for (const std::string& text : {stl, upper, old, "\xef\xbb\xbf" + stl, "\xef\xbb\xbf" + upper}) {
    const Triangle_soup s = read("t.stl", text);
    ASSERT_EQ(s.triangles.size(), 1U);
    EXPECT_EQ(s.points[2], (std::array<double, 3>{0, 1, 0}));
  }
}

TEST_F(Read_triangle_soup, old_line_ends_count_lines) {
  expect_error_in("t.off", "OFF\r3 1 0\r0 0 0\r1 0 nan\r0 1 0\r3 0 1 2\r", Element_kind::vertex, 1,
                  {":4:", "vertex 1"});
}

// A vertex that a line lacks is not taken from the next one.
TEST_F(Read_triangle_soup, faces_over_several_lines_must_fit) {
  const std::string start = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
  for (const std::string rest :
       {"3 0 1\n3 0 1 3\n3 1 2 3\n", "3 0 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
        "3 0 1\n3\n1 2 3\n3 1 2 3\n", "3 0 1\n", "3 0 1\n9\n3 0 1 2\n3 0 1 3\n"})
    expect_error_in("f.off", start + rest, Element_kind::face, 0,
                    {":7:", "face 0 of 3 has only 2 of 3 vertices"});
}

TEST_F(Read_triangle_soup, text_without_line_ends_is_refused_in_bounded_memory) {
  for (const std::string extension : {"off", "obj", "ply", "stl", "ts"}) {
    const std::string start = extension == "stl" ? "solid " : "";
    const std::string path = file("sparse." + extension, start);
    std::filesystem::resize_file(path, std::uintmax_t(1) << 28);
    expect_error(path, Element_kind::none, 0, {":1:", "64 MiB", "line ends"});
  }
}

TEST_F(Read_triangle_soup, messages_show_no_more_than_can_be_read) {
  const std::string nul(1, '\0'), escape = "\x1b[31m", lengthy(5000, 'x');
  for (const std::string& word : {"a" + nul + "b", "a" + escape, lengthy, nul + lengthy}) {
    const std::map<std::string, std::string> files{
        {"w.off", word + "\n4 4 0\n"},
        {"f.obj", "v 0 0 0\nf 1 " + word + " 2\n"},
        {"format.ply", "ply\nformat " + word + " 1.0\n"},
        {"type.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty " + word + " x\n"},
        {"name.ply", "ply\nformat ascii 1.0\nelement " + word + " many\n"},
        {"item.ply",
         "ply\nformat ascii 1.0\nelement " + word + " 1\nproperty int x\nend_header\nz\n"},
        {"t.stl", word}};
    for (const auto& [name, content] : files) try {
        read(name, content);
        ADD_FAILURE() << name;
      } catch (const Invalid_input& error) {
        const std::string message(error.what());
        EXPECT_LT(message.size(), directory_.string().size() + 250) << name;
        EXPECT_TRUE(std::all_of(message.begin(), message.end(),
                                [](char c) { return c >= ' ' && c <= '~'; }))
            << name << message;
        EXPECT_GT(message.size(), directory_.string().size() + 40) << name; // no NUL cuts it
      }
  }
}

TEST_F(Read_triangle_soup, binary_ply_of_both_byte_orders_gives_the_same_tetrahedron) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Triangle_soup s = read("t.ply", tetrahedron_ply(order));
    EXPECT_EQ(s.triangles, tetrahedron_faces);
    EXPECT_EQ(s.points[3], (std::array<double, 3>{0, 0, 1}));
  }
}

TEST_F(Read_triangle_soup, binary_off_is_read) {
  std::string content = "OFF BINARY\n";
  const auto integer = [&](std::int32_t i) { append(content, i, std::endian::big); };
  for (const int i : {4, 4, 0}) integer(i);
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F})
    append(content, x, std::endian::big);
  for (const auto& t : tetrahedron_faces) {
    integer(3);
    for (const std::uint32_t v : t) integer(static_cast<std::int32_t>(v));
    integer(0);
  }
  const Triangle_soup s = read("t.off", content);
  EXPECT_EQ(s.triangles, tetrahedron_faces);
  EXPECT_EQ(s.points[2], (std::array<double, 3>{0, 1, 0}));
  expect_error_in("short.off", content.substr(0, content.size() - 6), Element_kind::face, 3,
                  {"face 3 of the 4 faces", "truncated"});
}

TEST_F(Read_triangle_soup, stl_merges_equal_corners_in_the_order_of_first_occurrence) {
  const std::string text =
      "solid a facet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
      "vertex 0.1 1 0\nendloop\nendfacet\nfacet normal 0 0 1\nouter loop\n"
      "vertex 1 0 0\nvertex 1 1 0\nvertex 0.1 1 -0\nendloop\nendfacet\n"
      "endsolid a\n";
  const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {1, 3, 2}};
  const Triangle_soup s = read("t.stl", text);
  EXPECT_EQ(s.triangles, expected);
  EXPECT_EQ(s.points.size(), 4U);
  EXPECT_EQ(s.points[2][0], 0.1);
  const Triangle_soup b =
      read("b.stl", binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0, 0, 1, 0}}, 2));
  EXPECT_EQ(b.triangles, expected);
  EXPECT_EQ(b.points.size(), 4U);
}

TEST_F(Read_triangle_soup, many_corners_of_stl_are_merged_as_a_map_does_it) {
  std::mt19937 random(3);
  std::vector<std::array<float, 9>> facets(3000);
  std::map<std::array<double, 3>, std::uint32_t> number; // which takes zeros of both signs as one
  std::vector<std::uint32_t> corners;
  for (auto& facet : facets) {
    for (float& x : facet) x = static_cast<float>(static_cast<int>(random() % 21) - 10) * 0.1F;
    facet[random() % 9] = -0.0F;
    for (std::size_t k = 0; k < 9; k += 3)
      corners.push_back(number
                            .try_emplace({facet[k], facet[k + 1], facet[k + 2]},
                                         static_cast<std::uint32_t>(number.size()))
                            .first->second);
  }
  const Triangle_soup s = read("m.stl", binary_stl(facets, 3000));
  EXPECT_EQ(s.points.size(), number.size());
  for (const auto& [place, v] : number) EXPECT_EQ(s.points[v], place);
  std::vector<std::uint32_t> expected, found;
  for (std::size_t f = 0; f < facets.size(); ++f) { // without those that are lines
    const std::array<std::uint32_t, 3> t{corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      expected.insert(expected.end(), t.begin(), t.end());
  }
  for (const auto& t : s.triangles) found.insert(found.end(), t.begin(), t.end());
  EXPECT_EQ(found, expected);
}

TEST_F(Read_triangle_soup, coordinates_are_the_doubles_nearest_to_the_text) {
  const Triangle_soup s =
      read("t.off", "OFF\n3 1 0\n0.1 1e-160 1e120\n"
                    "0.10000000000000000555 2.2250738585072011e-308 -3e-400\n"
                    "123456789.123456789123456789 1 9007199254740993\n3 0 1 2\n");
  EXPECT_EQ(s.points[0], (std::array<double, 3>{0.1, 1e-160, 1e120}));
  EXPECT_EQ(s.points[1], (std::array<double, 3>{0.1, 2.2250738585072011e-308, 0}));
  EXPECT_EQ(s.points[2],
            (std::array<double, 3>{123456789.123456789123456789, 1, 9007199254740992.0}));
  const Triangle_soup o = read("t.obj", "v 0.1 0.2 0.3\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(o.points[0], (std::array<double, 3>{0.1, 0.2, 0.3}));
}

TEST_F(Read_triangle_soup, has_extension_compares_the_last_extension_in_any_letter_case) {
  for (const std::string name : {"m.off", "a.b/M.Off", "x.ply.OBJ", ".off.ts"})
    EXPECT_TRUE(has_extension(name, mesh_extensions)) << name;
  for (const std::string name : {"off", "m.offx", "m.xyz", "m.off/n", "m.off ", ""})
    EXPECT_FALSE(has_extension(name, mesh_extensions)) << name;
  EXPECT_TRUE(has_extension("p.XYZ", point_set_extensions));
}

TEST_F(Read_triangle_soup, files_that_cannot_be_opened_are_named) {
  expect_error((directory_ / "absent.off").string(), Element_kind::none, 0, {"does not exist"});
  expect_error(directory_.string(), Element_kind::none, 0, {"is a directory"});
  expect_error_in("empty.off", "", Element_kind::none, 0, {"the file is empty"});
  expect_error_in("mesh.txt", tetrahedron_off, Element_kind::none, 0,
                  {"\"txt\" is not supported", ".off"});
  expect_error_in("mesh", tetrahedron_off, Element_kind::none, 0, {"is not supported"});
  const std::string locked = file("locked.off", tetrahedron_off);
  std::filesystem::permissions(locked, std::filesystem::perms::none);
  if (!std::ifstream(locked)) // an administrator reads everything
    expect_error(locked, Element_kind::none, 0, {"permissions"});
}

TEST_F(Read_triangle_soup, truncated_off_names_the_first_missing_element) {
  std::string vertices = "OFF\n100 1 0\n";
  for (int i = 0; i < 37; ++i) vertices += "0 0 1\n";
  expect_error_in("v.off", vertices, Element_kind::vertex, 37,
                  {"before vertex 37 of the 100 vertices", "truncated", ":39:"});
  expect_error_in("p.off", vertices + "0 0", Element_kind::vertex, 37,
                  {"vertex 37 of 100 has only 2 coordinates", ":40:"});
  const std::string cut = tetrahedron_off.substr(0, tetrahedron_off.size() - 8);
  expect_error_in("f.off", cut, Element_kind::face, 3, {"before face 3 of the 4 faces"});
  expect_error_in("i.off", tetrahedron_off.substr(0, tetrahedron_off.size() - 3),
                  Element_kind::face, 3, {":10:", "face 3 of 4 has only 2 of 3 vertices"});
  expect_error_in("h.off", "OFF\n", Element_kind::none, 0, {"number of vertices"});
  expect_error_in("g.off", "OFF\n4 -1 0\n", Element_kind::none, 0, {"number of faces", ":2:"});
}

TEST_F(Read_triangle_soup, counts_in_a_header_do_not_claim_memory) {
  for (const std::string count : {"4000000000", "9000000000000000000"}) {
    expect_error_in("v.off", "OFF\n" + count + " 1 0\n0 0 0\n", Element_kind::vertex, 1,
                    {"vertex 1 of the " + count});
    expect_error_in("f.off", "OFF\n3 " + count + " 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                    Element_kind::face, 1, {"face 1 of the " + count});
    const std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex " + count +
                               "\nproperty float x\nproperty float y\nproperty float z\n";
    expect_error_in("v.ply", header + "end_header\n123456789012", Element_kind::vertex, 1,
                    {"vertex 1 of the " + count, "truncated"});
    expect_error_in("e.ply",
                    "ply\nformat ascii 1.0\nelement blank " + count + "\nelement face " + count +
                        "\nproperty list uint int vertex_indices\n"
                        "end_header\n4000000000 1 2 3\n",
                    Element_kind::face, 0, {"face 0 of the " + count});
  }
  expect_error_in("n.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
                  Element_kind::face, 0, {"has only 3 of 4000000000 vertices", ":6:"});
  expect_error_in("b.stl",
                  binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, 4000000000U).replace(0, 5, "xxxxx"),
                  Element_kind::face, 1, {"facet 1 of the 4000000000", "truncated"});
}

TEST_F(Read_triangle_soup, coordinates_that_are_not_finite_name_the_vertex) {
  for (const std::string word : {"nan", "-nan", "inf", "-Infinity", "1e999"}) {
    expect_error_in("t.off", "OFF\n3 1 0\n0 0 0\n1 " + word + " 0\n0 1 0\n3 0 1 2\n",
                    Element_kind::vertex, 1, {":4:", "vertex 1", "not a finite number"});
    expect_error_in("t.obj", "v 0 0 0\nv 0 0 " + word + "\nf 1 2 2\n", Element_kind::vertex, 1,
                    {":2:", "vertex 1", "not a finite number"});
    expect_error_in("t.ply",
                    "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                    "property float z\nend_header\n0 0 " +
                        word + "\n",
                    Element_kind::vertex, 0, {":8:", "vertex 0", "not a finite number"});
    expect_error_in("t.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 " + word + "\n",
                    Element_kind::face, 0, {":4:", "facet 0", "not a finite number"});
  }
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_error_in("b.stl", binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, nan}}, 1), Element_kind::face, 0,
                  {"facet 0", "not a finite number"});
  std::string ply = tetrahedron_ply(std::endian::little);
  const double infinity = std::numeric_limits<double>::infinity();
  std::memcpy(&ply[ply.find("end_header\n") + 11 + 15], &infinity, 8); // x of vertex 1
  expect_error_in("b.ply", ply, Element_kind::vertex, 1, {"vertex 1", "not a finite number"});
}

TEST_F(Read_triangle_soup, faces_that_are_no_faces_are_named) {
  const std::string start = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n";
  expect_error_in("r.off", start + "3 0 1 4\n", Element_kind::face, 1,
                  {":8:", "face 1 refers to vertex 4", "from 0 to 3"});
  expect_error_in("n.off", start + "3 0 -1 2\n", Element_kind::face, 1,
                  {":8:", "face 1 refers to vertex -1"});
  expect_error_in("s.off", start + "2 0 1\n", Element_kind::face, 1,
                  {":8:", "face 1 has 2 vertices", "remove it"});
  expect_error_in("z.off", start + "0\n", Element_kind::face, 1, {"face 1 has 0 vertices"});
  for (const std::string pinched : {"6 0 1 2 0 3 2", "10 0 1 2 3 0 1 2 3 0 1"})
    expect_error_in("k.off", start + pinched + "\n", Element_kind::face, 1,
                    {":8:", "face 1 repeats vertex", "both sides", "cut the face"});
  expect_error_in("l.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1\n5 0 1 2 1 0\n",
                  Element_kind::none, 0, {"no face has three different vertices"});
  expect_error_in("x.off", start + "3 0 1 2.5\n", Element_kind::face, 1, {"not a whole number"});
  expect_error_in("f.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", Element_kind::none, 0,
                  {"has no faces"});
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  expect_error_in("r.obj", obj + "f 1 2 9\nf 1 2 3\n", Element_kind::face, 0,
                  {":4:", "face 0 refers to vertex 9", "from 1 to 3"});
  expect_error_in("n.obj", obj + "f 1 2 -4\n", Element_kind::face, 0, {":4:", "vertex -4"});
  expect_error_in("z.obj", obj + "f 1 2 0\n", Element_kind::face, 0, {":4:", "\"0\""});
  expect_error_in("e.obj", obj, Element_kind::none, 0, {"has no faces"});
  expect_error_in("r.ply", tetrahedron_ply(std::endian::big, -1), Element_kind::face, 0,
                  {"face 0 refers to vertex -1"});
  expect_error_in("r.ts",
                  "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n"
                  "TRGL 1 2 4\nEND\n",
                  Element_kind::face, 0, {":6:", "face 0 refers to vertex 4"});
}

TEST_F(Read_triangle_soup, no_number_of_a_gocad_file_is_read_in_part) {
  const std::string head = "GOCAD TSurf 1\nTFACE\n";
  const std::vector<std::string> good{"VRTX 1 0.5 0 0", "VRTX 2 1.9 0 0", "PVRTX 3 0 1.7 0.5 9",
                                      "TRGL 1 2 3", "END"};
  const auto file = [&](std::size_t changed, const std::string& line) {
    std::string text = head;
    for (std::size_t i = 0; i < good.size(); ++i) text += (i == changed ? line : good[i]) + '\n';
    return text;
  };
  EXPECT_EQ(read("good.ts", file(9, "")).points[2], (std::array<double, 3>{0, 1.7, 0.5}));
  for (const char* word : {"0,5", "0.5.1", "1e", "five", "0x1", ""})
    expect_error_in("c.ts", file(2, "VRTX 3 0 1.7 " + std::string(word)), Element_kind::vertex, 2,
                    {":5:", "vertex 2"});
  expect_error_in("nan.ts", file(2, "VRTX 3 0 nan 0"), Element_kind::vertex, 2, {"vertex 2"});
  expect_error_in("n.ts", file(2, "VRTX 3.5 0 1.7 0"), Element_kind::none, 0, {":5:", "\"3.5\""});
  expect_error_in("f.ts", file(3, "TRGL 1 2 3,4"), Element_kind::none, 0, {":6:", "\"3,4\""});
  expect_error_in("s.ts", file(3, "TRGL 1 2"), Element_kind::none, 0, {":6:", "\"\""});
  expect_error_in("e.ts", file(4, "GOCAD TSurf 1"), Element_kind::none, 0, {":7:", "END"});
}

TEST_F(Read_triangle_soup, vertices_of_gocad_objects_have_the_numbers_that_the_file_gives) {
  const Triangle_soup soup = read("two.ts", "GOCAD TSurf 1\nTFACE\nVRTX 7 0 0 0\nVRTX -2 1 0 0\n"
                                            "VRTX 30 0 1 0\nATOM 4 7\nTRGL -2 30 4\nBSTONE 7\nEND\n"
                                            "GOCAD TSurf 1\nTFACE\nVRTX 7 0 0 1\nVRTX 8 1 0 1\n"
                                            "VRTX 9 0 1 1\nTRGL 7 8 9\nEND\n");
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  EXPECT_EQ(soup.triangles, (Triangles{{1, 2, 0}, {3, 4, 5}}));
}

TEST_F(Read_triangle_soup, what_of_faces_has_no_area_as_they_repeat_a_vertex_is_left_out) {
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;
  using Numbers = std::vector<std::uint32_t>;
  const std::string points = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n";
  const auto of_second = [&](const std::string& face) {
    return read("f.off", "OFF\n5 3 0\n" + points + "3 0 1 4\n" + face + "\n3 0 4 3\n");
  };
  for (const std::string nothing :
       {"3 2 1 2", "3 2 2 2", "4 0 1 2 1", "4 0 1 0 1", "5 0 0 1 1 0", "8 0 1 2 3 4 3 2 1"}) {
    const Triangle_soup soup = of_second(nothing);
    EXPECT_EQ(soup.triangles, (Triangles{{0, 1, 4}, {0, 4, 3}})) << nothing;
    EXPECT_EQ(soup.polygon_of_triangle, (Numbers{0, 2})) << nothing;
    EXPECT_EQ(soup.faces_with_repeated_vertices, 1U) << nothing;
    EXPECT_EQ(soup.input_faces, 3U) << nothing;
  }
  for (const std::string triangle : {"4 0 1 1 2", "5 0 0 1 2 0", "5 0 1 3 1 2", "6 0 4 0 1 2 2"}) {
    const Triangle_soup soup = of_second(triangle);
    ASSERT_EQ(soup.triangles.size(), 3U) << triangle;
    EXPECT_EQ(soup.triangles[1], (std::array<std::uint32_t, 3>{0, 1, 2})) << triangle;
    EXPECT_TRUE(soup.polygon_of_triangle.empty()) << triangle; // each face is one
    EXPECT_EQ(soup.faces_with_repeated_vertices, 1U) << triangle;
  }
  const Triangle_soup square = of_second("6 0 1 1 2 3 0");
  EXPECT_EQ(square.triangles.size(), 4U);
  EXPECT_EQ(square.polygon_of_triangle, (Numbers{0, 1, 1, 2}));
  EXPECT_EQ(square.triangulated_polygons, 1U);
  // a triangle at the end of a line, which leads on beyond it
  EXPECT_EQ(of_second("7 4 1 2 3 1 4 2").triangles[1], (std::array<std::uint32_t, 3>{1, 2, 3}));
  // the first face
  const Triangle_soup first = read("f.off", "OFF\n5 2 0\n" + points + "3 0 0 4\n3 0 4 3\n");
  EXPECT_EQ(first.triangles, (Triangles{{0, 4, 3}}));
  EXPECT_EQ(first.polygon_of_triangle, (Numbers{1}));
  // facets of STL whose corners have rounded to the same point
  const Triangle_soup stl =
      read("d.stl", binary_stl({{0, 0, 0, 1, 0, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 1, 0}}, 2));
  EXPECT_EQ(stl.triangles, (Triangles{{0, 1, 2}}));
  EXPECT_EQ(stl.polygon_of_triangle, (Numbers{1}));
}

TEST_F(Read_triangle_soup, polygons_are_read_as_they_are) {
  const auto expect_faces = [&](const std::string& name, const std::string& content) {
    const Polygon_soup soup = read_polygon_soup(file(name, content));
    EXPECT_EQ(soup.points.size(), 5U) << name;
    EXPECT_EQ(soup.points[4], (std::array<double, 3>{0, 0, 1})) << name;
    EXPECT_EQ(soup.faces,
              (std::vector<std::vector<std::uint32_t>>{{0, 1, 2, 3}, {3, 3, 4}, {4, 1, 0}}))
        << name;
  };
  expect_faces("p.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n"
                        "4 0 1 2 3\n3 3 3 4\n3 4 1 0\n");
  expect_faces("p.obj", "v 0 0 0\nv 1 0 0\nf 1 2 3/7 4//2\nv 1 1 0\nv 0 1 0\nv 0 0 1\n"
                        "f 4 4 5\nf -1 -4 -5\n");
  EXPECT_TRUE(read_polygon_soup(file("q.off", "OFF\n1 0 0\n0 0 1\n")).faces.empty());
  EXPECT_THROW(read_polygon_soup(file("r.obj", "v 0 0 0\nf 1 1 2\n")), Invalid_input);
  EXPECT_THROW(read_polygon_soup(file("s.off", "OFF\n2 1 0\n0 0 1\n1 1 1\n2 0 1\n")),
               Invalid_input);
  EXPECT_THROW(read_polygon_soup("none.off"), Invalid_input);
}

TEST_F(Read_triangle_soup, points_are_read_from_lists_and_from_files_without_faces) {
  const std::vector<std::array<double, 3>> points{{0.1, -2, 3e-5}, {1, 2, 3}, {-4, 5, 6.25}};
  const auto expect_points = [&](const std::string& name, const std::string& content) {
    const Triangle_soup soup =
        read_triangle_soup(file(name, content), Nonplanar_polygons::fan, File_faces::optional);
    EXPECT_EQ(soup.points, points) << name << '\n' << content;
    EXPECT_TRUE(soup.triangles.empty() && soup.input_faces == 0) << name;
  };
  expect_points("a.xyz", "0.1 -2 3e-5\n1 2 3\n-4 5 6.25\n");
  expect_points("b.xyz", "3\n0.1 -2 3e-5\n1 2 3\n-4 5 6.25");
  expect_points("c.XYZ",
                "# points\r\n\r\n 0.1\t-2 3e-5 0 0 1 red\r\n1 2 3 # one\r\n-4 5 6.25 nan\r\n");
  expect_points("d.pwn", "0.1 -2 3e-5 0 0 1\n+1 2 3 0 1 0\n-4 5 6.25 1 0 0\n");
  expect_points("e.off", "OFF 3 0 0\n0.1 -2 3e-5\n1 2 3\n-4 5 6.25\n");
  expect_points("f.obj", "v 0.1 -2 3e-5\nv 1 2 3\nown words\nv -4 5 6.25\n");
  expect_points("g.ply",
                "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
                "property double z\nproperty uchar red\nend_header\n0.1 -2 3e-5 7\n1 2 3 7\n"
                "-4 5 6.25 7\n");
}

TEST_F(Read_triangle_soup, faces_are_ignored_where_points_are_asked_for) {
  const std::string mesh = "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 1\n3 0 1 9\n";
  const Triangle_soup soup =
      read_triangle_soup(file("m.off", mesh), Nonplanar_polygons::fan, File_faces::ignored);
  EXPECT_EQ(soup.points, (std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(soup.triangles.empty() && soup.input_faces == 0);
  const std::string stl = binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0, 0, 1, 0}}, 2);
  EXPECT_EQ(read_triangle_soup(file("m.stl", stl), Nonplanar_polygons::fan, File_faces::ignored)
                .points.size(),
            4U);
  const std::string whole = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_EQ(read_triangle_soup(file("w.off", whole), Nonplanar_polygons::fan, File_faces::optional)
                .triangles.size(),
            1U);
}

TEST_F(Read_triangle_soup, points_that_are_no_points_are_named) {
  const auto expect = [&](const std::string& content, std::size_t point,
                          const std::vector<std::string>& words) {
    try {
      read_triangle_soup(file("p.xyz", content), Nonplanar_polygons::fan, File_faces::optional);
      ADD_FAILURE() << content;
    } catch (const Invalid_input& e) {
      EXPECT_EQ(e.index(), point) << e.what();
      for (const std::string& word : words)
        EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what() << '\n' << word;
    }
  };
  expect("0 0 0\n\n1 2\n", 1, {"p.xyz:3:", "point 1", "fewer than three", "remove it"});
  expect("0 0 0\n1,2,3\n", 1, {"p.xyz:2:", "point 1", "\"1,2,3\"", "spaces"});
  expect("0 0 0\n1 nan 3\n", 1, {"p.xyz:2:", "point 1", "not a finite number"});
  expect("0 0 1e999\n", 0, {"p.xyz:1:", "point 0", "not a finite number"});
  expect("2\nwater\nO 0 0 0\nH 1 0 0\n", 0, {"p.xyz:2:", "\"water\""});
  expect("3\n0 0 0\n1 0 0\n", 2, {"point 2 of the 3", "truncated"});
  expect("# nothing\n", 0, {"p.xyz: ", "no points"});
  expect_error_in("p.xyz", "0 0 0\n1 0 0\n0 1 0\n", Element_kind::none, 0,
                  {"has no faces", "point cloud"});
}

TEST_F(Read_triangle_soup, truncated_files_of_other_formats_are_refused) {
  const std::string ply = tetrahedron_ply(std::endian::little);
  const std::size_t header = ply.find("end_header\n") + 11;
  for (std::size_t length = 1; length < ply.size(); ++length)
    EXPECT_THROW(read("cut.ply", ply.substr(0, length)), Invalid_input) << length;
  expect_error_in("v.ply", ply.substr(0, header + 20), Element_kind::vertex, 1,
                  {"vertex 1 of the 4", "truncated"});
  const std::string stl = binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, 1);
  for (std::size_t length = 1; length < stl.size(); ++length)
    EXPECT_THROW(read("cut.stl", stl.substr(0, length)), Invalid_input) << length;
  expect_error_in("t.stl", "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\n",
                  Element_kind::face, 1, {"before facet 1 is complete", "truncated"});
  expect_error_in("t.ts",
                  "GOCAD TSurf 1\nTFACE\nVRTX 1 0 0 0\nVRTX 2 1 0 0\nVRTX 3 0 1 0\n"
                  "TRGL 1 2 3\n",
                  Element_kind::none, 0, {"beyond vertex 3 and face 1"});
}

TEST_F(Read_triangle_soup, every_truncation_of_an_off_file_is_refused) {
  // the last number may lose digits, and the newline, unnoticed: it has one digit here
  for (std::size_t length = 1; length + 1 < tetrahedron_off.size(); ++length)
    EXPECT_THROW(read("cut.off", tetrahedron_off.substr(0, length)), Invalid_input) << length;
}

TEST_F(Read_triangle_soup, garbage_is_refused_in_every_format) {
  std::string noise;
  std::uint32_t state = 2463534242U; // xorshift, seeded
  for (int i = 0; i < 5000; ++i) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    noise += static_cast<char>(state >> 24);
  }
  for (const std::string extension : {"off", "obj", "ply", "stl", "ts"}) {
    EXPECT_THROW(read("noise." + extension, noise), Invalid_input) << extension;
    EXPECT_THROW(read("words." + extension, "solid words and\nno mesh at all\n"), Invalid_input)
        << extension;
    EXPECT_THROW(read("blank." + extension, " \n\n"), Invalid_input) << extension;
  }
  expect_error_in("ply.off", "ply\nformat ascii 1.0\n", Element_kind::none, 0,
                  {"starts with \"ply\" instead of OFF", ":1:"});
  expect_error_in("off.obj", tetrahedron_off, Element_kind::none, 0, {":1:", "not a statement"});
}

// Every change of a few bytes gives a sound soup or an error, and no crash.
TEST_F(Read_triangle_soup, damaged_files_are_read_soundly_or_refused) {
  const std::vector<std::pair<std::string, std::string>> files{
      {"m.off", tetrahedron_off},
      {"m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1/1 2 -1\n"},
      {"m.ply", tetrahedron_ply(std::endian::little)},
      {"m.stl", binary_stl({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {1, 0, 0, 1, 1, 0, 0, 1, 0}}, 2)}};
  std::uint32_t state = 88172645U; // xorshift, seeded
  const auto random = [&state](std::size_t n) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state % n;
  };
  for (const auto& [name, content] : files)
    for (int round = 0; round < 200; ++round) {
      std::string damaged = content;
      for (std::size_t changes = 1 + random(3); changes > 0; --changes)
        damaged[random(damaged.size())] =
            random(2) == 0 ? static_cast<char>(random(256)) : content[random(content.size())];
      try {
        const Triangle_soup s = read(name, damaged);
        for (const auto& p : s.points)
          for (const double x : p) EXPECT_TRUE(std::isfinite(x)) << name << " " << round;
        for (const auto& t : s.triangles)
          for (const std::uint32_t v : t) EXPECT_LT(v, s.points.size()) << name << " " << round;
      } catch (const Invalid_input& error) {
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos);
      }
    }
}

TEST_F(Read_triangle_soup, damaged_ply_headers_are_refused) {
  const std::string vertex = "element vertex 1\nproperty float x\nproperty float y\n";
  const std::string start = "ply\nformat ascii 1.0\n";
  const std::vector<std::pair<std::string, std::string>> headers{
      {start + vertex + "end_header\n0 0\n", "no property z"},
      {start + vertex + "property quad z\nend_header\n0 0 0\n", "\"quad\" is not a type"},
      {start + "property float x\nend_header\n", "not one of an element"},
      {start + "element vertex many\nend_header\n", "no valid count"},
      {start + "element face 1\nproperty list uchar int v\nend_header\n3 0 1 2\n",
       "vertex_indices"},
      {"ply\nformat text 1.0\nend_header\n", "\"text\" is not one of"},
      {"ply\n" + vertex + "end_header\n", "no format line"},
      {start + vertex, "within its header"}};
  for (const auto& [content, part] : headers)
    expect_error_in("h.ply", content, Element_kind::none, 0, {part});
}

TEST_F(Read_triangle_soup, polygons_keep_their_index_orientation_and_place) {
  const Triangle_soup s =
      read("p.off", "OFF\n8 3 0\n0 0 0\n2 0 0\n2 2 0\n1 .5 0\n0 2 0\n3 0 0\n3 3 0\n"
                    "-1 1 0\n3 1 5 6\n5 0 1 2 3 4\n3 0 4 7\n");
  EXPECT_EQ(s.input_faces, 3U);
  EXPECT_EQ(s.triangulated_polygons, 1U);
  EXPECT_EQ(s.polygon_of_triangle, (std::vector<std::uint32_t>{0, 1, 1, 1, 2}));
  ASSERT_EQ(s.triangles.size(), 5U);
  EXPECT_EQ(s.triangles[0], (std::array<std::uint32_t, 3>{1, 5, 6}));
  EXPECT_EQ(s.triangles[4], (std::array<std::uint32_t, 3>{0, 4, 7}));
  // the pentagon is not convex; its triangles are counterclockwise and fill its area, 4 - 1.5
  double area = 0;
  for (std::size_t t = 1; t < 4; ++t) {
    EXPECT_GT(doubled_area(s, s.triangles[t]), 0);
    area += doubled_area(s, s.triangles[t]) / 2;
  }
  EXPECT_EQ(area, 2.5); // all operations are exact in double
}

TEST_F(Read_triangle_soup, quadrilaterals_take_the_valid_diagonal_at_any_scale) {
  // an arrow head with its reflex corner at each position; the valid diagonal ends there
  const double arrow[4][2] = {{0, 0}, {4, 1}, {1, 1}, {1, 4}};
  for (const std::string exponent : {"e0", "e120", "e-160", "e149"})
    for (unsigned turn = 0; turn < 4; ++turn) {
      std::string content = "OFF\n4 1 0\n";
      for (unsigned k = 0; k < 4; ++k)
        content += std::to_string(int(arrow[(k + turn) % 4][0])) + exponent + " " +
                   std::to_string(int(arrow[(k + turn) % 4][1])) + exponent + " 0\n";
      const Triangle_soup s = read("q.off", content + "4 0 1 2 3\n");
      const std::uint32_t reflex = (2 + 4 - turn) % 4;
      ASSERT_EQ(s.triangles.size(), 2U);
      for (const auto& t : s.triangles)
        EXPECT_TRUE(t[0] == reflex || t[1] == reflex || t[2] == reflex) << exponent << turn;
    }
}

TEST_F(Read_triangle_soup, refuses_coordinates_of_which_areas_are_infinite) {
  for (const std::string x : {"1e151", "-1e200", "5e307"}) {
    expect_error_in("far.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 " + x + " 0\n3 0 1 2\n",
                    Element_kind::vertex, 2, {});
  }
}

TEST_F(Read_triangle_soup, polygons_with_vertices_inside_sides_keep_them) {
  const Triangle_soup s =
      read("c.off", "OFF\n8 1 0\n0 0 0\n1 0 0\n2 0 0\n2 1 0\n2 2 0\n1 2 0\n0 2 0\n"
                    "0 1 0\n8 0 1 2 3 4 5 6 7\n");
  ASSERT_EQ(s.triangles.size(), 6U);
  double area = 0;
  for (const auto& t : s.triangles) {
    EXPECT_GT(doubled_area(s, t), 0); // Delaunay leaves no flat triangle
    area += doubled_area(s, t) / 2;
  }
  EXPECT_EQ(area, 4.);
}

TEST_F(Read_triangle_soup, polygons_that_cross_themselves_or_are_flat_are_still_triangulated) {
  const Triangle_soup star =
      read("s.off", "OFF\n5 1 0\n0 0 0\n2 2 1\n0 2 0\n2 0 1\n1 3 0\n5 0 1 2 3 4\n");
  EXPECT_EQ(star.triangles.size(), 3U);
  EXPECT_EQ(greatest_edge_degree(star), 2U);
  const Triangle_soup line =
      read("l.off", "OFF\n5 1 0\n0 0 0\n1 1 1\n2 2 2\n3 3 3\n4 4 4\n5 0 1 2 3 4\n");
  EXPECT_EQ(line.triangles.size(), 3U);
  EXPECT_EQ(greatest_edge_degree(line), 2U);
}

TEST_F(Read_triangle_soup, a_diagonal_never_doubles_another_edge) {
  const std::string square = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  // two squares back to back on the same vertices
  const Triangle_soup pillow = read("p.off", square + "4 0 1 2 3\n4 3 2 1 0\n");
  EXPECT_EQ(pillow.triangles.size(), 4U);
  EXPECT_EQ(greatest_edge_degree(pillow), 2U);
  // a triangle that has one diagonal of a square as a side, whichever it is
  for (const std::string other : {"3 0 2 4\n", "3 1 3 4\n"}) {
    const Triangle_soup s =
        read("t.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n" + other + "4 0 1 2 3\n");
    EXPECT_EQ(greatest_edge_degree(s), 2U);
  }
}

TEST_F(Read_triangle_soup, a_polygon_without_a_free_diagonal_makes_a_soup_and_no_mesh) {
  const Triangle_soup s = read_triangle_soup(
      file("q.off", "OFF\n6 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n0 0 2\n4 0 1 2 3\n3 0 2 4\n"
                    "3 1 3 5\n"));
  EXPECT_EQ(s.triangles.size(), 4U);
  EXPECT_EQ(s.triangulated_polygons, 1U);
  refusals::expect_invalid([&] { CGAL::Intrinsic_triangulations::Intrinsic_input input(s); },
                           Element_kind::edge, {}, {" has 3 faces ("});
}

TEST_F(Read_triangle_soup, text_with_numbers_of_every_kind_agrees_with_the_reader_of_CGAL) {
  const std::string path =
      file("c.off", "COFF\n5 4 8\n0 0 0 255 0 0 255\n1e3 0.25 -7 0 0 0 0\n"
                    ".5 5. 1E-3 1 1 1 1\n-1.7976931348623157e149 4.9e-324 3\n"
                    "7 8 9 1 2 3 4\n3 0 1 2 0.1 0.2 0.3\n4 0 1 2 3\n3 3 2 4 1\n"
                    "3 4 1 0\n");
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  ASSERT_TRUE(CGAL::IO::read_polygon_soup(path, points, faces));
  const Triangle_soup s = read_triangle_soup(path);
  ASSERT_EQ(s.points.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(s.points[v][static_cast<std::size_t>(k)], points[v][k]) << v;
  EXPECT_EQ(s.input_faces, faces.size());
}

} // namespace

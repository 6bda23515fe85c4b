// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stored_triangulations.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/input/renumbering.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using stored::delaunay_signs;
using stored::Double;
using stored::Exact;
using stored::expect_equal;
using stored::expect_same_but_for_widths;
using stored::from_text;
using stored::message_of;
using stored::replaced;
using stored::text;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Points = std::vector<std::array<double, 3>>;

// a bumpy height field over a grid: irregular, with a border and an isolated vertex, last
IT::Intrinsic_input terrain(std::uint32_t n, bool integer) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> height(0, 2);
  Points points;
  Triangles triangles;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const double z = height(random);
      points.push_back({double(i), double(j), integer ? double(int(z)) : z});
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1;
      triangles.push_back({a, b, b + 1});
      triangles.push_back({a, b + 1, a + 1});
    }
  points.push_back({0, 0, 5});
  const auto count = static_cast<std::uint32_t>(points.size());
  return {IT::Gluing_map(IT::gluing_from_triangles(count, triangles)), std::move(points)};
}

template <class Triangulation>
unsigned flip_at_random(Triangulation& t, unsigned attempts, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<typename Triangulation::halfedge_descriptor> sides;
  for (const auto h : halfedges(t.mesh())) sides.push_back(h);
  std::uniform_int_distribution<std::size_t> side(0, sides.size() - 1);
  unsigned flips = 0;
  for (unsigned i = 0; i < attempts; ++i)
    flips += t.flip_edge(sides[side(random)]) == IT::Move_status::done ? 1 : 0;
  return flips;
}

// leaves no vertex, but a metric that would be defined by it
void define_by_places(Exact& t) {
  const auto h = halfedge(*faces(t.mesh()).begin(), t.mesh());
  EXPECT_EQ(t.remove_vertex(t.insert_vertex(h, {0.25, 0.25, 0.5}).vertex), IT::Move_status::done);
}

} // namespace

// What was only flipped is decided by the history of flips, and by coordinates when it is read.
TEST(Intrinsic_triangulation_format, exact_triangulation_goes_on_as_if_it_had_not_been_stored) {
  for (const bool integer : {false, true})
    for (const bool by_places : {true, false}) {
      SCOPED_TRACE(std::string(integer ? "integer" : "double") + (by_places ? ", by places" : ""));
      Exact t(terrain(6, integer));
      if (by_places) define_by_places(t);
      ASSERT_GT(flip_at_random(t, 900, 3), 200U);
      Exact back = from_text<Exact>(text(t));
      if (by_places) {
        ASSERT_NE(back.input().surface(), nullptr);
        EXPECT_TRUE(back.input().surface()->is_defined_by_metric());
      }
      EXPECT_EQ(delaunay_signs(back), delaunay_signs(t));
      EXPECT_EQ(flip_at_random(back, 300, 4), flip_at_random(t, 300, 4));
      expect_same_but_for_widths(back, t); // predicates sharpen by what they remember
      IT::flip_to_delaunay(t);
      IT::flip_to_delaunay(back);
      expect_same_but_for_widths(back, t);
      EXPECT_EQ(IT::check_delaunay(back).non_delaunay_edges, 0U);
      EXPECT_EQ(IT::check_delaunay(back).cocircular_edges, IT::check_delaunay(t).cocircular_edges);
    }
}

TEST(Intrinsic_triangulation_format, report_and_scale_come_back) {
  IT::Intrinsic_input input = terrain(3, false);
  for (auto& p : input.points)
    for (double& x : p) x *= 0x1p100;
  input.mollification = IT::Mollification::squared_lengths;
  const Exact t(std::move(input));
  const Exact back = from_text<Exact>(text(t));
  EXPECT_EQ(back.report().mollification.kind, IT::Mollification::squared_lengths);
  EXPECT_EQ(back.report().mollification.delta, t.report().mollification.delta);
  EXPECT_EQ(back.input().metric().delta(), t.input().metric().delta());
  EXPECT_LT(back.metric().scale_exponent(), -90);
  for (const auto e : edges(t.mesh())) EXPECT_EQ(back.squared_length(e), t.squared_length(e));
}

TEST(Intrinsic_triangulation_format, renumbered_triangulation_keeps_the_way_back_to_the_input) {
  IT::Intrinsic_input input = terrain(3, false);
  const IT::Input_names names = IT::renumber(input.mesh, input.points);
  const Double built(input);
  IT::Input_definition::Parts parts{
      input.mesh.number_of_vertices(), built.input().metric(), names, {}, {}};
  parts.report.renumbered = true;
  const auto renumbered = std::make_shared<const IT::Input>(input.mesh, std::move(parts));
  const Double t(input.mesh, built.metric(), renumbered);
  const Double back = from_text<Double>(text(t));
  EXPECT_TRUE(back.report().renumbered);
  EXPECT_EQ(back.input().names().vertices.users(), names.vertices.users());
  EXPECT_EQ(back.input().names().faces.users(), names.faces.users());
  EXPECT_EQ(back.input().names().edges.users(), names.edges.users());
  expect_equal(text(back), text(t));
}

TEST(Intrinsic_triangulation_format, file_of_a_file_has_equal_bytes) {
  const std::filesystem::path directory =
      std::filesystem::temp_directory_path() /
      ("intrinsic_triangulation_format_" + std::to_string(std::random_device()()));
  std::filesystem::create_directory(directory);
  Exact t(terrain(5, false));
  IT::flip_to_delaunay(t);
  IT::write_intrinsic_triangulation(directory / "a.idt", t);
  EXPECT_EQ(IT::read_intrinsic_triangulation_arithmetic(directory / "a.idt"), "exact");
  IT::write_intrinsic_triangulation(directory / "b.idt",
                                    IT::read_intrinsic_triangulation<Exact>(directory / "a.idt"));
  const auto bytes = [](const std::filesystem::path& p) {
    std::ifstream in(p, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  EXPECT_EQ(bytes(directory / "a.idt"), bytes(directory / "b.idt"));
  EXPECT_EQ(bytes(directory / "a.idt"), text(t));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 2);
  EXPECT_THROW(IT::write_intrinsic_triangulation(directory / "none" / "a.idt", t),
               std::runtime_error);
  std::filesystem::remove_all(directory);
}

TEST(Intrinsic_triangulation_format, damage_is_reported_with_file_and_line) {
  const std::string s = text(Exact(terrain(1, false)));
  ASSERT_EQ(message_of(s), "");
  EXPECT_EQ(message_of(replaced(s, "IDT 5", "OFF")).rfind("file.idt:1: ", 0), 0U);
  for (const std::string version : {"1", "2", "3", "4"}) {
    const std::string message = message_of(replaced(s, "IDT 5", "IDT " + version));
    EXPECT_NE(message.find("version " + version + ", only version 5"), std::string::npos);
    EXPECT_NE(message.find("make the triangulation again"), std::string::npos);
  }
  EXPECT_NE(message_of(replaced(s, "exact", "rational")).find("rational"), std::string::npos);
  EXPECT_NE(message_of(replaced(s, "exact", "double")).find("double arithmetic"),
            std::string::npos);
  EXPECT_NE(message_of(text(Double(terrain(1, false)))).find("stored in double arithmetic"),
            std::string::npos);
  EXPECT_NE(message_of(replaced(s, "rows 0\nv", "rows 400000000\nv")), "");
  EXPECT_NE(message_of(replaced(s, "input points", "input circles")).find("circles"),
            std::string::npos);
  EXPECT_NE(message_of(replaced(s, "delta 0x0p+0", "delta -0x1p-3")).find("negative"),
            std::string::npos);
  EXPECT_NE(message_of(replaced(s, "delta 0x0p+0", "delta nan")).find("nan"), std::string::npos);
  EXPECT_NE(message_of(s + "\n").find(""), std::string::npos); // what follows the end is not read
}

// A file without one of its numbers: the word of a line of a section, counted from its end if
// negative.
namespace {
std::string with_other_value(const std::string& file, const std::string& section, unsigned line,
                             int word, double factor) {
  std::istringstream in(file);
  std::string result, text_line;
  for (unsigned left = 0; std::getline(in, text_line);) {
    if (left > 0 && --left == 0) {
      std::vector<std::string> words;
      std::istringstream parts(text_line);
      for (std::string w; parts >> w;) words.push_back(w);
      std::string& w =
          words[static_cast<std::size_t>(word < 0 ? static_cast<int>(words.size()) + word : word)];
      std::array<char, 64> number{};
      std::snprintf(number.data(), number.size(), "%a", factor * std::strtod(w.c_str(), nullptr));
      w = number.data();
      text_line.clear();
      for (const std::string& x : words) text_line += (text_line.empty() ? "" : " ") + x;
    }
    if (text_line.rfind(section + " ", 0) == 0) left = line + 1;
    result += text_line + "\n";
  }
  return result;
}
} // namespace

TEST(Intrinsic_triangulation_format, doubles_whose_lengths_and_areas_do_not_agree_are_refused) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    Double t(terrain(3, false));
    flip_at_random(t, 20, seed);
    const std::string s = text(t);
    ASSERT_EQ(message_of<Double>(with_other_value(s, "faces", seed, -1, 1)), "") << "seed " << seed;
    for (const double factor : {3., 0., 1.001})
      EXPECT_NE(message_of<Double>(with_other_value(s, "faces", seed, -1, factor))
                    .find("do not span its area"),
                std::string::npos)
          << "seed " << seed << ", area times " << factor;
    EXPECT_NE(
        message_of<Double>(with_other_value(s, "edges", seed, 0, 0)).find("do not span its area"),
        std::string::npos)
        << "seed " << seed;
  }
}

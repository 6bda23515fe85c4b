// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_pages.h"
#include "refusals.h"
#include "subdivisions.h"

#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <regex>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Points = subdivisions::Points;

using html_pages::encoded;
using html_pages::numbers;

IT::Html_view simple_view() {
  IT::Html_view view = html_pages::simple_view();
  view.description = "two lines\nof text";
  return view;
}

std::string page(const IT::Common_subdivision& s, const Points& points,
                 const IT::Html_view& view = simple_view()) {
  std::ostringstream out;
  IT::write_html_view(out, s, points, view);
  return out.str();
}

Points points_of(const IT::Common_subdivision& grid, std::uint32_t n) {
  return IT::positions(grid, subdivisions::grid_points(n));
}

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t result = 0;
  for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i + 1))
    ++result;
  return result;
}

const std::vector<std::string> data_ids{
    "points",       "triangles",       "colors",      "sources",
    "kinds",        "labels",          "input-edges", "input-edges-room",
    "marks",        "intrinsic-edges", "view-axes",   "intrinsic-edges-room",
    "glyph-places", "glyph-vectors"};

} // namespace

TEST(Html_view, Loads_nothing_from_anywhere) {
  const auto s = subdivisions::grid(2);
  const std::string html = page(s, points_of(s, 2));
  EXPECT_FALSE(std::regex_search(html, std::regex("<[^>]*\\s(src|href)\\s*=")));
  for (const char* word :
       {"<link", "@import", "url(", "fetch(", "XMLHttpRequest", "http:", "https:"})
    EXPECT_EQ(occurrences(html, word), 0u) << word;
}

TEST(Html_view, Has_data_in_base64_of_the_expected_sizes) {
  const auto s = subdivisions::grid(3); // 9 squares of 4 triangles; 16 vertices and 9 crossings
  const std::string html = page(s, points_of(s, 3));
  for (const std::string& id : data_ids) {
    EXPECT_EQ(occurrences(html, " id=\"" + id + "\""), 1u) << id;
    EXPECT_EQ(encoded(html, id).size() % 4, 0u) << id;
  }
  EXPECT_EQ(numbers<float>(html, "points").size(), 25u * 3);
  EXPECT_EQ(numbers<std::uint32_t>(html, "triangles").size(), 36u * 3);
  EXPECT_EQ(numbers<std::uint8_t>(html, "colors").size(), 36u * 3);
  EXPECT_EQ(numbers<std::uint32_t>(html, "sources").size(), 36u * 2);
  EXPECT_EQ(numbers<std::uint8_t>(html, "kinds").size(), 25u);
  EXPECT_EQ(numbers<std::uint32_t>(html, "labels").size(), 25u * 2);
  // 12 + 12 sides of squares, and both halves of one diagonal for each triangulation
  for (const std::string edges : {"input-edges", "intrinsic-edges"}) {
    EXPECT_EQ(numbers<std::uint32_t>(html, edges).size(), (24u + 18) * 2);
    EXPECT_EQ(numbers<float>(html, edges + "-room").size(), 24u + 18);
  }
  EXPECT_TRUE(encoded(html, "settings").empty());
  EXPECT_TRUE(encoded(html, "marks").empty());
}

TEST(Html_view, Has_triangles_and_sources_of_the_subdivision) {
  const auto s = subdivisions::grid(2); // all faces are triangles already
  const std::string html = page(s, points_of(s, 2));
  EXPECT_EQ(numbers<std::uint32_t>(html, "triangles"), s.corner);
  const auto sources = numbers<std::uint32_t>(html, "sources");
  ASSERT_EQ(sources.size(), 2 * s.number_of_faces());
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    EXPECT_EQ(sources[2 * f], s.intrinsic_face[f]);
    EXPECT_EQ(sources[2 * f + 1], s.input_face[f]);
  }
}

TEST(Html_view, Escapes_text) {
  const auto s = subdivisions::tetrahedron();
  IT::Html_view view = simple_view();
  view.title = "</script><script>alert(\"1\")</script> & <b>";
  view.description = "<img onerror=x>";
  const std::string html = page(s, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, view);
  EXPECT_EQ(occurrences(html, "alert("), 2u); // in the title, and in the panel
  EXPECT_EQ(occurrences(html, "&lt;/script&gt;&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; "
                              "&amp; &lt;b&gt;"),
            2u);
  EXPECT_EQ(occurrences(html, "<img"), 0u);
}

TEST(Html_view, Does_not_let_scripts_end_themselves) {
  const auto s = subdivisions::tetrahedron();
  const Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::size_t ends = occurrences(page(s, points), "</script>");
  IT::Html_view view = simple_view();
  view.three = "var THREE = { a: \"</script>\", b: \"</SCRIPT>\", c: 1 </d/ };";
  const std::string html = page(s, points, view);
  EXPECT_EQ(occurrences(html, "</script>"), ends);
  EXPECT_EQ(occurrences(html, "</SCRIPT>"), 0u);
  EXPECT_NE(html.find("{ a: \"<\\/script>\", b: \"<\\/SCRIPT>\", c: 1 </d/ };"), std::string::npos);
}

TEST(Html_view, Has_the_scripts_and_their_licence) {
  const auto s = subdivisions::tetrahedron();
  const std::string html = page(s, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const std::size_t notice = html.find("The above copyright notice and this permission notice");
  const std::size_t three = html.find("var THREE = {};");
  const std::size_t controls = html.find("THREE.TrackballControls = null;");
  const std::size_t program = html.find("WebGLRenderer");
  EXPECT_LT(html.find("three.js authors"), notice);
  EXPECT_LT(notice, three);
  EXPECT_LT(three, controls);
  EXPECT_LT(controls, program);
  EXPECT_LT(program, html.size());
}

TEST(Html_view, Says_what_a_browser_lacks) {
  const auto s = subdivisions::tetrahedron();
  const std::string html = page(s, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  EXPECT_NE(html.find("needs WebGL"), std::string::npos);
  EXPECT_NE(html.find("needs JavaScript"), std::string::npos);
}

TEST(Html_view, Colours_neighbouring_intrinsic_faces_differently) {
  constexpr std::uint32_t n = 20;
  const auto s = subdivisions::grid(n);
  const auto color = numbers<std::uint8_t>(page(s, points_of(s, n)), "colors");
  const auto color_of = [&](std::size_t f) {
    return std::array{color[3 * f], color[3 * f + 1], color[3 * f + 2]};
  };
  std::map<std::uint32_t, std::size_t> first; // a face at each intrinsic edge
  std::size_t pairs = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (const auto& side : s.sides(f)) {
      if (side.intrinsic_edge == subdivisions::none) continue;
      const std::size_t g = first.try_emplace(side.intrinsic_edge, f).first->second;
      if (s.intrinsic_face[f] == s.intrinsic_face[g]) {
        EXPECT_EQ(color_of(f), color_of(g));
        continue;
      }
      ++pairs;
      int difference = 0;
      for (std::size_t c = 0; c < 3; ++c)
        difference = std::max(difference, std::abs(color_of(f)[c] - color_of(g)[c]));
      EXPECT_GE(difference, 24);
    }
  EXPECT_GE(pairs, 2u * n * (n - 1) + n * n); // all inner edges of the intrinsic triangulation
}

TEST(Html_view, Centres_points_before_they_lose_precision) {
  constexpr std::uint32_t n = 4;
  const auto s = subdivisions::grid(n);
  const Points points = points_of(s, n);
  const auto near = numbers<float>(page(s, points), "points");
  // 2^26: the sum is rounded to 2^-26, and a unit in the last place of single precision is 2^26 / 2^23
  for (const std::array<double, 2> change : {std::array<double, 2>{1, 67108864.},
                                             {1e-300, 0},
                                             {1e300, 0},
                                             {std::numeric_limits<double>::max() / 4, 0}}) {
    Points moved = points;
    for (auto& p : moved)
      for (double& x : p) x = x * change[0] + change[1];
    const auto far = numbers<float>(page(s, moved), "points");
    ASSERT_EQ(far.size(), near.size());
    for (std::size_t i = 0; i < near.size(); ++i) EXPECT_NEAR(far[i], near[i], 1e-6);
  }
  float greatest = 0;
  for (std::size_t i = 0; i < near.size(); i += 3)
    greatest = std::max(greatest, std::hypot(near[i], near[i + 1], near[i + 2]));
  EXPECT_LE(greatest, 1 + 1e-6);
  EXPECT_GE(greatest, 1 - 1e-6);
}

TEST(Html_view, Tells_the_kind_and_the_numbers_of_each_vertex) {
  auto s = subdivisions::grid(1);
  s.vertices[2] = {7, IT::Subdivision_vertex_kind::inserted, 1, {3, {0, 1, 3}, {0.5, 0.25, 0.25}}};
  s.vertices[3].intrinsic = 9;
  const std::string html = page(s, points_of(s, 1));
  EXPECT_EQ(numbers<std::uint8_t>(html, "kinds"), (std::vector<std::uint8_t>{0, 0, 1, 0, 2}));
  EXPECT_EQ(numbers<std::uint32_t>(html, "labels"),
            (std::vector<std::uint32_t>{0, 0, 1, 1, 7, 1, 9, 3, 4, 4}));
}

TEST(Html_view, Gives_edges_the_height_of_the_smaller_face) {
  auto s = subdivisions::grid(1);
  // a rectangle of width 4 and height 3 has a circumcircle of radius 5 / 2, which is scaled to 1
  const Points points = IT::positions(s, Points{{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 3, 0}});
  const std::string html = page(s, points);
  for (const std::string id : {"input-edges", "intrinsic-edges"}) {
    const auto ends = numbers<std::uint32_t>(html, id);
    const auto room = numbers<float>(html, id + "-room");
    ASSERT_EQ(ends.size(), 2 * room.size());
    for (std::size_t e = 0; e < room.size(); ++e) {
      std::array<double, 3> d{};
      for (std::size_t c = 0; c < 3; ++c)
        d[c] = points[ends[2 * e]][c] - points[ends[2 * e + 1]][c];
      const bool is_half_diagonal = ends[2 * e] == 4 || ends[2 * e + 1] == 4;
      const double length = (is_half_diagonal ? 2 : 1) * std::hypot(d[0], d[1], d[2]);
      EXPECT_NEAR(room[e], 12 / length / 2.5, 1e-5); // twice the area of half the rectangle is 12
    }
  }
}

TEST(Html_view, Scales_a_field_in_double_precision) {
  const auto s = subdivisions::grid(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> values{1e15, 1e15 + 1, 1e15 + 4, 1e15 + 2, nan};
  IT::Html_view view = simple_view();
  const std::vector<IT::Subdivision_field> fields{{"heat", values}};
  view.fields = fields;
  const std::string html = page(s, points_of(s, 1), view);
  EXPECT_NE(html.find("data-name=\"heat\""), std::string::npos);
  const auto attribute = [&](const std::string& name) {
    const std::size_t begin = html.find(name + "=\"") + name.size() + 2;
    return std::stod(html.substr(begin, html.find('"', begin) - begin));
  };
  EXPECT_EQ(attribute("data-least"), 1e15);
  EXPECT_EQ(attribute("data-greatest"), 1e15 + 4);
  const auto x = numbers<float>(html, "field-0");
  ASSERT_EQ(x.size(), 5u);
  EXPECT_EQ((std::vector<float>{x.begin(), x.end() - 1}), (std::vector<float>{0, 0.25, 1, 0.5}));
  EXPECT_TRUE(std::isnan(x[4]));
}

TEST(Html_view, Takes_fields_that_are_constant_or_not_finite_or_huge) {
  const auto s = subdivisions::grid(1);
  const double infinity = std::numeric_limits<double>::infinity();
  const double huge = std::numeric_limits<double>::max();
  IT::Html_view view = simple_view();
  const auto scalars = [&](const std::vector<double>& values) {
    const IT::Subdivision_field field("f", values);
    view.fields = std::span(&field, 1);
    return numbers<float>(page(s, points_of(s, 1), view), "field-0");
  };
  EXPECT_EQ(scalars({3, 3, 3, 3, 3}), std::vector<float>(5, 0));
  EXPECT_EQ(scalars({-huge, huge, 0, 0, 0}), (std::vector<float>{0, 1, 0.5, 0.5, 0.5}));
  for (const float x : scalars({infinity, -infinity, infinity, infinity, infinity}))
    EXPECT_TRUE(std::isnan(x));
}

TEST(Html_view, Scales_a_texture_alike_in_both_directions) {
  const auto s = subdivisions::grid(1);
  const std::vector<std::array<double, 2>> places{{-1, 5}, {3, 5}, {-1, 6}, {3, 7}, {1, 6}};
  IT::Html_view view = simple_view();
  view.texture = places;
  view.isolines = 7;
  view.has_edges = false;
  const std::string html = page(s, points_of(s, 1), view);
  EXPECT_EQ(numbers<float>(html, "texture"),
            (std::vector<float>{0, 0, 1, 0, 0, 0.25, 1, 0.5, 0.5, 0.25}));
  EXPECT_NE(html.find("data-isolines=\"7\" data-edges=\"hidden\""), std::string::npos);
  EXPECT_TRUE(numbers<float>(page(s, points_of(s, 1)), "texture").empty());
  view.texture = std::span(places).first(4);
  EXPECT_THROW(page(s, points_of(s, 1), view), IT::Invalid_input);
}

TEST(Html_view, Gives_triangles_corners_of_their_own_for_values_of_faces) {
  const auto s = subdivisions::grid(1);
  std::vector<double> values;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) values.push_back(static_cast<double>(f));
  const std::vector<IT::Subdivision_field> fields{
      {"faces", values, IT::Subdivision_field::Place::faces},
      {"vertices", std::vector<double>{0, 1, 2, 3, 4}}};
  IT::Html_view view = simple_view();
  view.fields = fields;
  const std::string html = page(s, points_of(s, 1), view);
  const auto corner = numbers<std::uint32_t>(html, "triangles");
  const auto on_faces = numbers<float>(html, "field-0"),
             at_vertices = numbers<float>(html, "field-1");
  const std::size_t shared = s.number_of_vertices();
  ASSERT_EQ(on_faces.size(), shared + corner.size());
  ASSERT_EQ(at_vertices.size(), on_faces.size());
  for (std::size_t i = 0; i < corner.size(); ++i) {
    EXPECT_EQ(corner[i], shared + i);
    EXPECT_EQ(on_faces[corner[i]], on_faces[corner[i / 3 * 3]]); // one colour
  }
  EXPECT_EQ(on_faces[corner.front()], 0);
  EXPECT_EQ(on_faces[corner.back()], 1);
  EXPECT_TRUE(std::isnan(on_faces[0]));
  EXPECT_EQ(at_vertices[4], 1);
}

TEST(Html_view, Refuses_what_it_cannot_show) {
  const auto s = subdivisions::grid(1);
  const Points points = points_of(s, 1);
  EXPECT_THROW(page(s, {}), IT::Invalid_input);
  EXPECT_THROW(page(s, subdivisions::grid_points(1)), IT::Invalid_input); // none for the crossing
  IT::Html_view view = simple_view();
  const std::vector<double> values(4, 0.);
  for (const IT::Subdivision_field& field :
       {IT::Subdivision_field("short", values),
        IT::Subdivision_field("vectors", std::vector<std::array<double, 3>>(5)),
        IT::Subdivision_field("corners", std::vector<double>(s.corner.size()),
                              IT::Subdivision_field::Place::corners)}) {
    view.fields = std::span(&field, 1);
    EXPECT_THROW(page(s, points, view), IT::Invalid_input) << field.name;
  }
}

TEST(Html_view, Shows_one_of_several_fields_first) {
  const auto s = subdivisions::grid(1);
  const std::vector<IT::Subdivision_field> fields{{"a", std::vector<double>{0, 1, 2, 3, 4}},
                                                  {"b\"c", std::vector<double>{0, 4, 8, 2, 6}}};
  IT::Html_view view = simple_view();
  view.fields = std::span(fields).first(1);
  EXPECT_NE(page(s, points_of(s, 1), view).find("data-fields=\"1\" data-shown=\"0\""),
            std::string::npos);
  view.fields = fields;
  EXPECT_THROW(page(s, points_of(s, 1), view), IT::Invalid_input); // a quote in a name
  const std::vector<IT::Subdivision_field> named{fields[0], {"b", fields[1].values}};
  view.fields = named;
  view.shown_field = 1;
  std::string html = page(s, points_of(s, 1), view);
  EXPECT_NE(html.find("data-fields=\"2\" data-shown=\"1\""), std::string::npos);
  EXPECT_EQ(numbers<float>(html, "field-1"), (std::vector<float>{0, 0.5, 1, 0.25, 0.75}));
  view.shown_field = 2; // none: faces have their colours, or one
  html = page(s, points_of(s, 1), view);
  EXPECT_NE(html.find("data-shown=\"faces\""), std::string::npos);
  view.has_face_colors = false;
  html = page(s, points_of(s, 1), view);
  EXPECT_NE(html.find("data-shown=\"none\""), std::string::npos);
  EXPECT_EQ(numbers<std::uint8_t>(html, "colors").size(), 3 * s.number_of_faces()); // to be chosen
}

TEST(Html_view, Has_marked_points_with_labels) {
  const auto s = subdivisions::grid(1);
  const Points points = points_of(s, 1);
  const std::vector<IT::Polyline> marks{{{points[3]}, false, 2}, {{points[0]}, false, -1}};
  IT::Html_view view = simple_view();
  view.marks = marks;
  view.marks_name = "zeros & poles";
  const std::string html = page(s, points, view);
  EXPECT_NE(html.find("data-marks=\"zeros &amp; poles\""), std::string::npos);
  EXPECT_EQ(numbers<std::int32_t>(html, "marks-labels"), (std::vector<std::int32_t>{2, -1}));
  const auto all = numbers<float>(html, "points"), marked = numbers<float>(html, "marks");
  EXPECT_EQ((std::vector<float>{all.begin() + 9, all.begin() + 12}),
            (std::vector<float>{marked.begin(), marked.begin() + 3}));
}

TEST(Html_view, Has_the_parts_of_its_program_in_order) {
  const auto s = subdivisions::grid(1);
  const std::string html = page(s, points_of(s, 1));
  std::size_t before = html.find("\"use strict\"");
  for (const char* part : {"const maps", "const element", "function lines(", "const camera",
                           "function numberAt(", "function showField(", "</html>"}) {
    const std::size_t here = html.find(part);
    ASSERT_NE(here, std::string::npos) << part;
    EXPECT_GT(here, before) << part;
    before = here;
  }
}

TEST(Html_view, Says_which_fields_are_classes) {
  const auto s = subdivisions::grid(1);
  std::vector<IT::Subdivision_field> fields(2,
                                            {"f", std::vector<double>(s.number_of_vertices(), 3)});
  fields[1].has_classes = true;
  fields[1].name = "g";
  IT::Html_view view = simple_view();
  view.fields = fields;
  const std::string html = page(s, points_of(s, 1), view);
  EXPECT_EQ(occurrences(html, "data-classes=\"0\""), 1u);
  EXPECT_EQ(occurrences(html, "data-classes=\"1\""), 1u);
}

TEST(Html_view, Scales_vectors_and_leaves_out_what_is_none) {
  const auto s = subdivisions::grid(2);
  const Points points = points_of(s, 2);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<IT::Placed_vector> vectors{{points[0], {3, 0, 0}},
                                               {points[1], {0, 0, 0}},
                                               {points[2], {none, 1, 0}},
                                               {points[3], {0, 6, 0}}};
  IT::Html_view view = simple_view();
  view.vectors = vectors;
  view.are_arrows = false;
  std::ostringstream out;
  const IT::Html_view_report report = IT::write_html_view(out, s, points, view);
  EXPECT_EQ(report.vectors, 2u);
  EXPECT_TRUE(report.is_complete());
  const auto drawn = numbers<float>(out.str(), "glyph-vectors");
  ASSERT_EQ(drawn.size(), 6u);
  EXPECT_FLOAT_EQ(drawn[4], 2 * drawn[0]);
  const auto all = numbers<float>(out.str(), "points"),
             places = numbers<float>(out.str(), "glyph-places");
  EXPECT_EQ((std::vector<float>{all.begin() + 9, all.begin() + 12}),
            (std::vector<float>{places.begin() + 3, places.end()}));
  EXPECT_NE(out.str().find("data-glyphs=\"directions\""), std::string::npos);
}

// Places of a logarithm at (0, 0), where the part beyond x = 6 is torn off.
TEST(Html_view, A_logarithm_ends_where_it_tears) {
  constexpr std::uint32_t n = 8;
  const auto s = subdivisions::grid(n);
  Points vertices;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) vertices.push_back({double(j), double(i), 0});
  const Points points = IT::positions(s, vertices);
  std::vector<std::array<double, 2>> places;
  double least = 0;
  for (const auto& p : points) {
    places.push_back({p[0] > 6 ? p[0] - 100 : p[0], p[1]});
    least = std::min(least, places.back()[0]);
  }
  IT::Html_view view = simple_view();
  view.texture = places;
  EXPECT_EQ(page(s, points, view).find("data-reach"), std::string::npos);
  view.is_logarithm = true;
  const std::string html = page(s, points, view);
  std::smatch found;
  ASSERT_TRUE(
      std::regex_search(html, found, std::regex("data-reach=\"([^,]*),([^,]*),([^\"]*)\"")));
  const double size = 6 - least;
  EXPECT_NEAR(std::stod(found[1]), -least / size, 1e-6);
  EXPECT_NEAR(std::stod(found[3]), 6 / size, 1e-6);
}

TEST(Html_view, Finds_three_js_that_is_not_given) {
  const std::filesystem::path directory =
      std::filesystem::path(testing::TempDir()) / "three_js_of_a_test";
  std::filesystem::create_directories(directory / "build");
  EXPECT_TRUE(IT::find_three_js(directory).three.empty());
  EXPECT_TRUE(IT::find_three_js(directory / "nowhere").trackball_controls.empty());
  std::ofstream(directory / "build" / "three.min.js") << "a\nb";
  std::ofstream(directory / "TrackballControls.js") << "c";
  EXPECT_EQ(IT::find_three_js(directory).three, "a\nb");
  EXPECT_EQ(IT::find_three_js(directory).trackball_controls, "c");
  std::filesystem::remove_all(directory);

  const auto s = subdivisions::grid(1);
  IT::Html_view view;
  view.title = "t";
  const IT::Three_js found = IT::find_three_js();
  if (!found.three.empty() && !found.trackball_controls.empty()) {
    EXPECT_NE(page(s, points_of(s, 1), view).find("TrackballControls = function"),
              std::string::npos);
    return;
  }
  EXPECT_NE(refusals::refusal([&] { page(s, points_of(s, 1), view); }).find("libjs-three"),
            std::string::npos);
}

TEST(Html_view, Tells_that_a_stream_fails) {
  const auto s = subdivisions::grid(1);
  std::ostringstream out;
  out.setstate(std::ios::badbit);
  EXPECT_THROW(IT::write_html_view(out, s, points_of(s, 1), simple_view()), std::runtime_error);
}

TEST(Html_view, Takes_a_subdivision_without_faces_and_one_without_extent) {
  EXPECT_TRUE(numbers<float>(page({}, {}), "points").empty());
  const auto s = subdivisions::tetrahedron();
  const std::string html = page(s, Points(4, {5, 5, 5}));
  for (const float x : numbers<float>(html, "points")) EXPECT_EQ(x, 0);
  for (const float x : numbers<float>(html, "intrinsic-edges-room")) EXPECT_EQ(x, 0);
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "refusals.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/read_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

TEST(Read_polylines, Gives_what_was_written) {
  const std::vector<IT::Polyline> written{{{{0, 0, 0}, {1, 0.1, 0}, {1, 1, 1e-9}}, false, 7},
                                          {{{5, 5, 5}, {6, 5, 5}, {6, 6, 5}}, true, 3},
                                          {{{1, 2, 3}}, false, 2}};
  for (const std::string_view extension : IT::polyline_extensions) {
    std::stringstream file;
    IT::write_polylines(file, extension, written);
    std::vector<IT::Polyline> read = IT::read_polylines(file, extension);
    ASSERT_EQ(read.size(), written.size()) << extension;
    if (extension == "vtp") std::ranges::rotate(read, read.begin() + 1); // points come first there
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].points, written[i].points) << extension << i;
      EXPECT_EQ(read[i].is_closed, written[i].is_closed) << extension << i;
      EXPECT_EQ(read[i].label, written[i].label) << extension << i;
    }
  }
}

TEST(Read_polylines, Refuses_files_that_are_cut_short_or_changed) {
  const std::vector<IT::Polyline> written{{{{0, 0, 0}, {1, 0.1, 0}, {1, 1, 1e-9}}, false, 7}};
  for (const std::string_view extension : {"vtp", "ply"}) {
    std::stringstream file;
    IT::write_polylines(file, extension, written);
    const std::string text = file.str();
    for (std::size_t n = 0; n + 40 < text.size(); n += 7) {
      std::istringstream part(text.substr(0, n));
      EXPECT_THROW(IT::read_polylines(part, extension), IT::Invalid_input) << extension << n;
    }
  }
  std::istringstream other("v 0 0 0\nv 1 0 0\nl 1 2\n");
  EXPECT_THROW(IT::read_polylines(other, "off"), IT::Invalid_input);
}

TEST(Read_polylines, Takes_files_of_other_programs) {
  std::istringstream file("# made by hand\nmtllib x.mtl\nv 0 0 0\nv 1 0 0 1\nvt 0 0\nl -2 -1\n"
                          "v 2 0 0\nl 1/1 3/1\n");
  const std::vector<IT::Polyline> read = IT::read_polylines(file, "obj");
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].points[1][0], 1);
  EXPECT_EQ(read[1].points[1][0], 2);
  EXPECT_EQ(read[1].label, 1);
}

TEST(Read_polylines, Names_the_line_that_is_wrong) {
  for (const char* text : {"v 0 0\n", "v 0 0 0\nl 1 2\n", "v 0 0 0\nl 0\n", "v 0 0 0\nl a\n"}) {
    std::istringstream file(text);
    const std::string message = refusals::refusal([&] { IT::read_polylines(file, "obj"); });
    EXPECT_NE(message.find("line "), std::string::npos) << text;
  }
  std::istringstream none("v 0 0 0\nf 1 1 1\n");
  EXPECT_THROW(IT::read_polylines(none, "obj"), IT::Invalid_input);
}

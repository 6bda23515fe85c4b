// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

/// A path, a loop, a point, nothing.
std::vector<IT::Polyline> example() {
  return {{{{0, 0, 0.1}, {1, 0, 0}, {1, 1e-300, 0}}, false, 7},
          {{{0, 0, 2}, {1, 0, 2}, {0, 1, 2}}, true, -1},
          {{{5, 5, 5}}, true, 3},
          {{}, false, 4}};
}

std::string written(const std::string& extension, const std::vector<IT::Polyline>& lines) {
  std::ostringstream out;
  IT::write_polylines(out, extension, lines);
  return out.str();
}

template <class T>
T number_at(const std::string& bytes, std::size_t at) {
  T x;
  std::memcpy(&x, bytes.data() + at, sizeof(T));
  return x;
}

/// The numbers of an array of a VTP file, without the count of bytes before them.
template <class T>
std::vector<T> array(const std::string& file, std::size_t tag) {
  static const std::string digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0;
  int n = 0;
  for (std::size_t i = file.find('\n', tag) + 1; digits.find(file[i]) != std::string::npos; ++i) {
    bits = (bits << 6) | static_cast<unsigned>(digits.find(file[i]));
    n += 6;
    if (n >= 8) bytes += static_cast<char>((bits >> (n -= 8)) & 255);
  }
  const auto size = number_at<std::uint64_t>(bytes, 0);
  EXPECT_EQ(bytes.size(), size + 8);
  std::vector<T> result;
  for (std::size_t i = 8; i < bytes.size(); i += sizeof(T))
    result.push_back(number_at<T>(bytes, i));
  return result;
}

} // namespace

TEST(WritePolylines, KnowsItsExtensions) {
  for (const std::string_view yes : IT::polyline_extensions)
    EXPECT_FALSE(written("." + std::string(yes), example()).empty()) << yes;
  EXPECT_THROW(written("off", example()), IT::Invalid_input);
}

TEST(WritePolylines, ObjHasLinesAndPointsWithLabels) {
  EXPECT_EQ(written("obj", example()),
            "# polylines and their labels: curve\n"
            "v 0 0 0.1\nv 1 0 0\nv 1 1e-300 0\nv 0 0 2\nv 1 0 2\nv 0 1 2\nv 5 5 5\n"
            "# curve 7\nl 1 2 3\n# curve -1\nl 4 5 6 4\n# curve 3\np 7\n");
}

TEST(WritePolylines, NamesLabelsAsItIsAskedTo) {
  for (const std::string extension : {"vtp", "obj", "ply"}) {
    std::ostringstream out;
    IT::write_polylines(out, extension, example(), "index");
    EXPECT_NE(out.str().find("index"), std::string::npos) << extension;
    EXPECT_EQ(out.str().find("curve"), std::string::npos) << extension;
  }
}

TEST(WritePolylines, PlyHasVerticesAndEdgesWithLabels) {
  const std::string file = written("ply", example());
  EXPECT_NE(file.find("element vertex 7\n"), std::string::npos);
  EXPECT_NE(file.find("element edge 5\n"), std::string::npos);
  const std::size_t begin = file.find("end_header\n") + 11;
  ASSERT_EQ(file.size(), begin + 7 * 28 + 5 * 12);
  EXPECT_EQ(number_at<double>(file, begin + 2 * 28 + 8), 1e-300);
  EXPECT_EQ(number_at<std::int32_t>(file, begin + 3 * 28 + 24), -1);
  const std::vector<std::array<std::int32_t, 3>> edges{
      {0, 1, 7}, {1, 2, 7}, {3, 4, -1}, {4, 5, -1}, {5, 3, -1}};
  for (std::size_t e = 0; e < 5; ++e)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(number_at<std::int32_t>(file, begin + 7 * 28 + 12 * e + 4 * k), edges[e][k]);
}

TEST(WritePolylines, VtpHasCellsWithLabels) {
  const std::string file = written("vtp", example());
  EXPECT_NE(file.find("NumberOfPoints=\"7\" NumberOfVerts=\"1\" NumberOfLines=\"2\""),
            std::string::npos);
  EXPECT_EQ(array<std::int32_t>(file, file.find("Name=\"curve\"")),
            (std::vector<std::int32_t>{3, 7, -1}));
  const std::vector<double> points = array<double>(file, file.find("Name=\"Points\""));
  ASSERT_EQ(points.size(), 21U);
  EXPECT_EQ(points[2], 0.1);
  const std::size_t lines = file.find("<Lines>");
  EXPECT_EQ(array<std::int64_t>(file, file.find("connectivity", lines)),
            (std::vector<std::int64_t>{0, 1, 2, 3, 4, 5, 3}));
  EXPECT_EQ(array<std::int64_t>(file, file.find("offsets", lines)),
            (std::vector<std::int64_t>{3, 7}));
  EXPECT_EQ(array<std::int64_t>(file, file.find("connectivity", file.find("<Verts>"))),
            (std::vector<std::int64_t>{6}));
}

TEST(WritePolylines, NothingIsAValidFile) {
  for (const char* extension : {"vtp", "obj", "ply"}) EXPECT_NE(written(extension, {}), "");
}

TEST(WritePolylines, AFileIsWrittenOrNamed) {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / "write_polylines.obj";
  IT::write_polylines(path, example());
  std::ifstream in(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), {});
  EXPECT_EQ(text, written("obj", example()));
  std::filesystem::remove(path);
  EXPECT_THROW(IT::write_polylines(path.parent_path() / "missing" / "x.obj", example()),
               std::runtime_error);
}

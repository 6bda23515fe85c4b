// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/Points_at_places.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans STL, text or binary, and merges the corners with equal coordinates.
class STL_scanner {
public:
  STL_scanner(std::istream& in, std::uintmax_t file_size, Soup_builder& out)
      : stream_(in), in_(in), file_size_(file_size), out_(out) {}

  void run() {
    if (is_binary())
      scan_binary();
    else
      scan_text();
    out_.line = 0;
  }

private:
  using Point = Points_at_places::Point;

  // The size decides, not the word solid, since many binary files start with it, too.
  bool is_binary() {
    char header[84] = {};
    stream_.read(header, 84);
    const bool whole = stream_.gcount() == 84;
    stream_.clear();
    stream_.seekg(0);
    std::string_view text(header, 84);
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    if (!is_word(next_word(text), "solid")) return true;
    return whole && file_size_ == 84 + 50 * std::uintmax_t(count_in(header));
  }

  static std::uint32_t count_in(const char* header) {
    std::uint32_t n = 0;
    for (unsigned i = 0; i < 4; ++i)
      n |= std::uint32_t(static_cast<unsigned char>(header[80 + i])) << (8 * i);
    return n;
  }

  std::size_t facet() const { return out_.number_of_faces(); }

  [[noreturn]] void fail(const std::string& what) {
    out_.fail(Element_kind::face, facet(), "facet " + std::to_string(facet()) + " " + what);
  }

  // Vertices are numbered in the order in which they first occur.
  void add_corner(const Point& p) {
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
      fail("has a coordinate that is not a finite number; correct it or remove the facet");
    const auto next = static_cast<std::uint32_t>(out_.number_of_vertices());
    const auto point_of = [&](std::uint32_t w) -> const Point& { return out_.point(w); };
    const std::uint32_t v = vertices_.find_or_add(p, next, point_of);
    if (v == next) out_.add_vertex(p[0], p[1], p[2]);
    face_.push_back(v);
  }

  void end_facet() {
    out_.add_face(face_);
    face_.clear();
  }

  void scan_binary() {
    char header[84];
    if (!in_.read(header, 84))
      out_.fail("the file is neither a text STL file, which starts with the word solid, nor long "
                "enough to be a binary one; get a complete copy");
    const std::uint32_t count = count_in(header);
    out_.reserve(0, static_cast<std::size_t>(std::min<std::uintmax_t>(count, file_size_ / 50)));
    for (std::uint32_t i = 0; i < count; ++i) {
      char record[50]; // a normal vector, three points, and an attribute
      if (!in_.read(record, sizeof(record))) fail_short(count);
      for (unsigned k = 3; k < 12; k += 3)
        add_corner({number(record, k), number(record, k + 1), number(record, k + 2)});
      end_facet();
    }
  }

  static double number(const char* record, unsigned k) {
    std::array<char, 4> bytes;
    std::copy_n(record + 4 * k, 4, bytes.begin());
    if (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    return static_cast<double>(std::bit_cast<float>(bytes));
  }

  [[noreturn]] void fail_short(std::uint32_t count) {
    fail("of the " + std::to_string(count) +
         " that the header announces is missing; the file is truncated, get a complete copy, or it "
         "is no STL file");
  }

  void scan_text() {
    bool in_solid = false, in_facet = false;
    for (auto word = next(); !word.empty(); word = next()) {
      if (in_facet && is_word(word, "vertex")) scan_corner();
      if (in_facet && is_word(word, "endfacet")) {
        in_facet = false;
        if (face_.size() != 3) fail("does not have three vertices; divide it into triangles");
        end_facet();
      }
      if (!in_facet && is_word(word, "solid")) in_solid = true;
      if (!in_facet && is_word(word, "endsolid")) in_solid = false;
      if (in_solid && is_word(word, "facet")) in_facet = true;
    }
    if (in_solid)
      out_.fail(Element_kind::face, facet(),
                "the file ends before facet " + std::to_string(facet()) +
                    " is complete or the solid is closed; it is truncated: get a complete copy");
  }

  std::string_view next() {
    const std::string_view word = in_.next_word_of_file(line_);
    out_.line = in_.line_number();
    return word;
  }

  void scan_corner() {
    Point p;
    for (double& x : p)
      if (!parse_number(next(), x))
        fail("has a vertex without three coordinates that are numbers; correct it, or get a "
             "complete copy if the file is truncated");
    add_corner(p);
  }

  std::istream& stream_;
  Buffered_input in_;
  std::uintmax_t file_size_;
  Soup_builder& out_;
  Points_at_places vertices_;
  std::vector<std::int64_t> face_; // the current one
  std::string_view line_;
};

} // namespace

void scan_STL(std::istream& in, std::uintmax_t file_size, Soup_builder& out) {
  STL_scanner(in, file_size, out).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal

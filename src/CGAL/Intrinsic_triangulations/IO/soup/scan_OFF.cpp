// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans the Object File Format with all its prefixes (ST, C, N, 4, n), as text or binary.
class OFF_scanner {
public:
  OFF_scanner(std::istream& in, std::uintmax_t file_size, Soup_builder& out)
      : in_(in), file_size_(file_size), out_(out) {}

  void run() {
    scan_header();
    // no more elements than the file has room for: a wrong count must not claim memory
    const std::int64_t room = static_cast<std::int64_t>(file_size_ / 6);
    out_.reserve(static_cast<std::size_t>(std::min(vertices_, room)),
                 static_cast<std::size_t>(std::min(faces_, room)));
    for (std::int64_t i = 0; i < vertices_; ++i) binary_ ? binary_vertex() : text_vertex();
    try {
      for (std::int64_t i = 0; i < faces_; ++i) binary_ ? binary_face() : text_face();
    } catch (const Invalid_input&) {
      if (short_face_) throw *short_face_;
      throw;
    }
  }

private:
  [[noreturn]] void fail_short(Element_kind kind) {
    const bool vertex = kind == Element_kind::vertex;
    const std::size_t read = vertex ? out_.number_of_vertices() : out_.number_of_faces();
    out_.fail(kind, read,
              std::string("the file ends before ") + (vertex ? "vertex " : "face ") +
                  std::to_string(read) + " of the " + std::to_string(vertex ? vertices_ : faces_) +
                  (vertex ? " vertices" : " faces") +
                  " that its header announces; it is truncated: get a complete copy");
  }

  // The rest of the current line, or the next line with content.
  bool next_line() {
    std::string_view rest = line_;
    const bool is_there = !next_word(rest).empty() || in_.next_content_line(line_, '#');
    if (!is_there) line_ = {};
    out_.line = in_.line_number();
    return is_there;
  }

  void scan_header() {
    if (!next_line()) out_.fail("the file is empty; an OFF file starts with the word OFF");
    scan_keyword(next_word(line_));
    std::string_view rest = line_;
    if (next_word(rest) == "BINARY") {
      line_ = {};
      binary_ = true;
    }
    const std::int64_t dimension = dimensional_ ? scan_count("dimension") : 3;
    if (dimension != 3)
      out_.fail("points of dimension " + std::to_string(dimension) +
                " are not supported; give points in space");
    vertices_ = scan_count("number of vertices");
    faces_ = scan_count("number of faces");
    if (!skel_) scan_count("number of edges");
  }

  void scan_keyword(std::string_view word) {
    std::string_view rest = word;
    const auto take = [&rest](std::string_view prefix) {
      const bool starts = rest.starts_with(prefix);
      if (starts) rest.remove_prefix(prefix.size());
      return starts;
    };
    textures_ = take("ST");
    colors_ = take("C");
    normals_ = take("N");
    homogeneous_ = take("4");
    dimensional_ = take("n");
    skel_ = rest == "SKEL";
    if (rest == "OFF" || skel_) return;
    out_.fail(
        "the file starts with \"" + shown(word) +
        "\" instead of OFF; check that it is an OFF file, or give it the extension of its format");
  }

  std::int64_t scan_count(const char* name) {
    std::int64_t value = -1;
    std::int32_t binary_value = 0;
    bool good = false;
    if (binary_) {
      good = read_binary(in_, binary_value, std::endian::big);
      value = binary_value;
    } else {
      good = next_line() && parse_integer(next_word(line_), value);
    }
    if (!good || value < 0)
      out_.fail(std::string("the header has no valid ") + name +
                "; it must give the numbers of vertices, faces and edges");
    return value;
  }

  void text_vertex() {
    if (!next_line()) fail_short(Element_kind::vertex);
    double p[4] = {0, 0, 0, 1};
    for (unsigned k = 0; k < (homogeneous_ ? 4U : 3U); ++k) {
      const std::string_view word = next_word(line_);
      if (word.empty()) fail_vertex("has only " + std::to_string(k) + " coordinates");
      if (!parse_number(word, p[k])) fail_vertex("has a coordinate that is not a number");
    }
    line_ = {};
    add_vertex(p);
  }

  [[noreturn]] void fail_vertex(const std::string& what) {
    out_.fail_vertex(" of " + std::to_string(vertices_) + " " + what +
                     "; correct the line, or the counts in the header if it is not a vertex");
  }

  void add_vertex(const double* p) {
    if (p[3] == 1)
      out_.add_vertex(p[0], p[1], p[2]);
    else
      out_.add_vertex(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
  }

  void text_face() {
    if (!next_line()) fail_short(Element_kind::face);
    std::int64_t size = 0;
    if (!parse_integer(next_word(line_), size) || size < 0)
      fail_face("does not start with its number of vertices");
    face_.clear();
    bool goes_on = false;
    for (std::int64_t k = 0; k < size; ++k) {
      std::string_view word = next_word(line_);
      if (word.empty()) {
        go_on_in_next_line(k, size);
        goes_on = true;
        word = next_word(line_);
      }
      std::int64_t v = 0;
      if (!parse_integer(word, v)) fail_face("has a vertex that is not a whole number");
      face_.push_back(v);
    }
    if (goes_on && !next_word(line_).empty()) throw *short_face_;
    line_ = {};
    out_.add_face(face_);
  }

  // A face may take several lines, and a face with missing vertices looks the same. If the next
  // line does not fit, the missing vertices are the error.
  void go_on_in_next_line(std::int64_t k, std::int64_t size) {
    if (!short_face_) try {
        fail_face("has only " + std::to_string(k) + " of " + std::to_string(size) + " vertices");
      } catch (const Invalid_input& error) {
        short_face_ = error;
      }
    if (!next_line()) throw *short_face_;
  }

  [[noreturn]] void fail_face(const std::string& what) {
    out_.fail_face(" of " + std::to_string(faces_) + " " + what +
                   "; correct the line, or get a complete copy if the file is truncated");
  }

  void skip_floats(std::int64_t count, Element_kind kind) {
    float ignored = 0;
    for (; count > 0; --count)
      if (!read_binary(in_, ignored, std::endian::big)) fail_short(kind);
  }

  void binary_vertex() {
    double p[4] = {0, 0, 0, 1};
    for (unsigned k = 0; k < (homogeneous_ ? 4U : 3U); ++k) {
      float x = 0;
      if (!read_binary(in_, x, std::endian::big)) fail_short(Element_kind::vertex);
      p[k] = static_cast<double>(x);
    }
    out_.line = 0;
    add_vertex(p);
    skip_floats((normals_ ? 3 : 0) + (colors_ ? 4 : 0) + (textures_ ? 2 : 0), Element_kind::vertex);
  }

  void binary_face() {
    out_.line = 0;
    const auto integer = [this] {
      std::int32_t value = 0;
      if (!read_binary(in_, value, std::endian::big)) fail_short(Element_kind::face);
      return value;
    };
    face_.clear();
    for (std::int32_t size = integer(); size > 0; --size) face_.push_back(integer());
    const std::int32_t color_components = integer();
    out_.add_face(face_);
    skip_floats(color_components, Element_kind::face);
  }

  Buffered_input in_;
  std::uintmax_t file_size_;
  Soup_builder& out_;
  std::string_view line_;
  std::vector<std::int64_t> face_;
  std::optional<Invalid_input> short_face_; // what is wrong with the first that went on
  std::int64_t vertices_ = 0, faces_ = 0;
  bool binary_ = false, skel_ = false;
  bool textures_ = false, colors_ = false, normals_ = false, homogeneous_ = false,
       dimensional_ = false;
};

} // namespace

void scan_OFF(std::istream& in, std::uintmax_t file_size, Soup_builder& out) {
  OFF_scanner(in, file_size, out).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal

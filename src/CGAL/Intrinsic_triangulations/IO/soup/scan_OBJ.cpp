// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans the vertices and faces of a Wavefront OBJ file; the rest is skipped, since programs write
// their own statements.
class OBJ_scanner {
public:
  OBJ_scanner(std::istream& in, Soup_builder& out) : in_(in), out_(out) {
    out_.first_reference = 1;
    out_.forward_references = true;
  }

  void run() {
    std::string_view line;
    while (in_.next_content_line(line, '#')) {
      out_.line = in_.line_number();
      // a backslash continues the line
      if (const auto last = line.find_last_not_of(" \t\r");
          last != std::string_view::npos && line[last] == '\\') {
        joined_ += line.substr(0, last);
        joined_ += ' ';
        continue;
      }
      if (joined_.empty()) {
        scan(line);
      } else {
        joined_ += line;
        scan(joined_);
        joined_.clear();
      }
    }
    if (!joined_.empty()) scan(joined_);
    const bool is_empty = out_.needs_faces || out_.number_of_vertices() == 0;
    if (is_empty && out_.number_of_faces() == 0 && unknown_line_ != 0) {
      out_.line = unknown_line_;
      out_.fail(std::string("the line is not a statement of an OBJ file, and the file has no ") +
                (out_.needs_faces ? "faces" : "points") +
                "; give it the "
                "extension of its format");
    }
  }

private:
  void scan(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word == "v")
      scan_vertex(line);
    else if (word == "f")
      scan_face(line);
    else if (unknown_line_ == 0 && !is_known(word))
      unknown_line_ = out_.line;
  }

  void scan_vertex(std::string_view line) {
    double p[3];
    for (double& x : p)
      if (!parse_number(next_word(line), x))
        out_.fail_vertex(
            " does not have three coordinates that are numbers; correct the line, or get "
            "a complete copy if the file is truncated");
    out_.add_vertex(p[0], p[1], p[2]);
  }

  // f v/vt/vn ...: negative references count back from the latest vertex.
  void scan_face(std::string_view line) {
    face_.clear();
    const auto count = std::int64_t(out_.number_of_vertices());
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      const std::string_view reference = word.substr(0, word.find('/'));
      std::int64_t v = 0;
      if (!parse_number(reference, v) || v == 0)
        out_.fail_face(" refers to vertex \"" + shown(reference) +
                       "\"; references are whole numbers other than 0: correct the line");
      if (v < 0 && -v > count)
        out_.fail_face(" refers to vertex " + std::to_string(v) + ", but only " +
                       std::to_string(count) +
                       " vertices come before it; correct the index or remove the face");
      face_.push_back(v > 0 ? v - 1 : count + v);
    }
    out_.add_face(face_);
  }

  static bool is_known(std::string_view word) {
    static constexpr std::array<std::string_view, 50> statements{
        "vt",       "vn",      "vp",         "p",      "l",         "g",      "s",      "o",
        "mg",       "bevel",   "c_interp",   "ctech",  "d_interp",  "lod",    "usemap", "usemtl",
        "mtllib",   "maplib",  "shadow_obj", "stech",  "trace_obj", "cstype", "deg",    "step",
        "bmat",     "con",     "curv",       "curv2",  "surf",      "parm",   "trim",   "hole",
        "scrv",     "sp",      "end",        "bsp",    "bzp",       "cdc",    "cdp",    "res",
        "call",     "csh",     "surf_1",     "surf_2", "q0_1",      "q1_1",   "q0_2",   "q1_2",
        "curv2d_1", "curv2d_2"};
    return std::ranges::find(statements, word) != statements.end();
  }

  Buffered_input in_;
  Soup_builder& out_;
  std::string joined_;
  std::size_t unknown_line_ = 0; // the first
  std::vector<std::int64_t> face_;
};

} // namespace

void scan_OBJ(std::istream& in, Soup_builder& out) { OBJ_scanner(in, out).run(); }

} // namespace CGAL::Intrinsic_triangulations::internal

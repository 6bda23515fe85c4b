// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans the vertices and triangles of the objects in a GOCAD file. The file itself gives numbers to
// vertices, in any order, anew in each object. Statements of other kinds are skipped.
class GOCAD_scanner {
public:
  GOCAD_scanner(std::istream& in, Soup_builder& out) : in_(in), out_(out) {}

  void run() {
    std::string_view line;
    while (in_.next_line(line)) {
      out_.line = in_.line_number();
      scan(line);
    }
    if (is_open_)
      out_.fail("the file ends without END, beyond vertex " +
                std::to_string(out_.number_of_vertices()) + " and face " +
                std::to_string(out_.number_of_faces()) + "; it is truncated: get a complete copy");
  }

private:
  void scan(std::string_view line) {
    const std::string_view word = next_word(line);
    if (word == "GOCAD") {
      begin_object();
    } else if (word == "END") {
      is_open_ = false;
    } else if (word == "VRTX" || word == "PVRTX") {
      scan_vertex(line);
    } else if (word == "ATOM" || word == "PATOM") {
      const std::int64_t name = number(next_word(line));
      vertices_[name] = vertex(number(next_word(line)));
    } else if (word == "TRGL") {
      face_.clear();
      for (int i = 0; i < 3; ++i) face_.push_back(vertex(number(next_word(line))));
      out_.add_face(face_);
    }
  }

  void begin_object() {
    if (is_open_) out_.fail("an object begins before END of the one before; complete that one");
    is_open_ = true;
    vertices_.clear();
  }

  void scan_vertex(std::string_view line) {
    const std::int64_t name = number(next_word(line));
    double p[3];
    for (double& x : p) {
      const std::string_view word = next_word(line);
      if (!parse_number(word, x))
        out_.fail_vertex(word.empty() ? " has fewer than three coordinates; complete the line"
                                      : " has \"" + shown(word) +
                                            "\" in place of a coordinate; correct it to a number "
                                            "with a decimal point");
    }
    vertices_[name] = std::int64_t(out_.number_of_vertices());
    out_.add_vertex(p[0], p[1], p[2]);
  }

  std::int64_t number(std::string_view word) const {
    std::int64_t n = 0;
    if (!parse_number(word, n))
      out_.fail("there is \"" + shown(word) +
                "\" in place of the number of a vertex; correct the line to a whole number");
    return n;
  }

  std::int64_t vertex(std::int64_t name) const {
    const auto found = vertices_.find(name);
    if (found == vertices_.end())
      out_.fail_face(" refers to vertex " + std::to_string(name) +
                     ", which no line before gives; correct the number or remove the line");
    return found->second;
  }

  Buffered_input in_;
  Soup_builder& out_;
  bool is_open_ = false; // whether an object has begun and not ended
  std::unordered_map<std::int64_t, std::int64_t> vertices_; // of this object, by their numbers
  std::vector<std::int64_t> face_;
};

} // namespace

void scan_GOCAD(std::istream& in, Soup_builder& out) { GOCAD_scanner(in, out).run(); }

} // namespace CGAL::Intrinsic_triangulations::internal

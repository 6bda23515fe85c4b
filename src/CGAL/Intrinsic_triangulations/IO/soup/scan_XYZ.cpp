// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/soup/scan.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans a list of points: three coordinates at the start of each line. What follows is skipped, as
// programs write normals and colors there.
class XYZ_scanner {
public:
  XYZ_scanner(std::istream& in, Soup_builder& out) : in_(in), out_(out) {}

  void run() {
    std::string_view line;
    while (in_.next_content_line(line, '#')) {
      out_.line = in_.line_number();
      if (out_.number_of_vertices() == 0 && !has_count_ && scan_count(line)) continue;
      scan_point(line);
    }
    if (out_.number_of_vertices() < count_)
      out_.fail(Element_kind::vertex, out_.number_of_vertices(),
                "the file ends before point " + std::to_string(out_.number_of_vertices()) +
                    " of the " + std::to_string(count_) +
                    " that its first line announces; it is truncated: get a complete copy");
    out_.line = 0;
  }

private:
  // The first line may hold the number of points, alone.
  bool scan_count(std::string_view line) {
    const std::string_view word = next_word(line);
    has_count_ = next_word(line).empty() && parse_number(word, count_);
    return has_count_;
  }

  void scan_point(std::string_view line) {
    double p[3];
    for (double& x : p) {
      const std::string_view word = next_word(line);
      if (!parse_number(word, x))
        fail(word.empty() ? " has fewer than three coordinates"
                          : " has \"" + shown(word) + "\" in place of a coordinate");
      if (!std::isfinite(x)) fail(" has a coordinate that is not a finite number");
    }
    out_.add_vertex(p[0], p[1], p[2]);
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::size_t v = out_.number_of_vertices();
    out_.fail(Element_kind::vertex, v,
              "point " + std::to_string(v) + what +
                  "; start the line with three numbers that are separated by spaces, or remove it");
  }

  Buffered_input in_;
  Soup_builder& out_;
  std::size_t count_ = 0;
  bool has_count_ = false;
};

} // namespace

void scan_XYZ(std::istream& in, Soup_builder& out) { XYZ_scanner(in, out).run(); }

} // namespace CGAL::Intrinsic_triangulations::internal

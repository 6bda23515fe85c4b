// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Scans the vertices, lines, points and labels of an OBJ file.
class Polyline_scanner {
public:
  explicit Polyline_scanner(std::istream& in) : in_(in) {}

  std::vector<Polyline> run() {
    for (std::string_view line; in_.next_line(line);) {
      const std::string_view word = text::next_word(line);
      if (word == "v")
        scan_vertex(line);
      else if (word == "l" || word == "p")
        scan_polyline(line);
      else if (word.starts_with('#'))
        scan_label(line);
    }
    return std::move(result_);
  }

private:
  // Of comments such as "# curve 5".
  void scan_label(std::string_view line) {
    text::next_word(line);
    std::int32_t label = 0;
    const std::string_view number = text::next_word(line);
    label_.reset();
    if (text::parse_number(number, label) && text::next_word(line).empty()) label_ = label;
  }

  void scan_vertex(std::string_view line) {
    std::array<double, 3> p;
    for (double& x : p)
      if (!text::parse_number(text::next_word(line), x))
        fail("the vertex does not have three coordinates; correct the line");
    points_.push_back(p);
  }

  // References count from 1, or back from the latest vertex.
  void scan_polyline(std::string_view line) {
    Polyline curve;
    curve.label = label_.value_or(static_cast<std::int32_t>(result_.size()));
    label_.reset();
    std::int64_t last = 0;
    for (std::string_view w = text::next_word(line); !w.empty(); w = text::next_word(line)) {
      const auto n = static_cast<std::int64_t>(points_.size());
      if (!text::parse_number(w.substr(0, w.find('/')), last) || last == 0 || last > n || last < -n)
        fail("the line refers to a vertex that is not there; correct it");
      if (last < 0) last += n + 1;
      curve.points.push_back(points_[static_cast<std::size_t>(last - 1)]);
    }
    close_polyline(curve);
    if (!curve.points.empty()) result_.push_back(std::move(curve));
  }

  [[noreturn]] void fail(const std::string& what) const {
    fail_polylines("line " + std::to_string(in_.line_number()) + ": " + what);
  }

  text::Buffered_input in_;
  std::vector<std::array<double, 3>> points_;
  std::vector<Polyline> result_;
  std::optional<std::int32_t> label_;
};

} // namespace

std::vector<Polyline> scan_polylines_OBJ(std::istream& in) { return Polyline_scanner(in).run(); }

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/read_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <istream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

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
    if (result_.empty())
      throw Invalid_input(Element_kind::none, 0,
                          "the file has no lines; give an .obj file with elements l");
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
    std::int64_t first = 0, last = 0;
    for (std::string_view w = text::next_word(line); !w.empty(); w = text::next_word(line)) {
      const auto n = static_cast<std::int64_t>(points_.size());
      if (!text::parse_number(w.substr(0, w.find('/')), last) || last == 0 || last > n || last < -n)
        fail("the line refers to a vertex that is not there; correct it");
      if (last < 0) last += n + 1;
      if (curve.points.empty()) first = last;
      curve.points.push_back(points_[static_cast<std::size_t>(last - 1)]);
    }
    curve.is_closed = curve.points.size() > 2 && first == last;
    if (curve.is_closed) curve.points.pop_back();
    if (!curve.points.empty()) result_.push_back(std::move(curve));
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Invalid_input(Element_kind::none, 0,
                        "line " + std::to_string(in_.line_number()) + ": " + what);
  }

  text::Buffered_input in_;
  std::vector<std::array<double, 3>> points_;
  std::vector<Polyline> result_;
  std::optional<std::int32_t> label_;
};

} // namespace

std::vector<Polyline> read_polylines(std::istream& in) { return Polyline_scanner(in).run(); }

std::vector<Polyline> read_polylines(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::runtime_error(path.string() +
                             ": the file cannot be read; give the path of an .obj file");
  try {
    return read_polylines(in);
  } catch (const Invalid_input& e) {
    throw std::runtime_error(path.string() + ": " + e.what());
  }
}

} // namespace CGAL::Intrinsic_triangulations

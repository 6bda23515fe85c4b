// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/curves/scan_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Buffered_input.h>

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

constexpr const char* expected_PLY =
    "the file is not as .ply has curves here, binary with vertices and edges; write the curves to "
    ".vtp or .obj";

// Scans vertices and edges, in the layout of `write_polylines()`.
class PLY_polyline_scanner {
public:
  explicit PLY_polyline_scanner(std::istream& in) : in_(in) {}

  std::vector<Polyline> run() {
    scan_header();
    points_.resize(vertices_);
    labels_.resize(vertices_);
    for (std::size_t i = 0; i < vertices_; ++i) {
      for (double& x : points_[i]) take(x);
      take(labels_[i]);
    }
    std::vector<char> is_used(vertices_, 0);
    for (std::size_t i = 0; i < edges_; ++i) {
      std::array<std::int32_t, 3> edge{};
      for (std::int32_t& x : edge) take(x);
      add_edge(edge, is_used);
    }
    for (Polyline& line : result_) close_polyline(line);
    for (std::size_t i = 0; i < vertices_; ++i)
      if (is_used[i] == 0) result_.push_back({{points_[i]}, false, labels_[i]});
    return std::move(result_);
  }

private:
  // The properties are those that are written, so that their types need not be looked at.
  void scan_header() {
    std::string header;
    for (std::string_view line; in_.next_line(line);) {
      if (line == "end_header") break;
      if (line.starts_with("comment")) continue;
      std::string_view rest = line;
      if (text::next_word(rest) == "element") {
        const std::string_view kind = text::next_word(rest);
        if (kind == "face")
          fail_polylines("the file has a surface; give it as the input, or give curves");
        std::size_t& count = kind == "edge" ? edges_ : vertices_;
        if (!text::parse_number(text::next_word(rest), count)) fail_polylines(expected_PLY);
        line = line.substr(0, static_cast<std::size_t>(rest.data() - line.data()));
        line = line.substr(0, line.rfind(' ')); // without the number
      }
      header.append(line).append(";");
    }
    if (!header.starts_with(
            "ply;format binary_little_endian 1.0;element vertex;"
            "property double x;property double y;property double z;property int ") ||
        header.find(";element edge;property int vertex1;property int vertex2;property int ") ==
            header.npos)
      fail_polylines(expected_PLY);
  }

  template <class T>
  void take(T& x) {
    if (!text::read_binary(in_, x, std::endian::little))
      fail_polylines("the file ends too early; write it again");
  }

  // An edge goes on where the one before has ended, or begins a line.
  void add_edge(const std::array<std::int32_t, 3>& edge, std::vector<char>& is_used) {
    for (std::size_t k = 0; k < 2; ++k) {
      if (edge[k] < 0 || static_cast<std::size_t>(edge[k]) >= vertices_)
        fail_polylines("an edge refers to vertex " + std::to_string(edge[k]) +
                       ", which is not there; write the file again");
      is_used[static_cast<std::size_t>(edge[k])] = 1;
    }
    if (result_.empty() || last_ != edge[0] || result_.back().label != edge[2])
      result_.push_back({{points_[static_cast<std::size_t>(edge[0])]}, false, edge[2]});
    last_ = edge[1];
    result_.back().points.push_back(points_[static_cast<std::size_t>(last_)]);
  }

  text::Buffered_input in_;
  std::size_t vertices_ = 0, edges_ = 0;
  std::vector<std::array<double, 3>> points_;
  std::vector<std::int32_t> labels_;
  std::vector<Polyline> result_;
  std::int32_t last_ = -1;
};

} // namespace

std::vector<Polyline> scan_polylines_PLY(std::istream& in) {
  return PLY_polyline_scanner(in).run();
}

} // namespace CGAL::Intrinsic_triangulations::internal

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "side_by_side.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace program {

namespace {

constexpr std::uint32_t none = IT::Common_subdivision::none;

// By how much numbers of the second surface grow: one more than the largest of the first.
std::uint32_t offset_of(const std::vector<std::uint32_t>& numbers) {
  std::uint32_t most = 0;
  for (const std::uint32_t i : numbers)
    if (i != none) most = std::max(most, i + 1);
  return most;
}

void append(std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from,
            std::uint32_t offset) {
  for (const std::uint32_t i : from) to.push_back(i == none ? none : i + offset);
}

void append_sides(std::vector<IT::Common_subdivision::Side>& to,
                  const std::vector<IT::Common_subdivision::Side>& from) {
  std::vector<std::uint32_t> input, intrinsic;
  for (const auto& side : to) {
    input.push_back(side.input_edge);
    intrinsic.push_back(side.intrinsic_edge);
  }
  const std::uint32_t after_input = offset_of(input), after_intrinsic = offset_of(intrinsic);
  const auto moved = [](std::uint32_t e, std::uint32_t offset) {
    return e == none ? none : e + offset;
  };
  for (const auto& side : from)
    to.push_back(
        {moved(side.input_edge, after_input), moved(side.intrinsic_edge, after_intrinsic)});
}

// Where the right one begins along x, so that a tenth of both widths is between them.
double shift(const std::vector<Point>& left, const std::vector<Point>& right) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double left_end = -infinity, left_begin = infinity, right_begin = infinity, right_end = -infinity;
  for (const Point& p : left) {
    left_begin = std::min(left_begin, p[0]);
    left_end = std::max(left_end, p[0]);
  }
  for (const Point& p : right) {
    right_begin = std::min(right_begin, p[0]);
    right_end = std::max(right_end, p[0]);
  }
  return left_end - right_begin + ((left_end - left_begin) + (right_end - right_begin)) / 10;
}

// The vertices in the order of a subdivision: all vertices of triangulations, then all crossings.
template <class Value>
std::vector<Value> merged(const std::vector<Value>& left, const std::vector<Value>& right,
                          std::size_t left_vertices, std::size_t right_vertices) {
  std::vector<Value> result(left.begin(), left.begin() + std::ptrdiff_t(left_vertices));
  result.insert(result.end(), right.begin(), right.begin() + std::ptrdiff_t(right_vertices));
  result.insert(result.end(), left.begin() + std::ptrdiff_t(left_vertices), left.end());
  result.insert(result.end(), right.begin() + std::ptrdiff_t(right_vertices), right.end());
  return result;
}

} // namespace

Surface_with_fields side_by_side(Surface_with_fields left, const Surface_with_fields& right) {
  IT::Common_subdivision& s = left.s;
  const IT::Common_subdivision& r = right.s;
  const std::size_t mine = s.vertices.size(), theirs = r.vertices.size();
  std::vector<Point> moved = right.points;
  const double x = shift(left.points, right.points);
  for (Point& p : moved) p[0] += x;
  left.points = merged(left.points, moved, mine, theirs);
  for (std::size_t i = 0; i < left.fields.size(); ++i)
    left.fields[i].values = merged(left.fields[i].values, right.fields[i].values, mine, theirs);
  const auto crossings = static_cast<std::uint32_t>(s.crossings.size());
  for (std::uint32_t& v : s.corner)
    if (v >= mine) v += static_cast<std::uint32_t>(theirs);
  for (const std::uint32_t v : r.corner)
    s.corner.push_back(v + static_cast<std::uint32_t>(v < theirs ? mine : mine + crossings));
  const std::uint32_t corners = s.face_begin.back();
  for (std::size_t f = 1; f < r.face_begin.size(); ++f)
    s.face_begin.push_back(corners + r.face_begin[f]);
  append(s.input_face, r.input_face, offset_of(s.input_face));
  append(s.intrinsic_face, r.intrinsic_face, offset_of(s.intrinsic_face));
  append(s.intrinsic_halfedge, r.intrinsic_halfedge, offset_of(s.intrinsic_halfedge));
  append(s.input_halfedge, r.input_halfedge, offset_of(s.input_halfedge));
  append_sides(s.side, r.side);
  if (!s.sheet.empty()) s.sheet.resize(s.number_of_faces(), 0);
  s.vertices.insert(s.vertices.end(), r.vertices.begin(), r.vertices.end());
  s.crossings.insert(s.crossings.end(), r.crossings.begin(), r.crossings.end());
  s.number_of_border_edges += r.number_of_border_edges;
  return left;
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Edge_point Isoline::end_of_piece(std::size_t piece) const {
  if (!is_closed && piece + 2 == points.size()) return points.back();
  const Edge_point& p = points[piece + 1 == points.size() ? 0 : piece + 1];
  return {p.halfedge ^ 1U, 1 - p.parameter};
}

std::vector<double> even_levels(std::span<const double> values, std::size_t count) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const double x : values) {
    if (!std::isfinite(x)) continue;
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
  std::vector<double> levels;
  for (std::size_t k = 1; k <= count && least <= greatest; ++k)
    levels.push_back(
        std::lerp(least, greatest, static_cast<double>(k) / static_cast<double>(count + 1)));
  return levels;
}

namespace internal {

namespace {

// Where a linear function on an edge has a value, from the end below (0) to the end above (1).
double parameter_of_level(double below, double above, double level) {
  const bool is_low = std::isinf(below), is_high = std::isinf(above);
  if (is_low || is_high) return is_low == is_high ? 0.5 : is_low ? 1 : 0;
  const double whole = above - below;
  const double x = std::isfinite(whole) ? (level - below) / whole
                                        : (level / 2 - below / 2) / (above / 2 - below / 2);
  return std::clamp(x, 0.0, 1.0);
}

// Traces the lines of one level after another. A corner sequence of a face with vertices below and
// above changes sides exactly twice: the line enters through the side that leads down, and leaves
// through the one that leads up. So every face has at most one piece, and the walk has no choice.
class Isoline_tracer {
public:
  explicit Isoline_tracer(const Function_on_halfedges& f)
      : f_(f), entered_at_(f.next.size(), std::numeric_limits<std::size_t>::max()) {}

  void trace(double level, std::size_t number, std::vector<Isoline>& lines) {
    level_ = level;
    number_ = number;
    // lines from border to border, then closed ones
    for (const bool is_closed : {false, true})
      for (const std::uint32_t first : f_.of_face) {
        const std::uint32_t h = entrance(first);
        if (h == Gluing::none || entered_at_[h] == number_) continue;
        if (is_closed || is_border(h ^ 1U)) lines.push_back(line_from(h));
      }
  }

private:
  bool is_border(std::uint32_t h) const { return f_.next[h] == Gluing::none; }
  bool is_above(std::uint32_t h) const { return f_.value[h] >= level_; }
  bool leads_down(std::uint32_t h) const { return is_above(h) && !is_above(f_.next[h]); }
  bool leads_up(std::uint32_t h) const { return !is_above(h) && is_above(f_.next[h]); }

  // the side of the face of h that a line enters through
  std::uint32_t entrance(std::uint32_t h) const {
    for (unsigned k = 0; k < 3; ++k, h = f_.next[h])
      if (leads_down(h)) return h;
    return Gluing::none;
  }

  Isoline line_from(std::uint32_t start) {
    Isoline line{level_, number_, true, {}};
    for (std::uint32_t h = start; entered_at_[h] != number_;) {
      entered_at_[h] = number_;
      const auto end_value = [&](std::uint32_t g) { return f_.value[f_.next[g]]; };
      line.points.push_back({h, 1 - parameter_of_level(end_value(h), f_.value[h], level_)});
      std::uint32_t exit = f_.next[h];
      while (!leads_up(exit)) exit = f_.next[exit];
      if (is_border(exit ^ 1U)) {
        line.is_closed = false;
        line.points.push_back({exit, parameter_of_level(f_.value[exit], end_value(exit), level_)});
        break;
      }
      h = exit ^ 1U;
    }
    return line;
  }

  const Function_on_halfedges& f_;
  // of each halfedge: the number of the last level with a line that enters its face there
  std::vector<std::size_t> entered_at_;
  double level_ = 0;
  std::size_t number_ = 0;
};

} // namespace

void Function_on_halfedges::resize(std::uint32_t edges) {
  next.assign(std::size_t{2} * edges, Gluing::none);
  value.assign(std::size_t{2} * edges, 0);
}

void Function_on_halfedges::add_face(const std::array<std::uint32_t, 3>& halfedges,
                                     const std::array<double, 3>& values) {
  of_face.push_back(halfedges[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    next[halfedges[k]] = halfedges[(k + 1) % 3];
    value[halfedges[k]] = values[k];
  }
}

double value_of_row(std::span<const double> values, std::uint32_t row) {
  if (row >= values.size())
    throw std::invalid_argument("isolines need a value for each vertex; there are " +
                                std::to_string(values.size()) + " and none for vertex " +
                                std::to_string(row));
  if (std::isnan(values[row]))
    throw std::invalid_argument("isolines: the value of vertex " + std::to_string(row) +
                                " is not a number");
  return values[row];
}

std::vector<Isoline> trace_isolines(const Function_on_halfedges& f, std::span<const double> levels,
                                    const std::function<bool(std::size_t)>& progress) {
  if (!std::ranges::all_of(levels, [](double x) { return std::isfinite(x); }))
    throw std::invalid_argument("isolines: a level is not finite");
  std::vector<Isoline> lines;
  Isoline_tracer tracer(f);
  for (std::size_t i = 0; i < levels.size() && progress(i); ++i) tracer.trace(levels[i], i, lines);
  return lines;
}

void add_polyline(std::size_t level, bool is_closed,
                  const std::vector<std::array<double, 3>>& points,
                  std::vector<Polyline>& polylines) {
  Polyline all{{}, is_closed, static_cast<std::int32_t>(level)};
  for (const std::array<double, 3>& p : points)
    if (all.points.empty() || all.points.back() != p) all.points.push_back(p);
  if (all.is_closed && all.points.size() > 1 && all.points.back() == all.points.front())
    all.points.pop_back();
  if (all.points.size() > 1) polylines.push_back(std::move(all));
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

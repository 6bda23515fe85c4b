// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_CHORD_BOUND_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_CHORD_BOUND_H

#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// A ball in space that a piece of a source is in.
struct Source_ball {
  std::array<double, 3> center;
  double radius;
};

// Finds the distance in space to the nearest of many balls, which is no longer than any way on the surface: balls in a tree
// that halves them by coordinates in turn.
class Chord_bound {
public:
  Chord_bound() = default;
  explicit Chord_bound(std::vector<Source_ball> balls) : balls_(std::move(balls)) {
    for (const Source_ball& b : balls_) greatest_radius_ = std::max(greatest_radius_, b.radius);
    split(0, balls_.size(), 0);
  }

  // \return the least of a distance and the bound, negative if there are no balls
  double nearest(const std::array<double, 3>& p) const {
    double best = balls_.empty() ? 0 : std::numeric_limits<double>::infinity();
    search(p, 0, balls_.size(), 0, best);
    return best;
  }

private:
  void split(std::size_t begin, std::size_t end, std::size_t axis) {
    if (end - begin < 2) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [this](std::size_t i) {
      return balls_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    std::nth_element(at(begin), at(middle), at(end), [axis](const auto& a, const auto& b) {
      return a.center[axis] < b.center[axis];
    });
    split(begin, middle, (axis + 1) % 3);
    split(middle + 1, end, (axis + 1) % 3);
  }

  // without `std::hypot()`, which takes long, where squares are well within the range of doubles
  static double distance(const std::array<double, 3>& p, const std::array<double, 3>& q) {
    const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
    const double squared = x * x + y * y + z * z;
    return squared > 1e-280 && squared < 1e280 ? std::sqrt(squared) : std::hypot(x, y, z);
  }

  void search(const std::array<double, 3>& p, std::size_t begin, std::size_t end, std::size_t axis,
              double& best) const {
    if (begin == end) return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Source_ball& b = balls_[middle];
    best = std::min(best, distance(p, b.center) - b.radius);
    const double beyond = p[axis] - b.center[axis];
    const std::size_t other = (axis + 1) % 3;
    const bool is_left = beyond < 0;
    is_left ? search(p, begin, middle, other, best) : search(p, middle + 1, end, other, best);
    if (std::abs(beyond) - greatest_radius_ > best) return;
    is_left ? search(p, middle + 1, end, other, best) : search(p, begin, middle, other, best);
  }

  std::vector<Source_ball> balls_;
  double greatest_radius_ = 0;
};

// Where the vertices of each row are in space, in scaled units; not finite where that is not known.
template <NumberedTriangulation Triangulation>
std::vector<std::array<double, 3>> positions_of_rows(const Triangulation& t) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  std::vector<std::array<double, 3>> result(t.number_of_vertices(), {unknown, unknown, unknown});
  const Input_metric& metric = t.input().metric();
  const auto& points = metric.points();
  if (points.empty()) return {};
  for (std::uint32_t f = 0; f < metric.number_of_faces(); ++f)
    if (metric.has_excess(f)) return {}; // faces that are not flat in space: chords are no bound
  for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh())) {
    const std::uint32_t i = t.index(v);
    if (!t.is_inserted(v)) {
      if (i < points.size()) result[t.input_vertex(v)] = points[i];
      continue;
    }
    if constexpr (requires { t.places()->location(i); })
      if (const auto* places = t.places(); places != nullptr) {
        const Surface_point& p = places->location(i);
        std::array<double, 3> x{0, 0, 0};
        std::uint32_t h = p.halfedge;
        for (std::size_t k = 0; k < 3; ++k, h = places->input().next(h))
          for (std::size_t c = 0; c < 3; ++c)
            x[c] += p.weights[k] * points[places->input().source(h)][c];
        result[t.input_vertex(v)] = x;
      }
  }
  return result;
}

// Balls about the sources: points for vertices; else about the corner of the face that is nearest.
// \return nothing, if a source is where no position is known
inline std::vector<Source_ball> source_balls(const Face_table& table, const Source_places& sources,
                                             const std::vector<std::array<double, 3>>& positions) {
  std::vector<Source_ball> balls;
  if (positions.empty()) return balls;
  const auto add = [&](int row, double radius) {
    balls.push_back({positions[static_cast<std::size_t>(row)], radius});
  };
  for (const int row : sources.rows) add(row, 0);
  for (const Source_side& s : sources.sides) {
    const Table_face& f = table.faces[s.face];
    for (const std::size_t k : {s.side, (s.side + 1) % 3}) add(f.rows[k], f.length(s.side) / 2);
  }
  for (const Source_segment& s : sources.segments) {
    const auto corners = table.faces[s.face].layout();
    const auto a = place_in_layout(corners, s.from), b = place_in_layout(corners, s.to);
    std::pair<double, int> nearest{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t k = 0; k < 3; ++k)
      nearest = std::min(nearest, {std::max(std::abs(corners[k] - a), std::abs(corners[k] - b)),
                                   table.faces[s.face].rows[k]});
    add(nearest.second, nearest.first);
  }
  for (const Source_ball& b : balls)
    if (!std::isfinite(b.center[0])) return {};
  return balls;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_CHORD_BOUND_H

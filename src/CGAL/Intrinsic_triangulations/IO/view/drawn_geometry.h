// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Centres points and scales them to the unit ball before rounding them to single precision; it
// first halves each coordinate, so that no difference overflows.
class Unit_ball_scaling {
  using Point = std::array<double, 3>;

public:
  explicit Unit_ball_scaling(std::span<const Point> points) {
    for (std::size_t c = 0; c < 3 && !points.empty(); ++c) {
      const auto [least, greatest] =
          std::minmax_element(points.begin(), points.end(),
                              [c](const Point& p, const Point& q) { return p[c] < q[c]; });
      low_[c] = (*least)[c] / 2;
      extent_[c] = (*greatest)[c] / 2 - low_[c];
    }
    const double greatest = std::max({extent_[0], extent_[1], extent_[2]});
    unit_ = greatest > 0 ? greatest : 1;
    double radius = 0;
    for (const Point& p : points)
      radius = std::max(radius, std::hypot(centred(p, 0), centred(p, 1), centred(p, 2)));
    radius_ = radius > 0 ? radius : 1;
  }

  std::array<float, 3> operator()(const Point& p) const {
    std::array<float, 3> result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = static_cast<float>(centred(p, c) / radius_);
    return result;
  }
  // the sides of the bounding box after scaling
  Point scaled_extent() const {
    Point result;
    for (std::size_t c = 0; c < 3; ++c) result[c] = extent_[c] / unit_ / radius_;
    return result;
  }
  // the length that is scaled to 1; infinite if it is none
  double radius() const { return 2 * unit_ * radius_; }

private:
  double centred(const Point& p, std::size_t c) const {
    return ((p[c] / 2 - low_[c]) - extent_[c] / 2) / unit_;
  }

  Point low_{0, 0, 0}, extent_{0, 0, 0};
  double unit_ = 1, radius_ = 1;
};

// The edges of one triangulation as segments, each with the room that there is to draw it: the
// height over the whole edge of the smaller of the faces beside it. In a bundle of slivers it is
// small.
struct Drawn_edges {
  std::vector<std::uint32_t> ends; // two vertices of the subdivision per segment
  std::vector<std::uint32_t> edge; // the edge of each segment
  std::vector<float> room;         // one per segment
  // on a cover: 1 for a segment beside fronts of faces, 2 beside backs, or 3
  std::vector<std::uint8_t> sheets;
};

// The sheets beside each side of a face; empty if there is one sheet. What lies on an edge of the
// input lies beside the faces there, all else inside of a face.
inline std::vector<std::uint8_t> sheets_beside(const Common_subdivision& s) {
  std::vector<std::uint8_t> result, beside_edge;
  if (s.sheet.empty()) return result;
  const auto edge = [&s](std::size_t c) { return std::size_t{s.side[c].input_edge}; };
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (std::size_t c = s.face_begin[f]; c < s.face_begin[f + 1]; ++c) {
      result.push_back(static_cast<std::uint8_t>(1U << s.sheet[f]));
      if (edge(c) == Common_subdivision::none) continue;
      if (edge(c) >= beside_edge.size()) beside_edge.resize(edge(c) + 1, 0);
      beside_edge[edge(c)] |= result.back();
    }
  for (std::size_t c = 0; c < result.size(); ++c)
    if (edge(c) != Common_subdivision::none) result[c] = beside_edge[edge(c)];
  return result;
}

// The area of each face of a triangulation, the sum of its pieces; `face_of` labels its faces.
inline std::vector<double> drawn_areas(const Common_subdivision& s,
                                       std::span<const std::array<float, 3>> points,
                                       const std::vector<std::uint32_t>& face_of) {
  const auto area = [&points](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::array<double, 3> u, v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = double{points[b][i]} - double{points[a][i]};
      v[i] = double{points[c][i]} - double{points[a][i]};
    }
    const auto minor = [&](std::size_t i, std::size_t j) { return u[i] * v[j] - u[j] * v[i]; };
    return std::hypot(minor(0, 1), minor(1, 2), minor(2, 0)) / 2;
  };
  std::vector<double> result;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    if (face_of[f] >= result.size()) result.resize(face_of[f] + std::size_t{1}, 0);
    const std::span<const std::uint32_t> v = s.face(f);
    for (std::size_t k = 2; k < v.size(); ++k) result[face_of[f]] += area(v[0], v[k - 1], v[k]);
  }
  return result;
}

// The edges of one of the two triangulations of a common subdivision: `edge_of` labels its edges.
inline Drawn_edges drawn_edges(const Common_subdivision& s,
                               std::span<const std::array<float, 3>> points,
                               std::uint32_t Common_subdivision::Side::*edge_of,
                               const std::vector<std::uint32_t>& face_of) {
  using Side = Common_subdivision::Side;
  const std::vector<double> area = drawn_areas(s, points, face_of);
  std::size_t bound = 0;
  for (const Side& side : s.side)
    if (side.*edge_of != Common_subdivision::none)
      bound = std::max(bound, std::size_t{side.*edge_of} + 1);
  std::vector<double> least(bound, std::numeric_limits<double>::infinity()), length(bound, 0);
  for (std::size_t f = 0; f < s.number_of_faces(); ++f)
    for (const Side& side : s.sides(f))
      if (const std::uint32_t e = side.*edge_of; e != Common_subdivision::none)
        least[e] = std::min(least[e], area[face_of[f]]);
  const std::vector<std::uint8_t> sheets = sheets_beside(s);
  Drawn_edges result;
  for_each_subdivision_edge(s, [&](std::uint32_t a, std::uint32_t b, const Side& side) {
    const std::uint32_t e = side.*edge_of;
    if (e == Common_subdivision::none) return;
    const auto difference = [&](std::size_t i) {
      return double{points[b][i]} - double{points[a][i]};
    };
    length[e] += std::hypot(difference(0), difference(1), difference(2));
    result.ends.insert(result.ends.end(), {a, b});
    result.edge.push_back(e);
    if (!sheets.empty())
      result.sheets.push_back(sheets[static_cast<std::size_t>(&side - s.side.data())]);
  });
  for (const std::uint32_t e : result.edge)
    result.room.push_back(length[e] > 0 ? static_cast<float>(2 * least[e] / length[e]) : 0.f);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_GEOMETRY_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_EDGES_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges of one triangulation as segments, each with the room that there is to draw it: the height
// over the whole edge of the smaller of the faces beside it. In a bundle of slivers it is small.
struct Drawn_edges {
  std::vector<std::uint32_t> ends; // two vertices of the subdivision per segment
  std::vector<float> room;         // one per segment
};

// Computes the edges and faces of one of the two triangulations of a common subdivision.
class Drawn_edges_builder {
  using Side = Common_subdivision::Side;
  using Point = std::array<float, 3>;
  static constexpr std::uint32_t none = Common_subdivision::none;

public:
  // `edge_of` is the label of the triangulation's edges, `face_of` that of its faces.
  Drawn_edges_builder(const Common_subdivision& s, std::span<const Point> points,
                      std::uint32_t Side::*edge_of, const std::vector<std::uint32_t>& face_of)
      : s_(s), points_(points), edge_of_(edge_of), face_of_(face_of) {}

  Drawn_edges build() const {
    const std::vector<double> area = face_areas();
    std::size_t bound = 0;
    for (const Side& side : s_.side)
      if (side.*edge_of_ != none) bound = std::max(bound, std::size_t{side.*edge_of_} + 1);
    std::vector<double> least(bound, std::numeric_limits<double>::infinity()), length(bound, 0);
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f)
      for (const Side& side : s_.sides(f))
        if (const std::uint32_t e = side.*edge_of_; e != none)
          least[e] = std::min(least[e], area[face_of_[f]]);
    for_each_segment([&](std::uint32_t a, std::uint32_t b, std::uint32_t e) {
      length[e] += std::hypot(difference(a, b, 0), difference(a, b, 1), difference(a, b, 2));
    });
    Drawn_edges result;
    for_each_segment([&](std::uint32_t a, std::uint32_t b, std::uint32_t e) {
      result.ends.insert(result.ends.end(), {a, b});
      result.room.push_back(length[e] > 0 ? static_cast<float>(2 * least[e] / length[e]) : 0.f);
    });
    return result;
  }

private:
  template <class Visit>
  void for_each_segment(Visit visit) const {
    for_each_subdivision_edge(s_, [&](std::uint32_t a, std::uint32_t b, const Side& side) {
      if (side.*edge_of_ != none) visit(a, b, side.*edge_of_);
    });
  }

  double difference(std::uint32_t a, std::uint32_t b, std::size_t c) const {
    return double{points_[b][c]} - double{points_[a][c]};
  }

  double area(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const auto minor = [&](std::size_t i, std::size_t j) {
      return difference(a, b, i) * difference(a, c, j) - difference(a, b, j) * difference(a, c, i);
    };
    return std::hypot(minor(0, 1), minor(1, 2), minor(2, 0)) / 2;
  }

  // The area of each face of the triangulation, the sum of its pieces.
  std::vector<double> face_areas() const {
    std::size_t bound = 0;
    for (const std::uint32_t f : face_of_) bound = std::max(bound, std::size_t{f} + 1);
    std::vector<double> result(bound, 0);
    for (std::size_t f = 0; f < s_.number_of_faces(); ++f) {
      const std::span<const std::uint32_t> v = s_.face(f);
      for (std::size_t k = 2; k < v.size(); ++k) result[face_of_[f]] += area(v[0], v[k - 1], v[k]);
    }
    return result;
  }

  const Common_subdivision& s_;
  std::span<const Point> points_;
  std::uint32_t Side::*edge_of_;
  const std::vector<std::uint32_t>& face_of_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_DRAWN_EDGES_H

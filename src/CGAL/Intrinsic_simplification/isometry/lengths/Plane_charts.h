// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Maps z to turn z + shift.
struct Plane_motion {
  std::uint32_t chart;
  Plane_number turn, shift;

  friend bool operator<(const Plane_motion& a, const Plane_motion& b) {
    if (a.chart != b.chart) return a.chart < b.chart;
    return a.turn == b.turn ? a.shift < b.shift : a.turn < b.turn;
  }
};

/*
Lays out faces in planes, exactly. Neighbours with rational squared lengths, whose areas are
rational multiples of each other, have one chart: with the area a of its first face, which names it,
points are x + y i a, where x and y are rational, and the first side of that face is 1. All faces of
a plane in space have one chart, and so has the whole surface of a cube.

So positions in a chart follow from no root and no division but those here, whatever moves do to the
faces.
*/
class Plane_charts {
public:
  using Halfedge = Gluing_map::Halfedge;
  static constexpr std::uint32_t none = Gluing::none;
  // The squared length of an edge if it is rational, and easy to find.
  using Squared_length = std::function<const std::optional<Gmpq>&(std::uint32_t edge)>;

  // no charts
  Plane_charts() = default;
  // \param first_side of each face
  Plane_charts(const Gluing_map& mesh, const std::vector<std::uint32_t>& first_side,
               const std::vector<char>& is_face_wanted, const Squared_length& squared_length);

  // The chart of a face, or none.
  std::uint32_t chart(std::uint32_t face) const { return chart_.empty() ? none : chart_[face]; }
  // The number of the point where a halfedge starts, in the chart of its face.
  std::uint32_t number_of_point(std::uint32_t halfedge) const { return point_[halfedge]; }
  const Plane_number& point(std::uint32_t number) const { return points_[number]; }
  // that of the quadruple area of its first face
  const Gmpq& squared_area(std::uint32_t chart) const { return squared_area_[chart]; }

  // The motion that takes the chart of the face across a halfedge to that of its own face, which is
  // the same chart; nothing if it is the identity. \pre the mesh is that of the constructor
  std::optional<Plane_motion> motion_across(const Gluing_map& mesh, Halfedge h) const;
  // first b, then a
  Plane_motion composed(const Plane_motion& a, const Plane_motion& b) const;
  Plane_motion inverse(const Plane_motion& a) const;
  static bool is_identity(const Plane_motion& a) {
    return a.turn == Plane_number{1, 0} && a.shift == Plane_number{0, 0};
  }

private:
  std::optional<Rational_triangle> triangle(const Gluing_map& mesh, Halfedge h) const;
  bool start_chart(const Gluing_map& mesh, Halfedge first);
  bool place_across(const Gluing_map& mesh, Halfedge h);
  std::uint32_t number(const Gluing_map& mesh, Halfedge o, const Plane_number& apex);
  const Plane_number& source(Halfedge h) const { return points_[point_[h.index]]; }

  const Squared_length* squared_length_ = nullptr; // while charts are made
  std::vector<std::uint32_t> chart_;               // of each face
  std::vector<std::uint32_t> point_;               // of each halfedge
  std::vector<Plane_number> points_;
  std::vector<Gmpq> squared_area_; // of charts, by their faces
  std::vector<std::size_t> bits_;  // of the lengths of these faces
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H

#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Plane_number.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
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
  // The squared length of an edge if it is rational, and easy to find, else null. Equal lengths
  // should be one object: then much that follows from them is found once.
  using Squared_length = std::function<const Gmpq*(std::uint32_t edge)>;

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
  // Returns the grid of a chart; null if there is no such chart, or its points are on no grid.
  const Chart_grid* grid(std::uint32_t chart) const {
    const auto known = charts_.find(chart);
    return known == charts_.end() || !known->second.grid.exists() ? nullptr : &known->second.grid;
  }
  // \pre its chart has a grid
  const Grid_point& grid_point(std::uint32_t number) const { return grid_points_[number]; }
  // that of the quadruple area of its first face
  const Gmpq& squared_area(std::uint32_t chart) const { return charts_.at(chart).squared_area; }

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
  struct Chart {
    Gmpq squared_area;
    std::size_t bits; // of the lengths of its first face
    Chart_grid grid;
  };
  using Sides = std::array<const Gmpq*, 3>; // squared lengths
  // A face with its first side from 0 to 1, in the numbers of a chart.
  struct Placed_triangle {
    Sides sides{};
    std::uint32_t chart = none;
    std::optional<Plane_number> apex; // nothing if it does not belong to the chart
    std::size_t bits = 0;             // of its lengths
  };
  // nothing if the face has no rational lengths
  std::optional<Sides> sides_of(const Gluing_map& mesh, Halfedge h) const;
  const Placed_triangle& placed(const Sides& sides, std::uint32_t chart);
  bool start_chart(const Gluing_map& mesh, Halfedge first);
  bool place_across(const Gluing_map& mesh, Halfedge h);
  std::uint32_t number(const Gluing_map& mesh, Halfedge o, const Plane_number& apex);
  void find_grids(const Gluing_map& mesh);
  const Plane_number& source(Halfedge h) const { return points_[point_[h.index]]; }

  const Squared_length* squared_length_ = nullptr; // while charts are made
  std::vector<std::uint32_t> chart_;               // of each face
  std::vector<std::uint32_t> point_;               // of each halfedge
  std::vector<Plane_number> points_;
  std::vector<Grid_point> grid_points_;             // of each point, if its chart has a grid
  std::unordered_map<std::uint32_t, Chart> charts_; // by their first faces
  std::vector<Placed_triangle> placed_;             // the last ones, while charts are made
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_LENGTHS_PLANE_CHARTS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

/*!
\file
Where edges of the two triangulations cross: in which order, and where along the edges.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lists for every intrinsic edge the input edges that it crosses, and for every input edge the
crossings along it.

Crossings on edge `e` are consecutive, in the order in which halfedge `2e` meets them.
*/
struct Edge_crossings {
  /// First crossing of each intrinsic edge, and one entry more.
  std::vector<std::uint32_t> begin;
  /// For each crossing the input halfedge of the face that halfedge `2e` enters there.
  std::vector<std::uint32_t> entered;
  /// First entry in `on_curve` of each curve that is crossed, and one entry more. A curve is an
  /// input edge, or a part of one between inserted vertices, in the direction of its even halfedge.
  std::vector<std::uint32_t> curve_begin{0};
  /// Crossings on each curve, in order.
  std::vector<std::uint32_t> on_curve;

  /// returns the number of crossings.
  std::size_t size() const { return entered.size(); }
  /// returns the number of the crossing that is passed by intrinsic halfedge `h` after `position`
  /// others.
  std::uint32_t crossing(std::uint32_t h, Normal_coordinate position) const {
    const auto p = static_cast<std::uint32_t>(position);
    return h % 2 == 0 ? begin[h / 2] + p : begin[h / 2 + 1] - 1 - p;
  }
  /// returns the input halfedge of the face that intrinsic halfedge `h` enters at that crossing.
  std::uint32_t entered_by(std::uint32_t h, Normal_coordinate position) const {
    return entered[crossing(h, position)] ^ (h & 1U);
  }
  /// returns the input halfedges that halfedge `2 * edge` crosses.
  std::span<const std::uint32_t> entered_on(std::uint32_t edge) const {
    return {entered.data() + begin[edge], begin[edge + 1] - begin[edge]};
  }
};

namespace internal {

// The crossings as faces see them: their numbers twice, and the last bit of the halfedge of the
// face.
template <class Triangulation, CurveCoordinates Coordinates>
struct Linked_crossings {
  std::vector<std::uint32_t>
      linked; // the other end of the curve in the face; none if it is at a corner
  std::vector<std::array<std::uint32_t, 2>>
      starts; // where curves leave their first faces, input halfedge

  Linked_crossings(const Triangulation& t, const Coordinates& coordinates,
                   const Edge_crossings& crossings)
      : linked(2 * crossings.size(), Gluing::none) {
    const Intrinsic_view<Triangulation> view(t);
    const auto seen = [&](std::uint32_t h, Normal_coordinate position) {
      return 2 * crossings.crossing(h, position) + (h & 1U);
    };
    for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
      const auto s = sides_of_face(view, view.halfedge_of_face(t.index(f)));
      const Corner_coordinates c = corner_coordinates(view, coordinates, s[0]);
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t next = s[(k + 1) % 3], last = s[(k + 2) % 3];
        for (Normal_coordinate i = 0; i < c.cutting[k]; ++i) {
          const Normal_coordinate from_end = coordinates.normal_coordinate(last / 2) - 1 - i;
          const std::uint32_t a = seen(s[k], i), b = seen(last, from_end);
          linked[a] = b;
          linked[b] = a;
        }
        for (Normal_coordinate i = 0; i < c.emanating[k]; ++i) {
          const std::uint32_t x = input_halfedge(coordinates, Curve_end{s[k], i});
          if (x % 2 == 0) starts.push_back({seen(next, c.cutting[(k + 1) % 3] + i), x});
        }
      }
    }
  }
};

// numbers the crossings along intrinsic edges, and says nothing else of them
template <class Coordinates>
Edge_crossings numbered_crossings(const Coordinates& coordinates) {
  Edge_crossings result;
  std::uint64_t count = 0;
  for (std::uint32_t e = 0; e < coordinates.number_of_edges(); ++e) {
    result.begin.push_back(static_cast<std::uint32_t>(count));
    count += static_cast<std::uint64_t>(crossings(coordinates.normal_coordinate(e)));
    if (count >> 31U != 0)
      throw std::length_error("input and intrinsic edges cross more than 2^31 times");
  }
  result.begin.push_back(static_cast<std::uint32_t>(count));
  result.entered.resize(count, Gluing::none);
  return result;
}

// Finds the input halfedges that each edge crosses, and not their order along curves. Curves that
// start side by side are followed together, the longest rows first: those over slivers from the
// vertex that these share, which takes one step where the other ends take hundreds.
template <class Triangulation, class Coordinates>
Edge_crossings follow_rows_of_curves(const Triangulation& t, const Coordinates& coordinates) {
  Edge_crossings result = numbered_crossings(coordinates);
  const Intrinsic_view<Triangulation> view(t);
  std::vector<std::pair<Normal_coordinate, std::uint32_t>> rows; // length, and first side of corner
  for (const typename Triangulation::face_descriptor f : faces(t.mesh())) {
    const auto s = sides_of_face(view, view.halfedge_of_face(t.index(f)));
    const Corner_coordinates c = corner_coordinates(view, coordinates, s[0]);
    for (unsigned k = 0; k < 3; ++k)
      if (c.emanating[k] > 0) rows.emplace_back(c.emanating[k], s[k]);
  }
  std::sort(rows.begin(), rows.end(), std::greater<>());
  std::vector<Curve_bundle> stack;
  std::vector<std::uint32_t> along; // of the curves of a row
  const auto pass = [&](const Curve_bundle& b) {
    for (Normal_coordinate i = 0; i < b.count; ++i)
      result.entered[result.crossing(b.halfedge, b.position + i)] =
          along[static_cast<std::size_t>(b.number + i)] ^ (b.halfedge & 1U);
  };
  for (const auto& row : rows) {
    const Normal_coordinate count = row.first;
    along.clear();
    for (Normal_coordinate i = 0; i < count; ++i)
      along.push_back(input_halfedge(coordinates, Curve_end{row.second, i}));
    const Curve_crossing first = first_crossing(view, coordinates, Curve_end{row.second, 0});
    const auto is_known = [&](Normal_coordinate i) { // from the other end
      return result.entered[result.crossing(first.halfedge, first.position + i)] != Gluing::none;
    };
    for (Normal_coordinate i = 0, end = 0; i < count; i = end) {
      for (end = i + 1; end < count && is_known(end) == is_known(i);) ++end;
      if (is_known(i)) continue;
      const Curve_bundle unknown{first.halfedge, first.position + i, end - i, i};
      follow_curves(
          view, coordinates, unknown, stack, [](auto&&...) {}, pass);
    }
  }
  return result;
}

// `edge_crossings()`, also for triangulations whose metric has no values.
template <class Triangulation, class Coordinates>
Edge_crossings follow_all_curves(const Triangulation& t, const Coordinates& coordinates) {
  Edge_crossings result = numbered_crossings(coordinates);
  result.on_curve.reserve(result.size());
  const Linked_crossings<Triangulation, Coordinates> all(t, coordinates, result);
  result.curve_begin.reserve(all.starts.size() + 1);
  for (const auto& [first, x] : all.starts) {
    for (std::uint32_t i = first; i != Gluing::none; i = all.linked[i ^ 1U]) {
      result.entered[i / 2] = x ^ (i & 1U); // leaves a face from left to right
      result.on_curve.push_back(i / 2);
    }
    result.curve_begin.push_back(static_cast<std::uint32_t>(result.on_curve.size()));
  }
  return result;
}

} // namespace internal

/*!
\brief follows all input edges over the intrinsic triangulation.
\param t the triangulation
\param coordinates its normal coordinates and roundabouts, a model of `CurveCoordinates`
\throws std::length_error if there are more than 2^31 crossings
\complexity linear in the number of edges and crossings
*/
template <IndexedTriangulation Triangulation, CurveCoordinates Coordinates>
Edge_crossings edge_crossings(const Triangulation& t, const Coordinates& coordinates) {
  return internal::follow_all_curves(t, coordinates);
}

/*!
\brief holds where crossings are along the edges.
*/
struct Crossing_parameters {
  /// Per crossing: 0 at the source of the even halfedge of the input edge, 1 at its target.
  std::vector<double> on_input;
  /// Per crossing: 0 at the source of the even halfedge of the intrinsic edge, 1 at its target.
  std::vector<double> on_intrinsic;
};

namespace internal {

/// A point in the plane of doubles.
using Point = Plane_vector<double>;

/// Unfolds the input triangles along an intrinsic edge; keeps its memory from edge to edge.
template <class Input>
class Edge_strip {
public:
  explicit Edge_strip(const Input& input) : input_(input) {}

  /// unfolds the strip between two points, of the face before the first and after the last of the
  /// input halfedges `entered`.
  void unfold(const Surface_point& from, const Surface_point& to,
              std::span<const std::uint32_t> entered) {
    strip_.start(entered.front());
    for (const std::uint32_t x : entered.subspan(1)) strip_.enter(input_, strip_.last(), x);
    z_ = {{0, 0}, {std::sqrt(input_.squared_length(entered.front() / 2)), 0}};
    strip_.develop(z_, approximate_values(input_), entered.size() - 1);
    line_ = {place(seen_from(input_, from, entered.front() ^ 1U), z_[1], z_[0]),
             place(seen_from(input_, to, entered.back()), side(entered.size() - 1, 0),
                   side(entered.size() - 1, 1))};
  }

  /// unfolds the strip along an intrinsic halfedge, which enters the faces of `entered`.
  template <class View, CurveCoordinates Coordinates>
  void unfold(const View& view, const Coordinates& coordinates, std::uint32_t h,
              std::span<const std::uint32_t> entered) {
    unfold(corner_on_input(view, coordinates, h), corner_on_input(view, coordinates, h ^ 1U),
           entered);
  }

  /// returns the vector from end to end.
  Point vector() const { return line_.to - line_.from; }
  /// returns where the straight line crosses side `i`, from its source.
  double parameter(std::size_t i) const { return line_.parameter(side(i, 0), side(i, 1)); }
  /// returns where the straight line meets the point at `parameter` of side `i`.
  double along(std::size_t i, double parameter) const {
    return line_.along(side(i, 0) + parameter * (side(i, 1) - side(i, 0)));
  }

private:
  // where the side over which face `i` is entered starts or ends
  const Point& side(std::size_t i, std::size_t end) const { return z_[strip_[i].point[end]]; }

  // the point of a face whose halfedge runs from `s` to `t`
  Point place(const Surface_point& p, const Point& s, const Point& t) const {
    const Point side = t - s, apex = side * apex_above_side(input_, p.halfedge);
    return {s.x + p.weights[1] * side.x + p.weights[2] * apex.x,
            s.y + p.weights[1] * side.y + p.weights[2] * apex.y};
  }

  const Input& input_;
  Development<> strip_; // from the first face that is entered on
  std::vector<Point> z_;
  Straight_line line_{{0, 0}, {0, 0}};
};

// Keeps the order along edges.
inline void make_monotone(const Edge_crossings& crossings, Crossing_parameters& p) {
  for (std::size_t e = 0; e + 1 < crossings.begin.size(); ++e)
    for (std::uint32_t i = crossings.begin[e] + 1; i < crossings.begin[e + 1]; ++i)
      p.on_intrinsic[i] = std::max(p.on_intrinsic[i], p.on_intrinsic[i - 1]);
  for (std::size_t c = 0; c + 1 < crossings.curve_begin.size(); ++c)
    for (std::uint32_t i = crossings.curve_begin[c] + 1; i < crossings.curve_begin[c + 1]; ++i) {
      double& x = p.on_input[crossings.on_curve[i]];
      x = std::max(x, p.on_input[crossings.on_curve[i - 1]]);
    }
}

} // namespace internal

/*!
\brief computes where crossings are: for each intrinsic edge the input triangles that it passes are
unfolded, and its ends joined by a straight line.

It uses only the input and the connectivity of the crossings, so that errors do not grow with the
number of moves.
\param t the triangulation
\param coordinates its normal coordinates and roundabouts, a model of `CurveCoordinates`
\param crossings what `edge_crossings()` returned
\complexity linear in the number of crossings
*/
template <NumberedTriangulation Triangulation, CurveCoordinates Coordinates>
Crossing_parameters crossing_parameters(const Triangulation& t, const Coordinates& coordinates,
                                        const Edge_crossings& crossings) {
  const Intrinsic_view<Triangulation> view(t);
  Crossing_parameters p;
  p.on_input.resize(crossings.size());
  p.on_intrinsic.resize(crossings.size());
  internal::Edge_strip strip(coordinates.input());
  for (std::uint32_t e = 0; e + 1 < crossings.begin.size(); ++e) {
    const std::span<const std::uint32_t> entered = crossings.entered_on(e);
    if (entered.empty()) continue;
    strip.unfold(view, coordinates, 2 * e, entered);
    for (std::size_t i = 0; i < entered.size(); ++i) {
      const double x = strip.parameter(i);
      p.on_input[crossings.begin[e] + i] = entered[i] % 2 == 0 ? x : 1 - x;
      p.on_intrinsic[crossings.begin[e] + i] = strip.along(i, x);
    }
  }
  internal::make_monotone(crossings, p);
  return p;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EDGE_CROSSINGS_H

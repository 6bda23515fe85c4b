// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_PARAMETERS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_PARAMETERS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/CurveCoordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Curve_strip.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Input_locator.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief tells where crossings are along the edges.
*/
struct Crossing_parameters {
  /// Per crossing: 0 at the source of the even halfedge of the input edge, 1 at its target.
  std::vector<double> on_input;
  /// Per crossing: 0 at the source of the even halfedge of the intrinsic edge, 1 at its target.
  std::vector<double> on_intrinsic;
};

namespace internal {

/// A point in the plane of doubles.
using Point = Plane_point<double>;

/// Unfolds the input triangles along an intrinsic edge; keeps its memory from edge to edge.
template <class Input>
class Edge_strip {
public:
  explicit Edge_strip(const Input& input) : input_(input) {}

  /// unfolds the strip between two points, of the face before the first and after the last of the
  /// input halfedges `entered`.
  void unfold(Surface_point from, Surface_point to, std::span<const std::uint32_t> entered) {
    sides_.clear();
    Side s{{0, 0}, {std::sqrt(input_.squared_length(entered.front() / 2)), 0}};
    from_ = place(seen_from(input_, from, entered.front() ^ 1U), s.target, s.source);
    for (std::size_t i = 0;; ++i) {
      sides_.push_back(s);
      if (i + 1 == entered.size()) break;
      const Point apex = place({entered[i], {0, 0, 1}}, s.source, s.target);
      if ((entered[i + 1] ^ 1U) == input_.next(entered[i]))
        s.source = apex;
      else
        s.target = apex;
    }
    to_ = place(seen_from(input_, to, entered.back()), s.source, s.target);
  }

  /// unfolds the strip along an intrinsic halfedge, which enters the faces of `entered`.
  template <class View, CurveCoordinates Coordinates>
  void unfold(const View& view, const Coordinates& coordinates, std::uint32_t h,
              std::span<const std::uint32_t> entered) {
    unfold(corner_on_input(view, coordinates, h), corner_on_input(view, coordinates, h ^ 1U),
           entered);
  }

  /// returns the vector from end to end.
  Point vector() const { return to_ - from_; }

  /// returns where the straight line crosses side `i`, from its source.
  double parameter(std::size_t i) const {
    const Point d = vector();
    const double a = cross(d, sides_[i].source - from_), b = cross(d, sides_[i].target - from_);
    return a - b > 0 ? std::clamp(a / (a - b), 0.0, 1.0) : 0.5;
  }

  /// returns where the straight line meets the point at `parameter` of side `i`.
  double along(std::size_t i, double parameter) const {
    const Point d = vector(), s = sides_[i].source, t = sides_[i].target;
    const Point p{s.x + parameter * (t.x - s.x), s.y + parameter * (t.y - s.y)};
    const double squared = dot(d, d);
    return squared > 0 ? std::clamp(dot(d, p - from_) / squared, 0.0, 1.0) : 0.5;
  }

private:
  struct Side {
    Point source, target;
  };

  // the point of a face whose halfedge runs from `s` to `t`
  Point place(const Surface_point& p, const Point& s, const Point& t) const {
    const Point side = t - s, apex = side * apex_above_side(input_, p.halfedge);
    return {s.x + p.weights[1] * side.x + p.weights[2] * apex.x,
            s.y + p.weights[1] * side.y + p.weights[2] * apex.y};
  }

  const Input& input_;
  std::vector<Side> sides_;
  Point from_{0, 0}, to_{0, 0};
};

// What is in order along an edge stays in order.
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

Nothing but the input and the connectivity of the crossings enters, so that errors do not grow with the
number of moves.
\param t the triangulation
\param coordinates its normal coordinates and roundabouts, a model of `CurveCoordinates`
\param crossings what `edge_crossings()` returned
\complexity linear in the number of crossings
*/
template <class Triangulation, CurveCoordinates Coordinates>
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

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_PARAMETERS_H

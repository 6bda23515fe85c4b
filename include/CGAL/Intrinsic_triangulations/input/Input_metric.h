// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_METRIC_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_METRIC_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief defines the cone metric of the input exactly: three rational squared lengths per face.

The lengths come either from points in space, L_ij = |p_i - p_j|^2, or from squared lengths given
per edge (an abstract metric, which need not embed anywhere). A nonnegative `delta` is added to
every squared length (squared-length mollification). Where faces in space became planar polygons,
their diagonals are not the distances of the points: an *excess*, a double of any sign, is added to
the squared distance. All values are in scaled units: coordinates are multiplied by
2^scale_exponent(), so that the mean edge is near 1 and products of squared lengths neither overflow
nor underflow. Scaling is exact.

Faces and edges are those of the triangulation before its first move, in its own numbering.
*/
class Input_metric {
public:
  /// Coordinates of a point.
  using Point = std::array<double, 3>;
  /// The three values that name the sides of a face: vertices (from points) or edges (abstract).
  using Sides = std::array<std::uint32_t, 3>;

  /// constructs a metric without faces.
  Input_metric() = default;

  /*!
  \brief restores a metric from what its accessors return.
  \param points one point per vertex, or none
  \param squared_lengths one squared length per edge, or none
  \param sides what names the sides of each face
  \param delta what is added to every squared length
  \param scale_exponent exponent of the scale
  */
  Input_metric(std::vector<Point> points, std::vector<double> squared_lengths,
               std::vector<Sides> sides, double delta, int scale_exponent)
      : points_(std::move(points)), squared_lengths_(std::move(squared_lengths)),
        sides_(std::move(sides)), delta_(delta), scale_exponent_(scale_exponent) {}

  /*!
  \brief takes the metric of points in space.
  \param mesh the connectivity
  \param points one point per vertex of `mesh`, scaled
  \param scale_exponent what `scale_points()` returned
  */
  static Input_metric from_points(const Gluing_map& mesh, std::vector<Point> points,
                                  int scale_exponent) {
    return Input_metric(
        std::move(points), {},
        sides_of_faces(mesh, [&mesh](Gluing_map::Halfedge h) { return mesh.source(h).index; }), 0,
        scale_exponent);
  }

  /*!
  \brief takes the metric of squared edge lengths.
  \param mesh the connectivity
  \param squared_lengths one squared length per edge of `mesh`, scaled
  \param scale_exponent what `scale_squared_lengths()` returned
  */
  static Input_metric from_squared_lengths(const Gluing_map& mesh,
                                           std::vector<double> squared_lengths,
                                           int scale_exponent) {
    return Input_metric({}, std::move(squared_lengths),
                        sides_of_faces(mesh, [](Gluing_map::Halfedge h) { return h.index / 2; }), 0,
                        scale_exponent);
  }

  /// returns the number of input faces.
  std::uint32_t number_of_faces() const { return static_cast<std::uint32_t>(sides_.size()); }
  /// tells whether the metric comes from points in space.
  bool is_embedded() const { return squared_lengths_.empty(); }
  /// tells whether the metric is that of the points, without mollification or planar polygons.
  bool is_in_space() const { return is_embedded() && delta_ == 0 && excess_.empty(); }
  /// tells the same for face `f`.
  bool is_in_space(std::uint32_t f) const { return is_embedded() && delta_ == 0 && !has_excess(f); }
  /// returns what is added to the squared distance of the ends of side `k` of face `f`, in scaled
  /// units.
  double excess(std::uint32_t f, unsigned k) const { return excess_.empty() ? 0 : excess_[f][k]; }
  /// tells whether anything is added to a side of face `f`.
  bool has_excess(std::uint32_t f) const {
    return !excess_.empty() && excess_[f] != std::array<double, 3>{0, 0, 0};
  }
  /// sets what is added to the squared distances of points, by sides of faces; empty: zero.
  void set_excess(std::vector<std::array<double, 3>> excess) { excess_ = std::move(excess); }
  /// returns s, where coordinates are scaled by 2^s and squared lengths by 4^s.
  int scale_exponent() const { return scale_exponent_; }
  /// returns what is added to every squared length, in scaled units.
  double delta() const { return delta_; }
  /// sets what is added to every squared length, in scaled units. \pre `delta >= 0`, finite
  void set_delta(double delta) { delta_ = delta; }
  /// returns the scaled points; empty for an abstract metric.
  const std::vector<Point>& points() const { return points_; }
  /// returns the scaled squared lengths per edge; empty for a metric from points.
  const std::vector<double>& squared_lengths() const { return squared_lengths_; }
  /// returns what names the sides of face `f`.
  const Sides& sides(std::uint32_t f) const { return sides_[f]; }
  /// returns what names a side, see `Sides`: the vertex where it starts, or its edge.
  std::uint32_t name(std::uint32_t source, std::uint32_t edge) const {
    return is_embedded() ? source : edge;
  }
  /// returns the first side of face `f` from which on its sides have the given names; nothing if
  /// their names differ.
  std::optional<unsigned> slot(std::uint32_t f, const Sides& names) const {
    const auto& [a, b, c] = sides_[f];
    if (names == Sides{a, b, c}) return 0;
    if (names == Sides{b, c, a}) return 1;
    if (names == Sides{c, a, b}) return 2;
    return std::nullopt;
  }

  /*!
  \brief computes the squared length of side `k` of face `f`, in scaled units.
  \tparam FT a number type constructible from `double`; the result is as exact as `FT` is
  */
  template <class FT>
  FT squared_length(std::uint32_t f, unsigned k) const {
    const Sides& s = sides_[f];
    if (!is_embedded()) return FT(squared_lengths_[s[k]]) + FT(delta_);
    const FT l = squared_distance<FT>(points_[s[k]], points_[s[(k + 1) % 3]]) + FT(delta_);
    return has_excess(f) ? l + FT(excess_[f][k]) : l;
  }

  /*!
  \brief computes D = (4 A)^2 of face `f` from its squared lengths.
  \tparam FT as for `squared_length()`
  */
  template <class FT>
  FT squared_quadruple_area(std::uint32_t f) const {
    return Intrinsic_triangulations::squared_quadruple_area(
        squared_length<FT>(f, 0), squared_length<FT>(f, 1), squared_length<FT>(f, 2));
  }

  /// computes the squared distance of two points in `FT` arithmetic.
  template <class FT>
  static FT squared_distance(const Point& p, const Point& q) {
    const FT x = FT(p[0]) - FT(q[0]);
    const FT y = FT(p[1]) - FT(q[1]);
    const FT z = FT(p[2]) - FT(q[2]);
    return x * x + y * y + z * z;
  }

private:
  template <class Name>
  static std::vector<Sides> sides_of_faces(const Gluing_map& mesh, Name name) {
    std::vector<Sides> sides(mesh.number_of_faces());
    for (std::uint32_t f = 0; f < sides.size(); ++f) {
      const auto [h, n, l] = mesh.sides({f});
      sides[f] = {name(h), name(n), name(l)};
    }
    return sides;
  }

  std::vector<Point> points_;
  std::vector<double> squared_lengths_;
  std::vector<Sides> sides_;
  std::vector<std::array<double, 3>> excess_;
  double delta_ = 0;
  int scale_exponent_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_METRIC_H

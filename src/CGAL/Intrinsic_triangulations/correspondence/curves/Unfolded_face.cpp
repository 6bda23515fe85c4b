// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_development.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// the combination of three points
template <class Point_at>
Plane_vector<double> unfolded_combination(const std::array<double, 3>& weights,
                                          const Point_at& at) {
  Plane_vector<double> p{0, 0};
  for (unsigned k = 0; k < 3; ++k) p = p + weights[k] * at(k);
  return p;
}

} // namespace internal

template <FieldNumber FT>
std::optional<Place_in_face> Unfolded_face<FT>::place(const std::array<double, 3>& weights,
                                                      double nearness) const {
  const Rounded p = in_face(weights);
  Place result = region_of(p);
  const std::array<double, 3> w = weights_in_triangle(result.triangle, p);
  return rounded(w, nearness, result) ? std::optional(result) : std::nullopt;
}

template <FieldNumber FT>
std::optional<Place_in_face> Unfolded_face<FT>::place_on_side(const Input& input,
                                                              const Surface_point& location) const {
  Place result;
  result.region = development().region_beside_first_side();
  result.triangle = development().beside_first_side();
  const double along = std::floor(location.weights[1] * 0x1p52) * 0x1p-52;
  if (!(along > 0 && along < 1)) return std::nullopt;
  result.location = {location.halfedge, {1 - along, along, 0}};
  result.weights = seen_from(input, result.location, halfedge(result.triangle)).weights;
  for (unsigned k = 0; k < 2; ++k) // not at an end, which may be inside the input edge
    if (approximate(to_corner(result, k)) == Rounded{0, 0}) return std::nullopt;
  return result;
}

template <FieldNumber FT>
std::optional<Place_in_face>
Unfolded_face<FT>::place_at(const Input& input, const Surface_point& wanted,
                            const std::array<double, 3>& weights) const {
  const Rounded near = in_face(weights);
  double least = std::numeric_limits<double>::infinity();
  Place result;
  for (std::uint32_t t = 0; t <= development().last(); ++t) {
    const std::optional<Surface_point> p = seen_in(input, t, wanted);
    if (!p) continue;
    const Rounded d = in_triangle(t, p->weights) - near;
    if (!(dot(d, d) < least)) continue;
    least = dot(d, d);
    result.triangle = t;
    result.location = *p;
  }
  if (least == std::numeric_limits<double>::infinity()) return std::nullopt;
  return at(result.triangle, result.location);
}

template <FieldNumber FT>
Vertex_move_values<FT> Unfolded_face<FT>::values(const Place& p) const {
  std::array<Point, 3> to;
  Vertex_move_values<FT> result;
  const FT unit = z_.unit();
  for (unsigned k = 0; k < 3; ++k) {
    to[k] = to_corner(p, k);
    result.squared_lengths[k] = unit * dot(to[k], to[k]);
  }
  for (unsigned k = 0; k < 3; ++k)
    result.quadruple_areas[k] = (unit + unit) * cross(to[k], to[(k + 1) % 3]);
  return result;
}

template <FieldNumber FT>
Face_values<FT> Unfolded_face<FT>::face_values() const {
  const Point i = position(development().corner(0)), ij = position(development().corner(1)) - i,
              ik = position(development().corner(2)) - i, jk = ik - ij;
  const FT unit = z_.unit();
  return {{unit * dot(ij, ij), unit * dot(jk, jk), unit * dot(ik, ik)},
          (unit + unit) * cross(ij, ik)};
}

template <FieldNumber FT>
Seen_corner Unfolded_face<FT>::farthest_corner(const Input& input, const Place& p) const {
  const Rounded axis = along(input, p);
  Seen_corner result;
  double farthest = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const Rounded to = approximate(to_corner(p, k));
    if (!(dot(to, to) > farthest)) continue;
    farthest = dot(to, to);
    result = {k, std::atan2(cross(axis, to), dot(axis, to))};
  }
  return result;
}

template <FieldNumber FT>
Mapped_point Unfolded_face<FT>::locate(const std::array<double, 3>& weights) const {
  const Rounded p = in_face(weights);
  const std::uint32_t t = region_of(p).triangle;
  const Rounded d = rounded_point(t, 1) - rounded_point(t, 0),
                side = approximate(position(development().corner(1))) -
                       approximate(position(development().corner(0)));
  return {{halfedge(t), weights_in_triangle(t, p)},
          in_frame(side, d) / std::sqrt(dot(d, d) * dot(side, side)),
          {1, 0}};
}

template <FieldNumber FT>
Plane_vector<double> Unfolded_face<FT>::approximate(const Point& p) {
  if constexpr (requires { p.x.to_double(); })
    return {p.x.to_double(), p.y.to_double()};
  else
    return {CGAL::to_double(p.x), CGAL::to_double(p.y)};
}

template <FieldNumber FT>
Plane_vector<FT> Unfolded_face<FT>::position(const Corner& c) const {
  const Point o = point(c.triangle, 0);
  if (c.weights[0] == 1) return o;
  if (c.weights[1] == 1) return point(c.triangle, 1);
  const Point a = point(c.triangle, 1) - o, b = point(c.triangle, 2) - o;
  const FT s(c.weights[1]), t(c.weights[2]);
  return {o.x + s * a.x + t * b.x, o.y + s * a.y + t * b.y};
}

template <FieldNumber FT>
Plane_vector<FT> Unfolded_face<FT>::to_corner(const Place& from, unsigned k) const {
  Corner to = development().corner(k);
  if (from.triangle != to.triangle) {
    const std::optional<unsigned> shared = development().shared_corner(from.triangle, to);
    if (!shared) return position(to) - position({from.triangle, from.weights});
    to = {from.triangle, {}};
    to.weights[*shared] = 1;
  }
  const Point o = point(from.triangle, 0);
  const Point a = point(from.triangle, 1) - o, b = point(from.triangle, 2) - o;
  const FT s(to.weights[1] - from.weights[1]), t(to.weights[2] - from.weights[2]);
  return {s * a.x + t * b.x, s * a.y + t * b.y};
}

template <FieldNumber FT>
Plane_vector<double> Unfolded_face<FT>::in_face(const std::array<double, 3>& weights) const {
  return internal::unfolded_combination(
      weights, [&](unsigned k) { return approximate(position(development().corner(k))); });
}

template <FieldNumber FT>
Plane_vector<double> Unfolded_face<FT>::in_triangle(std::uint32_t t,
                                                    const std::array<double, 3>& weights) const {
  return internal::unfolded_combination(weights, [&](unsigned k) { return rounded_point(t, k); });
}

template <FieldNumber FT>
std::array<double, 3> Unfolded_face<FT>::weights_in_triangle(std::uint32_t t,
                                                             const Rounded& p) const {
  return Intrinsic_triangulations::weights_in_triangle(p, rounded_point(t, 0), rounded_point(t, 1),
                                                       rounded_point(t, 2));
}

template <FieldNumber FT>
Place_in_face Unfolded_face<FT>::region_of(const Rounded& p) const {
  Place result;
  const auto is_beyond = [&](std::uint32_t t) {
    const Rounded a = rounded_point(t, 0);
    return cross(rounded_point(t, 1) - a, p - a) > 0;
  };
  result.triangle = development().find_region(is_beyond, result.region);
  return result;
}

template <FieldNumber FT>
std::optional<Surface_point> Unfolded_face<FT>::seen_in(const Input& input, std::uint32_t t,
                                                        const Surface_point& p) const {
  const std::uint32_t h = halfedge(t), o = p.halfedge ^ 1U;
  if (input.face(p.halfedge) == input.face(h)) return seen_from(input, p, h);
  if (p.weights[2] != 0 || input.face(o) != input.face(h)) return std::nullopt;
  return seen_from(input, {o, {p.weights[1], p.weights[0], 0}}, h);
}

template <FieldNumber FT>
std::optional<Place_in_face> Unfolded_face<FT>::at(std::uint32_t t, const Surface_point& p) const {
  constexpr double inwards = 0x1p-20; // so far that the walk ends in the triangle
  std::array<double, 3> w = p.weights;
  for (double& x : w) x += inwards * (1. / 3 - x);
  Place result = region_of(in_triangle(t, w));
  if (result.triangle != t) return std::nullopt;
  const auto zero = std::find(p.weights.begin(), p.weights.end(), 0.);
  if (zero != p.weights.end()) {
    const auto opposite = static_cast<unsigned>(zero - p.weights.begin());
    const std::uint32_t child = development().entered_over(t, opposite);
    if (child == Triangle_strips::none || !put_on_curve(child, opposite, p.weights, result))
      return std::nullopt;
    return result;
  }
  result.weights = p.weights;
  result.location = p;
  return result;
}

template <FieldNumber FT>
Plane_vector<double> Unfolded_face<FT>::along(const Input& input, const Place& p) const {
  const bool is_on_edge = p.location.weights[2] == 0;
  const auto is_side = [&](std::uint32_t side, std::size_t k) {
    return side / 2 == p.location.halfedge / 2 && !(is_on_edge && p.weights[(k + 2) % 3] != 0);
  };
  std::uint32_t side = halfedge(p.triangle);
  std::size_t k = 0;
  for (; k < 2 && !is_side(side, k); ++k) side = input.next(side);
  const Rounded a = rounded_point(p.triangle, k), b = rounded_point(p.triangle, (k + 1) % 3);
  return side == p.location.halfedge ? b - a : a - b;
}

template <FieldNumber FT>
bool Unfolded_face<FT>::rounded(std::array<double, 3> w, double nearness, Place& result) const {
  const std::uint32_t t = result.triangle;
  if (t > 0 && w[2] < nearness) return put_on_curve(t, 2, w, result);
  for (const std::uint32_t child : development().children(t)) {
    const unsigned opposite = (development().triangles().exit_to(child) + 2) % 3;
    if (w[opposite] < nearness) return put_on_curve(child, opposite, w, result);
  }
  const std::optional<std::array<double, 3>> exact = representable_weights(w);
  if (!exact) return false;
  result.weights = *exact;
  result.location = {halfedge(t), *exact};
  return true;
}

template <FieldNumber FT>
bool Unfolded_face<FT>::put_on_curve(std::uint32_t child, unsigned opposite,
                                     std::array<double, 3> w, Place& result) const {
  const unsigned from = (opposite + 1) % 3, to = (opposite + 2) % 3;
  w[opposite] = 0;
  w[to] = std::floor(w[to] / (w[from] + w[to]) * 0x1p52) * 0x1p-52;
  w[from] = 1 - w[to];
  if (w[from] == 0 || w[to] == 0) return false;
  result.weights = w;
  const bool ends_here = result.triangle == child; // else the side of the triangle runs backwards
  const std::uint32_t side = halfedge(child) ^ (ends_here ? 0U : 1U);
  const std::uint32_t curve =
      halfedge(child) ^ (development().name_curve(child, result.region) ? 0U : 1U);
  result.location = side == curve ? Surface_point{curve, {w[from], w[to], 0}}
                                  : Surface_point{curve, {w[to], w[from], 0}};
  return true;
}

template class Unfolded_face<double>;
template class Unfolded_face<Interval_nt<false>>;
template class Unfolded_face<Short_ball>;
template class Unfolded_face<Long_ball>;

} // namespace CGAL::Intrinsic_triangulations

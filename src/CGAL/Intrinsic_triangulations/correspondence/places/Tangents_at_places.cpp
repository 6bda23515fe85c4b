// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/Space_vector.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/points_in_one_face.h>

#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// A vector in space, projected to the plane of a face, along both sides that start at a corner.
struct In_corner {
  double first, second; // in units of the sides
  double cosine;        // of the angle between the vector and that of these coefficients
};

// Where a vector may point: anywhere in the plane of a face, to the side of `h` where the face is,
// or into the corner at its source.
enum class Stays_in { plane, half_plane, corner };

// Coefficients along the sides from the source of `h` in its face, of the nearest vector there.
In_corner in_corner(const Input& input, const std::vector<Vector_in_space>& coordinates,
                    std::uint32_t h, const Vector_in_space& v, Stays_in where) {
  const std::uint32_t n = input.next(h);
  const auto point = [&](std::uint32_t vertex) { return coordinates[input.names().row(vertex)]; };
  const Vector_in_space o = point(input.source(h)), p = point(input.target(h)),
                        q = point(input.target(n));
  const Vector_in_space a = difference(p, o), b = difference(q, o);
  const double aa = inner_product(a, a), ab = inner_product(a, b), bb = inner_product(b, b),
               va = inner_product(v, a), vb = inner_product(v, b);
  const double det = aa * bb - ab * ab;
  In_corner result{(va * bb - vb * ab) / det, (vb * aa - va * ab) / det, -1};
  if (where == Stays_in::half_plane && !(result.second >= 0)) result = {va / aa, 0, -1};
  if (where == Stays_in::corner && !(result.first >= 0 && result.second >= 0)) {
    const bool is_first = va / std::sqrt(aa) >= vb / std::sqrt(bb);
    result = is_first ? In_corner{1, 0, -1} : In_corner{0, 1, -1};
  }
  const Vector_in_space w{result.first * a[0] + result.second * b[0],
                          result.first * a[1] + result.second * b[1],
                          result.first * a[2] + result.second * b[2]};
  const double squares = inner_product(v, v) * inner_product(w, w);
  result.cosine = squares > 0 ? inner_product(v, w) / std::sqrt(squares) : 0;
  return result;
}

Tangent_vector tangent_of(const Input& input, const Surface_point& p, const In_corner& c) {
  const Geodesic_face face(input, p.halfedge);
  return {p, unscaled(c.first * face.edge[0] - c.second * face.edge[2], input.scale_exponent())};
}

// By how much a vector in the plane of the first or the last face about a border vertex points out
// of the surface over the border: an angle, not positive for others.
double angle_beyond(const Input& input, std::uint32_t h, const In_corner& c, bool is_first,
                    bool is_last) {
  const Tangent_vector v = tangent_of(input, {h, {1, 0, 0}}, c);
  const double angle = std::atan2(v.vector[1], v.vector[0]), here = angle_at_source(input, h);
  const double before = is_first ? -angle : 0,
               turn = angle < 0 ? angle + 2 * std::numbers::pi : angle;
  return is_last && (before <= 0 || turn - here < before) ? turn - here : before;
}

// The face at a point whose plane has a vector nearest to it. Of the front and the back of one on a
// cover, the front.
struct Nearest_face {
  const Input& input;
  const std::vector<Vector_in_space>& coordinates;
  const Vector_in_space& v;
  In_corner best{0, 0, -2};
  Surface_point point{};

  bool is_front(std::uint32_t h) const {
    return !input.names().is_cover() || input.names().faces.user(input.face(h)) % 2 == 0;
  }

  void take(const Surface_point& p, const In_corner& c) {
    constexpr double same = 0x1p-40; // up to rounding
    const bool is_better =
        best.cosine == -2 || c.cosine > best.cosine + same ||
        (c.cosine > best.cosine - same && is_front(p.halfedge) && !is_front(point.halfedge));
    if (!is_better) return;
    best = c;
    point = p;
  }

  // in the faces at a point that is no vertex
  void take_all(const Surface_point& p, Stays_in where) {
    for (const Surface_point& q : descriptions(input, p))
      take(q, in_corner(input, coordinates, q.halfedge, v, where));
  }

  void take_about(std::uint32_t vertex) {
    const std::uint32_t first = input.outgoing_halfedge(vertex);
    std::uint32_t last = first;
    const auto at_source = [](std::uint32_t h) { return Surface_point{h, {1, 0, 0}}; };
    const Fan_angle fan = measure_fan(input, first, [&](std::uint32_t h, double) {
      if (input.is_border(h)) return;
      last = h;
      take(at_source(h), in_corner(input, coordinates, h, v, Stays_in::corner));
    });
    if (!fan.is_on_border) return;
    for (const std::uint32_t h : {first, last}) {
      const In_corner here = in_corner(input, coordinates, h, v, Stays_in::plane);
      const double beyond = angle_beyond(input, h, here, h == first, h == last);
      const double gap = 2 * std::numbers::pi - fan.sum;
      if (!(beyond > 0x1p-40 && beyond <= gap / 2 && here.cosine > best.cosine - 0x1p-50)) continue;
      best = here;
      point = at_source(h);
    }
  }
};

} // namespace

Tangent_vector Space_projector::at_point(const Surface_point& p, const Vector_in_space& v) const {
  Nearest_face nearest{input_, points_, v};
  const std::vector<Surface_point> others =
      sheets_.is_cover() ? sheets_.others(p) : std::vector<Surface_point>();
  // On an edge of several faces, a vector that points out of one of them over the edge has no face
  // to go on in. The others are named along the edge.
  if (others.size() < 2) nearest.take_all(p, Stays_in::plane);
  const Stays_in where = others.size() < 2 ? Stays_in::plane : Stays_in::half_plane;
  for (const Surface_point& q : others) nearest.take_all(q, where);
  return tangent_of(input_, nearest.point, nearest.best);
}

Tangent_vector Space_projector::at_vertex(std::uint32_t vertex, const Vector_in_space& v) const {
  Nearest_face nearest{input_, points_, v};
  const std::uint32_t row = input_.names().row(vertex);
  const std::uint32_t first = input_.names().vertices.user(input_.names().vertex(row));
  for (std::uint32_t copy = first; copy < input_.number_of_vertices(); ++copy) {
    const std::uint32_t here = input_.names().vertices.here(copy);
    if (input_.names().row(here) != row) break;
    nearest.take_about(here);
  }
  return tangent_of(input_, nearest.point, nearest.best);
}

} // namespace CGAL::Intrinsic_triangulations::internal

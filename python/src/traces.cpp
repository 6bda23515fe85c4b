// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "curve_arrays.h"
#include "places.h"
#include "tangents.h"

#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/points_in_one_face.h>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

// Geodesics from a point in a direction.

namespace python {

namespace {

/// A vector in space, or in the tangent plane of the point.
using Direction = std::variant<std::complex<double>, Space_vector>;

double dot(const Space_vector& a, const Space_vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A vector in space, projected to the plane of a face, along both sides that start at a corner.
struct In_corner {
  double first, second; // in units of the sides
  double cosine;        // of the angle between the vector and that of these coefficients
};

// Coefficients along the sides from the source of `h` in its face. `stays_inside`: of the nearest
// vector between the sides.
In_corner in_corner(const IT::Input& input, const Points& coordinates, std::uint32_t h,
                    const Space_vector& v, bool stays_inside) {
  const std::uint32_t n = input.next(h);
  const auto point = [&](std::uint32_t vertex) { return coordinates[input.names().row(vertex)]; };
  const Space_vector o = point(input.source(h)), p = point(input.target(h)),
                     q = point(input.target(n));
  const Space_vector a{p[0] - o[0], p[1] - o[1], p[2] - o[2]};
  const Space_vector b{q[0] - o[0], q[1] - o[1], q[2] - o[2]};
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b), va = dot(v, a), vb = dot(v, b);
  const double det = aa * bb - ab * ab;
  In_corner result{(va * bb - vb * ab) / det, (vb * aa - va * ab) / det, -1};
  if (stays_inside && !(result.first >= 0 && result.second >= 0)) {
    const bool is_first = va / std::sqrt(aa) >= vb / std::sqrt(bb);
    result = is_first ? In_corner{1, 0, -1} : In_corner{0, 1, -1};
  }
  const Space_vector w{result.first * a[0] + result.second * b[0],
                       result.first * a[1] + result.second * b[1],
                       result.first * a[2] + result.second * b[2]};
  result.cosine = dot(v, w) / std::sqrt(dot(v, v) * dot(w, w));
  return result;
}

IT::Tangent_vector tangent_of(const IT::Input& input, const IT::Surface_point& p,
                              const In_corner& c) {
  const IT::Geodesic_face face(input, p.halfedge);
  return {p,
          IT::unscaled(c.first * face.edge[0] - c.second * face.edge[2], input.scale_exponent())};
}

// By how much a vector in the plane of the first or the last face about a border vertex points out
// of the surface over the border: an angle, not positive for others.
double angle_beyond(const IT::Input& input, std::uint32_t h, const In_corner& c, bool is_first,
                    bool is_last) {
  const IT::Tangent_vector v = tangent_of(input, {h, {1, 0, 0}}, c);
  const double angle = std::atan2(v.vector[1], v.vector[0]), here = angle_at_source(input, h);
  const double before = is_first ? -angle : 0,
               turn = angle < 0 ? angle + 2 * std::numbers::pi : angle;
  return is_last && (before <= 0 || turn - here < before) ? turn - here : before;
}

// The face at a point whose plane has a vector nearest to it. Of the front and the back of one on a
// cover, the front.
struct Nearest_face {
  const IT::Input& input;
  const Points& coordinates;
  const Space_vector& v;
  In_corner best{0, 0, -2};
  IT::Surface_point point{};

  bool is_front(std::uint32_t h) const {
    return input.names().sheets == 1 || input.names().faces.user(input.face(h)) % 2 == 0;
  }

  void take(const IT::Surface_point& p, const In_corner& c) {
    constexpr double same = 0x1p-40; // up to rounding
    const bool is_better =
        best.cosine == -2 || c.cosine > best.cosine + same ||
        (c.cosine > best.cosine - same && is_front(p.halfedge) && !is_front(point.halfedge));
    if (!is_better) return;
    best = c;
    point = p;
  }

  // in the faces at a point that is no vertex
  void take_all(const IT::Surface_point& p) {
    for (const IT::Surface_point& q : IT::internal::descriptions(input, p))
      take(q, in_corner(input, coordinates, q.halfedge, v, false));
  }

  void take_about(std::uint32_t vertex) {
    const std::uint32_t first = input.outgoing_halfedge(vertex);
    std::uint32_t last = first;
    const auto at_source = [](std::uint32_t h) { return IT::Surface_point{h, {1, 0, 0}}; };
    const IT::Fan_angle fan = IT::measure_fan(input, first, [&](std::uint32_t h, double) {
      if (input.is_border(h)) return;
      last = h;
      take(at_source(h), in_corner(input, coordinates, h, v, true));
    });
    if (!fan.is_on_border) return;
    for (const std::uint32_t h : {first, last}) {
      const In_corner here = in_corner(input, coordinates, h, v, false);
      const double beyond = angle_beyond(input, h, here, h == first, h == last);
      const double gap = 2 * std::numbers::pi - fan.sum;
      if (!(beyond > 0x1p-40 && beyond <= gap / 2 && here.cosine > best.cosine - 0x1p-50)) continue;
      best = here;
      point = at_source(h);
    }
  }
};

} // namespace

IT::Tangent_vector tangent_in_space(const IT::Input& input, const Points& coordinates,
                                    const Place& p, std::uint32_t vertex, const Space_vector& v) {
  Nearest_face nearest{input, coordinates, v};
  if (!p.is_vertex()) {
    const IT::Surface_point here = point_on_input(input, p);
    nearest.take_all(here);
    if (const IT::internal::Sheets sheets(input); sheets.is_cover())
      for (const IT::Surface_point& q : sheets.others(here)) nearest.take_all(q);
  } else {
    const std::uint32_t row = input.names().row(vertex);
    const std::uint32_t first = input.names().vertices.user(input.names().vertex(row));
    for (std::uint32_t copy = first; copy < input.number_of_vertices(); ++copy) {
      const std::uint32_t here = input.names().vertices.here(copy);
      if (input.names().row(here) != row) break;
      nearest.take_about(here);
    }
  }
  return tangent_of(input, nearest.point, nearest.best);
}

namespace {

// In the frame of the face; at a vertex, in the polar coordinates of the surface there.
template <class T>
IT::Tangent_vector tangent_in_plane(const T& t, const Place& p, const std::complex<double>& z) {
  if (p.has_face()) return {point_on_input(t.input(), p), {z.real(), z.imag()}};
  const auto v = Place_finder<T>(t).vertex(p.vertex);
  const IT::Intrinsic_view<T> view(t);
  const std::uint32_t first = view.outgoing_halfedge(t.index(v));
  const double scale =
      IT::internal::polar_scale(IT::measure_fan(view, first, [](std::uint32_t, double) {}));
  return IT::tangent_to_input(t, IT::internal::vector_at_source(view, first, scale, z)).value();
}

template <class T>
IT::Tangent_vector tangent(const T& t, const Points& coordinates, const Place& p,
                           const Direction& direction) {
  if (const auto* z = std::get_if<std::complex<double>>(&direction))
    return tangent_in_plane(t, p, *z);
  if (coordinates.empty())
    throw IT::Invalid_input(IT::Element_kind::none, 0,
                            "the surface has lengths and no points, so that it has no directions "
                            "in space; give a complex number");
  const auto v =
      p.is_vertex() ? Place_finder<T>(t).vertex(p.vertex) : typename T::vertex_descriptor{};
  return tangent_in_space(t.input(), coordinates, p, t.index(v), std::get<Space_vector>(direction));
}

IT::Traced_curve traced(const IT::Input& input, const IT::Geodesic& geodesic) {
  IT::Traced_curve curve;
  curve.status = geodesic.status;
  curve.points = geodesic.points;
  // a point is named in the face before it
  for (std::size_t i = 1; i < geodesic.points.size(); ++i)
    curve.faces.push_back(input.face(geodesic.points[i].halfedge));
  curve.length = geodesic.length;
  curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
  return curve;
}

py::dict trace(Surface& s, const Place_arrays& from, const Direction& direction, double length) {
  const Place p = places_of(s, from).at(0);
  Watch watch;
  std::shared_ptr<const IT::Input> input;
  const IT::Geodesic geodesic = with_triangulation(s, watch, [&](const auto& t) {
    input = t.shared_input();
    const IT::Tangent_vector start = tangent(t, s.points, p, direction);
    if (!(std::hypot(start.vector[0], start.vector[1]) > 0))
      throw IT::Invalid_input(IT::Element_kind::none, 0,
                              "the direction is zero, or orthogonal to the face; give another");
    return IT::internal::trace_on(*input, start.point, start.vector, length,
                                  IT::parameters::default_values());
  });
  return curve_arrays(*input, s.points, {traced(*input, geodesic), false});
}

} // namespace

void bind_traces(py::module_& m) { m.def("trace", trace); }

} // namespace python

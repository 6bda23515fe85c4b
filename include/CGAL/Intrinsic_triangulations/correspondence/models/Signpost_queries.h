// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/signpost_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/tangent_frames.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds the last halfedge before an angle, from one on about its source.
template <class View, class Signposts>
Corner_direction direction_from(const View& view, const Signposts& signposts, std::uint32_t first,
                                double angle) {
  const Tangent_frames::Fan fan = signposts.fan(first);
  std::uint32_t best = first, g = first;
  double least = 2 * fan.angle; // the angle from `best`
  do {
    if (view.is_border(g)) break;
    double d = angle - signposts.angle(g);
    if (d < 0 && !fan.is_on_border) d += fan.angle;
    if (d >= 0 && d < least) least = d, best = g;
    g = next_around_source(view, g);
  } while (g != first);
  if (view.is_border(next_around_source(view, best)))
    least = std::min(least, angle_at_source(view, best));
  return {best, least}; // beyond the corner of `best` if that is thinner than rounding
}

/// The geodesic from a corner of a face to a point of it.
struct Corner_geodesic {
  unsigned corner;                // of the face
  double length;                  // to the point
  double angle;                   // from the side that starts at the corner
  Plane_vector<double> direction; // in the frame of the face
};

// The geodesics from the corners of a face to a point, the shortest first.
std::array<Corner_geodesic, 3> corner_geodesics(const Geodesic_face& face,
                                                const std::array<double, 3>& weights);

// Traces from the corners in turn until one succeeds; `walk` starts from a corner.
template <class Complex, class Start>
std::optional<Mapped_point> locate_from_corners(const Complex& complex, const Geodesic_face& face,
                                                const std::array<double, 3>& weights, Start start) {
  std::vector<Geodesic_crossing> crossings;
  for (const Corner_geodesic& g : corner_geodesics(face, weights)) {
    const Geodesic_walk<Complex> walk = start(face.side[g.corner], g.angle);
    if (walk.is_blocked() && g.length > 0) continue;
    crossings.clear();
    const Geodesic_end end =
        finish_walk(complex, walk, g.length, {std::size_t{1} << 22U, false}, crossings);
    if (end.status == Status::done) return Mapped_point{end.point, g.direction, end.direction};
  }
  return std::nullopt;
}

// Finds the point of the input at a point of the intrinsic triangulation, along the geodesic from
// the nearest corner of its face that works, which has the same direction and length on both
// (§3.4.3).
template <class Triangulation, class Signposts>
std::optional<Mapped_point> find_on_input(const Triangulation& t, const Signposts& signposts,
                                          const Surface_point& p) {
  const Intrinsic_view<Triangulation> view(t);
  return locate_from_corners(
      signposts.input(), Geodesic_face(view, p.halfedge), p.weights,
      [&](std::uint32_t h, double angle) { return signposts.walk(h, angle); });
}

// Finds the direction of a corner from a point of the face with a given place on the input: along
// the first geodesic from a corner that leads there, the shortest first.
template <class Triangulation, class Signposts>
std::optional<Seen_corner> see_corner(const Triangulation& t, const Signposts& signposts,
                                      const Surface_point& p, const Surface_point& place) {
  const Intrinsic_view<Triangulation> view(t);
  const Geodesic_face face(view, p.halfedge);
  const auto target = Geodesic_target::at_point(signposts.input(), place);
  std::vector<Strip_side> strip;
  for (const Corner_geodesic& g : corner_geodesics(face, p.weights)) {
    const auto walk = [&](double turn) {
      return signposts.walk(face.side[g.corner], g.angle + turn);
    };
    const Geodesic_to_target r = trace_corrected(signposts.input(), walk, target, g.length, strip);
    if (!r.is_reached) continue;
    const double back =
        r.end == place.halfedge ? -1 : 1; // half a turn between the frames of an edge
    if (r.along != Gluing::none)
      return Seen_corner{g.corner, r.along == place.halfedge ? std::numbers::pi : 0};
    return Seen_corner{g.corner, std::atan2(back * r.direction[1], back * r.direction[0])};
  }
  return std::nullopt;
}

// Finds the point of the intrinsic triangulation at a point of the input, likewise.
template <class Triangulation, class Signposts>
std::optional<Mapped_point> find_on_intrinsic(const Triangulation& t, const Signposts& signposts,
                                              const Surface_point& p) {
  const Intrinsic_view<Triangulation> view(t);
  return locate_from_corners(view, Geodesic_face(signposts.input(), p.halfedge), p.weights,
                             [&](std::uint32_t h, double angle) {
                               return Geodesic_walk<Intrinsic_view<Triangulation>>(
                                   view, signposts.intrinsic_direction(view, h, angle));
                             });
}

// Answers queries by tracing geodesics, see `Curve_queries`.
template <class Triangulation, class Signposts>
class Signpost_queries {
public:
  Signpost_queries(const Triangulation& t, const Signposts& signposts)
      : t_(t), signposts_(signposts) {}

  std::optional<Mapped_point> on_input(const Surface_point& p) const {
    return find_on_input(t_, signposts_, p);
  }
  std::optional<Mapped_point> on_intrinsic(const Surface_point& p) const {
    return find_on_intrinsic(t_, signposts_, p);
  }
  Edge_path path_on_input(std::uint32_t edge) const {
    return trace_edge_by_signposts(t_, signposts_, edge);
  }
  Edge_path path_on_intrinsic(std::uint32_t x) const {
    return trace_input_edge_by_signposts(t_, signposts_, x);
  }
  std::uint32_t input_edge_along(std::uint32_t edge) const {
    const std::uint32_t h = path_on_input(edge).along;
    return h == Gluing::none ? h : h / 2;
  }
  auto walk_on_input(std::uint32_t h, double turn) const { return signposts_.walk(h, turn); }
  std::optional<Corner_direction> direction_on_intrinsic(std::uint32_t x, double turn) const {
    return signposts_.intrinsic_direction(Intrinsic_view<Triangulation>(t_), x, turn);
  }
  Integer_coordinates curves() const { return integer_coordinates(t_, signposts_); }

private:
  const Triangulation& t_;
  const Signposts& signposts_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_QUERIES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_FOLLOW_SIGNPOSTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_FOLLOW_SIGNPOSTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Edge_path.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/trace_geodesic.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

/*!
\file
Edges of one triangulation traced over the other along geodesics that signposts start.
*/

namespace CGAL::Intrinsic_triangulations {

/*!
\brief requires the directions of intrinsic halfedges on the input, as starts of geodesics, and the
places where these end.

Syntax of \ref ::SignpostDirections, which describes its meaning.
*/
template <class Signposts>
concept SignpostDirections = requires(const Signposts& s, std::uint32_t i, double turn) {
  { s.input() } -> std::same_as<const Input&>;
  { s.shared_input() } -> std::convertible_to<std::shared_ptr<const Input>>;
  { s.is_inserted(i) } -> std::same_as<bool>;
  { s.location(i) } -> std::same_as<const Surface_point&>;
  { s.target(i) } -> std::same_as<Geodesic_target>;
  { s.walk(i) } -> std::same_as<internal::Geodesic_walk<Input>>;
  { s.walk(i, turn) } -> std::same_as<internal::Geodesic_walk<Input>>;
};

namespace internal {

// Traces to a target; once more in a corrected direction if it was met by a bent line. `walk(turn)`
// starts.
template <class Complex, class Walk>
Geodesic_to_target trace_corrected(const Complex& complex, const Walk& walk,
                                   const Geodesic_target& target, double length,
                                   std::vector<Strip_side>& strip) {
  Geodesic_to_target r;
  double turn = 0;
  for (int i = 0; i < 3 && !r.is_reached; ++i) {
    r = trace_to_target(complex, walk(turn), target, length, strip);
    if (!(r.length > 0)) break;
    turn += std::atan(r.slope);
  }
  return r;
}

// Traces an intrinsic halfedge from its source.
template <class View, class Signposts>
Geodesic_to_target follow_signpost(const View& view, const Signposts& signposts, std::uint32_t h,
                                   std::vector<Strip_side>& strip) {
  return trace_corrected(
      signposts.input(), [&](double turn) { return signposts.walk(h, turn); },
      signposts.target(view.target(h)), std::sqrt(view.squared_length(h / 2)), strip);
}

// Traces an intrinsic halfedge over the input (§3.4.1), from its target if that fails from its
// source. Appends the input edges that it crosses to `crossings`; `strip` is space for the trace.
template <class View, class Signposts>
Geodesic_to_target trace_signpost(const View& view, const Signposts& signposts, std::uint32_t h,
                                  std::vector<Geodesic_crossing>& crossings,
                                  std::vector<Strip_side>& strip) {
  Geodesic_to_target r = follow_signpost(view, signposts, h, strip);
  if (r.is_reached) {
    for (const Strip_side& s : strip) crossings.push_back({s.halfedge, s.parameter(r.slope)});
    return r;
  }
  r = follow_signpost(view, signposts, h ^ 1U, strip);
  if (!r.is_reached) return r;
  for (std::size_t i = strip.size(); i-- > 0;)
    crossings.push_back({strip[i].halfedge ^ 1U, 1 - strip[i].parameter(r.slope)});
  if (r.along != Gluing::none) r.along ^= 1U;
  return r;
}

// How far along a traced line it crosses a side of its strip, as a part of it.
inline double part_of_line(const Strip_side& s, const Geodesic_to_target& r) {
  const double p = s.parameter(r.slope);
  const double x = s.source[0] + p * (s.target[0] - s.source[0]),
               y = s.source[1] + p * (s.target[1] - s.source[1]);
  return std::clamp(std::hypot(x, y) / r.length, 0.0, 1.0);
}

// The path of intrinsic halfedge 2e over the input.
template <class Triangulation, class Signposts>
Edge_path trace_edge_by_signposts(const Triangulation& t, const Signposts& signposts,
                                  std::uint32_t edge) {
  const Intrinsic_view<Triangulation> view(t);
  const std::uint32_t h = 2 * edge;
  std::vector<Strip_side> strip;
  std::vector<Geodesic_crossing> crossings;
  const Geodesic_to_target r = trace_signpost(view, signposts, h, crossings, strip);
  if (!r.is_reached) return {Status::not_traceable, Gluing::none, {}};
  Edge_path path{r.is_certain ? Status::done : Status::inaccurate, r.along, {}};
  const auto add = [&](const Surface_point& p, double x) {
    path.points.push_back({p, point_on_halfedge(view, h, x), x});
  };
  const auto end = [&](std::uint32_t g) {
    const auto walk = signposts.walk(g);
    return Surface_point{walk.face().side[0], walk.weights()};
  };
  add(end(h), 0);
  double last = 0; // keeps the order despite rounding
  const bool is_forward = strip.empty() || strip.front().halfedge == crossings.front().halfedge;
  for (std::size_t i = 0; i < crossings.size(); ++i) {
    const Geodesic_crossing& c = crossings[i];
    last = std::max(last, is_forward ? part_of_line(strip[i], r)
                                     : 1 - part_of_line(strip[strip.size() - 1 - i], r));
    add({c.halfedge ^ 1U, {c.parameter, 1 - c.parameter, 0}}, last); // in the face that it enters
  }
  add(end(h ^ 1U), 1);
  return path;
}

// The vertices along an input halfedge: its ends, and those inserted on it.
template <class Triangulation, class Signposts>
std::vector<std::pair<double, std::uint32_t>>
vertices_on_input_halfedge(const Triangulation& t, const Signposts& signposts, std::uint32_t x) {
  std::vector<std::pair<double, std::uint32_t>> on_it{{0, signposts.input().source(x)},
                                                      {1, signposts.input().target(x)}};
  for (const auto d : vertices(t.mesh())) {
    const std::uint32_t v = t.index(d);
    if (!signposts.is_inserted(v)) continue;
    const Surface_point& p = signposts.location(v);
    std::uint32_t h = p.halfedge;
    for (std::size_t k = 0; k < 3; ++k, h = signposts.input().next(h))
      if (h / 2 == x / 2 && p.weights[(k + 2) % 3] == 0)
        on_it.emplace_back(p.weights[h == x ? (k + 1) % 3 : k], v);
  }
  std::sort(on_it.begin(), on_it.end()); // parameters of inserted vertices are between 0 and 1
  return on_it;
}

// The path of an input halfedge over the intrinsic triangulation: part by part, between the
// vertices inserted on it.
template <class Triangulation, class Signposts>
Edge_path trace_input_edge_by_signposts(const Triangulation& t, const Signposts& signposts,
                                        std::uint32_t x) {
  const Intrinsic_view<Triangulation> view(t);
  const double length = std::sqrt(signposts.input().squared_length(x / 2));
  const auto on_it = vertices_on_input_halfedge(t, signposts, x);
  Edge_path path;
  std::vector<Strip_side> strip;
  for (std::size_t i = 0; i + 1 < on_it.size(); ++i) {
    const auto [from, vertex] = on_it[i];
    const auto [to, next] = on_it[i + 1];
    const auto walk = [&, v = vertex](double turn) {
      return Geodesic_walk<Intrinsic_view<Triangulation>>(
          view, i == 0 ? signposts.intrinsic_direction(view, x, turn)
                       : signposts.intrinsic_direction_at(view, v, x, turn));
    };
    const auto first = walk(0);
    const Geodesic_to_target r =
        trace_corrected(view, walk, Geodesic_target::at_vertex(next), (to - from) * length, strip);
    if (!r.is_reached) return {Status::not_traceable, Gluing::none, {}};
    if (!r.is_certain) path.status = Status::inaccurate;
    const auto add = [&, a = from, b = to](const Surface_point& p, double along) {
      const double s = a + along * (b - a);
      path.points.push_back({point_on_halfedge(signposts.input(), x, s), p, s});
    };
    if (i == 0) add({first.face().side[0], first.weights()}, 0);
    for (const Strip_side& s : strip) {
      const double p = s.parameter(r.slope);
      add({s.halfedge, {1 - p, p, 0}}, part_of_line(s, r));
    }
    const std::uint32_t out = view.outgoing_halfedge(next);
    add(point_on_halfedge(view, out, 0), 1);
    path.along = on_it.size() == 2 ? r.along : Gluing::none;
  }
  return path;
}

} // namespace internal

/*!
\brief holds the paths of all intrinsic edges over the input: the input edges that each one crosses,
from the source of its halfedge `2e`.
*/
struct Edge_traces {
  /// For each edge number the index of its first crossing, and one entry more.
  std::vector<std::size_t> begin{0};
  /// The crossings of all edges: the halfedge of the input face that is left, and where it is
  /// crossed.
  std::vector<Geodesic_crossing> crossings;
  /// For each edge number the input halfedge that halfedge `2e` runs along, in its direction; none
  /// if it runs across faces. It may be a part of it only: between inserted vertices.
  std::vector<std::uint32_t> along;
  /// The first edge whose trace did not end at its end; none if all did.
  std::uint32_t first_failed = Gluing::none;
  /// Number of edges whose trace did not end at their ends: these have no crossings.
  std::uint32_t failed = 0;
  /// The first edge with a vertex so close to it that rounding may have decided the side.
  std::uint32_t first_uncertain = Gluing::none;
  /// Number of those.
  std::uint32_t uncertain = 0;

  /// tells whether all edges were traced, beyond rounding.
  bool is_certain() const { return failed == 0 && uncertain == 0; }
  /// returns the crossings of edge `e`.
  std::span<const Geodesic_crossing> operator[](std::uint32_t e) const {
    return {crossings.data() + begin[e], begin[e + 1] - begin[e]};
  }
};

/*!
\brief traces all intrinsic edges over the input.
\tparam Signposts its correspondence, a model of \ref ::SignpostDirections
\param t the triangulation
\param signposts its signposts
\return the traces, and what failed
\complexity linear in the number of edges and crossings
*/
template <NumberedTriangulation Triangulation, SignpostDirections Signposts>
Edge_traces trace_edges(const Triangulation& t, const Signposts& signposts) {
  const Intrinsic_view<Triangulation> view(t);
  std::vector<char> exists(t.numbers().edge_capacity(t.mesh()), 0);
  for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) exists[t.index(e)] = 1;
  Edge_traces traces;
  traces.along.assign(exists.size(), Gluing::none);
  traces.begin.reserve(exists.size() + 1);
  std::vector<internal::Strip_side> strip;
  for (std::uint32_t e = 0; e < exists.size(); ++e) {
    if (exists[e] != 0) {
      const internal::Geodesic_to_target r =
          internal::trace_signpost(view, signposts, 2 * e, traces.crossings, strip);
      traces.along[e] = r.along;
      if (!r.is_reached && traces.failed++ == 0) traces.first_failed = e;
      if (r.is_reached && !r.is_certain && traces.uncertain++ == 0) traces.first_uncertain = e;
    }
    traces.begin.push_back(traces.crossings.size());
  }
  return traces;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_FOLLOW_SIGNPOSTS_H

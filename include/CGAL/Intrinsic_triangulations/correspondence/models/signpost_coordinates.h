// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/check_curves.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/follow_signposts.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

/*!
\file
Converts signposts to integer coordinates: integers that are proven consistent replace rounded
directions, or the conversion is refused.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/// Reads normal coordinates and roundabouts from the traces of all intrinsic edges.
template <class Triangulation, class Signposts>
class Signpost_reader {
public:
  Signpost_reader(const Triangulation& t, const Signposts& signposts)
      : t_(t), view_(t), signposts_(signposts), input_(signposts.input()), fans_(input_),
        traces_(trace_edges(t, signposts)) {}

  Integer_coordinates read() {
    if (traces_.failed > 0) refuse(traces_.first_failed);
    for (const typename Triangulation::vertex_descriptor v : vertices(t_.mesh()))
      if (signposts_.is_inserted(t_.index(v))) add_inserted(t_.index(v));
    normal_.assign(traces_.along.size(), 0);
    roundabout_.assign(2 * normal_.size(), Gluing::none);
    for (const typename Triangulation::edge_descriptor e : edges(t_.mesh())) add_edge(t_.index(e));
    Integer_coordinates result(signposts_.shared_input(), std::move(fans_), std::move(normal_),
                               std::move(roundabout_), std::move(location_));
    std::uint32_t bad = first_inconsistent_edge(t_, result);
    if (bad == Gluing::none) bad = first_wrong_length(t_, result);
    if (bad != Gluing::none) refuse(bad);
    return result;
  }

private:
  [[noreturn]] static void refuse(std::uint32_t edge) {
    throw Invalid_input(Element_kind::edge, edge,
                        "the path of an intrinsic edge cannot be found from signposts: use integer "
                        "coordinates");
  }

  const Surface_point& location(std::uint32_t vertex) const {
    return location_[vertex - input_.number_of_vertices()];
  }
  // The first slot of a vertex on an input edge; none inside a face.
  std::uint32_t fan(std::uint32_t vertex) const {
    return fan_[vertex - input_.number_of_vertices()];
  }

  void add_inserted(std::uint32_t vertex) {
    const std::size_t i = vertex - input_.number_of_vertices();
    if (i >= location_.size()) {
      location_.resize(i + 1);
      fan_.resize(i + 1, Gluing::none);
    }
    Surface_point p = signposts_.location(vertex);
    const auto zeros = std::count(p.weights.begin(), p.weights.end(), 0.0);
    if (zeros > 1) refuse(view_.outgoing_halfedge(vertex) / 2);
    while (zeros == 1 && p.weights[2] != 0)
      p = {input_.next(p.halfedge), {p.weights[1], p.weights[2], p.weights[0]}};
    location_[i] = p;
    if (zeros == 1) fan_[i] = fans_.add_fan_on_edge(p.halfedge);
  }

  void add_edge(std::uint32_t e) {
    const std::uint32_t h = 2 * e, x = traces_.along[e];
    const auto path = traces_[e];
    if (x != Gluing::none) {
      normal_[e] = -1;
      roundabout_[h] = slot_along(e, view_.source(h), x);
      roundabout_[h ^ 1U] = slot_along(e, view_.target(h), x ^ 1U);
      return;
    }
    if (path.size() > static_cast<std::size_t>(maximal_normal_coordinate)) refuse(e);
    normal_[e] = static_cast<Normal_coordinate>(path.size());
    roundabout_[h] = roundabout(h, path.empty() ? Gluing::none : path.front().halfedge);
    roundabout_[h ^ 1U] =
        roundabout(h ^ 1U, path.empty() ? Gluing::none : path.back().halfedge ^ 1U);
  }

  // The slot at `vertex` of the curve along `x`.
  std::uint32_t slot_along(std::uint32_t e, std::uint32_t vertex, std::uint32_t x) const {
    if (!signposts_.is_inserted(vertex)) {
      if (input_.source(x) != vertex) refuse(e);
      return fans_.slot(x);
    }
    const std::uint32_t slot = fan(vertex);
    if (slot == Gluing::none || location(vertex).halfedge / 2 != x / 2) refuse(e);
    return location(vertex).halfedge == x ? slot : slot + 1;
  }

  // The first curve counterclockwise from a halfedge that leaves its first face through `out`, or
  // ends in that face.
  std::uint32_t roundabout(std::uint32_t h, std::uint32_t out) const {
    const std::uint32_t v = view_.source(h);
    if (!signposts_.is_inserted(v)) {
      const std::uint32_t g = out == Gluing::none ? corner_to_target(h) : last_side(out);
      if (input_.source(g) != v) refuse(h / 2);
      return fans_.slot(next_around_source(input_, g));
    }
    if (fan(v) == Gluing::none) return Gluing::none;
    return is_on_left(h, out) ? fan(v) + 1 : fan(v);
  }

  std::uint32_t last_side(std::uint32_t g) const { return input_.next(input_.next(g)); }

  // The first face on the left of the edge that the source lies on, not on the right.
  bool is_on_left(std::uint32_t h, std::uint32_t out) const {
    const std::uint32_t g = location(view_.source(h)).halfedge;
    const bool left = starts_beside(g, h, out);
    const bool right = !input_.is_border(g ^ 1U) && starts_beside(g ^ 1U, h, out);
    if (left != right) return left;
    const std::uint32_t side = signposts_.walk(h).face().side[0]; // a face glued to itself
    if (side / 2 != g / 2) refuse(h / 2);
    return side == g;
  }

  bool starts_beside(std::uint32_t g, std::uint32_t h, std::uint32_t out) const {
    if (out != Gluing::none) return input_.face(out) == input_.face(g);
    const std::uint32_t w = view_.target(h);
    if (!signposts_.is_inserted(w)) return input_.target(input_.next(g)) == w;
    const std::uint32_t p = location(w).halfedge, f = input_.face(g);
    return input_.face(p) == f || (fan(w) != Gluing::none && input_.face(p ^ 1U) == f);
  }

  // The corner where a halfedge without crossings starts from a vertex of the input; it ends at an
  // inserted vertex.
  std::uint32_t corner_to_target(std::uint32_t h) const {
    const std::uint32_t v = view_.source(h), w = view_.target(h);
    if (!signposts_.is_inserted(w)) refuse(h / 2);
    const std::uint32_t p = location(w).halfedge;
    const bool is_on_edge =
        fan(w) != Gluing::none; // then in front of the edge, on one of its sides
    std::array<std::uint32_t, 3> corners{last_side(p), Gluing::none, Gluing::none};
    if (!is_on_edge)
      corners = sides_of_face(input_, p);
    else if (!input_.is_border(p ^ 1U))
      corners[1] = last_side(p ^ 1U);
    const auto is_here = [&](std::uint32_t g) {
      return g != Gluing::none && input_.source(g) == v;
    };
    const auto first = std::find_if(corners.begin(), corners.end(), is_here);
    if (first == corners.end()) refuse(h / 2);
    if (std::count_if(corners.begin(), corners.end(), is_here) == 1) return *first;
    const std::uint32_t side = signposts_.walk(h).face().side[0]; // two corners at one vertex
    if (std::find(corners.begin(), corners.end(), side) == corners.end()) refuse(h / 2);
    return side;
  }

  const Triangulation& t_;
  Intrinsic_view<Triangulation> view_;
  const Signposts& signposts_;
  const Input& input_;
  Vertex_fans fans_;
  Edge_traces traces_;
  std::vector<std::uint32_t> fan_;        // per inserted vertex
  std::vector<Surface_point> location_;   // per inserted vertex
  std::vector<Normal_coordinate> normal_; // per edge
  std::vector<std::uint32_t> roundabout_; // per halfedge
};

} // namespace internal

/*!
\brief finds the integer coordinates of a triangulation that is represented by signposts.

It traces all intrinsic edges over the input, and accepts the traces only if they are proven
consistent, see `first_inconsistent_edge()` and `first_wrong_length()`: the common subdivision is
right, or there is none. A vertex exactly on an input edge cuts that edge. If rounding put it there,
which only happens in doubles, other representations may have it beside the edge.
\tparam Signposts its correspondence, a model of \ref ::SignpostDirections
\param t the triangulation
\param signposts its signposts
\return the coordinates
\throws Invalid_input naming the first intrinsic edge that has no path, or one that contradicts
  others; the remedy is to use `Integer_coordinates`
\complexity linear in the number of edges and crossings
*/
template <NumberedTriangulation Triangulation, SignpostDirections Signposts>
Integer_coordinates integer_coordinates(const Triangulation& t, const Signposts& signposts) {
  return internal::Signpost_reader<Triangulation, Signposts>(t, signposts).read();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_SIGNPOST_COORDINATES_H

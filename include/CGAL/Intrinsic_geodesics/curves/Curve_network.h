// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_NETWORK_H
#define CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_NETWORK_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_order.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/Interval_nt.h>

#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
template <class Triangulation>
class Curve_shortener;
template <class Triangulation>
class Network_joints;
} // namespace internal

/*!
\brief is a family of paths and loops along the edges of an intrinsic triangulation that do not
  cross (§5.1 and §5.2 of the course).

A curve is a sequence of halfedges. Any number of curves may run along an edge, in either direction,
in an order in which they do not cross. A curve has a *joint* at each vertex that it passes. Joints
at fixed vertices and the ends of paths stay in place; all others may move when curves are
shortened.

The network refers to the triangulation. Other algorithms must not flip edges with curves: pass them
`edge_is_constrained_map()`.
\tparam Triangulation a model of `GeodesicTriangulation`
*/
template <GeodesicTriangulation Triangulation>
class Curve_network {
  using Mesh = typename Triangulation::Mesh;
  using Segments = internal::Curve_segments;

public:
  /// Vertex of the triangulation.
  using vertex_descriptor = typename Triangulation::vertex_descriptor;
  /// Halfedge of the triangulation.
  using halfedge_descriptor = typename Triangulation::halfedge_descriptor;
  /// Edge of the triangulation.
  using edge_descriptor = typename Triangulation::edge_descriptor;

  /// starts without curves. \param t the triangulation; it must outlive the network
  /// \complexity linear
  explicit Curve_network(Triangulation& t)
      : t_(&t), segments_(t.numbers().edge_capacity(t.mesh())),
        ends_(t.numbers().vertex_capacity(t.mesh()), 0) {}

  /// returns the triangulation.
  const Triangulation& triangulation() const { return *t_; }
  /// returns the triangulation.
  Triangulation& triangulation() { return *t_; }

  /*!
  \brief adds a path.

  It leaves out pieces that go out and back the same way, up to fixed vertices.
  \param halfedges its halfedges, each from the target of the one before, or on a cover from a copy
    of it: such a joint is not free
  \return its number, which counts from 0
  \throws Invalid_input if the halfedges are not connected, there are none, or the path crosses a
    curve; then the network stays as it was. A path may end on another curve, and cross it at a
    fixed vertex
  \complexity linear in its length, in the number of curves beside it and in the degrees of vertices
  with other curves
  */
  template <std::ranges::input_range HalfedgeRange>
  std::uint32_t add_path(const HalfedgeRange& halfedges) {
    return add({halfedges.begin(), halfedges.end()}, false);
  }
  /// adds a loop, whose last halfedge leads to the source of the first; see `add_path()`. A loop
  /// that goes out and back as a whole has contracted.
  template <std::ranges::input_range HalfedgeRange>
  std::uint32_t add_loop(const HalfedgeRange& halfedges) {
    return add({halfedges.begin(), halfedges.end()}, true);
  }

  /// fixes a vertex: joints there are not free, and curves may cross there.
  void fix(vertex_descriptor v) {
    const std::uint32_t i = t_->index(v);
    if (i >= fixed_.size()) fixed_.resize(i + std::size_t{1}, false);
    fixed_[i] = true;
  }
  /// returns whether a vertex is fixed.
  bool is_fixed(vertex_descriptor v) const {
    return t_->index(v) < fixed_.size() && fixed_[t_->index(v)];
  }

  /// lets go of all fixed vertices. \pre there are no curves
  void unfix() { fixed_.clear(); }

  /// returns the number of curves.
  std::uint32_t number_of_curves() const { return static_cast<std::uint32_t>(curves_.size()); }
  /// returns whether a curve is a loop.
  bool is_loop(std::uint32_t curve) const { return curves_[curve].is_loop; }
  /// returns whether a curve has no halfedges: a loop has contracted, a path ends where it starts.
  bool is_point(std::uint32_t curve) const { return curves_[curve].first == Segments::none; }
  /// returns the vertex where a curve starts; if it `is_point()`, the vertex of the point.
  vertex_descriptor start(std::uint32_t curve) const {
    if (is_point(curve)) return curves_[curve].start;
    return source(halfedge_of(curves_[curve].first), t_->mesh());
  }

  /// returns the halfedges of a curve in order. \complexity linear in their number
  std::vector<halfedge_descriptor> halfedges(std::uint32_t curve) const {
    std::vector<halfedge_descriptor> result;
    for_each_segment(curve, [&](std::uint32_t s) { result.push_back(halfedge_of(s)); });
    return result;
  }
  /// returns the length of a curve, in the units of the input; with exact traits to 1e-12 of it.
  /// \complexity linear
  double length(std::uint32_t curve) const {
    double sum = 0;
    for_each_segment(curve,
                     [&](std::uint32_t s) { sum += t_->length(edge(halfedge_of(s), t_->mesh())); });
    return sum;
  }
  /// returns the length of all curves, see `length()`.
  double length() const {
    double sum = 0;
    for (std::uint32_t c = 0; c < number_of_curves(); ++c) sum += length(c);
    return sum;
  }

  /// returns an interval that contains the length of a curve, see `length_enclosure()`.
  /// \complexity linear
  Interval_nt<> length_enclosure(std::uint32_t curve) const {
    Interval_nt<> sum(0);
    for_each_segment(curve, [&](std::uint32_t s) {
      sum += Intrinsic_triangulations::length_enclosure(*t_, edge(halfedge_of(s), t_->mesh()));
    });
    return sum;
  }

  /// returns whether a curve runs along an edge.
  bool carries_curve(edge_descriptor e) const { return !segments_.is_free(2 * t_->index(e)); }
  /// returns the curves along an edge, from left to right of its halfedge `2 * t.index(e)`.
  std::vector<std::uint32_t> curves_along(edge_descriptor e) const {
    std::vector<std::uint32_t> result;
    const std::uint32_t right = 2 * t_->index(e) + 1;
    for (std::uint32_t s = segments_.outermost(right - 1); s != Segments::none;
         s = segments_.beside(s, right))
      result.push_back(segments_[s].curve);
    return result;
  }
  /// returns a property map that is true of the edges that carry curves; it refers to the network.
  auto edge_is_constrained_map() const {
    return boost::make_function_property_map<edge_descriptor>(
        [this](edge_descriptor e) { return carries_curve(e); });
  }

  /// returns whether curves cross at the source of a halfedge; they do so only at fixed vertices.
  /// \complexity linear in its degree and the number of curves there
  bool has_crossing_at_source(halfedge_descriptor h) const {
    return internal::Curve_order<Triangulation>(*t_, segments_).has_crossing(h);
  }

  /// removes all curves; vertices stay fixed.
  void clear() {
    for (std::uint32_t c = 0; c < number_of_curves(); ++c) remove_segments(c);
    curves_.clear();
  }

private:
  /// \cond
  friend class internal::Curve_shortener<Triangulation>;
  friend class internal::Network_joints<Triangulation>;
  /// \endcond

  struct Curve {
    bool is_loop;
    std::uint32_t first = Segments::none, last = Segments::none;
    vertex_descriptor start; // its position if it has no segments
  };

  halfedge_descriptor halfedge_of(std::uint32_t s) const {
    return t_->numbers().halfedge_at(segments_[s].halfedge);
  }

  // the function may remove the segment
  template <class Function>
  void for_each_segment(std::uint32_t curve, const Function& f) const {
    const std::uint32_t last = curves_[curve].last;
    for (std::uint32_t s = curves_[curve].first; s != Segments::none;) {
      const std::uint32_t next = segments_[s].next;
      f(s);
      if (s == last) break;
      s = next;
    }
  }

  void remove_segments(std::uint32_t curve) {
    for_each_segment(curve, [this](std::uint32_t s) { remove_segment(s); });
    curves_[curve].first = curves_[curve].last = Segments::none;
  }
  void remove_segment(std::uint32_t s) {
    count_ends(halfedge_of(s), -1);
    segments_.remove(s);
  }
  void count_ends(halfedge_descriptor h, int n) {
    for (const vertex_descriptor v : {source(h, t_->mesh()), target(h, t_->mesh())}) {
      const std::uint32_t i = t_->index(v);
      if (i >= ends_.size()) ends_.resize(i + std::size_t{1}, 0);
      ends_[i] += static_cast<std::uint32_t>(n);
    }
  }

  // of segments at a vertex
  std::uint32_t number_of_ends(vertex_descriptor v) const {
    const std::uint32_t i = t_->index(v);
    return i < ends_.size() ? ends_[i] : 0;
  }

  std::uint32_t add(std::vector<halfedge_descriptor> way, bool is_loop) {
    check(way, is_loop);
    const vertex_descriptor start = source(way.front(), t_->mesh());
    remove_returns(way, is_loop);
    const std::uint32_t curve = number_of_curves();
    curves_.push_back({is_loop, Segments::none, Segments::none, start});
    append(curve, way);
    const internal::Curve_order<Triangulation> order(*t_, segments_);
    for_each_segment(curve, [&](std::uint32_t s) {
      segments_.stack(s, segments_[s].halfedge, order.left_neighbor(s));
    });
    for (const halfedge_descriptor h : way) {
      const vertex_descriptor v = source(h, t_->mesh());
      if (is_fixed(v) || number_of_ends(v) <= 2 || !order.has_crossing(h)) continue;
      remove_segments(curve);
      curves_.pop_back();
      throw Invalid_input(Element_kind::vertex, t_->index(v),
                          "the curve crosses another or itself at vertex " +
                              std::to_string(t_->index(v)) +
                              "; fix the vertex if it is a junction, or choose another way");
    }
    return curve;
  }

  void check(const std::vector<halfedge_descriptor>& way, bool is_loop) const {
    if (way.empty())
      throw Invalid_input(Element_kind::none, 0, "a curve needs a halfedge at least");
    for (std::size_t i = 0; i < way.size(); ++i) {
      if (i + 1 == way.size() && !is_loop) return;
      const halfedge_descriptor next = way[(i + 1) % way.size()];
      if (!internal::are_copies(*t_, target(way[i], t_->mesh()), source(next, t_->mesh())))
        throw Invalid_input(Element_kind::edge, t_->index(edge(next, t_->mesh())),
                            "halfedge " + std::to_string(i) +
                                " of a curve does not lead to the source of the one after it");
    }
  }

  void remove_returns(std::vector<halfedge_descriptor>& way, bool is_loop) const {
    const auto returns = [this](halfedge_descriptor g, halfedge_descriptor h) {
      return h == opposite(g, t_->mesh()) && !is_fixed(source(h, t_->mesh()));
    };
    std::vector<halfedge_descriptor> kept;
    for (const halfedge_descriptor h : way)
      if (!kept.empty() && returns(kept.back(), h))
        kept.pop_back();
      else
        kept.push_back(h);
    std::size_t n = 0; // at both ends of a loop
    while (is_loop && 2 * n + 1 < kept.size() && returns(kept[kept.size() - 1 - n], kept[n])) ++n;
    way.assign(kept.begin() + static_cast<std::ptrdiff_t>(n),
               kept.end() - static_cast<std::ptrdiff_t>(n));
  }

  // segments that are in no stack yet
  void append(std::uint32_t curve, const std::vector<halfedge_descriptor>& way) {
    Curve& c = curves_[curve];
    for (const halfedge_descriptor h : way) {
      const std::uint32_t s = segments_.add(t_->numbers().halfedge(h), curve);
      count_ends(h, 1);
      segments_.link(c.last, s);
      c.last = s;
      if (c.first == Segments::none) c.first = s;
    }
    if (c.is_loop) segments_.link(c.last, c.first);
  }

  Triangulation* t_;
  Segments segments_;
  std::vector<std::uint32_t> ends_; // of segments, per vertex
  std::vector<bool> fixed_;
  std::vector<Curve> curves_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CURVES_CURVE_NETWORK_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_QUERIES_CURVE_INSERTER_H
#define CGAL_INTRINSIC_GEODESICS_QUERIES_CURVE_INSERTER_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/Line_inserter.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_point.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/segments/Segment_flipper.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_to_target.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_walk.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Lays out a straight line over the input. Lengths are in the units of the input.
class Laid_out_line {
public:
  Laid_out_line(const Input& input, const Traced_curve& curve) : input_(input), curve_(curve) {}

  // The line from point `first` to point `last` of the curve, in the frame of its first face.
  Unscaled_vector vector(std::size_t first, std::size_t last) const;
  // Its length.
  double length(std::size_t first, std::size_t last) const;
  // A point at an end of a piece of it; within rounding of a vertex on the way, the vertex: a line
  // that is inserted cannot tell on which side it passes that.
  Surface_point point(std::size_t i, std::size_t piece) const;

private:
  Unscaled_vector piece(std::size_t i) const;
  bool turn(std::size_t i, Plane_vector<double>& x) const;

  const Input& input_;
  const Traced_curve& curve_;
};

/*
Turns geodesics over the input into paths of edges of the triangulation. It flips away the edges
that a geodesic crosses, and inserts vertices only where it crosses earlier geodesics. So each
geodesic may be found alone.

If a vertex is within rounding of a geodesic, the path may pass it on the wrong side:
`shorten_curves()` repairs this.
\tparam splits whether edges of earlier geodesics may be split; else `insert()` returns
  `not_traceable`
*/
template <class Triangulation, bool splits = true>
class Curve_inserter {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;

public:
  // \param log remembers flips, if nothing is split
  explicit Curve_inserter(Triangulation& t, Flip_log<Triangulation>* log = nullptr)
      : t_(t), lines_(t, log) {}

  // The halfedges of a path of one or several geodesics; paths are numbered from 0.
  std::vector<Halfedge> path(std::size_t i = 0) const { return lines_.paths().halfedges(t_, i); }
  void begin_path() { lines_.paths().begin(); }

  // Inserts a geodesic from one vertex to another, at the end of the last path.
  Move_status insert(const Traced_curve& curve, Vertex from, Vertex to) {
    const Laid_out_line line(t_.correspondence().input(), curve);
    const std::size_t n = curve.points.size();
    if (n < 2) return from == to ? Move_status::done : Move_status::not_traceable;
    for (std::size_t first = 0, last = 1; first + 1 < n; first = last++) {
      while (last + 1 < n && corner_of(line.point(last, last - 1)) == 3) ++last;
      // on a cover, a part may begin at another copy of the vertex where the one before ends
      const Move_status s = insert(line, first, last, vertex_at(line.point(first, first), from),
                                   vertex_at(line.point(last, last - 1), to));
      if (s != Move_status::done) return s;
    }
    return Move_status::done;
  }

private:
  // The vertex at a point, or another where there is none. The vertices of the input have the same
  // numbers.
  Vertex vertex_at(const Surface_point& p, Vertex other) const {
    const unsigned corner = corner_of(p);
    if (corner == 3) return other;
    std::uint32_t h = p.halfedge;
    for (unsigned k = 0; k < corner; ++k) h = t_.correspondence().input().next(h);
    return t_.numbers().vertex_at(t_.correspondence().input().source(h));
  }

  // a straight part
  Move_status insert(const Laid_out_line& line, std::size_t first, std::size_t last, Vertex from,
                     Vertex to) {
    const double length = line.length(first, last);
    if (!(length > 0)) return from == to ? Move_status::done : Move_status::not_traceable;
    const auto d = direction_at_vertex(t_, t_.index(from),
                                       {line.point(first, first), line.vector(first, last)});
    if (!d) return Move_status::not_traceable;
    return go(*d, std::ldexp(length, t_.metric().scale_exponent()), t_.index(to));
  }
  // The direction is corrected first: in a face that is thin, rounding turns it. The length is in
  // scaled units.
  Move_status go(Corner_direction d, double length, std::uint32_t to) {
    const Accurate_view<Triangulation> view(t_);
    const Geodesic_to_target straight =
        trace_to_target(view, Geodesic_walk<Accurate_view<Triangulation>>(view, d),
                        Geodesic_target::at_vertex(to), length, strip_);
    if (straight.end == Gluing::none) return lines_.go(d, length, to);
    return lines_.go({d.halfedge, d.angle + std::atan(straight.slope)}, straight.length, to);
  }

  Triangulation& t_;
  std::vector<Strip_side> strip_;
  Line_inserter<Triangulation, Flip_log<Triangulation>, splits> lines_;
};

// Adds a curve to a network. Fixes the vertices where it crosses another or itself, so that it may.
// \return the vertices
template <class Triangulation>
std::vector<typename Triangulation::vertex_descriptor>
add_crossing_curve(Curve_network<Triangulation>& network,
                   const std::vector<typename Triangulation::halfedge_descriptor>& way,
                   bool is_loop) {
  std::vector<typename Triangulation::vertex_descriptor> crossings;
  for (;;) {
    try {
      is_loop ? network.add_loop(way) : network.add_path(way);
      return crossings;
    } catch (const Invalid_input& e) {
      if (e.kind() != Element_kind::vertex) throw;
      crossings.push_back(
          network.triangulation().numbers().vertex_at(static_cast<std::uint32_t>(e.index())));
      network.fix(crossings.back());
    }
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_QUERIES_CURVE_INSERTER_H

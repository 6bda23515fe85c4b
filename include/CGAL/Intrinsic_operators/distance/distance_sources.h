// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_SOURCES_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_SOURCES_H

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/points_in_one_face.h>
#include <CGAL/Intrinsic_triangulations/tracing/within_rounding.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a curve through faces of an intrinsic triangulation, as a source of distances.

Two consecutive points are in one face, and the curve is straight between them: what
`Polyhedral_distance::shortest_path()` returns. Points within rounding of a vertex or an edge, up to
2^-40 of the longest side of their face, are on it: a piece along an edge belongs to the faces on
both sides alike.
*/
struct Polyline_source {
  /// The points, on the intrinsic triangulation.
  std::vector<Surface_point> points;
};

namespace internal {

// A straight piece of a source in a face of a table: barycentric coordinates of its ends there,
// which are equal for a point. On an edge there is one in each face, with half of the source.
struct Source_segment {
  std::uint32_t face;
  std::array<double, 3> from, to;
  double part = 1; // of the source

  bool is_point() const { return from == to; }
  // whether it is on a side
  bool is_along(std::size_t side) const {
    return from[(side + 2) % 3] == 0 && to[(side + 2) % 3] == 0;
  }
};

// A side of a face of a table, in the direction of the curve. Its own face lies left of it if
// `is_left`, else right.
struct Source_side {
  std::uint32_t face;
  std::uint32_t side;
  bool is_left;
};

// Where sources are, in the numbers of a table.
struct Source_places {
  std::vector<int> rows; // of vertices
  std::vector<Source_segment> segments;
  std::vector<Source_side> sides;
};

// Reads sources in all their forms.
template <NumberedTriangulation Triangulation>
class Source_reader {
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Face = typename Triangulation::face_descriptor;
  using Mesh = typename Triangulation::Mesh;

public:
  Source_reader(const Triangulation& t, const Face_table& table) : t_(t), table_(table) {}

  template <class Sources>
  Source_places read(const Sources& sources) {
    add(sources);
    std::sort(places_.rows.begin(), places_.rows.end()); // copies of a vertex are one source
    places_.rows.erase(std::unique(places_.rows.begin(), places_.rows.end()), places_.rows.end());
    return std::move(places_);
  }

private:
  template <class Source>
  void add(const Source& source) {
    if constexpr (std::convertible_to<Source, Vertex>)
      places_.rows.push_back(static_cast<int>(t_.input_vertex(source)));
    else if constexpr (std::convertible_to<Source, Halfedge>)
      add_side(source);
    else if constexpr (std::same_as<Source, Surface_point>)
      add_point(rounded(source));
    else if constexpr (std::same_as<Source, Face_location<Mesh>>)
      add(surface_point(t_, source));
    else if constexpr (std::same_as<Source, Polyline_source>)
      add_polyline(source.points);
    else {
      static_assert(
          std::ranges::range<const Source>,
          "sources are vertices and halfedges of t.mesh(), objects Surface_point, Face_location or "
          "Polyline_source, or ranges of them; a vertex of the user's mesh is "
          "vertex_on_intrinsic(t, "
          "v, mesh), a place on it locate_on_intrinsic(t, place, mesh)");
      for (const auto& s : source) add(s);
    }
  }

  bool is_border(Halfedge h) const {
    return face(h, t_.mesh()) == boost::graph_traits<Mesh>::null_face();
  }

  void add_side(Halfedge h) {
    const Halfedge in_face = is_border(h) ? opposite(h, t_.mesh()) : h;
    const std::uint32_t f = table_.slot[t_.index(face(in_face, t_.mesh()))];
    const std::uint32_t number = t_.numbers().halfedge(in_face);
    std::uint32_t side = 0;
    while (table_.faces[f].halfedges[side] != number) ++side;
    places_.sides.push_back({f, side, in_face == h});
  }

  void add_polyline(const std::vector<Surface_point>& points) {
    if (points.size() == 1) add(points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto in_common = points_in_one_face(Intrinsic_view<Triangulation>(t_),
                                                rounded(points[i - 1]), rounded(points[i]));
      if (!in_common)
        throw std::invalid_argument("points " + std::to_string(i - 1) + " and " +
                                    std::to_string(i) + " of a polyline are not in one face");
      const auto& [from, to] = *in_common;
      const bool is_point = points.size() == 2 && points[0].halfedge == points[1].halfedge &&
                            points[0].weights == points[1].weights;
      if (is_point || !are_together(from, to)) add_segment(from, to); // skip repeated points
    }
  }

  // Whether two points of a face are the same within rounding: a piece between them has no
  // direction.
  bool are_together(const Surface_point& p, const Surface_point& q) const {
    const Geodesic_face face(Intrinsic_view<Triangulation>(t_), p.halfedge);
    const Plane_vector<double> d = face.position(q.weights) - face.position(p.weights);
    const double longest = *std::max_element(face.length.begin(), face.length.end());
    return std::hypot(d[0], d[1]) <= 0x1p-38 * longest;
  }

  void add_point(const Surface_point& p) { add_segment(p, p); }

  Surface_point rounded(const Surface_point& p) const {
    if (is_border(t_.numbers().halfedge_at(p.halfedge))) return p;
    return within_rounding(Intrinsic_view<Triangulation>(t_), p);
  }

  void add_segment(const Surface_point& p, const Surface_point& q) {
    const Halfedge h = t_.numbers().halfedge_at(p.halfedge);
    if (is_border(h))
      throw std::invalid_argument("a source is not in a face, but beyond the border");
    const Source_segment s = segment(h, p.weights, q.weights);
    for (std::size_t k = 0; k < 3; ++k)
      if (s.is_point() && s.from[k] == 1) { // a corner is a vertex, and on two sides as well
        places_.rows.push_back(table_.faces[s.face].rows[k]);
        return;
      }
    for (std::size_t k = 0; k < 3; ++k) {
      if (!s.is_along(k)) continue;
      const Halfedge side = t_.numbers().halfedge_at(table_.faces[s.face].halfedges[k]),
                     beyond = opposite(side, t_.mesh());
      if (s.from[k] == 1 && s.to[(k + 1) % 3] == 1) return add_side(side);
      if (s.to[k] == 1 && s.from[(k + 1) % 3] == 1) return add_side(beyond);
      if (is_border(beyond)) break;
      places_.segments.push_back(s);
      places_.segments.push_back(
          segment(beyond, {s.from[(k + 1) % 3], s.from[k], 0}, {s.to[(k + 1) % 3], s.to[k], 0}));
      for (auto half = places_.segments.end() - 2; half != places_.segments.end(); ++half)
        half->part = 0.5;
      return;
    }
    places_.segments.push_back(s);
  }

  // From weights in the frame of a halfedge.
  Source_segment segment(Halfedge h, const std::array<double, 3>& from,
                         const std::array<double, 3>& to) const {
    const std::uint32_t number = t_.numbers().halfedge(h);
    Source_segment s{table_.slot[t_.index(face(h, t_.mesh()))], {}, {}};
    std::size_t k = 0;
    while (table_.faces[s.face].halfedges[k] != number) ++k;
    for (std::size_t i = 0; i < 3; ++i) {
      s.from[(k + i) % 3] = from[i];
      s.to[(k + i) % 3] = to[i];
    }
    return s;
  }

  const Triangulation& t_;
  const Face_table& table_;
  Source_places places_;
};

// The place of a point in the layout of its face.
inline std::complex<double> place_in_layout(const std::array<std::complex<double>, 3>& corners,
                                            const std::array<double, 3>& weights) {
  return weights[1] * corners[1] + weights[2] * corners[2]; // the first corner is at 0
}

double distance_to_segment(std::complex<double> p, std::complex<double> a, std::complex<double> b);

// The distances near sources: zero at vertices that are sources. At the corners of faces that
// contain a source, the distance in the face, or along edges from other sources if that is shorter.
std::map<int, double> distances_near_sources(const Face_table& table, const Source_places& sources);

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_DISTANCE_SOURCES_H

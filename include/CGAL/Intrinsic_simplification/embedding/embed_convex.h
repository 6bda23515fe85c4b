// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBED_CONVEX_H
#define CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBED_CONVEX_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

/*!
\file
The convex polyhedron of a metric on the sphere. Alexandrov proved that there is exactly one.
*/

namespace CGAL::Intrinsic_triangulations {

/// What `embed_convex()` is doing, in this order.
enum class Embedding_stage : std::uint8_t {
  flat_vertices, ///< removes flat vertices, by flips
  start,         ///< looks for pyramids over an apex far away
  curvatures,    ///< decreases the curvatures of the pyramids
  fit,           ///< moves points until edges have their lengths
  certificate    ///< proves what it can
};

/// returns what a stage does, in words.
const char* name_of(Embedding_stage stage);

/// How far `embed_convex()` is.
struct Embedding_progress {
  Embedding_stage stage = Embedding_stage::flat_vertices; ///< what it is doing
  double curvature_left = 1; ///< of the curvature at the start, along the segments from the apex
  std::size_t steps = 0;     ///< Newton steps so far
};

/// What `embed_convex()` is asked for.
struct Embed_options {
  /// Vertices whose angles sum to a full turn, up to this many radians and what rounding of lengths
  /// to doubles can change, are flat. They are left out and put back on faces. If they have some
  /// curvature c, the surface is stretched by about c, see `Convexity_certificate::stretch`, though
  /// the vertex may lose a height of the square root of c, times the size.
  double flat_within = 1e-10;
  std::size_t maximum_steps = 10000; ///< Newton steps; then the status is `cap`
  /// Is called before each step of every stage, and returns whether to go on.
  std::function<bool(const Embedding_progress&)> progress;
};

/// What the points of a `Convex_polyhedron` are.
enum class Convex_shape : std::uint8_t {
  polyhedron,            ///< it has a volume
  doubly_covered_polygon ///< a convex polygon, front and back, in the plane z = 0
};

/*!
\brief says what is proven about a `Convex_polyhedron`.

If `is_proven`, there is a polyhedron whose vertices are within `within` of the points
(Kantorovich's theorem), and whose surface is the given one: exactly if `stretch` is 0, but for the
rounding of numbers with 106 bits. Its convex edges are convex for certain. Its flat edges are flat
up to that distance: they may lie inside a face. It is convex up to that distance. A doubly covered
polygon is proven to be nearly isometric, by its stretch: front and back of the surface may differ a
little, and then the back takes the lengths of the front. A polyhedron with exactly the lengths of
the surface may have a height of about the square root of that stretch, times the size.
*/
struct Convexity_certificate {
  bool is_proven = false; ///< whether that polyhedron exists
  double within = 0;      ///< in the unit of the lengths
  /// Lengths of curves are multiplied by at most 1 + stretch, or divided by at most that, from the
  /// surface to that polyhedron: vertices with some curvature were made flat, or front and back of
  /// a polygon the same. 0: neither changed anything. Infinite: no bound is known.
  double stretch = 0;
  std::size_t convex_edges = 0;     ///< edges that are convex for certain
  std::size_t flat_edges = 0;       ///< edges that are flat up to that distance
  std::size_t concave_edges = 0;    ///< edges that are neither; 0 if the status is `done`
  bool encloses_its_centre = false; ///< whether faces turn once around the centre: with the
                                    ///< above, the polyhedron as a whole is convex, up to
                                    ///< `within`
};

/// What `embed_convex()` has found.
struct Convex_polyhedron {
  /// `done`; `inaccurate` if edges or the whole may be concave, or if the stretch is infinite, as
  /// where `flat_within` lets vertices go that are not nearly flat; `stalled` or `cap` if the
  /// solver has stopped; `cancelled`. There are points only if it is `done` or `inaccurate`.
  Status status = Status::done;
  Embedding_stage stage = Embedding_stage::certificate; ///< the last one: where it has stopped
  Convex_shape shape = Convex_shape::polyhedron;        ///< whether it has a volume
  /// The places of the vertices, by their names in the input: on a cover, of all copies.
  std::vector<std::array<double, 3>> points;
  /// Triangles between the points, counterclockwise from outside.
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<std::uint32_t> flat_vertices; ///< those that lie on a face or an edge
  /// Greatest difference between a distance in space and in the metric, over the edges of the
  /// polyhedron, by its diameter.
  double largest_error = 0;
  std::size_t steps = 0;             ///< Newton steps
  Convexity_certificate certificate; ///< what is proven
};

/*!
\brief finds the convex polyhedron whose surface has a given metric, up to motions of space.

Only lengths are used, never points. The method is that of Bobenko and Izmestiev (2008): pyramids
over all faces meet in an apex, segments from the apex to the vertices have curvatures, and these
are decreased to 0 together. Flips keep the edges convex. Then Newton's method finds the positions
from the lengths.
\param surface the surface
\param options what is asked for
\return the polyhedron, see its status
\throws Invalid_input if the surface is not a sphere, or covers a one-sided mesh; naming a vertex
  where angles sum to more than a full turn; or if `flat_within` is not from 0 to 0.1
\complexity in measurements about \f$n^{3/2}\f$ for n vertices
*/
Convex_polyhedron embed_convex(const Input& surface, const Embed_options& options = {});

/// returns why there are no points, and what to do about it; nothing if there are points.
std::string reason_without_points(const Convex_polyhedron& found);

/// embeds the surface of a triangulation, see there: its vertices are those of its input.
/// \tparam Triangulation a triangulation that keeps its input
template <class Triangulation>
  requires requires(const Triangulation& t) {
    { t.input() } -> std::convertible_to<const Input&>;
  }
Convex_polyhedron embed_convex(const Triangulation& t, const Embed_options& options = {}) {
  return embed_convex(t.input(), options);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_EMBEDDING_EMBED_CONVEX_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_NORMAL_COORDINATES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_NORMAL_COORDINATES_H

#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/formulas/Development.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

/*!
\file
Normal coordinates: curves in one or two triangles, and curves followed from face to face (§3.5.1 of
the course). Integers only.
*/

namespace CGAL::Intrinsic_triangulations {

/// Number of crossings of curves with an edge; -1 for an edge along which a curve runs.
using Normal_coordinate = std::int32_t;

/// Greatest number of crossings of one edge: sums of a few of them do not overflow.
inline constexpr Normal_coordinate maximal_normal_coordinate = Normal_coordinate{1} << 27;

/// returns the number of crossings, n^+ in the course.
inline Normal_coordinate crossings(Normal_coordinate n) { return std::max(n, 0); }
/// returns the number of curves that run along the edge, n^- in the course.
inline Normal_coordinate parallels(Normal_coordinate n) { return std::max(-n, 0); }

/*!
\brief describes how curves run in a face: corner 0 is the source of side 0, side `k` runs from
corner `k` to the next one.
*/
struct Corner_coordinates {
  /// Number of curves that cut off each corner, c in the course.
  std::array<Normal_coordinate, 3> cutting;
  /// Number of curves that emanate from each corner and cross the opposite side, e in the course.
  std::array<Normal_coordinate, 3> emanating;

  /// returns the only corner from which curves emanate, or 3.
  unsigned fan_corner() const {
    return static_cast<unsigned>(std::find_if(emanating.begin(), emanating.end(),
                                              [](Normal_coordinate n) { return n > 0; }) -
                                 emanating.begin());
  }
};

/*!
\brief computes how curves run in a face from the normal coordinates of its sides, Eq. 9 and 10 of
the course.
*/
inline Corner_coordinates corner_coordinates(const std::array<Normal_coordinate, 3>& normal) {
  const std::array<Normal_coordinate, 3> n{crossings(normal[0]), crossings(normal[1]),
                                           crossings(normal[2])};
  Corner_coordinates c;
  for (std::size_t k = 0; k < 3; ++k) // side k + 1 is opposite corner k
    c.emanating[k] = std::max(0, n[(k + 1) % 3] - n[k] - n[(k + 2) % 3]);
  for (std::size_t k = 0; k < 3; ++k)
    c.cutting[k] = (std::max(0, n[k] + n[(k + 2) % 3] - n[(k + 1) % 3]) - c.emanating[(k + 1) % 3] -
                    c.emanating[(k + 2) % 3]) /
                   2;
  return c;
}

/*!
\brief computes the normal coordinate of the edge km that a flip of ij makes, Eq. 13 of the course.
\param ij normal coordinate of the flipped edge
\param f how curves run in the left face, with corners i, j, k
\param g how curves run in the right face, with corners j, i, m
*/
inline Normal_coordinate flipped_normal_coordinate(Normal_coordinate ij,
                                                   const Corner_coordinates& f,
                                                   const Corner_coordinates& g) {
  const Normal_coordinate twice = std::abs(g.cutting[0] - f.cutting[1]) +
                                  std::abs(g.cutting[1] - f.cutting[0]) - g.emanating[2] -
                                  f.emanating[2];
  return f.cutting[2] + g.cutting[2] + twice / 2 + f.emanating[0] + f.emanating[1] +
         g.emanating[0] + g.emanating[1] + parallels(ij);
}

/// The place where a curve leaves a face.
struct Curve_crossing {
  std::uint32_t halfedge;     ///< the halfedge of that face
  Normal_coordinate position; ///< number of curves that cross it nearer to its source
};

/// The start or the end of a curve at the source of a halfedge, in the face of it.
struct Curve_end {
  std::uint32_t halfedge;  ///< the first side of the corner, counterclockwise
  Normal_coordinate index; ///< number of curves that emanate from the corner nearer to that side
};

/*!
\brief requires the number of curves that cross each edge.

Syntax of \ref ::NormalCoordinates, where its meaning is described.
*/
template <class Coordinates>
concept NormalCoordinates = requires(const Coordinates& c, std::uint32_t e) {
  { c.normal_coordinate(e) } -> std::same_as<Normal_coordinate>;
};

/*!
\brief describes how curves run in the face of `h`, whose source is corner 0.
*/
template <NumberedTriangles Complex, NormalCoordinates Coordinates>
Corner_coordinates corner_coordinates(const Complex& complex, const Coordinates& coordinates,
                                      std::uint32_t h) {
  const std::array<std::uint32_t, 3> s = sides_of_face(complex, h);
  return corner_coordinates({coordinates.normal_coordinate(s[0] / 2),
                             coordinates.normal_coordinate(s[1] / 2),
                             coordinates.normal_coordinate(s[2] / 2)});
}

/// returns where a curve that starts from a corner leaves the face. \pre such a curve exists
template <NumberedTriangles Complex, NormalCoordinates Coordinates>
Curve_crossing first_crossing(const Complex& complex, const Coordinates& coordinates,
                              const Curve_end& start) {
  const Corner_coordinates c = corner_coordinates(complex, coordinates, start.halfedge);
  return {complex.next(start.halfedge), c.cutting[1] + start.index};
}

/*!
\brief follows a curve from where it leaves a face to its end.
\param complex the intrinsic triangulation
\param coordinates the normal coordinates
\param crossing where the curve leaves a face
\param visit called for each `Curve_crossing`, from `crossing` on
\return the end, seen as the start of the curve that runs back
\complexity linear in the number of crossings
*/
template <NumberedTriangles Complex, NormalCoordinates Coordinates,
          std::invocable<const Curve_crossing&> Visit>
Curve_end follow_curve(const Complex& complex, const Coordinates& coordinates,
                       Curve_crossing crossing, Visit visit) {
  for (;;) {
    visit(crossing);
    const std::uint32_t h = crossing.halfedge ^ 1U; // enters its face
    const Normal_coordinate n = coordinates.normal_coordinate(h / 2);
    const Normal_coordinate from_source = n - 1 - crossing.position;
    const Corner_coordinates c = corner_coordinates(complex, coordinates, h);
    const std::uint32_t next = complex.next(h), last = complex.next(next);
    if (from_source < c.cutting[0]) // around the source
      crossing = {last, coordinates.normal_coordinate(last / 2) - 1 - from_source};
    else if (from_source < c.cutting[0] + c.emanating[2]) // to the apex
      return {last, from_source - c.cutting[0]};
    else // around the target
      crossing = {next, crossing.position};
  }
}

/// Curves that leave a face side by side.
struct Curve_bundle {
  std::uint32_t halfedge; ///< the halfedge of that face
  Normal_coordinate
      position;             ///< number of curves that cross it nearer to its source than the first
  Normal_coordinate count;  ///< number of curves
  Normal_coordinate number; ///< number of the first one, counted where following began
};

/// Ignores where curves pass.
struct Ignored_steps {
  /// ignores a step
  void operator()(const Curve_bundle&) const {}
};

/*!
\brief follows curves that leave a face side by side to their ends. As long as they run side by
side, they take one step together.
\param complex the intrinsic triangulation
\param coordinates the normal coordinates
\param bundle the curves
\param stack memory to use
\param visit called with the number of each curve and its `Curve_end`, see `follow_curve()`
\param pass called with the curves of each step, where they leave a face
\return the number of steps
\complexity linear in the number of steps, at most that of all crossings
*/
template <NumberedTriangles Complex, NormalCoordinates Coordinates,
          std::invocable<Normal_coordinate, const Curve_end&> Visit,
          std::invocable<const Curve_bundle&> Pass = Ignored_steps>
std::size_t follow_curves(const Complex& complex, const Coordinates& coordinates,
                          Curve_bundle bundle, std::vector<Curve_bundle>& stack, Visit visit,
                          Pass pass = {}) {
  std::size_t steps = 0;
  stack.assign(1, bundle);
  while (!stack.empty()) {
    Curve_bundle b = stack.back();
    stack.pop_back();
    for (; b.count > 0; ++steps) {
      pass(std::as_const(b));
      const std::uint32_t h = b.halfedge ^ 1U; // enters its face
      const Corner_coordinates c = corner_coordinates(complex, coordinates, h);
      const std::uint32_t next = complex.next(h), last = complex.next(next);
      const Normal_coordinate n = coordinates.normal_coordinate(h / 2), end = b.position + b.count;
      // from the target of h on: curves about the target, to the apex, about the source
      const Normal_coordinate to_source = n - c.cutting[0], to_apex = to_source - c.emanating[2];
      const auto about_target = std::max(0, std::min(end, to_apex) - b.position);
      const auto about_source = std::max(0, end - std::max(b.position, to_source));
      for (Normal_coordinate i = about_target; i < b.count - about_source; ++i)
        visit(b.number + i, Curve_end{last, to_source - 1 - (b.position + i)});
      if (about_source > 0) {
        const Normal_coordinate skipped = b.count - about_source;
        stack.push_back({last, b.position + skipped + coordinates.normal_coordinate(last / 2) - n,
                         about_source, b.number + skipped});
      }
      b = {next, b.position, about_target, b.number};
    }
  }
  return steps;
}

/*!
\brief is the strip of faces that a curve passes from the corner where it starts.
*/
struct Curve_strip {
  /// The faces; the curve starts at point 0, and ends at the last point.
  Development<> faces;
  /// The corner in which it ends, as the start of the way back.
  Curve_end end;

  /*!
  \brief follows a curve.
  \param complex the intrinsic triangulation
  \param coordinates its normal coordinates
  \param start where the curve starts; it crosses the face there
  */
  template <NumberedTriangles Complex, NormalCoordinates Coordinates>
  Curve_strip(const Complex& complex, const Coordinates& coordinates, const Curve_end& start) {
    faces.start(start.halfedge);
    end = follow_curve(
        complex, coordinates, first_crossing(complex, coordinates, start),
        [&](const Curve_crossing& c) { faces.enter(complex, faces.last(), c.halfedge ^ 1U); });
  }

  /// returns the positions of all points, with the first side of the first face from 0 to 1.
  template <NumberedComplex Complex>
  std::vector<Plane_vector<double>> develop(const Complex& complex) const {
    std::vector<Plane_vector<double>> z;
    faces.develop(z, approximate_values(complex));
    return z;
  }
};

/*!
\brief names one of the regions into which curves cut a face, or a curve between two of them.

Corners and sides are those of `Corner_coordinates`.
*/
struct Face_region {
  /// Number of curves that cut off each corner from the region.
  std::array<Normal_coordinate, 3> cutting{0, 0, 0};
  /// Number of curves emanating from a corner that have the region on their left.
  Normal_coordinate right_of_fan = 0;
  /// The corner from which curves emanate, or 3.
  unsigned fan_corner = 3;
  /// Whether the point is on a curve: curve `cutting[corner]` about `corner`, or if `corner` is
  /// `fan_corner` emanating curve `right_of_fan`.
  bool is_on_curve = false;
  /// The corner of that curve.
  unsigned corner = 3;
};

/*!
\brief returns the normal coordinates of the edges from the corners of a face to a new vertex in a
region of it: -1 if the edge runs along a curve.
*/
std::array<Normal_coordinate, 3> inserted_normal_coordinates(const Corner_coordinates& c,
                                                             const Face_region& r);

/*!
\brief tells whether the crossings of the edges to a vertex in a face are those of a vertex in a
region of the face: then the vertex can be removed.
\param c how curves run in the face without the vertex
\param normal normal coordinates of the edges from the corners to the vertex
\param is_on_curve whether the vertex is on a curve
*/
bool has_region(const Corner_coordinates& c, const std::array<Normal_coordinate, 3>& normal,
                bool is_on_curve);

/*!
\brief tells whether a vertex of degree three lies in a region of the face around it, or on a curve
along a side of that.
\param sides normal coordinates of the sides of the face
\param to normal coordinates of the edges from its corners to the vertex
\param is_on_curve whether the vertex is on a curve
*/
bool can_do_without_vertex(std::array<Normal_coordinate, 3> sides,
                           const std::array<Normal_coordinate, 3>& to, bool is_on_curve);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_NORMAL_COORDINATES_H

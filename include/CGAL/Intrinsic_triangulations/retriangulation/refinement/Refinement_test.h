// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Constrained_segments.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/Refinement_result.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a queue of faces by number: the highest priority first, and among equal priorities the
first to arrive.

A face that changes is pushed again, or removed; its old entry is then skipped.
*/
class Face_queue {
public:
  /// pushes a face, whether it waits or not. \complexity logarithmic
  void push(std::uint32_t face, double priority);

  /// removes a face, if it waits.
  void remove(std::uint32_t face) {
    if (face >= ticket_.size() || ticket_[face] == 0) return;
    --waiting_;
    ticket_[face] = 0;
  }

  /// tells whether no face waits.
  bool empty() const { return waiting_ == 0; }

  /// takes the first face out. \pre `!empty()`
  std::uint32_t pop();

  /// marks a face, and tells whether it was not marked.
  bool begin_check(std::uint32_t face) {
    resize(face);
    return !std::exchange(is_marked_[face], 1);
  }
  /// takes the mark away.
  void end_check(std::uint32_t face) { is_marked_[face] = 0; }

private:
  struct Entry {
    double priority;
    std::uint64_t ticket;
    std::uint32_t face;
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.priority < b.priority || (a.priority == b.priority && a.ticket > b.ticket);
    }
  };

  void resize(std::uint32_t face);

  std::priority_queue<Entry> heap_;
  std::vector<std::uint64_t> ticket_; // of the entry that is valid; 0: the face does not wait
  std::vector<char> is_marked_;
  std::uint64_t tickets_ = 0;
  std::size_t waiting_ = 0;
};

/// The result for a face.
enum class Face_state {
  good,       ///< it meets the criteria
  bad,        ///< it does not, and can be refined
  needle,     ///< it does not: see `Unsatisfied_reason::needle`
  small_angle ///< it does not: see `Unsatisfied_reason::small_angle`
};

/*!
\brief decides whether faces meet the criteria of refinement (Algorithm 4 of the course), by signs
that exact traits decide exactly.

The bound on angles is a cotangent, rounded so that the angle is not below the given one.
*/
class Refinement_test {
public:
  /*!
  \brief prepares the test.
  \param minimum_angle least angle of faces, in degrees
  \param maximum_circumradius largest circumradius of faces
  \param maximum_edge_length largest length of edges
  \param scale_exponent lengths are scaled by 2^scale_exponent
  \throws std::invalid_argument if a bound is not a number, not positive, or an angle of 60 degrees
  or more
  */
  Refinement_test(double minimum_angle, double maximum_circumradius, double maximum_edge_length,
                  int scale_exponent);

  /*!
  \brief decides about a face.
  \param t the triangulation
  \param face the face
  \param corners the vertices where its sides start
  \param segments the edges that are not flipped
  */
  template <class Triangulation>
  Face_state operator()(const Triangulation& t, const Indexed_face& face,
                        const std::array<std::uint32_t, 3>& corners,
                        const Constrained_segments& segments) const {
    const std::span<const Indexed_face> faces(&face, 1);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (squared_radius_ < infinity &&
        t.sign(faces, Large_circumradius_expression{squared_radius_}) == POSITIVE)
      return Face_state::bad;
    if (squared_length_ < infinity)
      for (std::size_t k = 0; k < 3; ++k)
        if (t.sign(faces, Long_side_expression{k, squared_length_}) == POSITIVE)
          return Face_state::bad;
    Face_state state = Face_state::good;
    if (cotangent_ < infinity && !has_certainly_no_small_angle(t.metric(), face))
      for (std::size_t k = 0; k < 3; ++k) {
        if (t.sign(faces, Small_angle_expression{k, cotangent_}) != POSITIVE) continue;
        state = why_small(face.edges, corners, k, segments);
        if (state == Face_state::bad) break;
      }
    return state;
  }

  /// tells whether a face of rounded values has an angle below the bound, up to rounding.
  bool is_thin(const Face_values<double>& v) const {
    const auto& [l, a] = v;
    return l[0] + l[1] + l[2] - 2 * std::min({l[0], l[1], l[2]}) > cotangent_ * a;
  }

private:
  template <class Metric>
  static constexpr bool stores_doubles = requires(const Metric& m) {
    { m.squared_length(0U) } -> std::same_as<const double&>;
    { m.quadruple_area(0U) } -> std::same_as<const double&>;
  };

  static double squared(double length, int scale_exponent) {
    return std::ldexp(length * length, 2 * scale_exponent);
  }

  // Most faces are good, and three signs cost more than one bound: the least angle is opposite the
  // shortest side.
  template <class Metric>
  bool has_certainly_no_small_angle(const Metric& metric, const Indexed_face& face) const {
    if constexpr (internal::Has_enclosures<Metric>) {
      const auto &a = metric.squared_length(face.edges[0]),
                 &b = metric.squared_length(face.edges[1]),
                 &c = metric.squared_length(face.edges[2]);
      // rounded upwards
      const double least = std::min({a.inf(), b.inf(), c.inf()}),
                   shape = a.sup() + b.sup() + c.sup() + -2 * least;
      return shape + -cotangent_ * metric.quadruple_area(face.face).inf() <= 0;
    } else if constexpr (stores_doubles<Metric>) {
      const double a = metric.squared_length(face.edges[0]),
                   b = metric.squared_length(face.edges[1]),
                   c = metric.squared_length(face.edges[2]), sum = a + b + c;
      // by more than the rounding errors of these signs
      return sum - 2 * std::min({a, b, c}) + 0x1p-48 * sum <=
             (1 - 0x1p-48) * cotangent_ * metric.quadruple_area(face.face);
    } else {
      return false;
    }
  }

  // why the angle opposite side k is small
  Face_state why_small(const std::array<std::uint32_t, 3>& edges,
                       const std::array<std::uint32_t, 3>& corners, std::size_t k,
                       const Constrained_segments& segments) const {
    const std::uint32_t e = edges[(k + 1) % 3], f = edges[(k + 2) % 3];
    if (e == f) return Face_state::needle;
    if (segments.is_segment(e) && segments.is_segment(f)) return Face_state::small_angle;
    if (segments.are_across_small_angle(corners[k], corners[(k + 1) % 3], std::atan(1 / cotangent_),
                                        !segments.is_segment(edges[k])))
      return Face_state::small_angle;
    return Face_state::bad;
  }

  double cotangent_ = std::numeric_limits<double>::infinity();
  double squared_radius_, squared_length_;
};

namespace internal {

// R = abc / (4 A)
inline double squared_circumradius(const Face_values<double>& v) {
  const auto& [l, a] = v;
  return l[0] / a * l[1] * (l[2] / a);
}

// Least distance of a new vertex for a face, and of its copies on other sheets, from other
// vertices: if they were nearer, refinement might not end. The circumcenter of a face of a Delaunay
// triangulation is a circumradius from all vertices, which for bounds up to 30 degrees is not below
// the shortest side of a thin face; for a face that is only too large, half of it is enough.
// Squared, and a little less: rounding must not refuse a vertex at this distance.
inline double least_distance(const Face_values<double>& v, bool is_thin) {
  const auto& l = v.squared_lengths;
  return (1 - 0x1p-10) *
         std::min({l[0], l[1], l[2], squared_circumradius(v) * (is_thin ? 1 : 0.25)});
}

// The face of the greatest one comes first: largest circumradius, or greatest cotangent.
inline double refinement_priority(Refinement_order order, const Face_values<double>& v) {
  if (order == Refinement_order::first_come) return 0;
  if (order == Refinement_order::largest_first) return squared_circumradius(v);
  const auto& [l, a] = v;
  return (l[0] + l[1] + l[2] - 2 * std::min({l[0], l[1], l[2]})) / a;
}

// Why a face stays although it does not meet the criteria.
inline Unsatisfied_reason unsatisfied_reason(Face_state s, bool was_stopped) {
  if (s == Face_state::needle) return Unsatisfied_reason::needle;
  if (s == Face_state::small_angle) return Unsatisfied_reason::small_angle;
  return was_stopped ? Unsatisfied_reason::stopped : Unsatisfied_reason::refused;
}

// Halfedges of the faces inside a rim, one each, up to a maximal number; each face is found from
// the first halfedge of the rim.
template <class Triangulation>
std::vector<typename Triangulation::halfedge_descriptor>
faces_inside(const Triangulation& t,
             const std::vector<typename Triangulation::halfedge_descriptor>& rim,
             std::size_t most) {
  using Halfedge = typename Triangulation::halfedge_descriptor;
  std::vector<Halfedge> stack{rim.front()}, found;
  std::vector<std::uint32_t> seen;
  while (!stack.empty() && seen.size() < most) {
    const Halfedge h = stack.back();
    stack.pop_back();
    const std::uint32_t f = t.index(face(h, t.mesh()));
    if (std::find(seen.begin(), seen.end(), f) != seen.end()) continue;
    seen.push_back(f);
    found.push_back(h);
    for (Halfedge g = next(h, t.mesh()); g != h; g = next(g, t.mesh()))
      if (std::find(rim.begin(), rim.end(), g) == rim.end()) stack.push_back(opposite(g, t.mesh()));
  }
  return found;
}

// Whether a vertex has no neighbour nearer than a distance, squared, in scaled units. Edges from a
// circumcenter to itself may be shorter, about vertices of small angle; those from its copies may
// not, or points about one such vertex would lead to points about the next.
template <class Triangulation>
bool keeps_distance(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                    double squared, bool may_have_loops) {
  bool keeps = true;
  for_each_outgoing(v, t.mesh(), [&](auto h) {
    const bool is_loop = target(h, t.mesh()) == v;
    keeps = keeps && ((is_loop && may_have_loops) || t.metric().approximate_squared_length(
                                                         t.numbers().halfedge(h) / 2) >= squared);
  });
  return keeps;
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_REFINEMENT_TEST_H

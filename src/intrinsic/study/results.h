// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_RESULTS_H
#define INTRINSIC_STUDY_RESULTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

// What the study measures of the triangulations that arithmetics lead to.

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/// returns a number as `long double`, or as `double` if its type has no conversion to that.
template <class FT>
long double long_double_of(const FT& x) {
  if constexpr (std::is_floating_point_v<FT>)
    return x;
  else if constexpr (requires { x.template convert_to<long double>(); })
    return x.template convert_to<long double>();
  else
    return CGAL::to_double(x);
}

/// Total area and cone angles of a triangulation, in scaled units.
struct Conserved {
  long double quadruple_area = 0;
  std::vector<long double> cone_angles; ///< per vertex
};

/// measures what flips conserve.
template <class Triangulation>
Conserved conserved(const Triangulation& t) {
  const auto& mesh = t.mesh();
  constexpr bool has_intervals =
      std::is_same_v<typename Triangulation::FT, CGAL::Interval_nt<false>>;
  const auto length = [&](auto h) {
    const std::uint32_t e = t.index(edge(h, mesh));
    if constexpr (has_intervals)
      return t.metric().approximate_squared_length(e);
    else
      return t.metric().squared_length(e);
  };
  Conserved c{0, std::vector<long double>(num_vertices(mesh), 0)};
  for (const auto f : faces(mesh)) {
    long double area = 0;
    if constexpr (has_intervals)
      area = t.metric().approximate_quadruple_area(t.index(f));
    else
      area = long_double_of(t.metric().quadruple_area(t.index(f)));
    c.quadruple_area += area;
    const auto ij = halfedge(f, mesh), jk = next(ij, mesh), ki = next(jk, mesh);
    const std::array l{length(ij), length(jk), length(ki)};
    using Number = typename decltype(l)::value_type;
    const std::array<std::uint32_t, 3> v{t.index(source(ij, mesh)), t.index(source(jk, mesh)),
                                         t.index(source(ki, mesh))};
    // twice the cross and the dot product of the sides at a corner; the latter may cancel
    for (std::size_t k = 0; k < 3; ++k)
      c.cone_angles[v[k]] +=
          std::atan2(area, long_double_of(Number(l[k] + l[(k + 2) % 3] - l[(k + 1) % 3])));
  }
  return c;
}

/// returns the width of the widest stored interval, relative to its upper bound.
template <class Triangulation>
double largest_interval_width(const Triangulation& t) {
  double largest = 0;
  const auto look_at = [&](const CGAL::Interval_nt<false>& x) {
    if (x.sup() > 0) largest = std::max(largest, (x.sup() - x.inf()) / x.sup());
  };
  for (const auto e : edges(t.mesh())) look_at(t.metric().squared_length(t.index(e)));
  for (const auto f : faces(t.mesh())) look_at(t.metric().quadruple_area(t.index(f)));
  return largest;
}

/// mixes a number into a hash (the finalizer of MurmurHash3)
inline std::uint64_t mixed(std::uint64_t hash, std::uint64_t x) {
  hash ^= x + 0x9e3779b97f4a7c15U;
  hash = (hash ^ (hash >> 33U)) * 0xff51afd7ed558ccdU;
  hash = (hash ^ (hash >> 33U)) * 0xc4ceb9fe1a85ec53U;
  return hash ^ (hash >> 33U);
}

/*!
\brief returns 16 hexadecimal digits that are equal for equal triangulations, and hardly else.

The hash of a face uses its vertices, the normal coordinates of its edges and the roundabouts of
their halfedges. Numbers of edges and faces depend on the flips before. So the smallest hash of the
sides of a face comes first, and hashes of faces are added.
*/
template <class Triangulation>
std::string fingerprint(const Triangulation& t) {
  const IT::Intrinsic_view<Triangulation> view(t);
  const auto& coordinates = t.correspondence();
  const auto hash_of_side = [&](std::uint32_t h) {
    const auto normal = static_cast<std::uint64_t>(coordinates.normal_coordinate(h / 2));
    const std::uint64_t key = mixed(mixed(view.source(h), coordinates.roundabout(h)), normal);
    return mixed(key, coordinates.roundabout(h ^ 1U));
  };
  std::uint64_t sum = 0;
  for (const auto f : faces(t.mesh())) {
    const std::uint32_t h = view.halfedge_of_face(t.index(f)), n = view.next(h);
    std::array<std::uint64_t, 3> sides{hash_of_side(h), hash_of_side(n),
                                       hash_of_side(view.next(n))};
    std::rotate(sides.begin(), std::min_element(sides.begin(), sides.end()), sides.end());
    sum += mixed(mixed(sides[0], sides[1]), sides[2]);
  }
  std::string digits(16, '0');
  for (std::size_t k = 0; k < 16; ++k) digits[15 - k] = "0123456789abcdef"[(sum >> (4 * k)) & 15U];
  return digits;
}

} // namespace program

#endif // INTRINSIC_STUDY_RESULTS_H

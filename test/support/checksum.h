// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_SUPPORT_CHECKSUM_H
#define TEST_SUPPORT_CHECKSUM_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

// What tells whether a triangulation has changed.
namespace checksums {

namespace IT = CGAL::Intrinsic_triangulations;

// where edges run on the input, by number
std::vector<std::uint32_t> coordinates(const auto& t) {
  std::vector<std::uint32_t> s;
  const IT::Integer_coordinates& c = *t.places();
  for (const auto e : edges(t.mesh())) {
    s.push_back(static_cast<std::uint32_t>(c.normal_coordinate(t.index(e))));
    s.push_back(c.roundabout(2 * t.index(e)));
    s.push_back(c.roundabout(2 * t.index(e) + 1));
  }
  return s;
}

/// A checksum of everything but caches and statistics, see FNV.
class Checksum {
public:
  void add(std::uint64_t x) { sum_ = (sum_ ^ x) * 0x100000001b3; }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const IT::Surface_point& p) {
    add(std::uint64_t{p.halfedge});
    for (const double w : p.weights) add(w);
  }
  std::uint64_t sum() const { return sum_; }

private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

void add_places(Checksum& s, const auto& t) {
  for (const std::uint32_t x : coordinates(t)) s.add(std::uint64_t{x});
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) s.add(t.places()->location(t.index(v)));
}

// what the model says of an edge
inline void add_edge(Checksum& s, const IT::Explicit_crossings& c, std::uint32_t e) {
  for (const std::uint32_t x : c.entered_on(e)) s.add(std::uint64_t{x});
}
// no more than has been added
inline void add_edge(Checksum&, const IT::Integer_coordinates&, std::uint32_t) {}
inline void add_edge(Checksum& s, const IT::Signposts& c, std::uint32_t e) {
  for (const std::uint32_t h : {2 * e, 2 * e + 1}) {
    s.add(c.angle(h));
    s.add(c.fan(h).angle);
  }
}
inline void add_edge(Checksum&, const IT::No_correspondence&, std::uint32_t) {}

std::uint64_t checksum(const auto& t) {
  using T = std::remove_cvref_t<decltype(t)>;
  const IT::Intrinsic_view view(t);
  Checksum s;
  if (t.places() != nullptr) add_places(s, t);
  for (const auto v : vertices(t.mesh())) s.add(std::uint64_t{t.input_vertex(v)});
  for (const auto h : halfedges(t.mesh())) {
    const std::uint32_t n = t.numbers().halfedge(h);
    for (const std::uint32_t x : {n, view.next(n), view.target(n), view.face(n)})
      s.add(std::uint64_t{x});
  }
  for (const auto e : edges(t.mesh())) add_edge(s, t.correspondence(), t.index(e));
  // exact traits have caches of values, which places define
  if constexpr (!T::Metric::is_exact) {
    for (const auto e : edges(t.mesh())) s.add(t.metric().squared_length(t.index(e)));
    for (const auto f : faces(t.mesh())) s.add(t.metric().quadruple_area(t.index(f)));
  }
  return s.sum();
}

} // namespace checksums

#endif // TEST_SUPPORT_CHECKSUM_H

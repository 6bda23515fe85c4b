// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_SUBDIVISION_ORACLE_H
#define TEST_INTRINSIC_TRIANGULATIONS_SUBDIVISION_ORACLE_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include "meshes.h"
#include "places.h"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The correct integer coordinates: from crossings in the plane, counted with rational numbers, and
// from properties on any surface.

namespace subdivision_oracle {

namespace IT = CGAL::Intrinsic_triangulations;
using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                          IT::Integer_coordinates>;
using Rounded = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>,
                                            IT::Integer_coordinates>;
inline constexpr std::uint32_t none = IT::Gluing::none;

inline IT::Intrinsic_input input(const meshes::Mesh& m,
                                 IT::Mollification mollification = IT::Mollification::none) {
  IT::Intrinsic_input i = m.input(mollification);
  i.may_renumber = false;
  return i;
}

// ---- any surface

namespace expected {

template <class T>
class Checker {
public:
  explicit Checker(const T& t) : t_(t), c_(t.correspondence()), view_(t) {}

  std::string check() {
    std::string error;
    for (const auto f : faces(t_.mesh())) {
      std::uint32_t h = view_.halfedge_of_face(t_.index(f));
      for (unsigned k = 0; k < 3; ++k, h = view_.next(h)) {
        check_side(h, error);
        check_corner(h, error);
      }
    }
    std::size_t expected = c_.input().number_of_halfedges();
    for (const auto v : vertices(t_.mesh())) expected += t_.is_inserted(v) && is_on_edge(v) ? 2 : 0;
    if (starts_.size() != expected)
      error += " " + std::to_string(starts_.size()) + " curves of " + std::to_string(expected);
    return error;
  }

private:
  void start(std::uint32_t slot, std::uint32_t h, std::string& error) {
    if (slot == none || !starts_.insert(slot).second)
      error += " curve starts twice or not at all at halfedge " + std::to_string(h);
  }
  template <class Vertex>
  bool is_on_edge(Vertex v) const {
    return c_.roundabout(view_.outgoing_halfedge(t_.index(v))) != none;
  }
  void check_side(std::uint32_t h, std::string& error) {
    if (c_.normal_coordinate(h / 2) >= 0) return;
    start(c_.roundabout(h), h, error);
    if (view_.is_border(h ^ 1U)) start(c_.roundabout(h ^ 1U), h ^ 1U, error);
    if (!error.empty()) return;
    if (c_.fans().halfedge(c_.roundabout(h)) != (c_.fans().halfedge(c_.roundabout(h ^ 1U)) ^ 1U))
      error += " ends disagree on edge " + std::to_string(h / 2);
  }
  void check_corner(std::uint32_t h, std::string& error) {
    const IT::Corner_coordinates c = IT::corner_coordinates(view_, c_, h);
    const std::uint32_t last = view_.next(view_.next(h));
    const auto n = [&](std::uint32_t x) { return IT::crossings(c_.normal_coordinate(x / 2)); };
    // each crossing of a side is by a curve about one of its ends, or from the corner opposite
    if (c.cutting[0] < 0 || n(h) != c.cutting[0] + c.cutting[1] + c.emanating[2] ||
        n(last) != c.cutting[2] + c.cutting[0] + c.emanating[1])
      error += " curves do not fit at halfedge " + std::to_string(h);
    if (c.emanating[0] > 0 && c_.roundabout(h) == none)
      error += " curve from a vertex without curves at halfedge " + std::to_string(h);
    if (!error.empty()) return;
    for (int i = 0; i < c.emanating[0]; ++i) {
      const IT::Curve_end from{h, i};
      start(c_.fans().advance(
                c_.roundabout(h),
                static_cast<std::uint32_t>(IT::parallels(c_.normal_coordinate(h / 2)) + i)),
            h, error);
      const IT::Curve_end to = IT::follow_curve(view_, c_, IT::first_crossing(view_, c_, from),
                                                [](const IT::Curve_crossing&) {});
      if (IT::input_halfedge(c_, to) != (IT::input_halfedge(c_, from) ^ 1U))
        error += " curve ends elsewhere, from halfedge " + std::to_string(h);
    }
  }

  const T& t_;
  const IT::Integer_coordinates& c_;
  IT::Intrinsic_view<T> view_;
  std::set<std::uint32_t> starts_;
};

} // namespace expected

/// Empty if every part of an input edge starts once from each of its ends and arrives at the other,
/// and the crossings of every face are those of curves that do not meet.
template <class T>
std::string defect(const T& t) {
  return expected::Checker<T>(t).check();
}

/// Normal coordinates and curves of all edges, by number.
template <class T>
std::vector<std::array<std::int64_t, 3>> state(const T& t) {
  std::vector<std::array<std::int64_t, 3>> s;
  for (const auto e : edges(t.mesh())) {
    const std::uint32_t i = t.index(e);
    s.push_back({t.correspondence().normal_coordinate(i), t.correspondence().roundabout(2 * i),
                 t.correspondence().roundabout(2 * i + 1)});
  }
  return s;
}

// ---- the plane

using Number = CGAL::Gmpq;
using Point = std::array<Number, 2>;

inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline int turn(const Point& u, const Point& v) { return CGAL::sign(u[0] * v[1] - u[1] * v[0]); }
inline int turn(const Point& a, const Point& b, const Point& c) { return turn(b - a, c - a); }
inline int along(const Point& u, const Point& v) { return CGAL::sign(u[0] * v[0] + u[1] * v[1]); }

/// Whether `c` is inside segment ab.
inline bool is_inside(const Point& a, const Point& b, const Point& c) {
  return turn(a, b, c) == 0 && along(a - c, b - c) < 0;
}

/// A triangulation of a planar mesh, and the exact positions of its vertices.
template <class T>
class Plane {
public:
  explicit Plane(const meshes::Mesh& m) : t(input(m)) {
    for (const meshes::Point& p : m.points) position.push_back({Number(p[0]), Number(p[1])});
  }

  T t;
  std::vector<Point> position; // by number of vertices

  IT::Intrinsic_view<T> view() const { return IT::Intrinsic_view<T>(t); }
  Point at(std::uint32_t h, const std::array<double, 3>& weights) const {
    const std::array<double, 3> w = *IT::representable_weights(weights);
    Point p{Number(0), Number(0)};
    for (const double x : w) {
      const Point& q = position[view().source(h)];
      for (std::size_t k = 0; k < 2; ++k) p[k] += Number(x) * q[k];
      h = view().next(h);
    }
    return p;
  }
  auto insert(std::uint32_t h, const std::array<double, 3>& weights) {
    const Point p = at(h, weights);
    const auto n = t.insert_vertex({h}, weights);
    set(n, p);
    return n;
  }
  /// The largest distance of a vertex from its requested position.
  double deviation = 0;
  auto reposition(IT::Gluing_map::Vertex v, std::uint32_t h, const std::array<double, 3>& weights) {
    const Point p = at(h, weights);
    const auto n = t.reposition_vertex(v, {h}, weights);
    set(n, p);
    return n;
  }

  /// How many input edges a segment crosses; -1 if it runs along one.
  IT::Normal_coordinate count(const Point& a, const Point& b) const {
    IT::Normal_coordinate n = 0;
    const IT::Input& s = t.correspondence().input();
    for (std::uint32_t x = 0; x < s.number_of_halfedges(); x += 2) {
      const Point &p = position[s.source(x)], &q = position[s.target(x)];
      const int pa = turn(p, q, a), pb = turn(p, q, b);
      const auto is_on = [&](const Point& c) { return c == p || c == q || is_inside(p, q, c); };
      if (pa == 0 && pb == 0 && is_on(a) && is_on(b)) return -1;
      n += pa * pb < 0 && turn(a, b, p) * turn(a, b, q) < 0 ? 1 : 0;
    }
    return n;
  }

  /// Empty if all normal coordinates and roundabouts equal the counts in the plane.
  std::string defect() const {
    std::string error;
    for (const auto e : edges(t.mesh())) {
      const std::uint32_t i = t.index(e);
      if (t.correspondence().normal_coordinate(i) != count(i))
        error += " edge " + std::to_string(i) + " is crossed " + std::to_string(count(i)) +
                 "x not " + std::to_string(t.correspondence().normal_coordinate(i));
      for (const std::uint32_t h : {2 * i, 2 * i + 1}) {
        const std::uint32_t slot = t.correspondence().roundabout(h);
        const std::uint32_t x = slot == none ? none : t.correspondence().fans().halfedge(slot);
        if (x != first_curve(h)) error += " roundabout of halfedge " + std::to_string(h);
      }
    }
    return error;
  }

private:
  template <class Insertion>
  void set(const Insertion& n, const Point& p) {
    if (n.status != IT::Move_status::done) return;
    const std::uint32_t v = t.index(n.vertex);
    if (v >= position.size()) position.resize(v + 1);
    const IT::Surface_point& place = t.correspondence().location(v);
    const bool is_place = places::is_exact(place);
    const IT::Input& s = t.correspondence().input();
    position[v] = places::combination(s, place.halfedge, place.weights, position);
    deviation = std::max(deviation, is_place ? places::distance(p, position[v]) : 1);
  }
  IT::Normal_coordinate count(std::uint32_t e) const {
    return count(position[view().source(2 * e)], position[view().target(2 * e)]);
  }
  // the first input halfedge counterclockwise from `h`, of those that start from its source or pass it
  std::uint32_t first_curve(std::uint32_t h) const {
    const Point &a = position[view().source(h)], d = position[view().target(h)] - a;
    const IT::Input& s = t.correspondence().input();
    std::uint32_t best = none;
    const auto half =
        [&](const Point& u) { // 0: along d or to its left, 1: against d or to its right
          const int side = turn(d, u);
          return side > 0 || (side == 0 && along(d, u) > 0) ? 0 : 1;
        };
    Point least;
    for (std::uint32_t x = 0; x < s.number_of_halfedges(); ++x) {
      const Point &p = position[s.source(x)], &q = position[s.target(x)];
      if (p != a && !is_inside(p, q, a)) continue;
      const Point u = q - p;
      if (best == none || half(u) < half(least) || (half(u) == half(least) && turn(u, least) > 0)) {
        best = x;
        least = u;
      }
    }
    return best;
  }
};

// ---- random moves

/// Makes random moves on `P`: a triangulation, or something that inserts and repositions itself.
template <class T>
class Mover {
public:
  using Vertex = typename T::vertex_descriptor;

  Mover(T& t, unsigned seed) : t_(t), random_(seed) {}

  double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }
  /// A halfedge with a face: by area, or any.
  std::uint32_t halfedge(bool by_area) {
    const IT::Intrinsic_view<T> view(t_);
    std::vector<double> sum{0};
    std::vector<std::uint32_t> first;
    for (const auto f : faces(t_.mesh())) {
      first.push_back(view.halfedge_of_face(t_.index(f)));
      sum.push_back(sum.back() + (by_area ? view.quadruple_area(t_.index(f)) : 1));
    }
    const double x = uniform() * sum.back();
    auto i = std::upper_bound(sum.begin(), sum.end(), x) - sum.begin() - 1;
    i = std::min(i, static_cast<std::ptrdiff_t>(first.size()) - 1);
    std::uint32_t h = first[static_cast<std::size_t>(i)];
    for (std::uint32_t k = below(3); k > 0; --k) h = view.next(h);
    return h;
  }
  /// Whether weights are multiples of 1/4: on regular meshes points make ties, and lie on input edges.
  bool is_simple = false;
  /// Weights inside, or on the first side.
  std::array<double, 3> weights(bool on_side) {
    if (is_simple) return on_side ? std::array{0.5, 0.5, 0.} : std::array{0.25, 0.25, 0.5};
    double a = uniform(), b = uniform();
    if (on_side) return {0.9 - 0.8 * a, 0.1 + 0.8 * a, 0};
    if (a + b > 1) a = 1 - a, b = 1 - b;
    return {1 - a - b, a, b};
  }

  /// One move of a random kind; inserted vertices are those to remove.
  template <class Insert, class Reposition>
  void move(bool by_area, Insert insert, Reposition reposition) {
    const unsigned kind = below(5);
    const std::uint32_t h = halfedge(by_area);
    if (kind < 2) {
      const auto n = insert(h, weights(kind == 1));
      if (n.status == IT::Move_status::done) inserted.push_back(n.vertex);
      count(0, n.status);
    } else if (kind == 2) {
      count(1, t_.flip_edge(t_.numbers().halfedge_at(h)));
    } else if (!inserted.empty()) {
      const std::uint32_t i = below(inserted.size());
      if (kind == 3) {
        const IT::Move_status s = t_.remove_vertex(inserted[i]);
        if (s == IT::Move_status::done) inserted.erase(inserted.begin() + i);
        count(2, s);
      } else {
        const auto n = reposition(inserted[i], h, weights(false));
        if (n.status == IT::Move_status::done) inserted[i] = n.vertex;
        count(3, n.status);
      }
    }
  }
  void move(bool by_area) {
    move(
        by_area,
        [&](std::uint32_t h, const auto& w) {
          return t_.insert_vertex(t_.numbers().halfedge_at(h), w);
        },
        [&](Vertex v, std::uint32_t h, const auto& w) {
          return t_.reposition_vertex(v, t_.numbers().halfedge_at(h), w);
        });
  }

  std::vector<Vertex> inserted;
  std::array<int, 10> statuses{}; // how often each `Move_status` came
  std::array<int, 4> done{};      // insertions, flips, removals, repositions
  int moves = 0;

private:
  void count(std::size_t kind, IT::Move_status s) {
    ++statuses[static_cast<std::size_t>(s)];
    done[kind] += s == IT::Move_status::done ? 1 : 0;
    ++moves;
  }

  T& t_;
  std::mt19937_64 random_;
};

} // namespace subdivision_oracle

#endif // TEST_INTRINSIC_TRIANGULATIONS_SUBDIVISION_ORACLE_H

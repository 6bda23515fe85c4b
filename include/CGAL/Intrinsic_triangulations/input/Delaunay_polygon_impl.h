// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DELAUNAY_POLYGON_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DELAUNAY_POLYGON_IMPL_H

#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Mpzf.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace polygon {

// Points with coordinates of a type, as they are seen along a normal n.
template <class FT>
class View {
public:
  using Vector = std::array<FT, 3>;

  explicit View(const std::array<double, 3>& normal) : normal_(vector(normal)) {}

  static Vector vector(const std::array<double, 3>& p) { return {FT(p[0]), FT(p[1]), FT(p[2])}; }
  static Vector difference(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  // <n, a x b>: the area of a parallelogram, times |n|
  FT area(const Vector& a, const Vector& b) const {
    return normal_[0] * (a[1] * b[2] - a[2] * b[1]) + normal_[1] * (a[2] * b[0] - a[0] * b[2]) +
           normal_[2] * (a[0] * b[1] - a[1] * b[0]);
  }
  // |n|^2 |a|^2 - <n, a>^2: the squared length, times |n|^2
  FT squared_length(const Vector& a) const {
    const FT height = dot(normal_, a);
    return dot(normal_, normal_) * dot(a, a) - height * height;
  }

private:
  static FT dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  Vector normal_;
};

// the sign of what a functor computes in any ring
template <class Compute>
Sign exact_sign(const Compute& compute) {
  {
    const Protect_FPU_rounding<true> upwards;
    const Uncertain<Sign> s = CGAL::sign(compute(Interval_nt<false>()));
    if (is_certain(s)) return get_certain(s);
  }
  return CGAL::sign(compute(Mpzf()));
}

} // namespace polygon

// Triangulates a polygon in space as it looks along a normal vector: ears are cut off, then diagonals are flipped until all are locally
// Delaunay. All signs are exact. `CGAL::Constrained_Delaunay_triangulation_2` does the same for thousands of sides, and takes as long
// to compile as a quarter of this package.
class Delaunay_polygon {
public:
  using Point = std::array<double, 3>;
  using Triangle = std::array<std::uint32_t, 3>;

  // The points must outlive this object.
  Delaunay_polygon(const std::vector<Point>& points, const Point& normal);

  // whether no two sides meet but at their common end
  bool is_simple() const;
  // Returns false if it turns clockwise around the normal. \pre `is_simple()`
  bool triangulate(std::vector<Triangle>& result);

private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  // of the area of a triangle
  Sign orientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const;
  // of side ij, between triangles ijk and jim
  bool is_locally_delaunay(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                           std::uint32_t m) const;

  std::uint32_t next(std::uint32_t i) const { return i + 1 < points_.size() ? i + 1 : 0; }
  // whether two sides that have no end in common are certainly apart, by doubles
  bool are_apart(std::uint32_t i, std::uint32_t j) const;
  bool meet(std::uint32_t i, std::uint32_t j) const;

  bool contains(const Triangle& t, std::uint32_t p) const;
  bool is_ear(const std::vector<std::uint32_t>& corners, std::size_t k) const;
  bool cut_ears();
  void add(std::uint32_t i, std::uint32_t j, std::uint32_t k);
  void flip_diagonals();

  const std::vector<Point>& points_;
  Point normal_;
  std::vector<std::array<double, 2>> plane_; // where points are seen, about
  std::map<Side, std::uint32_t> apex_;       // of the triangle on the left of each side
};

inline Delaunay_polygon::Delaunay_polygon(const std::vector<Point>& points, const Point& normal)
    : points_(points), normal_(normal) {
  // dropping the largest component of the normal keeps the order of points along lines
  const auto size = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto drop = static_cast<std::size_t>(
      std::max_element(normal_.begin(), normal_.end(), size) - normal_.begin());
  const std::size_t x = (drop + 1) % 3, y = (drop + 2) % 3;
  for (const Point& p : points_) {
    const double t = p[drop] / normal_[drop]; // moved along the normal to the plane of the others
    plane_.push_back({p[x] - t * normal_[x], p[y] - t * normal_[y]});
  }
}

inline Sign Delaunay_polygon::orientation(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
  return polygon::exact_sign([&]<class FT>(FT) {
    using View = polygon::View<FT>;
    const auto p = View::vector(points_[i]);
    return View(normal_).area(View::difference(View::vector(points_[j]), p),
                              View::difference(View::vector(points_[k]), p));
  });
}

inline bool Delaunay_polygon::is_locally_delaunay(std::uint32_t i, std::uint32_t j, std::uint32_t k,
                                                  std::uint32_t m) const {
  return polygon::exact_sign([&]<class FT>(FT) {
           using View = polygon::View<FT>;
           const View view(normal_);
           const auto side = [this](std::uint32_t a, std::uint32_t b) {
             return View::difference(View::vector(points_[b]), View::vector(points_[a]));
           };
           const auto ij = side(i, j), ki = side(k, i), mj = side(m, j);
           return Delaunay_expression()(
               Diamond_values<FT>{view.squared_length(ij), view.squared_length(side(j, k)),
                                  view.squared_length(ki), view.squared_length(side(i, m)),
                                  view.squared_length(mj), view.area(ki, ij), view.area(ij, mj)});
         }) != NEGATIVE;
}

inline bool Delaunay_polygon::are_apart(std::uint32_t i, std::uint32_t j) const {
  // coordinates are of unit size, and known to much less than that
  constexpr double margin = 1e-9;
  for (std::size_t x = 0; x < 2; ++x) {
    const auto [a, b] = std::minmax(plane_[i][x], plane_[next(i)][x]);
    const auto [c, d] = std::minmax(plane_[j][x], plane_[next(j)][x]);
    if (b + margin < c || d + margin < a) return true;
  }
  return false;
}

// Signs tell; four points of a line are apart if their sides are one after the other.
inline bool Delaunay_polygon::meet(std::uint32_t i, std::uint32_t j) const {
  if (are_apart(i, j)) return false;
  const std::uint32_t k = next(i), l = next(j);
  const Sign a = orientation(i, k, j), b = orientation(i, k, l), c = orientation(j, l, i),
             d = orientation(j, l, k);
  if (a != ZERO || b != ZERO || c != ZERO || d != ZERO) return a != b && c != d;
  const auto is_beyond = [this](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    return polygon::exact_sign([&]<class FT>(FT) { // of <q - p, r - q>, as it is seen
             using View = polygon::View<FT>;
             const View view(normal_);
             const auto u = View::vector(points_[p]), v = View::vector(points_[q]),
                        w = View::vector(points_[r]);
             return view.squared_length(View::difference(w, u)) -
                    view.squared_length(View::difference(v, u)) -
                    view.squared_length(View::difference(w, v));
           }) == POSITIVE;
  };
  const bool beyond_k = is_beyond(i, k, j) && is_beyond(i, k, l),
             beyond_i = is_beyond(k, i, j) && is_beyond(k, i, l);
  return !beyond_k && !beyond_i;
}

inline bool Delaunay_polygon::is_simple() const {
  const auto n = static_cast<std::uint32_t>(points_.size());
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = i + 2; j < n; ++j)
      if (next(j) != i && meet(i, j)) return false;
  return true;
}

// also on its border
inline bool Delaunay_polygon::contains(const Triangle& t, std::uint32_t p) const {
  constexpr double margin = 1e-9; // see above
  for (std::size_t x = 0; x < 2; ++x) {
    const double a = plane_[t[0]][x], b = plane_[t[1]][x], c = plane_[t[2]][x], q = plane_[p][x];
    if (q + margin < std::min({a, b, c}) || q > std::max({a, b, c}) + margin) return false;
  }
  return orientation(t[0], t[1], p) != NEGATIVE && orientation(t[1], t[2], p) != NEGATIVE &&
         orientation(t[2], t[0], p) != NEGATIVE;
}

inline bool Delaunay_polygon::is_ear(const std::vector<std::uint32_t>& corners,
                                     std::size_t k) const {
  const std::size_t n = corners.size();
  const Triangle t{corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]};
  if (orientation(t[0], t[1], t[2]) != POSITIVE) return false;
  return std::none_of(corners.begin(), corners.end(), [&](std::uint32_t p) {
    return std::find(t.begin(), t.end(), p) == t.end() && contains(t, p);
  });
}

inline void Delaunay_polygon::add(std::uint32_t i, std::uint32_t j, std::uint32_t k) {
  apex_[{i, j}] = k;
  apex_[{j, k}] = i;
  apex_[{k, i}] = j;
}

// What is left is simple again, and has an area: no corner lies on the side that is new. So there is an ear, unless the polygon turns
// clockwise.
inline bool Delaunay_polygon::cut_ears() {
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < points_.size(); ++i) corners.push_back(i);
  std::size_t tried = 0;
  for (std::size_t k = 0; corners.size() > 3; ++k) {
    const std::size_t n = corners.size();
    k %= n;
    if (tried++ > n) return false;
    if (!is_ear(corners, k)) continue;
    tried = 0;
    add(corners[(k + n - 1) % n], corners[k], corners[(k + 1) % n]);
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(k));
  }
  add(corners[0], corners[1], corners[2]);
  return orientation(corners[0], corners[1], corners[2]) == POSITIVE;
}

inline void Delaunay_polygon::flip_diagonals() {
  std::vector<Side> open;
  for (const auto& [s, apex] : apex_)
    if (s.first < s.second) open.push_back(s);
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    const auto left = apex_.find({i, j}), right = apex_.find({j, i});
    if (left == apex_.end() || right == apex_.end()) continue; // of the polygon, or flipped
    const std::uint32_t k = left->second, m = right->second;
    if (is_locally_delaunay(i, j, k, m)) continue;
    apex_.erase(left);
    apex_.erase(right);
    add(k, m, j);
    add(m, k, i);
    for (const Side& s : {Side(j, k), Side(k, i), Side(i, m), Side(m, j)}) open.push_back(s);
  }
}

inline bool Delaunay_polygon::triangulate(std::vector<Triangle>& result) {
  if (!cut_ears()) return false;
  flip_diagonals();
  result.clear();
  for (const auto& [side, apex] : apex_)
    if (side.first < side.second && side.first < apex)
      result.push_back({side.first, side.second, apex});
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DELAUNAY_POLYGON_IMPL_H

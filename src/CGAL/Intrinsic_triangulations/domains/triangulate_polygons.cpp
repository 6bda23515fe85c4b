// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/triangulate_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_shaper.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The planar polygons of a soup, while they may still be discarded.
class Planar_candidates {
public:
  using Point = Planar_polygons::Point;

  // what polygon i has become
  void set(std::size_t i, const Polygons& polygons, const Polygon_shaper& shaper) {
    reports_.resize(polygons.size());
    reports_[i] = {};
    shaper.count(reports_[i]);
    if (!shaper.is_flattened()) return;
    points_.resize(polygons.corners.size());
    std::copy(shaper.planar_points().begin(), shaper.planar_points().end(),
              points_.begin() + polygons.first_corner[i]);
  }
  bool is_flattened(std::size_t i) const { return reports_[i].flattened != 0; }
  bool has_any() const { return !points_.empty(); }
  void keep(std::size_t i) { reports_[i] = {0, 0, 1, 0}; }

  Planar_polygons finish(const Polygons& polygons) const {
    Planar_polygons result;
    for (std::size_t i = 0; i < reports_.size(); ++i) {
      const Polygon_report& r = reports_[i];
      result.report.planar += r.planar;
      result.report.flattened += r.flattened;
      result.report.kept += r.kept;
      result.report.largest_angle_change =
          std::max(result.report.largest_angle_change, r.largest_angle_change);
      if (is_flattened(i))
        result.add(polygons.face[i],
                   {&polygons.corners[polygons.first_corner[i]], polygons.sides(i)},
                   {&points_[polygons.first_corner[i]], polygons.sides(i)});
    }
    return result;
  }

private:
  std::vector<Polygon_report> reports_; // of each polygon alone
  std::vector<Point> points_;           // as `Polygons::corners`
};

// Triangulates the polygons of a soup such that no diagonal joins two vertices that another edge
// joins already, where that is possible: edges are later matched by their end vertices.
class Soup_triangulator {
public:
  Soup_triangulator(const Polygons& polygons, Nonplanar_polygons kind, Triangle_soup& soup,
                    const Polygon_failure& fail)
      : polygons_(polygons), soup_(soup), fail_(fail), shaper_(kind) {}

  void run() {
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      load(i);
      if (!shaper_.triangulate(triangles_))
        fail(i, "cannot be triangulated; divide it into triangles in the file");
      write(i);
      for_each_diagonal(i, [&](std::uint32_t u, std::uint32_t v) {
        diagonals_.push_back({u, v, static_cast<std::uint32_t>(i)});
      });
    }
    sort_diagonals();
    if (find_conflicts() && !resolve_conflicts()) keep_those_in_conflict();
    soup_.planar_polygons = planar_.finish(polygons_);
  }

private:
  struct Diagonal {
    std::uint32_t lower, upper, polygon;
    bool operator<(const Diagonal& other) const {
      return std::tie(lower, upper, polygon) < std::tie(other.lower, other.upper, other.polygon);
    }
  };

  void fail(std::size_t i, const std::string& what) const {
    fail_(polygons_.face[i], "face " + std::to_string(polygons_.face[i]) + " with " +
                                 std::to_string(polygons_.sides(i)) + " sides " + what);
  }

  void load(std::size_t i) {
    std::vector<std::array<double, 3>> polygon;
    for (std::size_t k = 0; k < polygons_.sides(i); ++k)
      polygon.push_back(soup_.points[polygons_.corner(i, k)]);
    shaper_.load(std::move(polygon));
  }

  void write(std::size_t i) {
    planar_.set(i, polygons_, shaper_);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (unsigned k = 0; k < 3; ++k)
        soup_.triangles[polygons_.first_triangle[i] + t][k] = polygons_.corner(i, triangles_[t][k]);
  }

  // Reads back what was written.
  void triangles_of(std::size_t i) {
    triangles_.resize(polygons_.sides(i) - 2);
    const auto begin = polygons_.corners.begin() + polygons_.first_corner[i];
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t v = soup_.triangles[polygons_.first_triangle[i] + t][k];
        triangles_[t][k] = static_cast<std::uint32_t>(
            std::find(begin, begin + static_cast<std::ptrdiff_t>(polygons_.sides(i)), v) - begin);
      }
  }

  // Calls f(u, v) for each diagonal of polygon i, as just triangulated, with u < v.
  template <class Function>
  void for_each_diagonal(std::size_t i, Function f) const {
    const auto n = static_cast<std::uint32_t>(polygons_.sides(i));
    for (const auto& triangle : triangles_)
      for (unsigned k = 0; k < 3; ++k) {
        const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];
        const std::uint32_t apart = a < b ? b - a : a - b;
        if (a > b || apart == 1 || apart == n - 1) continue; // each diagonal has two directions
        const std::uint32_t u = polygons_.corner(i, a), v = polygons_.corner(i, b);
        f(std::min(u, v), std::max(u, v));
      }
  }

  void sort_diagonals() {
    std::sort(diagonals_.begin(), diagonals_.end());
    first_diagonal_.assign(soup_.points.size() + 1, 0);
    for (const Diagonal& d : diagonals_) ++first_diagonal_[d.lower + 1];
    for (std::size_t v = 1; v < first_diagonal_.size(); ++v)
      first_diagonal_[v] += first_diagonal_[v - 1];
  }

  // Calls f(u, v) for the sides of all faces of the input, with u < v.
  template <class Function>
  void for_each_side(Function f) const {
    const auto side = [&f](std::uint32_t u, std::uint32_t v) { f(std::min(u, v), std::max(u, v)); };
    std::size_t t = 0;
    for (std::size_t i = 0; i <= polygons_.size(); ++i) {
      const std::size_t end =
          i < polygons_.size() ? polygons_.first_triangle[i] : soup_.triangles.size();
      for (; t < end; ++t)
        for (unsigned k = 0; k < 3; ++k)
          side(soup_.triangles[t][k], soup_.triangles[t][(k + 1) % 3]);
      if (i == polygons_.size()) break;
      const std::size_t n = polygons_.sides(i);
      for (std::size_t k = 0; k < n; ++k)
        side(polygons_.corner(i, k), polygons_.corner(i, (k + 1) % n));
      t += n - 2;
    }
  }

  // Marks the polygons that conflict with a side of a face or with an earlier polygon.
  bool find_conflicts() {
    in_conflict_.assign(polygons_.size(), 0);
    bool any = false;
    const auto mark = [&](std::uint32_t i) {
      in_conflict_[i] = 1;
      any = true;
    };
    for (std::size_t d = 1; d < diagonals_.size(); ++d)
      if (diagonals_[d].lower == diagonals_[d - 1].lower &&
          diagonals_[d].upper == diagonals_[d - 1].upper)
        mark(diagonals_[d].polygon);
    for_each_side([&](std::uint32_t u, std::uint32_t v) {
      const auto first = diagonals_.begin() + first_diagonal_[u];
      const auto last = diagonals_.begin() + first_diagonal_[u + 1];
      for (auto d = std::lower_bound(first, last, Diagonal{u, v, 0}); d != last && d->upper == v;
           ++d)
        mark(d->polygon);
    });
    return any;
  }

  static std::uint64_t key(std::uint32_t u, std::uint32_t v) {
    return std::uint64_t(std::min(u, v)) << 32 | std::max(u, v);
  }

  // Returns false if some have no other triangulation.
  bool resolve_conflicts() {
    std::unordered_set<std::uint64_t> taken;
    for_each_side([&](std::uint32_t u, std::uint32_t v) { taken.insert(key(u, v)); });
    for (const Diagonal& d : diagonals_)
      if (!in_conflict_[d.polygon]) taken.insert(key(d.lower, d.upper));
    bool all = true;
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      if (!in_conflict_[i]) continue;
      load(i);
      if (!planar_.is_flattened(i)) shaper_.keep();
      const auto is_free = [&](std::size_t j, std::size_t k) {
        return taken.count(key(polygons_.corner(i, j), polygons_.corner(i, k))) == 0;
      };
      bool is_found = shaper_.triangulate_with(is_free, triangles_);
      if (!is_found && shaper_.is_flattened()) { // in space other diagonals may be inside
        shaper_.keep();
        is_found = shaper_.triangulate_with(is_free, triangles_);
      }
      if (!is_found) {
        all = false;
        continue;
      }
      write(i);
      for_each_diagonal(i, [&](std::uint32_t u, std::uint32_t v) { taken.insert(key(u, v)); });
    }
    return all;
  }

  // An edge has one length: the diagonal of a planar polygon cannot be an edge of another face.
  void keep_those_in_conflict() {
    if (!planar_.has_any()) return;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> sides; // and their faces
    for (std::size_t t = 0; t < soup_.triangles.size(); ++t)
      for (std::size_t k = 0; k < 3; ++k)
        sides.emplace_back(key(soup_.triangles[t][k], soup_.triangles[t][(k + 1) % 3]),
                           soup_.polygon_of_triangle[t]);
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      if (!planar_.is_flattened(i)) continue;
      triangles_of(i);
      for_each_diagonal(i, [&](std::uint32_t u, std::uint32_t v) {
        const auto [first, last] =
            std::equal_range(sides.begin(), sides.end(), std::pair(key(u, v), std::uint32_t{0}),
                             [](const auto& a, const auto& b) { return a.first < b.first; });
        for (auto s = first; s != last; ++s)
          if (s->second != polygons_.face[i]) planar_.keep(i);
      });
    }
  }

  const Polygons& polygons_;
  Triangle_soup& soup_;
  const Polygon_failure& fail_;
  Polygon_shaper shaper_;
  Planar_candidates planar_;
  std::vector<Polygon_shaper::Triangle> triangles_;
  std::vector<Diagonal> diagonals_;
  std::vector<std::uint32_t> first_diagonal_;
  std::vector<char> in_conflict_;
};

void triangulate_polygons(const Polygons& polygons, Nonplanar_polygons kind, Triangle_soup& soup,
                          const Polygon_failure& fail) {
  if (polygons.size() != 0) Soup_triangulator(polygons, kind, soup, fail).run();
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

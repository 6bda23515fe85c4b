// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_SUBDIVIDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_SUBDIVIDER_H

#include <CGAL/Intrinsic_triangulations/geodesics/bezier/Bezier_curve.h>
#include <CGAL/Intrinsic_triangulations/geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_triangulations/geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Subdivides the control polygon of a curve by geodesics (§5.3 of the course; Morera et al. 2008): a round makes two polygons of
// each, which share its point at 1/2, by de Casteljau's triangle of midpoints. The next line from a midpoint to the one after
// it is not sought anew: it is the way along the two halves, through the control point between them, made geodesic. So
// it changes continuously with the control points, which a shortest path does not.
template <class Triangulation>
class Bezier_subdivider {
  using Mesh = typename Triangulation::Mesh;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Way = std::vector<Halfedge>;
  using Midpoint = Geodesic_midpoint<Triangulation>;

  // the side of a control polygon; it may have no edges
  struct Side {
    Vertex from, to;
    Way way;
  };
  // the sides, by number, that are done on both ends, and those in between
  struct Polygon {
    std::vector<std::size_t> left, inner;
    std::deque<std::size_t> right;
  };

public:
  explicit Bezier_subdivider(Triangulation& t) : t_(t), network_(t) {}

  void add_side(Vertex from, Vertex to, Way way) { sides_.push_back({from, to, std::move(way)}); }

  // makes all sides geodesic
  template <class NP>
  Status shorten(const NP& np, Shortening_result& counts) {
    network_.clear();
    for (const Side& s : sides_)
      if (!s.way.empty()) network_.add_path(s.way);
    const Shortening_result r = shorten_curves(network_, np);
    counts += r;
    std::uint32_t curve = 0;
    for (Side& s : sides_)
      if (!s.way.empty()) s.way = network_.halfedges(curve++);
    network_.clear();
    return r.status;
  }

  // makes two polygons of each one that has `degree` sides
  template <class NP>
  Status subdivide(std::size_t degree, const NP& np, Bezier_curve<Triangulation>& curve) {
    std::vector<Polygon> polygons(sides_.size() / degree);
    for (std::size_t i = 0; i < sides_.size(); ++i) polygons[i / degree].inner.push_back(i);
    for (std::size_t level = degree; level > 0; --level) {
      for (Polygon& p : polygons)
        if (!bisect(p, curve.midpoints)) return Status::stalled;
      drop_unused(polygons);
      if (level == 1) break;
      const Status s = shorten(np, curve.shortening);
      if (s != Status::done) return s;
    }
    return Status::done;
  }

  // tells the curve what it is
  void describe(Bezier_curve<Triangulation>& curve) const {
    curve.control_points.assign(1, sides_.front().from);
    curve.halfedges.clear();
    curve.length = 0;
    for (const Side& s : sides_) {
      curve.control_points.push_back(s.to);
      curve.halfedges.insert(curve.halfedges.end(), s.way.begin(), s.way.end());
      curve.length += length(s.way);
    }
  }

private:
  double length(Halfedge h) const { return t_.length(edge(h, t_.mesh())); }
  double length(const Way& way) const {
    double sum = 0;
    for (const Halfedge h : way) sum += length(h);
    return sum;
  }

  // one level of the triangle of midpoints
  bool bisect(Polygon& p, std::vector<Midpoint>& midpoints) {
    std::vector<std::size_t> halves;
    for (const std::size_t i : p.inner) {
      const Midpoint m = split(i);
      if (m.parameter < 0) return false;
      midpoints.push_back(m);
      halves.push_back(i);
      halves.push_back(sides_.size() - 1);
    }
    p.inner.clear();
    p.left.push_back(halves.front());
    p.right.push_front(halves.back());
    for (std::size_t k = 1; k + 1 < halves.size(); k += 2) {
      Side& first = sides_[halves[k]];
      Side& second = sides_[halves[k + 1]];
      first.way.insert(first.way.end(), second.way.begin(), second.way.end());
      first.to = second.to;
      remove_returns(first.way);
      p.inner.push_back(halves[k]);
    }
    return true;
  }

  // a way that goes back along itself has no edges, and is no curve
  void remove_returns(Way& way) const {
    Way kept;
    for (const Halfedge h : way)
      if (!kept.empty() && kept.back() == opposite(h, t_.mesh()))
        kept.pop_back();
      else
        kept.push_back(h);
    way = std::move(kept);
  }

  // keeps the sides that polygons have, in order
  void drop_unused(std::vector<Polygon>& polygons) {
    std::vector<Side> kept;
    const auto keep = [&](auto& numbers) {
      for (std::size_t& i : numbers) {
        kept.push_back(std::move(sides_[i]));
        i = kept.size() - 1;
      }
    };
    for (Polygon& p : polygons) {
      keep(p.left);
      keep(p.inner);
      keep(p.right);
    }
    sides_ = std::move(kept);
  }

  // Splits a side where half of its length is; the second half is a new side. A negative parameter: it cannot be split.
  Midpoint split(std::size_t i) {
    const double half = length(sides_[i].way) / 2;
    double before = 0;
    std::size_t k = 0;
    for (const Way& way = sides_[i].way; k < way.size(); ++k) {
      const double l = length(way[k]);
      if (before + l >= half) {
        const double x = (half - before) / l;
        if (x > 0 && x < 1) return split_at_edge(i, k, x);
        if (x >= 1) ++k;
        break;
      }
      before += l;
    }
    const Way& way = sides_[i].way;
    const Vertex m = k < way.size() ? source(way[k], t_.mesh()) : sides_[i].to;
    split_before(i, k, m);
    return {m, 0, false};
  }
  void split_before(std::size_t i, std::size_t k, Vertex m) {
    const auto at = sides_[i].way.begin() + static_cast<std::ptrdiff_t>(k);
    Side second{m, sides_[i].to, Way(at, sides_[i].way.end())};
    sides_[i].way.erase(at, sides_[i].way.end());
    sides_[i].to = m;
    sides_.push_back(std::move(second));
  }
  // A point that is rounded off its edge may be beyond a vertex close by: then the other face is tried. Where
  // faces are so thin that both fail, those at the edge are made Delaunay first, which leaves them thin only where a vertex is, and
  // places near it are tried.
  Midpoint split_at_edge(std::size_t i, std::size_t k, double x) {
    Midpoint m = try_split_at_edge(i, k, x);
    if (m.parameter >= 0) return m;
    flip_other_edges_to_delaunay();
    for (const double nudge :
         {0., 0x1p-44, -0x1p-44, 0x1p-32, -0x1p-32, 0x1p-20, -0x1p-20, 0x1p-10, -0x1p-10})
      if (m.parameter < 0) m = try_split_at_edge(i, k, x * (1 + nudge));
    return m;
  }
  void flip_other_edges_to_delaunay() {
    std::vector<char> is_on_side(t_.numbers().edge_capacity(t_.mesh()), 0);
    for (const Side& s : sides_)
      for (const Halfedge h : s.way) is_on_side[t_.index(edge(h, t_.mesh()))] = 1;
    const auto is_constrained = [&](typename Triangulation::edge_descriptor e) {
      return is_on_side[t_.index(e)] != 0;
    };
    flip_to_delaunay(t_,
                     parameters::edge_is_constrained_map(
                         boost::make_function_property_map<typename Triangulation::edge_descriptor>(
                             is_constrained)));
  }
  Midpoint try_split_at_edge(std::size_t i, std::size_t k, double x) {
    const Halfedge h = sides_[i].way[k], back = opposite(h, t_.mesh());
    for (const Halfedge g : {h, back}) {
      const auto inserted = t_.split_edge(g, g == h ? x : 1 - x);
      if (inserted.status != Move_status::done) continue;
      const std::size_t place = replace(g, halves_of(g, inserted.vertex), i, k);
      const double before = length(sides_[i].way[place]), after = length(sides_[i].way[place + 1]);
      split_before(i, place + 1, inserted.vertex);
      return {inserted.vertex, before / (before + after), true};
    }
    return {sides_[i].from, -1, false};
  }

  // The halves of an edge that was split at p: its halfedge h = ij has become ip on the border, else it leads to p, or from it,
  // from or to the corner that was on its right.
  std::pair<Halfedge, Halfedge> halves_of(Halfedge h, Vertex p) const {
    const auto& mesh = t_.mesh();
    const auto null = boost::graph_traits<Mesh>::null_face();
    const Halfedge g = opposite(h, mesh);
    if (face(g, mesh) == null) return {h, next(opposite(next(h, mesh), mesh), mesh)};
    if (face(h, mesh) == null)
      return {opposite(next(opposite(next(g, mesh), mesh), mesh), mesh), h};
    const Halfedge to_p = target(h, mesh) == p ? h : g, from_p = opposite(to_p, mesh);
    return {opposite(next(to_p, mesh), mesh), opposite(next(next(from_p, mesh), mesh), mesh)};
  }

  // puts the halves of an edge in its place, in all ways; returns the place of the first half of halfedge k of way i
  std::size_t replace(Halfedge h, const std::pair<Halfedge, Halfedge>& halves, std::size_t i,
                      std::size_t k) {
    const auto& mesh = t_.mesh();
    const Halfedge back = opposite(h, mesh);
    std::size_t place = k;
    for (std::size_t s = 0; s < sides_.size(); ++s) {
      Way way;
      for (std::size_t n = 0; n < sides_[s].way.size(); ++n) {
        const Halfedge x = sides_[s].way[n];
        if (s == i && n == k) place = way.size();
        if (x == h) {
          way.push_back(halves.first);
          way.push_back(halves.second);
        } else if (x == back) {
          way.push_back(opposite(halves.second, mesh));
          way.push_back(opposite(halves.first, mesh));
        } else {
          way.push_back(x);
        }
      }
      sides_[s].way = std::move(way);
    }
    return place;
  }

  Triangulation& t_;
  Curve_network<Triangulation> network_;
  std::vector<Side> sides_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_BEZIER_BEZIER_SUBDIVIDER_H

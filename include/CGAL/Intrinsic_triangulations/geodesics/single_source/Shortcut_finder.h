// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_SHORTCUT_FINDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_SHORTCUT_FINDER_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The edges that a segment between two vertices crosses, in order: the halfedges on the side of the first of them; and whether two that follow
// each other share the end on the left.
class Crossed_edges {
public:
  std::vector<std::uint32_t> halfedges;
  std::vector<char> shares_left; // one fewer

  // Takes note of the flip of edge i. \return whether it is not crossed any more
  bool flip(std::size_t i) {
    const bool is_at_end = i == 0 || i + 1 == halfedges.size();
    if (!is_at_end && shares_left[i - 1] != shares_left[i]) {
      std::swap(shares_left[i - 1], shares_left[i]);
      return false;
    }
    halfedges.erase(halfedges.begin() + static_cast<std::ptrdiff_t>(i));
    if (!shares_left.empty())
      shares_left.erase(shares_left.begin() + static_cast<std::ptrdiff_t>(i == 0 ? 0 : i - 1));
    return true;
  }
};

// Looks for straight ways from a vertex to others that are shorter than what is known: windows are followed through faces, in doubles,
// until a way by a vertex at their edge is shorter to all that is behind (Xin and Wang 2009). Where most edges are parts of shortest
// paths, as in a geodesic tree, that is after a face or two.
// \tparam Known tells `distance(v)` of vertices by number, and `is_barrier(h)` of halfedges: ways across those are not looked at
template <class Triangulation, class Known>
class Shortcut_finder {
  using Mesh = typename Triangulation::Mesh;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Vector = std::array<double, 2>;

public:
  Shortcut_finder(const Triangulation& t, const Known& known) : t_(t), known_(known) {
    windows_.reserve(most_windows);
  }

  // Looks at the vertices to which a path goes straight on from v.
  // \param in the last halfedge of the path to v, which may be bent only beyond pi; a null halfedge if it begins there
  // \param gain how much nearer a vertex must be, relatively
  // \return whether there is one; then `crossed()` are the edges on the way to it
  bool find(Vertex v, Halfedge in, double gain) {
    find_faces(v, in);
    for (const Halfedge h : faces_)
      if (find(h, gain)) return true;
    return false;
  }

  Crossed_edges crossed() const {
    Crossed_edges result;
    for (std::size_t i = found_;; i = windows_[i].before) {
      result.halfedges.push_back(t_.numbers().halfedge(windows_[i].halfedge));
      if (i == 0) break;
      result.shares_left.push_back(windows_[i].shares_left ? 1 : 0);
    }
    std::reverse(result.halfedges.begin(), result.halfedges.end());
    std::reverse(result.shares_left.begin(), result.shares_left.end());
    return result;
  }

private:
  // An end of what is seen: where that is, and whether it is the end of the edge.
  struct End {
    Vector point;
    bool is_vertex;
  };
  // What is seen of an edge, with the vertex at the origin: between directions `right` and `left`. The halfedge is on the near side, from
  // a to b.
  struct Window {
    Halfedge halfedge;
    Vector a, b;
    End right, left;
    std::size_t before; // the window that it is seen through
    bool shares_left;   // with that one
  };

  static constexpr std::size_t most_windows = 1000;

  // The halfedges from v with a face on the left into which a path can go straight on: the angles between its far side and the last
  // halfedge are beyond pi, on both sides, or the border is there.
  void find_faces(Vertex v, Halfedge in) {
    const auto& mesh = t_.mesh();
    faces_.clear();
    if (in == boost::graph_traits<Mesh>::null_halfedge()) {
      for_each_outgoing(v, mesh, [&](Halfedge h) {
        if (has_face(h)) faces_.push_back(h);
      });
      return;
    }
    Angle_sum left, right;
    Halfedge h = opposite(in, mesh);
    do {
      if (!has_face(h)) break;
      if (is_beyond_pi(left, h)) faces_.push_back(h);
      h = opposite(next(next(h, mesh), mesh), mesh); // counterclockwise
    } while (h != opposite(in, mesh));
    const bool is_closed = has_face(h);
    for (h = in; has_face(h) && !(is_closed && faces_.empty()); h = opposite(h, mesh)) {
      h = next(h, mesh); // clockwise
      const bool is_beyond = is_beyond_pi(right, h);
      if (is_closed && is_beyond) return;
      if (is_closed) faces_.pop_back();
      if (!is_closed && is_beyond) faces_.push_back(h);
    }
  }
  bool has_face(Halfedge h) const {
    return face(h, t_.mesh()) != boost::graph_traits<Mesh>::null_face();
  }
  // adds the angle at the source of h
  bool is_beyond_pi(Angle_sum& sum, Halfedge h) const {
    sum.add(approximate_values(t_.metric(), indexed_face_from(t_, h)));
    return sum.is_beyond_pi();
  }

  // Looks at the vertices that are seen from the source of `h` through the face on the left of `h`.
  bool find(Halfedge h, double gain) {
    const auto& mesh = t_.mesh();
    apex_distance_ = known_.distance(t_.index(source(h, mesh)));
    const Halfedge far = next(h, mesh), back = next(far, mesh);
    const Vector a{std::sqrt(squared_length(h)), 0};
    const double x = (squared_length(h) + squared_length(back) - squared_length(far)) / (2 * a[0]);
    const Vector b{x, quadruple_area(h) / (2 * a[0])};
    windows_.clear();
    push(far, a, b, {a, true}, {b, true}, 0);
    for (std::size_t i = 0; i < windows_.size(); ++i)
      if (look_through(i, gain)) return true;
    return false;
  }

  double squared_length(Halfedge h) const {
    return t_.metric().approximate_squared_length(t_.numbers().halfedge(h) / 2);
  }
  double quadruple_area(Halfedge h) const {
    return t_.metric().approximate_quadruple_area(t_.numbers().face(face(h, t_.mesh())));
  }
  static double cross(const Vector& a, const Vector& b) { return a[0] * b[1] - a[1] * b[0]; }
  static double distance(const Vector& a, const Vector& b) {
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]));
  }
  static double norm(const Vector& a) { return distance(a, {0, 0}); }
  // where a ray from the origin meets the line through a and b
  static Vector meet(const Vector& ray, const Vector& a, const Vector& b) {
    const Vector ab{b[0] - a[0], b[1] - a[1]};
    const double s = cross(a, ab) / cross(ray, ab);
    return {s * ray[0], s * ray[1]};
  }

  // Where the ray to an end of a window meets another edge, from a to b; the end of that edge on its side is a.
  static End moved(const End& end, const Vector& a, const Vector& b) {
    return end.is_vertex ? end : End{meet(end.point, a, b), false};
  }
  void push(Halfedge h, const Vector& a, const Vector& b, const End& right, const End& left,
            std::size_t before, bool shares_left = false) {
    const auto& mesh = t_.mesh();
    if (windows_.size() == most_windows || known_.is_barrier(t_.numbers().halfedge(h)) ||
        face(opposite(h, mesh), mesh) == boost::graph_traits<Mesh>::null_face())
      return;
    const End r = moved(right, a, b), l = moved(left, a, b);
    const double to_a = known_.distance(t_.index(source(h, mesh))) - apex_distance_;
    const double to_b = known_.distance(t_.index(target(h, mesh))) - apex_distance_;
    if (to_a + distance(a, l.point) < norm(l.point) || to_b + distance(b, r.point) < norm(r.point))
      return;
    windows_.push_back({h, a, b, r, l, before, shares_left});
  }

  // whether the vertex behind a window is nearer than known; else it divides what is seen
  bool look_through(std::size_t i, double gain) {
    const Window& w = windows_[i]; // stays where it is: room for all is reserved
    const auto& mesh = t_.mesh();
    const Halfedge o = opposite(w.halfedge, mesh), av = next(o, mesh), vb = next(av, mesh);
    const double e = squared_length(o);
    const double r = 1 / (2 * e), q = quadruple_area(o) * r;
    const double s = (squared_length(av) + e - squared_length(vb)) * r;
    const Vector ab{w.b[0] - w.a[0], w.b[1] - w.a[1]};
    const Vector v{w.a[0] + s * ab[0] + q * ab[1], w.a[1] + s * ab[1] - q * ab[0]};
    const bool is_left_of_right = cross(w.right.point, v) > 0,
               is_right_of_left = cross(v, w.left.point) > 0;
    if (is_left_of_right && is_right_of_left) {
      found_ = i;
      const double known = known_.distance(t_.index(target(av, mesh)));
      if (apex_distance_ + distance(v, {0, 0}) < known * (1 - gain)) return true;
    }
    const bool is_seen = is_left_of_right && is_right_of_left;
    if (is_left_of_right)
      push(av, w.a, v, w.right, is_seen ? End{v, true} : End{w.left.point, false}, i, false);
    if (is_right_of_left)
      push(vb, v, w.b, is_seen ? End{v, true} : End{w.right.point, false}, w.left, i, true);
    return false;
  }

  const Triangulation& t_;
  const Known& known_;
  std::vector<Halfedge> faces_;
  double apex_distance_ = 0;
  std::vector<Window> windows_;
  std::size_t found_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_SHORTCUT_FINDER_H

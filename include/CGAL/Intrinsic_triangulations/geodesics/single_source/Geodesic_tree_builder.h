// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>
#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/geodesics/shortening/Shortening_result.h>
#include <CGAL/Intrinsic_triangulations/geodesics/shortening/Wedge_flipper.h>
#include <CGAL/Intrinsic_triangulations/geodesics/single_source/Geodesic_tree.h>
#include <CGAL/Intrinsic_triangulations/geodesics/single_source/Shortcut_finder.h>
#include <CGAL/Intrinsic_triangulations/metric/wedge_angle.h>

#include <CGAL/enum.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Dijkstra's algorithm along edges, where a path is taken only if it is geodesic. One that is not is bent where it
// leaves the tree: the edges in the wedge there are flipped out, and shorter paths appear.
//
// All paths in the tree are geodesic. So a wedge below pi between the edge to a vertex u of the tree and an edge from it has no
// other edge of the tree: the wedge of that would be smaller still. Hence edges of the tree are never flipped.
//
// Why it ends: let d(v) be the distance of v along all edges; vertices in the tree have their d there, as one that is found to be
// nearer than it was taken for is taken out with all behind it. Edges are flipped in their order from the edge p u of the tree.
// When u n_j is flipped, all edges before it have angles of at least pi at their other ends: the path p n_1 ... n_j is convex
// in the triangle p u n_j and shorter than p u n_j, so that no d increases. When none can be flipped, d(v) is less than by
// way of u, where it was attained. There are finitely many geodesic edges below a length, so that the sum of all d decreases
// finitely often. This holds as far as sums of lengths in doubles tell apart what differs: a vertex of the tree is taken out only
// if it becomes nearer by `least_gain`, so that rounding does not take one out again and again; and one to which ways are bent again and
// again, but do not become shorter, is given up after `most_futile` of them.
//
// So far a path is compared with those that are longer by an edge before they are straightened, and is often not the shortest: that passes
// a vertex of small curvature on the other side. Then straight ways from the vertices of the tree are looked for by windows, see
// `Shortcut_finder.h`. Edges are flipped until the shorter way is one; no edge of the tree is among them, so that again no d
// increases.
template <class Triangulation>
class Geodesic_tree_builder {
  using Mesh = typename Triangulation::Mesh;
  using Vertex = typename Triangulation::vertex_descriptor;
  using Halfedge = typename Triangulation::halfedge_descriptor;
  using Session = typename Triangulation::Session;
  using Tree = Geodesic_tree<Triangulation>;
  static constexpr std::uint32_t none = Gluing::none;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  static constexpr double least_gain = 1e-10;    // relative
  static constexpr unsigned most_futile = 10000; // with exact traits, there were 712 at most

public:
  Geodesic_tree_builder(const Triangulation& t, Session& session, Flip_log<Triangulation>* log)
      : t_(t), session_(session), flip_wedge_(t, session, log),
        labels_(t.numbers().vertex_capacity(t.mesh())), bends_(labels_.size()),
        flips_when_bent_(2 * t.numbers().edge_capacity(t.mesh()), never) {}

  // `go_on(result)` is called now and then
  template <class Go_on>
  Shortening_result run(Vertex source, std::uint64_t cap, const Go_on& go_on) {
    cap_ = cap;
    accept(t_.index(source), 0, none);
    do {
      do drain(go_on);
      while (result_.status == Status::done && finds_more());
      find_shortcuts(go_on);
      if (queue_.empty() && changed_.empty() && has_accepted_since(accepted_before_all_))
        find_ways_to_all();
    } while (result_.status == Status::done && !(queue_.empty() && changed_.empty()));
    const bool are_lost = drop_lost_ways(t_, labels_, t_.index(source));
    if (result_.status == Status::done && (are_lost || lacks_way()))
      result_.status = Status::stalled;
    return result_;
  }

  Tree tree() const {
    std::vector<typename Tree::Branch> branches;
    branches.reserve(labels_.size());
    for (const Label& l : labels_)
      branches.push_back({std::ldexp(l.distance, -t_.metric().scale_exponent()), l.halfedge});
    return Tree(t_, std::move(branches), result_);
  }

private:
  struct Label {
    double bound = infinity;       // of paths that are worth to be looked at
    double distance = infinity;    // in the tree
    std::uint32_t halfedge = none; // to it in the tree
    bool is_in_tree = false;
  };
  // ways to a vertex that were bent
  struct Bends {
    double distance = infinity; // of the last one
    unsigned futile = 0;        // how many were not shorter than the one before
  };
  struct Candidate {
    double distance;
    std::uint32_t halfedge;
    bool operator<(const Candidate& c) const { return distance > c.distance; }
  };

  struct Known {
    const Geodesic_tree_builder* builder;

    double distance(std::uint32_t v) const { return builder->labels_[v].distance; }
    bool is_barrier(std::uint32_t h) const { return builder->is_in_tree(h); }
  };

  Halfedge halfedge_at(std::uint32_t h) const { return t_.numbers().halfedge_at(h); }
  std::uint32_t source_of(std::uint32_t h) const {
    return t_.index(source(halfedge_at(h), t_.mesh()));
  }
  std::uint32_t target_of(std::uint32_t h) const {
    return t_.index(target(halfedge_at(h), t_.mesh()));
  }
  bool is_in_tree(std::uint32_t h) const {
    return labels_[target_of(h)].halfedge == h || labels_[source_of(h)].halfedge == (h ^ 1U);
  }
  double distance_along(std::uint32_t h) const {
    return labels_[source_of(h)].distance +
           std::sqrt(t_.metric().approximate_squared_length(h / 2));
  }
  template <class Function>
  void for_each_out(std::uint32_t v, const Function& f) const {
    for_each_outgoing(t_.numbers().vertex_at(v), t_.mesh(),
                      [&](Halfedge h) { f(t_.numbers().halfedge(h)); });
  }

  template <class Go_on>
  void drain(const Go_on& go_on) {
    while (!queue_.empty() && result_.status == Status::done) {
      const Candidate c = queue_.top();
      queue_.pop();
      if (is_current(c)) take(c);
      if ((++steps_ & 0xfffU) == 0 && !session_.suspended([&] { return go_on(result_); }))
        result_.status = Status::cancelled;
    }
  }

  // the edge may have been flipped, its source taken out, or this way taken, since
  bool is_current(const Candidate& c) const {
    const std::uint32_t u = source_of(c.halfedge), v = target_of(c.halfedge);
    return labels_[u].is_in_tree && labels_[v].bound == c.distance &&
           labels_[v].distance != c.distance && distance_along(c.halfedge) == c.distance;
  }

  void relax(std::uint32_t h) {
    if (!labels_[source_of(h)].is_in_tree || bends_[target_of(h)].futile > most_futile) return;
    Label& to = labels_[target_of(h)];
    const double d = distance_along(h);
    if (!(d < to.bound) || (to.is_in_tree && !(d < to.distance * (1 - least_gain)))) return;
    to.bound = d;
    queue_.push({d, h});
  }
  // looks for ways to a vertex, but for those that were found to be bent since the last flip
  void search(std::uint32_t v) {
    labels_[v].bound = labels_[v].distance;
    for_each_out(v, [&](std::uint32_t h) {
      if (flips_when_bent_[h ^ 1U] != result_.flips) relax(h ^ 1U);
    });
  }

  void take(const Candidate& c) {
    const std::uint32_t u = source_of(c.halfedge), v = target_of(c.halfedge);
    if (labels_[u].halfedge == none || is_straight(u, c.halfedge)) {
      accept(v, c.distance, c.halfedge);
    } else {
      flips_when_bent_[c.halfedge] = result_.flips;
      note_bend(v, c.distance);
      search(v);
    }
  }

  // A way that is bent is shortened, so that the next one to the vertex should be shorter; rounding can hide that, or make up bends.
  void note_bend(std::uint32_t v, double distance) {
    Bends& b = bends_[v];
    if (!(distance < b.distance)) ++b.futile;
    b.distance = distance;
  }

  // whether the path goes on straight from u along h; if not, edges are flipped
  bool is_straight(std::uint32_t u, std::uint32_t h) {
    const auto& mesh = t_.mesh();
    const Halfedge in = halfedge_at(labels_[u].halfedge), out = halfedge_at(h);
    std::array<Wedge, 2> wedges; // on the left and on the right
    const std::array<bool, 2> is_whole{
        find_wedge(t_, in, out, wedges[0]),
        find_wedge(t_, opposite(out, mesh), opposite(in, mesh), wedges[1])};
    const std::size_t first = wedges[1].sum().rank() < wedges[0].sum().rank() ? 1 : 0;
    for (const std::size_t side : {first, 1 - first}) {
      if (!is_whole[side]) continue;
      ++result_.wedge_checks;
      const Comparison_result c =
          side == 0 ? compare_to_pi(session_, in, out, wedges[0])
                    : compare_to_pi(session_, opposite(out, mesh), opposite(in, mesh), wedges[1]);
      if (c == EQUAL) ++result_.exact_ties;
      if (c != SMALLER) continue;
      ++result_.shortenings;
      const std::uint64_t left = cap_ - result_.flips;
      const bool is_done =
          flip_wedge_(opposite(in, mesh), out, side == 0, left, result_, [this](Halfedge e) {
            const std::uint32_t i = t_.numbers().halfedge(e);
            relax(i);
            relax(i ^ 1U);
          });
      if (!is_done) result_.status = Status::cap;
      return false;
    }
    return true;
  }

  void accept(std::uint32_t v, double distance, std::uint32_t h) {
    if (labels_[v].is_in_tree) take_out(v);
    labels_[v] = {distance, distance, h, true};
    bends_[v].distance = infinity;
    ++accepted_;
    changed_.push_back(v);
    if (!is_isolated(t_.numbers().vertex_at(v)))
      for_each_out(v, [this](std::uint32_t g) { relax(g); });
  }

  // takes a vertex and all behind it out of the tree
  void take_out(std::uint32_t root) {
    std::vector<std::uint32_t> out{root}, near;
    for (std::size_t i = 0; i < out.size(); ++i) {
      labels_[out[i]] = {};
      for_each_out(out[i], [&](std::uint32_t h) {
        const std::uint32_t w = target_of(h);
        if (labels_[w].halfedge == h)
          out.push_back(w);
        else
          near.push_back(w);
      });
    }
    out.insert(out.end(), near.begin(), near.end());
    for (const std::uint32_t v : out)
      if (v != root && (!labels_[v].is_in_tree || labels_[v].bound != labels_[v].distance))
        search(v); // the way that was best led by here
  }

  // Looks again for ways to vertices where the best one that was known has been flipped away or lost by rounding.
  bool finds_more() {
    for (const Vertex v : vertices(t_.mesh())) {
      const Label& l = labels_[t_.index(v)];
      if ((!l.is_in_tree || l.bound != l.distance) && !is_isolated(v)) search(t_.index(v));
    }
    if (queue_.empty()) return false;
    const std::uint64_t progress = result_.flips + accepted_;
    if (progress == progress_before_) result_.status = Status::stalled;
    progress_before_ = progress;
    return result_.status == Status::done;
  }
  // Whether any vertex has been, since this was asked last. Flips alone are no progress: where a way is shorter than the one to a vertex in
  // the tree, the flips end in one that is taken. With rounding they need not, and would be made back and forth.
  bool has_accepted_since(std::uint64_t& before) const {
    return std::exchange(before, accepted_) != accepted_;
  }
  // Ways that were bent when they were looked at may have become better, and so have others, as lengths have been told more accurately.
  void find_ways_to_all() {
    for (Label& l : labels_) l.bound = l.distance;
    for (const Halfedge h : halfedges(t_.mesh())) {
      const std::uint32_t i = t_.numbers().halfedge(h);
      if (flips_when_bent_[i] != result_.flips) relax(i);
    }
  }

  // whether a vertex next to the tree is not in it, as all ways to it seem to be bent
  bool lacks_way() const {
    for (const Halfedge h : halfedges(t_.mesh())) {
      const std::uint32_t i = t_.numbers().halfedge(h);
      if (labels_[source_of(i)].is_in_tree && !labels_[target_of(i)].is_in_tree) return true;
    }
    return false;
  }

  // Looks for shorter ways straight on from all vertices that have been reached anew, near ones first.
  template <class Go_on>
  void find_shortcuts(const Go_on& go_on) {
    const Known known{this};
    Shortcut_finder<Triangulation, Known> finder(t_, known);
    std::vector<std::uint32_t> order;
    order.swap(changed_);
    std::sort(order.begin(), order.end());
    order.erase(std::unique(order.begin(), order.end()), order.end());
    std::sort(order.begin(), order.end(), [this](std::uint32_t v, std::uint32_t w) {
      return std::pair(labels_[v].distance, v) < std::pair(labels_[w].distance, w);
    });
    for (const std::uint32_t v : order)
      while (result_.status == Status::done && labels_[v].is_in_tree && finds_shortcut(finder, v))
        drain(go_on);
  }
  template <class Finder>
  bool finds_shortcut(Finder& finder, std::uint32_t v) {
    const std::uint32_t in = labels_[v].halfedge;
    const auto null = boost::graph_traits<Mesh>::null_halfedge();
    const Vertex from = t_.numbers().vertex_at(v);
    return !is_isolated(from) &&
           finder.find(from, in == none ? null : halfedge_at(in), 2 * least_gain) &&
           insert(finder.crossed()) && !queue_.empty();
  }
  // Flips edges that a segment crosses until the segment is one, unless that does not end.
  bool insert(Crossed_edges crossed) {
    const auto& edges = crossed.halfedges;
    std::size_t futile = 0;
    for (std::size_t i = 0; futile <= 4 * edges.size() && result_.flips < cap_; ++futile) {
      if (i >= edges.size()) i = 0;
      const std::uint32_t h = edges[i++];
      if (flip_wedge_.flip(halfedge_at(h)) != Move_status::done) continue;
      ++result_.flips;
      relax(h);
      relax(h ^ 1U);
      if (!crossed.flip(i - 1)) continue;
      if (edges.empty()) return true;
      futile = 0;
      i = i < 2 ? 0 : i - 2;
    }
    if (result_.flips >= cap_) result_.status = Status::cap;
    return false;
  }
  bool is_isolated(Vertex v) const {
    return halfedge(v, t_.mesh()) == boost::graph_traits<Mesh>::null_halfedge();
  }

  const Triangulation& t_;
  Session& session_;
  Wedge_flipper<Triangulation> flip_wedge_;
  std::vector<Label> labels_;
  std::vector<Bends> bends_;                   // per vertex
  std::vector<std::uint64_t> flips_when_bent_; // per halfedge
  std::priority_queue<Candidate> queue_;
  std::vector<std::uint32_t> changed_; // vertices from which shortcuts have not been looked for
  Shortening_result result_;
  std::uint64_t cap_ = 0, steps_ = 0, accepted_ = 0, progress_before_ = 0, accepted_before_all_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_SINGLE_SOURCE_GEODESIC_TREE_BUILDER_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Flips waiting edges until all are locally Delaunay (§4.2 of the course, Algorithms 1 and 3). It
keeps its memory for reuse.

The tessellation that is found does not depend on the order of flips, but their number does. If
short edges of slivers flip before long ones, they wind around the surface, and have to be flipped
back. So no edge flips while a longer side of its faces waits: that one is tested first.

Starting edges are tested in the order of memory, a few at a time. Edges near their flips are tested
before the next starting edges, while they are in the cache: roughly the long ones first, and edges
of similar length in the order of arrival. So a waiting edge is tested once for many flips near it.
*/
template <class Triangulation>
class Delaunay_flipper {
  using Mesh = typename Triangulation::Mesh;
  using Session = typename Triangulation::Session;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;

public:
  Delaunay_flipper(Triangulation& t, Session& session)
      : t_(t), session_(session), state_(num_edges(t.mesh()), settled) {
    starts_.reserve(num_edges(t.mesh()));
  }

  /// makes the edge of a halfedge wait.
  void push(Halfedge h) {
    if (set_suspect(h)) starts_.push_back(h);
  }

  /// makes the edges of the faces about a vertex wait, and those at it.
  void push_star(typename boost::graph_traits<Mesh>::vertex_descriptor v) {
    for_each_outgoing(v, t_.mesh(), [this](Halfedge h) {
      push(h);
      if (face(h, t_.mesh()) != boost::graph_traits<Mesh>::null_face()) push(next(h, t_.mesh()));
    });
  }

  /*!
  Flips until none waits.
  \param observer its `before_check()` and `before_flip()` return whether to go on,
  `is_constrained(h)` whether to keep an edge that is not locally Delaunay; `after_flip(h)` and
  `refused(h)` are called
  \return whether none waits
  */
  template <class Observer>
  bool run(Observer& observer) {
    const bool is_done = run_from_starts(observer);
    starts_.clear(); // what waited when it stopped is forgotten
    return is_done;
  }

private:
  using Sides = std::array<Halfedge, 4>;
  // of an edge; one that is not Delaunay waits for longer sides of its faces
  enum State : char { settled, suspect, not_delaunay };

  State& state(Halfedge h) { return state_[t_.index(edge(h, t_.mesh()))]; }
  // all edges alike if there is no metric
  double squared_length(Halfedge h) const {
    if constexpr (requires { t_.metric().approximate_squared_length(0U); })
      return t_.metric().approximate_squared_length(t_.index(edge(h, t_.mesh())));
    else if constexpr (requires { t_.metric().approximate_lambda(0U); })
      return std::pow(t_.metric().approximate_lambda(t_.index(edge(h, t_.mesh()))), 2);
    else
      return 0;
  }
  bool waits(Halfedge h) const {
    const std::uint32_t e = t_.index(edge(h, t_.mesh()));
    return e < state_.size() && state_[e] != settled;
  }
  Sides sides(Halfedge h) const {
    const Halfedge n = next(h, t_.mesh()), m = next(opposite(h, t_.mesh()), t_.mesh());
    return {n, next(n, t_.mesh()), m, next(m, t_.mesh())};
  }

  bool set_suspect(Halfedge h) {
    const std::uint32_t e = t_.index(edge(h, t_.mesh()));
    if (e >= state_.size()) state_.resize(e + std::size_t{1}, settled); // numbers may have gaps
    return std::exchange(state_[e], suspect) == settled;
  }

  // The power of 4 below a length, from 0: leading bits of the exponent of its square.
  std::size_t rank(Halfedge h) const {
    return (std::bit_cast<std::uint64_t>(squared_length(h)) >> 54U) & 0x1ffU;
  }
  void wait(Halfedge h) {
    const std::size_t r = rank(h);
    if (r >= waiting_.size()) waiting_.resize(r + 1);
    waiting_[r].push_back(h);
    longest_ = std::max(longest_, r);
    ++number_of_waiting_;
  }

  template <class Observer>
  bool run_from_starts(Observer& observer) {
    const std::size_t n = starts_.size();
    for (std::size_t first = 0; first < n; first += block) {
      if (!process(std::span(starts_).subspan(first, std::min(block, n - first)), observer))
        return false;
      while (number_of_waiting_ > 0) {
        while (waiting_[longest_].empty()) --longest_;
        sweep_.clear();
        sweep_.swap(waiting_[longest_]);
        number_of_waiting_ -= sweep_.size();
        if (!process(sweep_, observer)) return false;
      }
      longest_ = 0;
    }
    return true;
  }

  template <class Observer>
  bool process(std::span<const Halfedge> edges, Observer& observer) {
    for (const Halfedge h : edges) {
      if (state(h) == settled) continue; // it went before a shorter one
      if (!observer.before_check()) return false;
      state(h) = settled;
      if (session_.is_locally_delaunay(h) || observer.is_constrained(h)) continue;
      const Sides outer = sides(h);
      if (!(waits_for_any(h, outer) ? flip_after_longer(h, observer) : flip(h, outer, observer)))
        return false;
    }
    return true;
  }

  // Tests longer sides of the faces first, before them longer sides of theirs, and so on: lengths
  // grow along the path.
  template <class Observer>
  bool flip_after_longer(Halfedge first, Observer& observer) {
    state(first) = not_delaunay;
    path_.assign(1, first);
    while (!path_.empty()) {
      const Halfedge h = path_.back();
      if (state(h) == suspect) {
        if (!observer.before_check()) return false;
        const bool stays = session_.is_locally_delaunay(h) || observer.is_constrained(h);
        state(h) = stays ? settled : not_delaunay;
      }
      if (state(h) == not_delaunay) {
        const Sides outer = sides(h);
        if (waits_for_any(h, outer)) {
          path_.push_back(longest_that_waits(outer));
          continue;
        }
        state(h) = settled;
        if (!flip(h, outer, observer)) return false;
      }
      path_.pop_back();
    }
    return true;
  }

  // whether a longer side of its faces waits
  bool waits_for_any(Halfedge h, const Sides& outer) const {
    const double length = squared_length(h);
    unsigned result = 0;
    for (const Halfedge s : outer) // without branches: which ones wait is not predictable
      result |= unsigned{squared_length(s) > length} & unsigned{waits(s)};
    return result != 0;
  }
  // \pre there is one
  Halfedge longest_that_waits(const Sides& outer) const {
    const auto length = [this](Halfedge s) { return waits(s) ? squared_length(s) : -1; };
    return *std::max_element(outer.begin(), outer.end(),
                             [&](Halfedge r, Halfedge s) { return length(r) < length(s); });
  }

  template <class Observer>
  bool flip(Halfedge h, const Sides& outer, Observer& observer) {
    if (!observer.before_flip()) return false;
    if (session_.flip_non_delaunay_edge(h) != Move_status::done) {
      observer.refused(h);
      return true;
    }
    observer.after_flip(h);
    for (const Halfedge s : outer)
      if (set_suspect(s)) wait(s);
    return true;
  }

  // Starting edges at a time. With 64, edges of a torus are tested more often; with all, split
  // meshes take twice the time.
  static constexpr std::size_t block = 1024;

  Triangulation& t_;
  Session& session_;
  std::vector<State> state_;                   // by edge number
  std::vector<Halfedge> starts_;               // in the order of memory
  std::vector<std::vector<Halfedge>> waiting_; // by rank
  std::size_t longest_ = 0, number_of_waiting_ = 0;
  std::vector<Halfedge> sweep_, path_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H

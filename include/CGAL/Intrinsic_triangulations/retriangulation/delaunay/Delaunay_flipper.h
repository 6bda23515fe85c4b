// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H

#include <CGAL/Intrinsic_triangulations/connectivity/for_each_outgoing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Move_status.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
Flips edges that wait until none is left that is not locally Delaunay (§4.2 of the course, Algorithms 1
and 3). It can be used again and again: its memory stays.

Edges wait in the order in which they became suspect, each at most once: a sweep tests those that wait and
collects those that its flips make suspect for the next. Starting edges come in the order of memory, and an
edge that waits is tested once for all flips near it until then.
*/
template <class Triangulation>
class Delaunay_flipper {
  using Mesh = typename Triangulation::Mesh;
  using Session = typename Triangulation::Session;
  using Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor;

public:
  Delaunay_flipper(Triangulation& t, Session& session)
      : t_(t), session_(session), is_waiting_(num_edges(t.mesh()), 0) {}

  /// makes the edge of a halfedge wait.
  void push(Halfedge h) {
    const std::uint32_t e = t_.index(edge(h, t_.mesh()));
    if (e >= is_waiting_.size()) is_waiting_.resize(e + std::size_t{1}, 0); // numbers may have gaps
    if (is_waiting_[e]) return;
    is_waiting_[e] = 1;
    waiting_.push_back(h);
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
  \param observer its `before_check()` and `before_flip()` tell whether to go on,
  `is_constrained(h)` whether an edge that is not locally Delaunay is kept; `after_flip(h)` and
  `refused(h)` are called
  \return whether none waits
  */
  template <class Observer>
  bool run(Observer& observer) {
    std::vector<Halfedge>& sweep = sweep_;
    while (!waiting_.empty()) {
      sweep.swap(waiting_);
      waiting_.clear();
      for (const Halfedge h : sweep) {
        is_waiting_[t_.index(edge(h, t_.mesh()))] = 0;
        if (!process(h, observer)) return false;
      }
    }
    return true;
  }

private:
  template <class Observer>
  bool process(Halfedge h, Observer& observer) {
    if (!observer.before_check()) return false;
    if (session_.is_locally_delaunay(h) || observer.is_constrained(h)) return true;
    if (!observer.before_flip()) return false;
    const Halfedge o = opposite(h, t_.mesh());
    const Halfedge outer[4] = {next(h, t_.mesh()), next(next(h, t_.mesh()), t_.mesh()),
                               next(o, t_.mesh()), next(next(o, t_.mesh()), t_.mesh())};
    if (session_.flip_non_delaunay_edge(h) != Move_status::done) {
      observer.refused(h);
      return true;
    }
    observer.after_flip(h);
    for (const Halfedge x : outer) push(x);
    return true;
  }

  Triangulation& t_;
  Session& session_;
  std::vector<Halfedge> waiting_, sweep_;
  std::vector<char> is_waiting_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_DELAUNAY_DELAUNAY_FLIPPER_H

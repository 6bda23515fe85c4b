// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_PROPAGATION_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_PROPAGATION_H

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

/*!
\file
Exact distances on a polyhedral surface: Chen and Han's tree of windows (1990), explored by distance and pruned as Xin and
Wang do (2009), with the windows of a side together, as Qin et al. do for faces (2016).

A source sees faces through windows: intervals of sides, beyond which the faces in between are laid out in the plane. A window
that looks into a face is split by its far corner, or goes to one of the other sides. Corners get distances from the windows
that show them. Where the angles around a vertex are more than a full turn, and more than half a turn on the border, shortest
paths may pass through it; it becomes a source of the sector that the path before cannot get to.

**What prunes.** A window is dropped if one of the ends of its side, or the far corner of its face, is near enough to serve all
that it could: the path by way of that vertex would cross those through the window, and is shorter. The distances of vertices
are those of paths, final or not, so that this is right at all times. Of the windows of a side that show the far corner only the
nearest goes on to both sides (Chen and Han's "one angle, one split"). These arguments stay within one face and the
layout of the faces before it: they hold on any Delta-complex, also where a shortest path crosses a face more than once.

**The order.** The queue gives vertices by their distance, and sides by the least distance of a point of the windows that wait
there, which parts of windows never undercut. So the distance of a vertex is final when the vertex comes. The other windows of
the side come earlier than they would alone. That is right, and pays: the queue has a twentieth of the elements, and what
windows of a side have in common is computed once.

**It ends.** Windows are useless that are farther than all vertices and an edge; nearer ones are finitely many, as a straight line
turns by less than half a turn around each vertex that it passes, and the next is some way off. On a body k times as
long as thick windows wind around it up to about k times before they are longer than those that do not, so that their number grows with k, and from
10^7 on rounding hides which are longer: a cap on their number stands in for the proof.

**Rounding.** Comparisons are tolerant in the direction that keeps windows. A window drawn to a corner shows it if that lies off
its rays by rounding; no corner is lost between two windows so, at an error of second order. Distances never come from
comparisons, they are lengths of segments.
*/

namespace CGAL::Intrinsic_triangulations::internal {

/// What stops a propagation early.
/*!
\brief is what window propagation has still to look at: vertices, and sides with the windows that wait there, nearest first.

Windows of a side wait for each other, so that the queue is asked once for all of them, and that what they have in common is
computed once: about 20 on meshes of 80,000 faces.
*/
class Window_queue {
public:
  /// has no windows yet.
  explicit Window_queue(std::size_t sides) : sides_(sides) {}

  /// returns the least distance in the queue, infinity if it is empty.
  double least() const {
    return heap_.empty() ? std::numeric_limits<double>::infinity() : heap_.front().key;
  }
  /// tells whether nothing is left.
  bool is_empty() const { return heap_.empty(); }
  /// adds a vertex.
  void push_vertex(double key, std::uint32_t v) { push({key, v, true}); }
  /// adds a window to a side.
  void push_window(double key, std::uint32_t side, const Window& w) {
    std::uint32_t i = 0;
    if (free_.empty()) {
      i = static_cast<std::uint32_t>(pool_.size());
      pool_.emplace_back();
    } else {
      i = free_.back();
      free_.pop_back();
    }
    Waiting& s = sides_[side];
    pool_[i] = {w, s.first};
    s.first = i;
    if (key < s.key) {
      s.key = key;
      push({key, side, false});
    }
  }
  /// takes the nearest. \return whether it is a vertex; else it is a side, whose windows are to be taken
  bool pop(std::uint32_t& element) {
    const Entry e = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    element = e.element;
    return e.is_vertex;
  }
  /// takes all windows of a side: calls a function with each. There are none where the side came before.
  template <class Function>
  void take_windows(std::uint32_t side, const Function& f) {
    Waiting& s = sides_[side];
    std::uint32_t i = s.first;
    s = {};
    while (i != Gluing::none) {
      const Node node = pool_[i];
      free_.push_back(i);
      i = node.next;
      f(node.window);
    }
  }

private:
  struct Entry {
    double key;
    std::uint32_t element;
    bool is_vertex;
    // for a heap with the least key on top; windows before vertices, which they may still improve
    friend bool operator<(const Entry& a, const Entry& b) {
      return a.key > b.key || (a.key == b.key && a.is_vertex && !b.is_vertex);
    }
  };
  struct Node {
    Window window;
    std::uint32_t next;
  };
  struct Waiting {
    double key = std::numeric_limits<double>::infinity(); // the least of the windows
    std::uint32_t first = Gluing::none;
  };

  void push(const Entry& e) {
    heap_.push_back(e);
    std::push_heap(heap_.begin(), heap_.end());
  }

  std::vector<Entry> heap_;
  std::vector<Waiting> sides_;
  std::vector<Node> pool_;
  std::vector<std::uint32_t> free_; // of the pool
};

/// Vertices and points in faces, such as sources and targets.
struct Places {
  std::vector<std::uint32_t> vertices; ///< by their numbers
  std::vector<Point_in_face> points;   ///< others

  /// adds a vertex.
  void add(std::uint32_t v) { vertices.push_back(v); }
  /// adds a point in a face.
  void add(const Point_in_face& p) { points.push_back(p); }
};

struct Propagation_limits {
  double radius = std::numeric_limits<double>::infinity();           ///< in scaled units
  std::uint64_t windows = std::numeric_limits<std::uint64_t>::max(); ///< number to look through
  Places targets; ///< if there are any, it stops once their distances are known
};

/*!
\brief spreads windows from the sources of a field over the surface.
*/
class Window_propagation {
public:
  /// starts. Sources are added before `run()`, vertices first.
  explicit Window_propagation(Distance_field& field);
  /// makes a vertex a source.
  void add_source(std::uint32_t v);
  /// makes a point in a face a source.
  void add_source(const Point_in_face& p);
  /*!
  \brief spreads windows.
  \param limits when to stop
  \param progress is called now and then, with the number of windows and the distance reached; tells whether to go on
  \return `done`, `cap` or `cancelled`
  */
  Status run(const Propagation_limits& limits,
             const std::function<bool(std::uint64_t, double)>& progress);
  /// returns the number of windows that were looked through.
  std::uint64_t number_of_windows() const { return count_; }

private:
  // The nearest window of a side that shows the far corner.
  struct Split {
    double distance = std::numeric_limits<double>::infinity();
    double crossing =
        std::numeric_limits<double>::infinity(); // of its line to the corner and the side
  };
  // A face around a vertex, and what of its angle is meant.
  struct Wedge {
    std::uint32_t corner;
    double angle;
  };
  // A window and the far corner of its face.
  struct View {
    Window window;
    Apex_view apex;
  };

  void reach(std::uint32_t v, double distance, const Arrival& arrival);
  void finish(std::uint32_t v);
  void reach_copies(std::uint32_t v);
  void open_fan(std::uint32_t v, std::uint32_t first, bool everywhere);
  void open_closed_fan(std::uint32_t v, std::size_t arrival, double angle);
  void open_border_fan(std::uint32_t v, std::size_t arrival, double angle);
  void open_wedge(std::uint32_t v, const Wedge& wedge, double from, double to);
  double find_arrival(std::uint32_t v, std::size_t& index) const;
  void add_window(std::uint32_t side, Window w);
  void part_at_sources(std::uint32_t side, Window& w);
  void look_through(std::uint32_t side);
  void collect_views(std::uint32_t side, const Window_face& face);
  const View* show_apex(std::uint32_t side, const Window_face& face);
  void pass_on(const View& view, const Window_face& face, double nearest_crossing,
               bool is_nearest);
  bool knows_targets(const Propagation_limits& limits) const;

  Distance_field& field_;
  const Corner_table& table_;
  Window_queue queue_;
  std::vector<Split> split_;   // per side
  std::vector<char> is_final_; // per vertex
  std::vector<Wedge> fan_;     // of the vertex that is dealt with
  std::vector<View> views_;    // of the side that is dealt with
  double radius_ = std::numeric_limits<double>::infinity();
  std::uint64_t count_ = 0;
  std::uint64_t most_windows_ = std::numeric_limits<std::uint64_t>::max();
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_geodesics/distance/Window_propagation_impl.h>
#endif

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_WINDOW_PROPAGATION_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_RUN_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_RUN_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is a run of input halfedges that an intrinsic one enters one after the other, about one
vertex of the input.

Over needles an intrinsic edge crosses thousands of input edges, but turns about few vertices. Any
two input halfedges that are entered one after the other are a run, since both are sides of the
triangle in between.
*/
class Crossing_run {
public:
  /// constructs a run of no halfedges.
  Crossing_run() = default;
  /*!
  \brief constructs a run.
  \param first the first halfedge
  \param count number of halfedges
  \param is_clockwise whether they end at the vertex; else they start from it
  */
  Crossing_run(std::uint32_t first, std::uint32_t count, bool is_clockwise = false)
      : first_(first), bits_(2 * count + (is_clockwise && count > 1 ? 1U : 0U)) {}

  /// returns the first halfedge.
  std::uint32_t first() const { return first_; }
  /// returns the number of halfedges.
  std::uint32_t count() const { return bits_ / 2; }
  /// tells whether the halfedges end at the vertex; false for a single one.
  bool is_clockwise() const { return bits_ % 2 != 0; }

  /// returns a halfedge: the first one is number 0, and one behind the last would go on the run.
  std::uint32_t operator()(const Vertex_fans& fans, std::uint32_t i) const {
    return turned(fans, first_, i, is_clockwise());
  }
  /// returns the part from one number to another.
  Crossing_run part(const Vertex_fans& fans, std::uint32_t from, std::uint32_t to) const {
    return {(*this)(fans, from), to - from, is_clockwise()};
  }
  /// returns the run of the way back, which enters the opposite halfedges.
  Crossing_run reversed(const Vertex_fans& fans) const {
    return {(*this)(fans, count() - 1) ^ 1U, count(), !is_clockwise()};
  }

  /// returns the halfedge that is so many behind one, about its target or its source.
  static std::uint32_t turned(const Vertex_fans& fans, std::uint32_t halfedge, std::uint32_t count,
                              bool is_clockwise) {
    if (count == 0) return halfedge;
    return is_clockwise ? fans.halfedge(fans.retreat(fans.slot(halfedge ^ 1U), count)) ^ 1U
                        : fans.halfedge(fans.advance(fans.slot(halfedge), count));
  }

private:
  std::uint32_t first_ = 0;
  std::uint32_t bits_ = 0; // twice the number, and the direction
};

/*!
\brief appends a run to others, such that each is as long as possible: then there are as few as
possible, whichever way they are read.
\param fans the halfedges around the vertices of the input
\param runs the others
\param next what is entered behind them
*/
inline void append_run(const Vertex_fans& fans, std::vector<Crossing_run>& runs,
                       const Crossing_run& next) {
  if (!runs.empty()) {
    Crossing_run& last = runs.back();
    for (const bool way : {false, true}) {
      if (last.count() > 1 && last.is_clockwise() != way) continue;
      if (Crossing_run::turned(fans, last.first(), last.count(), way) != next.first()) continue;
      const bool goes_on = next.count() == 1 || next.is_clockwise() == way;
      last = {last.first(), last.count() + (goes_on ? next.count() : 1), way};
      if (!goes_on) runs.push_back(next.part(fans, 1, next.count()));
      return;
    }
  }
  runs.push_back(next);
}

/*!
\brief visits the parts of runs between two numbers of halfedges.
\tparam Visit a functor of a `Crossing_run`
\param fans the halfedges around the vertices of the input
\param runs what a halfedge enters
\param is_opposite whether to go back, as the opposite halfedge does
\param from, to numbers on the way
\param visit the functor
*/
template <std::invocable<const Crossing_run&> Visit>
void for_each_run(const Vertex_fans& fans, std::span<const Crossing_run> runs, bool is_opposite,
                  std::uint32_t from, std::uint32_t to, const Visit& visit) {
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < runs.size() && begin < to; ++i) {
    const Crossing_run& r = runs[is_opposite ? runs.size() - 1 - i : i];
    const std::uint32_t end = begin + r.count();
    if (end > from) {
      const std::uint32_t first = std::max(begin, from) - begin, last = std::min(end, to) - begin;
      visit(is_opposite ? r.part(fans, r.count() - last, r.count() - first).reversed(fans)
                        : r.part(fans, first, last));
    }
    begin = end;
  }
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_CROSSING_RUN_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TRIANGLE_STRIPS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TRIANGLE_STRIPS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief holds the input triangles under an intrinsic face: a strip, and possibly a second one that
branches off.

It is a `Development` of triangles that are seldom all looked at: over needles there are thousands
about one vertex, which are stored as one turn. The first side of the first triangle runs from point
0 to point 1, and triangle number n adds point n + 2. It reuses its memory.
*/
class Triangle_strips {
public:
  /// No triangle.
  static constexpr std::uint32_t none = Gluing::none;
  /// From so many triangles on a turn is long. Shorter ones, nearly all on meshes without needles,
  /// take less time one by one.
  static constexpr std::uint32_t long_turn = 32;
  /// The numbers of the points where the first side of a triangle starts, where it ends, and of its
  /// apex.
  using Points = std::array<std::uint32_t, 3>;

  /// starts with a triangle, named by its first side.
  void start(std::uint32_t side) {
    triangles_.assign(1, {side, {0, 1, 2}});
    turns_.clear();
    size_ = 1;
    branch_ = none;
  }
  /*!
  \brief adds a strip of triangles, each of which is entered from the one before. A second strip
  branches off.
  \param input, fans the input, and the halfedges around its vertices, which must live as long as
    triangles are asked for
  \param parent the triangle from which the first one is entered
  \param entered the halfedges over which triangles are entered
  \complexity linear in the number of runs, and of triangles in short ones
  */
  void enter(const Input& input, const Vertex_fans& fans, std::uint32_t parent,
             std::span<const Crossing_run> entered);

  /// returns the number of triangles.
  std::uint32_t size() const { return size_; }
  /// returns the number of the triangle that was added last.
  std::uint32_t last() const { return size_ - 1; }
  /// returns the first side of a triangle, over which it is entered.
  std::uint32_t side(std::uint32_t n) const {
    if (is_stored(n)) return triangles_[n].side;
    const Turn& t = turn_at(n);
    if (n >= t.end) return triangles_[n - t.skipped].side;
    return Crossing_run::turned(*fans_, t.side, n - t.first, t.pivot_end == 1);
  }
  /// returns the points of a triangle. \complexity logarithmic in the number of long turns
  Points points(std::uint32_t n) const {
    if (is_stored(n)) return triangles_[n].points;
    const Turn& t = turn_at(n);
    if (n >= t.end) return triangles_[n - t.skipped].points;
    return t.pivot_end == 0 ? Points{t.pivot, n + 1, n + 2} : Points{n + 1, t.pivot, n + 2};
  }
  /// returns the triangle from which one is entered. \pre it is not the first triangle
  std::uint32_t parent(std::uint32_t n) const { return n == branch_ ? branches_from_ : n - 1; }

  /// returns the side of its parent over which a triangle is entered.
  unsigned exit_to(std::uint32_t child) const;
  /// returns the triangle that is entered from one over a side of it; none if there is none.
  std::uint32_t entered_over(std::uint32_t n, unsigned side) const;

  /// returns the number behind the last triangle of a turn that starts with triangle `n`: that has
  /// the same end of its first side, 0 or 1, as all in between.
  std::uint32_t end_of_turn(std::uint32_t n, unsigned end) const;

private:
  struct Triangle {
    std::uint32_t side;
    Points points;
  };
  // triangles about a common corner, the end of their first sides with a number
  struct Turn {
    std::uint32_t first, end; // the numbers of the first one, and behind the last one
    std::uint32_t skipped;    // number of triangles up to the last one that are not stored
    std::uint32_t side;       // of the first one
    std::uint32_t pivot;      // the corner
    unsigned pivot_end;
  };

  // Whether no long turn starts before a triangle: then its number is its place.
  bool is_stored(std::uint32_t n) const { return turns_.empty() || n < turns_.front().first; }
  // the last turn that does not start behind a triangle
  const Turn& turn_at(std::uint32_t n) const;

  void add(const Input& input, Triangle& last, std::uint32_t halfedge);
  void add_turn(Triangle& last, const Crossing_run& rest);

  const Vertex_fans* fans_ = nullptr;
  std::vector<Triangle> triangles_; // that are stored
  std::vector<Turn> turns_;         // long ones, in order
  std::uint32_t size_ = 0;
  std::uint32_t branch_ = none, branches_from_ = none; // the first triangle of the second strip
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TRIANGLE_STRIPS_H

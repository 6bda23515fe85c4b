// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Face_region.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/explicit_crossing_lists.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

/*!
\brief finds the curves that cross the edge from a corner of a face to a vertex inserted in it.

These are the curves between the corner and the region of the vertex: first the arcs about the corner,
then curves that emanate from another one, then the arcs about another corner which cut off the region,
from the outermost one.
\param k the corner
\param sides the sides of the face
\param normal their normal coordinates
\param c how curves run in the face
\param r the region of the vertex
\param append called as `append(h, first, last)` for ranges of curves that cross halfedge `h`, counted from its
source, in the order in which the edge crosses them, and so that they cross both from the same side: then the input
halfedges of the faces entered are those of `h`
*/
template <class Append>
void find_crossings_of_spoke(unsigned k, const std::array<std::uint32_t, 3>& sides,
                             const std::array<Normal_coordinate, 3>& normal,
                             const Corner_coordinates& c, const Face_region& r, Append append) {
  const unsigned next = (k + 1) % 3, before = (k + 2) % 3;
  append(sides[k], 0, r.cutting[k]);
  const bool on_fan = r.is_on_curve && r.corner == r.fan_corner;
  if (r.fan_corner == before) // its curves leave through the side from k, the first ones first
    append(sides[k], c.cutting[k], c.cutting[k] + r.right_of_fan);
  else if (r.fan_corner == next) { // through the side to k, the last ones first
    const Normal_coordinate crossed = c.emanating[next] - r.right_of_fan - (on_fan ? 1 : 0);
    append(sides[before] ^ 1U, c.cutting[k], c.cutting[k] + crossed);
  }
  for (const unsigned l : {next, before}) {
    const bool on_arc = r.is_on_curve && r.corner == l && r.fan_corner != l;
    const std::uint32_t to_l = l == next ? sides[k] : sides[before] ^ 1U;
    const Normal_coordinate n = crossings(normal[l == next ? k : before]);
    append(to_l, n - c.cutting[l], n - r.cutting[l] - (on_arc ? 1 : 0));
  }
}

} // namespace internal

/*!
\brief represents how an intrinsic triangulation lies on the input by the crossings themselves (§3.3 of
the course): each intrinsic edge lists the input edges that it crosses, in order.

This is the overlay of Fisher et al. 2007 with its faces left implicit: in one intrinsic face the curves
do not cross each other, so that the numbers of crossings on its three sides tell which of them are
joined (Eq. 9 and 10), and thus all vertices, edges and faces of the overlay in it. The overlay's edges
along a side are the gaps of its list, and those along curves join two crossings, or a corner and a
crossing. What no list tells, where curves start from vertices and along which edges they run, is kept
as in `Integer_coordinates`.

In this form the overlay has more than flips, which are all that has been described. A flip of ij
to km changes the list of that edge alone: a curve crosses km if it joins the two sides of the quad that
km separates, and where it meets those sides it is in their lists, in the order along km. A vertex inserted
in a face lies in one of the overlay's faces there, or on a curve: an edge from a corner to it crosses the
curves that separate the two, which meet the sides of the face, and runs along the curve if that starts
from the corner. Removal of a vertex of degree three undoes this. A vertex on an edge is one in a face of
no area, followed by a flip; a vertex on the border needs one new edge, which is found in the same
way. Whatever the new edge, its list is made of a few ranges of the lists of sides of faces. A vertex on
a curve cuts it in two, but lists name the input edge and need not know.

Flips cost time linear in the lists that they change. In return all that crosses an edge is at hand
without following curves; see `trace_edge()`.

\cgalModels{CurveCoordinates}
*/
class Explicit_crossings : public Integer_coordinates {
public:
  /// What the representation is called by programs.
  static constexpr const char* name = "crossings";

  /// observes the triangulation that the input is: every edge runs along itself.
  /// \complexity linear
  template <class Triangulation>
  void start(const Triangulation& t) {
    Integer_coordinates::start(t);
    lists_ = internal::Crossing_lists(number_of_edges());
  }

  /// takes coordinates of a triangulation that is restored, and follows all curves.
  /// \throws std::length_error see `edge_crossings()` \complexity linear in the number of edges and crossings
  template <class Triangulation>
  void restore(const Triangulation& t, Integer_coordinates coordinates) {
    const Edge_crossings all = edge_crossings(t, coordinates);
    lists_ = internal::Crossing_lists(coordinates.number_of_edges());
    for (std::uint32_t e = 0; e < coordinates.number_of_edges(); ++e)
      lists_.assign(e, all.entered_on(e));
    Integer_coordinates::restore(t, std::move(coordinates));
  }

  /// returns the input halfedges of the faces that intrinsic halfedge `2 * edge` enters, in order.
  std::span<const std::uint32_t> entered_on(std::uint32_t edge) const { return lists_[edge]; }
  /// returns the input halfedge of the face that intrinsic halfedge `h` enters after `position` others.
  std::uint32_t entered_by(std::uint32_t h, Normal_coordinate position) const {
    const std::span<const std::uint32_t> list = lists_[h / 2];
    const auto p = static_cast<std::size_t>(position);
    return h % 2 == 0 ? list[p] : list[list.size() - 1 - p] ^ 1U;
  }
  /// returns the input halfedge that intrinsic halfedge `h` runs along, or along a part of which; none
  /// if it runs across faces.
  std::uint32_t along(std::uint32_t h) const {
    return normal_coordinate(h / 2) < 0 ? fans().halfedge(roundabout(h)) : Gluing::none;
  }

  /// announces a flip. \return whether the number of crossings stays in bounds
  /// \complexity linear in the number of crossings of the new edge
  template <class Triangulation>
  bool before(const Triangulation&, const Flip& move) {
    const Normals left = normals({move.ij, move.jk, move.ki}),
                  right = normals({move.ij, move.im, move.mj});
    const Corner_coordinates f = corner_coordinates(left), g = corner_coordinates(right);
    if (!before_flip(move, f, g)) return false;
    // Curves that cross km have one end on the path k, i, m around the quad, without k and m, and the other on the path
    // k, j, m. Seen from ki and im, all do but those arcs about i, counted from i along ij, that are arcs about i on
    // the other side too, or end there at the opposite corner: they are last on ki and first on im. Between ki and im
    // the curves from i cross: to jk, along ij, to mj.
    std::vector<std::uint32_t>& list = announced_[0];
    list.clear();
    Appender append{*this, list};
    const Normal_coordinate n_ki = crossings(left[2]), n_im = crossings(right[1]);
    append(move.ki, 0, n_ki - std::min(f.cutting[0], g.cutting[1] + g.emanating[2]));
    append(move.jk ^ 1U, f.cutting[2], f.cutting[2] + f.emanating[0]);
    if (left[0] < 0) list.push_back(along(move.ij ^ 1U));
    append(move.mj ^ 1U, g.cutting[0], g.cutting[0] + g.emanating[1]);
    append(move.im, std::min(g.cutting[1], f.cutting[0] + f.emanating[2]), n_im);
    return true;
  }
  /// follows a flip.
  template <class Triangulation>
  void after(const Triangulation& t, const Flip& move) {
    Integer_coordinates::after(t, move);
    store(move.km, announced_[0]);
  }

  /// announces the insertion of a vertex in a face. \return see `Integer_coordinates`
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_in_face& move) {
    if (!Integer_coordinates::before(t, move)) return false;
    find_spokes(move.sides);
    return true;
  }
  /// follows the insertion of a vertex in a face.
  template <class Triangulation>
  void after(const Triangulation& t, const Insertion_in_face& move) {
    Integer_coordinates::after(t, move);
    lists_.grow(number_of_edges());
    for (std::size_t k = 0; k < 3; ++k) store(move.spokes[k], announced_[k]);
  }

  /// announces the insertion of a vertex on the border. \return see `Integer_coordinates`
  template <class Triangulation>
  bool before(const Triangulation& t, const Insertion_on_border& move) {
    if (!Integer_coordinates::before(t, move)) return false;
    find_spokes({move.ip, move.jk, move.ki});
    return true;
  }
  /// follows the insertion of a vertex on the border.
  template <class Triangulation>
  void after(const Triangulation& t, const Insertion_on_border& move) {
    Integer_coordinates::after(t, move);
    lists_.grow(number_of_edges()); // parts of the border edge are crossed by nothing
    store(move.pk ^ 1U, announced_[2]);
  }

  /// announces the removal of a vertex of degree three. \return see `Integer_coordinates`
  template <class Triangulation>
  bool before(const Triangulation& t, const Removal_from_face& move) {
    if (!Integer_coordinates::before(t, move)) return false;
    for (const std::uint32_t s : move.spokes) lists_.clear(s / 2);
    return true;
  }
  /// announces the removal of a vertex from the border. \return see `Integer_coordinates`
  template <class Triangulation>
  bool before(const Triangulation& t, const Removal_from_border& move) {
    if (!Integer_coordinates::before(t, move)) return false;
    lists_.clear(move.pk / 2);
    return true;
  }
  using Integer_coordinates::after; // of removals

private:
  // Appends input halfedges entered by a halfedge to a list.
  struct Appender {
    const Explicit_crossings& from;
    std::vector<std::uint32_t>& list;

    void operator()(std::uint32_t h, Normal_coordinate first, Normal_coordinate last) {
      if (first >= last) return;
      const std::span<const std::uint32_t> all = from.lists_[h / 2];
      if (h % 2 == 0) {
        list.insert(list.end(), all.begin() + first, all.begin() + last);
      } else {
        for (Normal_coordinate i = first; i < last; ++i)
          list.push_back(all[all.size() - 1 - static_cast<std::size_t>(i)] ^ 1U);
      }
    }
  };

  void find_spokes(const std::array<std::uint32_t, 3>& sides) {
    const Normals n = normals(sides);
    const Corner_coordinates c = corner_coordinates(n);
    for (unsigned k = 0; k < 3; ++k) {
      announced_[k].clear();
      internal::find_crossings_of_spoke(k, sides, n, c, region_of_insertion(),
                                        Appender{*this, announced_[k]});
    }
  }

  // lists are stored along even halfedges
  void store(std::uint32_t h, std::vector<std::uint32_t>& list) {
    CGAL_assertion(list.size() ==
                   static_cast<std::size_t>(crossings(normal_coordinate(h / 2)))); // Eq. 13
    if (h % 2 != 0) {
      std::reverse(list.begin(), list.end());
      for (std::uint32_t& x : list) x ^= 1U;
    }
    lists_.assign(h / 2, list);
  }

  internal::Crossing_lists lists_;
  // lists of new edges of the move that has been announced
  std::array<std::vector<std::uint32_t>, 3> announced_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_EXPLICIT_CROSSINGS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a triangulation may know the places of inserted vertices on its input.
template <class Triangulation>
concept Knows_places = Triangulation::has_correspondence && requires(const Triangulation& t) {
  t.places();
};

/*!
Knows which points of a double cover are copies of one point of the user's faces: the front and the back of a face, by
name 2f and 2f + 1, and all edges of the cover that lie over one edge of the user.

To change sides is an isometry of the cover away from *seams*: front and back of two faces that meet at an edge are
glued by front to front and back to back. Where k > 2 faces meet, the front of the first is glued to the second, but
its back to the last. So edges that have not two faces are seams: those with one, over which a tufted cover turns to the other
side, too, as there a point and its copy are as near to each other as they are to the edge.
*/
class Sheets {
public:
  // \complexity linear
  explicit Sheets(const Input& input) : input_(input), is_cover_(has_two_sides()) {}

  // whether there are two sides
  bool is_cover() const { return is_cover_; }

  // Marks the edges of the cover that are seams, but those that make an angle below 60 degrees with
  // another, and those over the same edges. \complexity linear
  std::vector<char> wide_seams() const;

  // the other points that are copies of the same point as `p`, each once
  std::vector<Surface_point> others(Surface_point p) const;

  // one of the copies of a point, the same for all of them
  std::pair<std::uint32_t, std::array<double, 3>> name(const Surface_point& p) const;

private:
  // the same side of the back of a face as that of its front, and the other way round: it runs against it
  std::uint32_t other_side(std::uint32_t h) const;
  std::uint32_t other_face(std::uint32_t f) const;
  std::array<std::uint32_t, 3> sides_of(std::uint32_t f) const;

  // whether sides are changed at an edge other than by an isometry; an edge of the border is no
  // seam
  bool is_seam(std::uint32_t edge) const;

  // The edges over the user's edge that one lies over: a halfedge of each, the given one first; all run along it in one
  // direction.
  // \param most how many are wanted at most
  std::vector<std::uint32_t>
  edges_over(std::uint32_t h, std::size_t most = std::numeric_limits<std::size_t>::max()) const;

  Surface_point with_zero_last(Surface_point p) const;

  std::pair<std::uint32_t, std::array<double, 3>> name_here(Surface_point p) const;

  // whether faces are front and back of each other, by their names and the rows of their corners
  bool has_two_sides() const;

  const Input& input_;
  bool is_cover_;
};

/*!
Finds out which inserted vertices lie over one point of the user's faces; they are told one after the other.
\tparam Coordinates know where vertices are
*/
template <class Coordinates>
class First_copies {
public:
  // \complexity linear
  explicit First_copies(const Input& input) : input_(input), sheets_(input) {}

  // whether the coordinates are about the same input as before
  bool is_about(const Coordinates& coordinates) const { return &input_ == &coordinates.input(); }

  /*!
  \param i number of an inserted vertex, from the first; higher than those before
  \return the first vertex at the same point
  \complexity logarithmic
  */
  std::uint32_t operator()(std::uint32_t i, const Coordinates& coordinates) {
    if (!sheets_.is_cover()) return i;
    const auto name = [&](std::uint32_t n) {
      return sheets_.name(coordinates.location(input_.number_of_vertices() + n));
    };
    const auto here = name(i);
    const auto [place, is_new] = by_place_.insert({here, i});
    if (!is_new && name(place->second) != here) place->second = i; // that one was moved away
    return place->second;
  }

private:
  const Input& input_;
  Sheets sheets_;
  std::map<std::pair<std::uint32_t, std::array<double, 3>>, std::uint32_t> by_place_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_triangulations/correspondence/Sheets_impl.h>
#endif

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H

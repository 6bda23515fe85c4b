// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether a triangulation may store the places of inserted vertices on its input.
template <class Triangulation>
concept Knows_places = Triangulation::has_correspondence && requires(const Triangulation& t) {
  t.places();
};

/*!
Finds the points of a double cover that are copies of one point of the user's faces: on the front
and the back of a face, by name 2f and 2f + 1, and on all edges of the cover over one edge of the
user.

Exchanging front and back is an isometry of the cover away from *seams*: front and back of two faces
that meet at an edge are glued by front to front and back to back. Where k > 2 faces meet, the front
of the first is glued to the second, but its back to the last. So edges with more than two faces are
seams, and so are edges with one face, over which a tufted cover turns to the other side: a point
near the edge is close to its copy.
*/
class Sheets {
public:
  // \complexity linear
  explicit Sheets(const Input& input) : input_(input), is_cover_(has_two_sides()) {}

  const Input& input() const { return input_; }
  // whether there are two sides
  bool is_cover() const { return is_cover_; }

  // Marks the seams of the cover, except those that make an angle below 60 degrees with another
  // seam, and those over the same edges. \complexity linear
  std::vector<char> wide_seams() const;

  // the other points that are copies of the same point as `p`, each once
  std::vector<Surface_point> others(Surface_point p) const;

  // one of the copies of a point, the same for all of them
  std::pair<std::uint32_t, std::array<double, 3>> name(const Surface_point& p) const;

  // the same side of the back of a face as that of its front, and the other way round: it runs
  // against it
  std::uint32_t other_side(std::uint32_t h) const;

  // The edges over the same edge of the user: a halfedge of each, the given one first; all run in
  // one direction.
  // \param most the maximal number of edges
  std::vector<std::uint32_t>
  edges_over(std::uint32_t h, std::size_t most = std::numeric_limits<std::size_t>::max()) const;

  // whether an edge is a seam; border edges are not
  bool is_seam(std::uint32_t edge) const;

  // Whether more than two faces meet at some edge. There, exchanging front and back changes
  // distances.
  // \complexity linear
  bool has_branches() const;

  // Marks one of the front and the back of each face: the front of the first one by name, and on
  // from there to neighbours, but not over seams.
  // \complexity linear
  std::vector<char> one_sheet() const;

private:
  std::uint32_t other_face(std::uint32_t f) const;
  std::array<std::uint32_t, 3> sides_of(std::uint32_t f) const;

  Surface_point with_zero_last(Surface_point p) const;

  std::pair<std::uint32_t, std::array<double, 3>> name_here(Surface_point p) const;

  // whether faces are front and back of each other, by their names and the rows of their corners
  bool has_two_sides() const;

  const Input& input_;
  bool is_cover_;
};

// Counts the inserted vertices without the gaps that removals leave in their numbers: rows of
// matrices, in the order of the numbers. On a cover, the copies of a vertex have one row, that of
// the first of them. Counting is lazy: the next query counts new vertices, and those after a
// removed one (on a cover, all).
// \tparam Coordinates store where inserted vertices are
template <class Coordinates>
class Vertex_rows {
public:
  // observes moves like a correspondence
  template <class Triangulation>
  void start(const Triangulation& t) {
    first_ = t.input().number_of_vertices();
    first_row_ = t.input().number_of_rows();
    is_cover_ = Triangulation::has_correspondence && t.input().names().is_cover();
    for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
      if (t.is_inserted(v)) set(t.index(v), true);
  }
  template <class Triangulation>
  void restore(const Triangulation& t, const Coordinates&) {
    start(t);
  }
  template <class Triangulation, class Move>
  bool before(const Triangulation&, const Move&) const {
    return true;
  }
  template <class Triangulation, class Move>
  void make_room(const Triangulation& t, const Move&) {
    if constexpr (!std::is_same_v<Move, Flip>)
      reserve_at_least(is_there_, t.numbers().vertex_capacity(t.mesh()) + std::size_t{1} - first_);
  }
  template <class Triangulation, class Move>
  void after(const Triangulation&, const Move& move) noexcept {
    constexpr bool is_insertion =
        std::is_same_v<Move, Insertion_in_face> || std::is_same_v<Move, Insertion_on_border>;
    if constexpr (is_insertion || std::is_same_v<Move, Removal_from_face> ||
                  std::is_same_v<Move, Removal_from_border>)
      set(move.vertex, is_insertion);
  }

  // \param t the triangulation that has the rows
  template <class Triangulation>
  std::uint32_t row(std::uint32_t number, const Triangulation& t) const {
    count(t);
    return row_[number - first_];
  }
  template <class Triangulation>
  std::uint32_t number_of_rows(const Triangulation& t) const {
    if (!is_cover_) return first_row_ + count_;
    count(t);
    return first_row_ + counted_rows_;
  }

private:
  // The first inserted vertex at each point of the user's faces. Not copied: it refers to an input,
  // and the copy may have another one.
  struct First_copies {
    std::unique_ptr<const Sheets> sheets;
    std::map<std::pair<std::uint32_t, std::array<double, 3>>, std::uint32_t> by_place;

    First_copies() = default;
    First_copies(const First_copies&) {}
    First_copies(First_copies&&) = default;
    First_copies& operator=(First_copies other) noexcept {
      sheets = std::move(other.sheets);
      by_place = std::move(other.by_place);
      return *this;
    }
  };

  // the number of a vertex that is inserted, or removed
  void set(std::uint32_t number, bool is_inserted) {
    const std::uint32_t i = number - first_;
    if (i >= is_there_.size()) is_there_.resize(i + 1, 0);
    is_there_[i] = is_inserted ? 1 : 0;
    forget_from(i);
    if (is_inserted)
      ++count_;
    else
      --count_;
  }

  // The rows of this vertex and of all after it may change. On a cover all rows may change, since
  // another copy may be the first.
  void forget_from(std::size_t i) {
    if (i >= row_.size()) return;
    if (is_cover_) i = 0;
    counted_rows_ = row_[i] - first_row_;
    row_.resize(i);
    copies_ = First_copies();
  }

  // gives rows to those that have none
  template <class Triangulation>
  void count(const Triangulation& t) const {
    if (row_.size() == is_there_.size()) return;
    const Coordinates* const coordinates = is_cover_ ? t.places() : nullptr;
    if (coordinates != nullptr &&
        !(copies_.sheets && &copies_.sheets->input() == &coordinates->input())) {
      row_.clear();
      counted_rows_ = 0;
      copies_ = First_copies();
      copies_.sheets = std::make_unique<const Sheets>(coordinates->input());
    }
    while (row_.size() < is_there_.size()) {
      const auto i = static_cast<std::uint32_t>(row_.size());
      const bool is_there = is_there_[i] != 0;
      const std::uint32_t first =
          is_there && coordinates != nullptr ? first_copy(i, *coordinates) : i;
      row_.push_back(first == i ? first_row_ + counted_rows_ : row_[first]);
      if (first == i && is_there) ++counted_rows_;
    }
  }

  // The first inserted vertex at the point of number `i`; calls come with ascending `i`.
  std::uint32_t first_copy(std::uint32_t i, const Coordinates& coordinates) const {
    if (!copies_.sheets->is_cover()) return i;
    const auto name = [&](std::uint32_t n) {
      return copies_.sheets->name(coordinates.location(first_ + n));
    };
    const auto here = name(i);
    const auto [place, is_new] = copies_.by_place.insert({here, i});
    if (!is_new && name(place->second) != here) place->second = i; // that one was moved away
    return place->second;
  }

  std::uint32_t first_ = 0, first_row_ = 0, count_ = 0;
  bool is_cover_ = false;
  std::vector<std::uint8_t> is_there_;
  // of the first so many vertices, and the number of them
  mutable std::vector<std::uint32_t> row_;
  mutable std::uint32_t counted_rows_ = 0;
  mutable First_copies copies_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SHEETS_H

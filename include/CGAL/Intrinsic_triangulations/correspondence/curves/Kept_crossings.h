// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_KEPT_CROSSINGS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_KEPT_CROSSINGS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Crossing_run.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Edge_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/reserve_at_least.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief keeps a short list of runs of crossings per edge.

A record stores up to two runs, enough for most edges. A longer list is in a block of one array; its
length determines the size of the block, a power of two. Free blocks are linked per size. So changes
of a list seldom allocate memory, and a copy copies two arrays.
*/
class Crossing_lists {
public:
  /// constructs no lists.
  Crossing_lists() { free_.fill(none); }
  /// constructs `count` empty lists.
  explicit Crossing_lists(std::size_t count) : Crossing_lists() { grow(count); }

  /// makes sure that there are `count` lists; new ones are empty.
  void grow(std::size_t count) {
    if (count > lists_.size()) lists_.resize(count);
  }

  /// returns a list, valid until one is changed.
  std::span<const Crossing_run> operator[](std::size_t i) const {
    const List& l = lists_[i];
    return {l.size <= short_size ? l.data.data() : block(l), l.size};
  }

  /// makes room for `count` lists.
  void make_room(std::size_t count) { reserve_at_least(lists_, count); }
  /// makes room for new lists in place of old ones. \param sizes the lengths of the new ones
  void make_room_for(const std::array<std::size_t, 3>& sizes) {
    std::size_t all = blocks_.size();
    for (const std::size_t size : sizes)
      if (size > short_size)
        all += std::size_t{unit} << block_class(static_cast<std::uint32_t>(size));
    reserve_at_least(blocks_, all);
  }

  /// replaces a list; allocates no memory if there is room for the new one, or if it goes back to
  /// the length that it had before the last change. \pre `runs` are not in another list
  /// \complexity linear in its length
  void assign(std::size_t i, std::span<const Crossing_run> runs) {
    List& l = lists_[i];
    const auto size = static_cast<std::uint32_t>(runs.size());
    if (l.size > short_size || size > short_size) change_block(l, size);
    l.size = size;
    std::copy(runs.begin(), runs.end(), size <= short_size ? l.data.data() : block(l));
  }

  /// empties a list.
  void clear(std::size_t i) { assign(i, {}); }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t short_size = 2;
  static constexpr std::uint32_t unit = 4; // size of the smallest block

  struct List {
    std::uint32_t size = 0;
    // the first of the first one is the place of a block, in units
    std::array<Crossing_run, short_size> data{};
  };

  // blocks of class c have 2^c units
  static unsigned block_class(std::uint32_t size) {
    return static_cast<unsigned>(std::bit_width((size - 1) / unit));
  }
  const Crossing_run* block(const List& l) const {
    return blocks_.data() + std::size_t{unit} * l.data[0].first();
  }
  Crossing_run* block(const List& l) {
    return blocks_.data() + std::size_t{unit} * l.data[0].first();
  }

  void change_block(List& l, std::uint32_t size) {
    const bool had = l.size > short_size, has = size > short_size;
    if (had && has && block_class(l.size) == block_class(size)) return;
    const std::uint32_t taken = has ? take(block_class(size)) : none;
    if (had) give_back(l.data[0].first(), block_class(l.size));
    l.data[0] = {taken, 0};
  }

  std::uint32_t take(unsigned c) {
    const std::uint32_t first = free_[c];
    if (first != none) {
      free_[c] = blocks_[std::size_t{unit} * first].first();
      return first;
    }
    const auto place = static_cast<std::uint32_t>(blocks_.size() / unit);
    blocks_.resize(blocks_.size() + (std::size_t{unit} << c));
    return place;
  }

  void give_back(std::uint32_t place, unsigned c) {
    blocks_[std::size_t{unit} * place] = {free_[c], 0};
    free_[c] = place;
  }

  std::vector<List> lists_;
  std::vector<Crossing_run> blocks_;
  std::array<std::uint32_t, 32> free_; // first free block of each class; it names the next one
};

/*!
\brief finds the curves that cross the edge from a corner of a face to a vertex inserted in it.

These are the curves between the corner and the region of the vertex: first the arcs about the
corner, then curves that emanate from another one, then the arcs about another corner which cut off
the region, from the outermost one.
\param k the corner
\param sides the sides of the face
\param normal their normal coordinates
\param c how curves run in the face
\param r the region of the vertex
\param append called as `append(h, first, last)` for ranges of curves that cross halfedge `h`,
  counted from its source, in the order in which the edge crosses them, and so that they cross both
  from the same side: then the input halfedges of the faces entered are those of `h`
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

/*!
\brief keeps the input halfedges that each intrinsic edge crosses, see `Explicit_crossings`, once
following curves has taken as long as storing them (see `decide()`); nothing before. Its owner has
the normal coordinates and announces moves.

It stores them as runs. A part of 11,656 faces, half of them slivers with a common corner, has 17
million crossings once it is refined to 25 degrees: one by one they took 128 megabytes, and moving
them a third of the time of refinement.
*/
class Kept_crossings {
public:
  /// Normal coordinates of three sides.
  using Normals = std::array<Normal_coordinate, 3>;
  /// What an edge crosses.
  using Runs = std::vector<Crossing_run>;

  /// tells whether crossings are kept. All functions below except the next three require it.
  explicit operator bool() const { return are_kept_; }

  /// keeps crossings permanently, from a triangulation without crossings on.
  void keep_always(std::size_t number_of_edges);
  /// keeps crossings permanently, starting with the given ones.
  void keep_always(const Vertex_fans& fans, const Edge_crossings& all);

  /*!
  \brief decides whether to keep crossings.

  It stores all crossings once following curves has taken as long as storing them would: otherwise
  the time of insertions would grow with the length of the followed edges. It drops lists that get
  long, since moves change them.
  \param t, coordinates the triangulation, its coordinates
  \param steps number of steps taken along curves since the last call
  \complexity constant, amortized over these steps
  */
  template <class Triangulation, class Coordinates>
  void decide(const Triangulation& t, const Coordinates& coordinates, std::size_t steps) {
    if (is_decided_) return;
    const std::size_t edges = coordinates.number_of_edges();
    steps_ += steps;
    if (are_kept_) {
      forget_beyond(edges, 0);
    } else if (steps_ > patience * edges) {
      steps_ = 0;
      keep_if_few(t, coordinates, most(edges));
    }
  }
  /// keeps crossings, unless there are more than so many.
  template <class Triangulation, class Coordinates>
  void keep_if_few(const Triangulation& t, const Coordinates& coordinates, std::size_t most) {
    if (are_kept_) return;
    std::size_t all = 0;
    for (std::uint32_t e = 0; e < coordinates.number_of_edges(); ++e)
      all += static_cast<std::size_t>(crossings(coordinates.normal_coordinate(e)));
    if (all <= most) keep(coordinates.fans(), follow_rows_of_curves(t, coordinates));
  }

  /// forgets crossings that need not be kept, if there are too many together with `more` of them on
  /// an edge to come.
  void forget_beyond(std::size_t edges, Normal_coordinate more);

  /// visits the runs of input halfedges of the faces that intrinsic halfedge `h` enters, from one
  /// position to another.
  template <std::invocable<const Crossing_run&> Visit>
  void for_each_run_of(const Vertex_fans& fans, std::uint32_t h, Normal_coordinate first,
                       Normal_coordinate last, const Visit& visit) const {
    for_each_run(fans, lists_[h / 2], h % 2 != 0, static_cast<std::uint32_t>(first),
                 static_cast<std::uint32_t>(last), visit);
  }

  /*!
  \brief finds the crossings of the edge that a flip makes.
  \param fans the halfedges around the vertices of the input
  \param f, g how curves run in the two faces, with corners i, j, k and j, i, m
  \param n_ki, n_im numbers of crossings of these edges
  \param along the input halfedge along which ji runs; none if it runs across faces
  */
  void announce(const Vertex_fans& fans, const Flip& move, const Corner_coordinates& f,
                const Corner_coordinates& g, Normal_coordinate n_ki, Normal_coordinate n_im,
                std::uint32_t along);
  /// makes room for the announced crossings, before they are stored.
  void make_room() {
    lists_.make_room_for({announced_[0].size(), announced_[1].size(), announced_[2].size()});
  }
  /// makes room for the crossings of so many edges, too.
  void make_room(std::size_t number_of_edges) {
    make_room();
    lists_.make_room(number_of_edges);
  }
  /// stores the announced crossings of a flip, whose new edge has `n` of them.
  void store(const Vertex_fans& fans, const Flip& move, Normal_coordinate n);

  /// finds the crossings of the edges from the corners of a face to a region of it.
  void announce(const Vertex_fans& fans, const std::array<std::uint32_t, 3>& sides,
                const Normals& normals, const Face_region& region);
  /// stores the announced `n` crossings of the edge from corner `k`, whose halfedge starts there.
  void store_spoke(const Vertex_fans& fans, unsigned k, std::uint32_t halfedge,
                   Normal_coordinate n) {
    store(fans, halfedge, n, announced_[k]);
  }
  /// forgets crossings that need not be kept.
  void forget();

  /// makes room for edges without crossings.
  void grow(std::size_t number_of_edges) { lists_.grow(number_of_edges); }
  /// removes the crossings of a removed edge.
  void clear(std::uint32_t edge) {
    size_ -= lists_[edge].size();
    lists_.clear(edge);
  }

private:
  // Steps per edge after which storing is tried, and the most crossings per edge, on average. They
  // bound time and memory at worst: refining 13 meshes of the data set, three of them stretched by
  // 100, takes as long with any value.
  static constexpr std::size_t patience = 32, most_per_edge = 128;
  // So many are always few: 128 megabytes, while curves are followed.
  static constexpr std::size_t always_few = std::size_t(1) << 25U;
  static std::size_t most(std::size_t edges) { return std::max(most_per_edge * edges, always_few); }

  void keep(const Vertex_fans& fans, const Edge_crossings& all);

  // Appends input halfedges entered by a halfedge to a list.
  struct Appender {
    const Kept_crossings& from;
    const Vertex_fans& fans;
    Runs& list;

    void operator()(std::uint32_t h, Normal_coordinate first, Normal_coordinate last) const {
      if (first < last)
        from.for_each_run_of(fans, h, first, last,
                             [this](const Crossing_run& r) { append_run(fans, list, r); });
    }
  };

  // lists are stored along even halfedges
  void store(const Vertex_fans& fans, std::uint32_t h, [[maybe_unused]] Normal_coordinate n,
             Runs& list);

  bool are_kept_ = false, is_decided_ = false;
  std::size_t steps_ = 0; // since it was last decided
  Crossing_lists lists_;
  std::size_t size_ = 0; // number of runs
  // lists of new edges of the move that has been announced
  std::array<Runs, 3> announced_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_KEPT_CROSSINGS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_VERTEX_FANS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_VERTEX_FANS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <concepts>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief numbers the curves that start from each vertex, counterclockwise: the order of roundabouts
(§3.5.2 of the course).

A *slot* is the number of a curve at its start. Slots of one fan of faces at a vertex are
consecutive; a nonmanifold vertex has several fans. A vertex that was inserted on an input edge has
a fan of the two parts of that edge.
*/
class Vertex_fans {
public:
  /// constructs no fans.
  Vertex_fans() = default;

  /*!
  \brief numbers the halfedges around the vertices of `input`.
  \complexity linear
  */
  explicit Vertex_fans(const Input& input);

  /// returns the bound of the numbers of slots.
  std::uint32_t number_of_slots() const { return static_cast<std::uint32_t>(halfedge_.size()); }

  /// returns the slot of an input halfedge at its source.
  std::uint32_t slot(std::uint32_t halfedge) const { return slot_[halfedge]; }

  /// returns the input halfedge along which the curve of a slot starts; one that starts on an edge
  /// runs along a part of it.
  std::uint32_t halfedge(std::uint32_t slot) const { return halfedge_[slot]; }

  /// returns the slot that is `count` places counterclockwise from `slot`.
  std::uint32_t advance(std::uint32_t slot, std::uint32_t count) const {
    const Fan& fan = fan_[slot];
    if (count > fan.size) count %= fan.size; // seldom: a division takes longer than all the rest
    std::uint32_t place = slot - fan.begin + count;
    while (place >= fan.size) place -= fan.size;
    return fan.begin + place;
  }
  /// returns the slot that is `count` places clockwise from `slot`.
  std::uint32_t retreat(std::uint32_t slot, std::uint32_t count) const {
    const Fan& fan = fan_[slot];
    if (count > fan.size) count %= fan.size;
    std::uint32_t place = slot - fan.begin;
    while (place < count) place += fan.size;
    return fan.begin + (place - count);
  }

  /// returns the first slot of the fan of a slot.
  std::uint32_t first_slot(std::uint32_t slot) const { return fan_[slot].begin; }
  /// returns the number of slots of the fan of a slot.
  std::uint32_t degree(std::uint32_t slot) const { return fan_[slot].size; }

  /// returns how many places counterclockwise from slot `from` slot `to` is; the number of slots of
  /// the fan or more if they are in different fans.
  std::uint32_t distance(std::uint32_t from, std::uint32_t to) const {
    const Fan &f = fan_[from], &g = fan_[to];
    if (f.begin != g.begin) return Gluing::none;
    return to >= from ? to - from : f.size - (from - to);
  }

  /// makes room for the fan of a vertex on an edge, or for the removal of one.
  /// \complexity constant, amortized
  void make_room();
  /*!
  \brief adds the fan of a vertex on an edge; allocates no memory if there is room for it.
  \param halfedge the input halfedge of which the first slot is a part; the other one runs the other
    way
  \return the first slot; the other one is the next number
  */
  std::uint32_t add_fan_on_edge(std::uint32_t halfedge);

  /// removes a fan that `add_fan_on_edge()` added, of which `slot` is one slot; allocates no memory
  /// if there is room.
  void remove_fan(std::uint32_t slot) { free_.push_back(fan_[slot].begin); }

private:
  struct Fan {
    std::uint32_t begin, size;
  };

  void add_fan(const Input& input, std::uint32_t first);

  std::vector<std::uint32_t> slot_;     // per input halfedge
  std::vector<std::uint32_t> halfedge_; // per slot
  std::vector<Fan> fan_;                // per slot
  std::vector<std::uint32_t> free_;     // fans on edges that were removed
};

/*!
\brief requires integers that describe how the edges of the input run over the intrinsic
triangulation.

Syntax of \ref ::CurveCoordinates, which describes its meaning.
*/
template <class Coordinates>
concept CurveCoordinates = requires(const Coordinates& c, std::uint32_t i) {
  { c.input() } -> std::same_as<const Input&>;
  { c.fans() } -> std::same_as<const Vertex_fans&>;
  { c.number_of_edges() } -> std::same_as<std::uint32_t>;
  { c.normal_coordinate(i) } -> std::same_as<Normal_coordinate>;
  { c.roundabout(i) } -> std::same_as<std::uint32_t>;
  { c.is_inserted(i) } -> std::same_as<bool>;
  { c.location(i) } -> std::same_as<const Surface_point&>;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_VERTEX_FANS_H

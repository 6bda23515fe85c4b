// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINTS_AT_PLACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINTS_AT_PLACES_H

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds points with equal coordinates, by an open hash table of their numbers; the points are
// stored elsewhere. A table of the standard library, which holds each point in a block of its own,
// took three times as long for the corners of an STL file.
class Points_at_places {
public:
  using Point = std::array<double, 3>;

  // Returns the number of a point at a place; if there is none, adds the number of a new one.
  // \param point_of returns the point of a number that was added
  template <class Point_of>
  std::uint32_t find_or_add(const Point& place, std::uint32_t number, const Point_of& point_of) {
    if (2 * size_ >= slots_.size()) grow(point_of);
    std::uint32_t& slot = slots_[slot_of(place, point_of)];
    if (slot != none) return slot;
    ++size_;
    return slot = number;
  }

private:
  static constexpr std::uint32_t none = 0xffffffffU;

  // Zeros of both signs are one number, as for ==.
  static std::uint64_t hash(const Point& p) {
    std::uint64_t h = 0;
    for (const double x : p) {
      h = (h ^ (x == 0 ? 0 : std::bit_cast<std::uint64_t>(x))) *
          0x9e3779b97f4a7c15U; // golden ratio
      h ^= h >> 32U;           // coordinates of few digits differ in their upper bits
    }
    return h * 0x9e3779b97f4a7c15U; // its upper bits depend on all others
  }
  template <class Point_of>
  std::size_t slot_of(const Point& place, const Point_of& point_of) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t i = hash(place) >> (65 - std::bit_width(slots_.size()));
    while (slots_[i] != none && point_of(slots_[i]) != place) i = (i + 1) & mask;
    return i;
  }
  template <class Point_of>
  void grow(const Point_of& point_of) {
    const std::size_t slots = slots_.empty() ? 64 : 4 * slots_.size();
    const std::vector<std::uint32_t> old =
        std::exchange(slots_, std::vector<std::uint32_t>(slots, none));
    for (const std::uint32_t n : old)
      if (n != none) slots_[slot_of(point_of(n), point_of)] = n;
  }

  std::vector<std::uint32_t> slots_; // as many as a power of two
  std::size_t size_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_POINTS_AT_PLACES_H

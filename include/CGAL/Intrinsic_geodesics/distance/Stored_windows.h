// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_STORED_WINDOWS_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_STORED_WINDOWS_H

#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief keeps the windows that look into faces, 32 bytes each, in a list per side.

The ends of intervals are rounded outwards to multiples of 2^-32 of the side, the ends of the side exactly. A path through
what is added to an interval passes a vertex on the wrong side by that much: it is too short by the square of it, as a rule.
*/
class Stored_windows {
public:
  /// A window without what its side tells.
  struct Record {
    Plane_vector<double> image; ///< the source, in the frame of the side
    std::uint32_t begin;        ///< of the interval, in units of the side
    std::uint32_t end;          ///< of the interval
    std::uint32_t source;       ///< number of the source
    std::uint32_t next;         ///< another window of the side, or `Gluing::none`
  };

  /// forgets all windows, and makes room for those of a number of sides.
  void keep(std::size_t sides) {
    blocks_.clear();
    first_.assign(sides, Gluing::none);
    size_ = 0;
  }
  /// tells whether windows are kept.
  bool are_kept() const { return !first_.empty(); }
  /// adds a window to a side with a length.
  void add(const Window& w, std::uint32_t side, double length) {
    if (size_ % block_size == 0)
      blocks_.push_back(std::make_unique_for_overwrite<Record[]>(block_size));
    at(size_) = {w.image, rounded(w.begin / length * units), rounded(w.end / length * units + 1),
                 w.source, first_[side]};
    first_[side] = size_++;
  }
  /// calls a function with a window after the other that look through a side.
  template <class Function>
  void for_each(std::uint32_t side, const Function& f) const {
    for (std::uint32_t i = first_[side]; i != Gluing::none; i = at(i).next) f(at(i));
  }
  /// returns where an interval begins or ends on a side with a length.
  static double place(std::uint32_t end, double length) {
    return end == largest ? length : end / units * length;
  }
  /// returns the number of windows.
  std::size_t size() const { return size_; }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return blocks_.size() * block_size * sizeof(Record) + first_.size() * sizeof(std::uint32_t);
  }

private:
  static constexpr std::uint32_t block_size = 1U << 13U;
  static constexpr std::uint32_t largest = 0xffffffffU;
  static constexpr double units = largest;

  static std::uint32_t rounded(double x) { // downwards
    return static_cast<std::uint32_t>(std::clamp(x, 0.0, units));
  }
  Record& at(std::uint32_t i) const { return blocks_[i / block_size][i % block_size]; }

  std::vector<std::unique_ptr<Record[]>> blocks_;
  std::vector<std::uint32_t> first_; // per side
  std::uint32_t size_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_STORED_WINDOWS_H

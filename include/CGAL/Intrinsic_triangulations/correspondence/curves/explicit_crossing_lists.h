// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CROSSING_LISTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CROSSING_LISTS_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*!
\brief keeps a short list of numbers per edge.

A list of up to three is kept in its record, which is all that most edges need; a longer one in a block
of one array, whose size is a power of two and follows from the length. Blocks that are given back are
linked per size. Thus a change of a list seldom allocates memory, and a copy is that of two arrays.
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
  std::span<const std::uint32_t> operator[](std::size_t i) const {
    const List& l = lists_[i];
    return {l.size <= short_size ? l.data.data() : block(l), l.size};
  }

  /// replaces a list. \pre `values` are not in another list \complexity linear in its length
  void assign(std::size_t i, std::span<const std::uint32_t> values) {
    List& l = lists_[i];
    const auto size = static_cast<std::uint32_t>(values.size());
    if (l.size > short_size || size > short_size) change_block(l, size);
    l.size = size;
    std::copy(values.begin(), values.end(), size <= short_size ? l.data.data() : block(l));
  }

  /// empties a list.
  void clear(std::size_t i) { assign(i, {}); }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::uint32_t short_size = 3;
  static constexpr std::uint32_t unit = 4; // size of the smallest block

  struct List {
    std::uint32_t size = 0;
    std::array<std::uint32_t, short_size> data{}; // the first is the place of a block, in units
  };

  // blocks of class c have 2^c units
  static unsigned block_class(std::uint32_t size) {
    return static_cast<unsigned>(std::bit_width((size - 1) / unit));
  }
  const std::uint32_t* block(const List& l) const {
    return blocks_.data() + std::size_t{unit} * l.data[0];
  }
  std::uint32_t* block(const List& l) { return blocks_.data() + std::size_t{unit} * l.data[0]; }

  void change_block(List& l, std::uint32_t size) {
    const bool had = l.size > short_size, has = size > short_size;
    if (had && has && block_class(l.size) == block_class(size)) return;
    const std::uint32_t taken = has ? take(block_class(size)) : none;
    if (had) give_back(l.data[0], block_class(l.size));
    l.data[0] = taken;
  }

  std::uint32_t take(unsigned c) {
    const std::uint32_t first = free_[c];
    if (first != none) {
      free_[c] = blocks_[std::size_t{unit} * first];
      return first;
    }
    const auto place = static_cast<std::uint32_t>(blocks_.size() / unit);
    blocks_.resize(blocks_.size() + (std::size_t{unit} << c));
    return place;
  }

  void give_back(std::uint32_t place, unsigned c) {
    blocks_[std::size_t{unit} * place] = free_[c];
    free_[c] = place;
  }

  std::vector<List> lists_;
  std::vector<std::uint32_t> blocks_;
  std::array<std::uint32_t, 32> free_; // first free block of each class; it names the next one
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_EXPLICIT_CROSSING_LISTS_H

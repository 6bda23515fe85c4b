// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts the inserted vertices without the gaps that removals leave in their numbers: rows of matrices, in the order
// of the numbers. On a cover, the copies of a vertex have one row, that of the first of them. After a removal, and on covers,
// they are counted again when somebody asks.
class Vertex_rows {
public:
  Vertex_rows() = default;
  template <class Triangulation>
  explicit Vertex_rows(const Triangulation& t)
      : first_(t.input().number_of_vertices()), first_row_(t.input().number_of_rows()),
        is_cover_(Triangulation::has_correspondence && t.input().names().sheets > 1) {
    for (const typename Triangulation::vertex_descriptor v : vertices(t.mesh()))
      if (t.is_inserted(v)) insert(t.index(v));
  }

  // the number of an inserted vertex, and of one that is removed
  void insert(std::uint32_t number) {
    const std::uint32_t i = number - first_;
    if (i >= is_there_.size()) is_there_.resize(i + 1, 0);
    is_there_[i] = 1;
    if (is_current_ && i == row_.size() && !is_cover_)
      row_.push_back(first_row_ + count_);
    else
      is_current_ = false;
    ++count_;
  }
  void remove(std::uint32_t number) {
    is_there_[number - first_] = 0;
    is_current_ = false;
    --count_;
  }

  // \param t the triangulation that has the rows
  template <class Triangulation>
  std::uint32_t row(std::uint32_t number, const Triangulation& t) const {
    if (!is_current_) count_again(t);
    return row_[number - first_];
  }
  template <class Triangulation>
  std::uint32_t number_of_rows(const Triangulation& t) const {
    if (!is_cover_) return first_row_ + count_;
    if (!is_current_) count_again(t);
    return first_row_ + rows_of_cover_;
  }

private:
  template <class Triangulation>
  void count_again(const Triangulation& t) const {
    row_.resize(is_there_.size());
    std::vector<std::uint32_t> first;
    if (is_cover_) first = first_copies(t.places(), is_there_);
    std::uint32_t next = first_row_;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const bool is_copy = is_cover_ && first[i] != i;
      row_[i] = is_copy ? row_[first[i]] : next;
      if (!is_copy) next += is_there_[i];
    }
    rows_of_cover_ = next - first_row_;
    is_current_ = true;
  }

  std::uint32_t first_ = 0, first_row_ = 0, count_ = 0;
  bool is_cover_ = false;
  std::vector<std::uint8_t> is_there_;
  mutable std::vector<std::uint32_t> row_;
  mutable std::uint32_t rows_of_cover_ = 0;
  mutable bool is_current_ = true;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H

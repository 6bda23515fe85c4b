// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_ROWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_ROWS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts the inserted vertices without the gaps that removals leave in their numbers: rows of matrices, in the order
// of the numbers. After a removal, they are counted again when somebody asks.
class Vertex_rows {
public:
  Vertex_rows() = default;
  Vertex_rows(std::uint32_t input_vertices, std::uint32_t input_rows)
      : first_(input_vertices), first_row_(input_rows) {}

  // the number of an inserted vertex, and of one that is removed
  void insert(std::uint32_t number) {
    const std::uint32_t i = number - first_;
    if (i >= is_there_.size()) is_there_.resize(i + 1, 0);
    is_there_[i] = 1;
    if (is_current_ && i == row_.size())
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

  // of an inserted vertex
  std::uint32_t row(std::uint32_t number) const {
    if (!is_current_) count_again();
    return row_[number - first_];
  }
  std::uint32_t number_of_rows() const { return first_row_ + count_; }

private:
  void count_again() const {
    row_.resize(is_there_.size());
    std::uint32_t next = first_row_;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      row_[i] = next;
      next += is_there_[i];
    }
    is_current_ = true;
  }

  std::uint32_t first_ = 0, first_row_ = 0, count_ = 0;
  std::vector<std::uint8_t> is_there_;
  mutable std::vector<std::uint32_t> row_;
  mutable bool is_current_ = true;
};

// Of a cover, several vertices are copies of one of the user's and share its row. What belongs to a neighbourhood, as a tangent
// plane, has a number for each copy: its name, and for inserted vertices what follows. Without copies these are rows.
template <class Triangulation>
std::uint32_t copy_number(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  return t.is_inserted(v)
             ? t.input_vertex(v) - t.input().number_of_rows() + t.input().number_of_vertices()
             : t.input().names().vertices.user(t.index(v));
}

template <class Triangulation>
std::size_t number_of_copies(const Triangulation& t) {
  return t.number_of_vertices() - t.input().number_of_rows() + t.input().number_of_vertices();
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_ROWS_H

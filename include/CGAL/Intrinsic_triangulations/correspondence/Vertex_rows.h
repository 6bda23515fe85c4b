// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H

#include <CGAL/Intrinsic_triangulations/correspondence/Sheets.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Counts the inserted vertices without the gaps that removals leave in their numbers: rows of matrices, in the order
// of the numbers. On a cover, the copies of a vertex have one row, that of the first of them. What was inserted last is counted
// when somebody asks; after a removal those after it are, on a cover all.
// \tparam Coordinates know where inserted vertices are
template <class Coordinates>
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
    forget_from(i);
    ++count_;
  }
  void remove(std::uint32_t number) {
    is_there_[number - first_] = 0;
    forget_from(number - first_);
    --count_;
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
  // Not copied: it refers to an input, which the copy may have another of.
  struct Cache {
    std::unique_ptr<First_copies<Coordinates>> copies;

    Cache() = default;
    Cache(const Cache&) {}
    Cache(Cache&&) = default;
    Cache& operator=(Cache other) {
      copies = std::move(other.copies);
      return *this;
    }
  };

  // The row of this vertex and of all after it may be another now. Whether another copy is the first now takes all of them.
  void forget_from(std::size_t i) {
    if (i >= row_.size()) return;
    if (is_cover_) i = 0;
    counted_rows_ = row_[i] - first_row_;
    row_.resize(i);
    cache_.copies.reset();
  }

  // gives rows to those that have none
  template <class Triangulation>
  void count(const Triangulation& t) const {
    if (row_.size() == is_there_.size()) return;
    const Coordinates* const coordinates = is_cover_ ? t.places() : nullptr;
    if (coordinates != nullptr && !(cache_.copies && cache_.copies->is_about(*coordinates))) {
      row_.clear();
      counted_rows_ = 0;
      cache_.copies = std::make_unique<First_copies<Coordinates>>(coordinates->input());
    }
    while (row_.size() < is_there_.size()) {
      const auto i = static_cast<std::uint32_t>(row_.size());
      const bool is_there = is_there_[i] != 0;
      const std::uint32_t first =
          is_there && coordinates != nullptr ? (*cache_.copies)(i, *coordinates) : i;
      row_.push_back(first == i ? first_row_ + counted_rows_ : row_[first]);
      if (first == i && is_there) ++counted_rows_;
    }
  }

  std::uint32_t first_ = 0, first_row_ = 0, count_ = 0;
  bool is_cover_ = false;
  std::vector<std::uint8_t> is_there_;
  // of the first so many vertices, and the number of them
  mutable std::vector<std::uint32_t> row_;
  mutable std::uint32_t counted_rows_ = 0;
  mutable Cache cache_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_VERTEX_ROWS_H

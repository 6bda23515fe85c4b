// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_COPIES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_COPIES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Whether two vertices are one point of the user's surface: the same, or copies on a cover.
template <class Triangulation>
bool are_copies(const Triangulation& t, typename Triangulation::vertex_descriptor v,
                typename Triangulation::vertex_descriptor w) {
  if constexpr (requires { t.input().names().row_of_vertex; })
    if (!t.input().names().row_of_vertex.empty()) return t.input_vertex(v) == t.input_vertex(w);
  return v == w;
}

// The vertices of the triangulation over one vertex of the user: several on a cover.
template <class Triangulation>
std::vector<typename Triangulation::vertex_descriptor> copies_of_row(const Triangulation& t,
                                                                     std::uint32_t row) {
  const Input_names& names = t.input().names();
  if (names.row_of_vertex.empty()) return {t.numbers().vertex_at(names.vertices.here(row))};
  std::vector<typename Triangulation::vertex_descriptor> result;
  const auto begin = names.row_of_vertex.begin();
  const auto [first, last] = std::equal_range(begin, names.row_of_vertex.end(), row);
  for (auto copy = first; copy != last; ++copy)
    result.push_back(
        t.numbers().vertex_at(names.vertices.here(static_cast<std::uint32_t>(copy - begin))));
  return result;
}

// The copies of a vertex; only itself if it was inserted.
template <class Triangulation>
std::vector<typename Triangulation::vertex_descriptor>
copies_of_vertex(const Triangulation& t, typename Triangulation::vertex_descriptor v) {
  if constexpr (requires { t.input().names(); })
    if (!t.is_inserted(v)) return copies_of_row(t, t.input_vertex(v));
  return {v};
}

} // namespace CGAL::Intrinsic_triangulations::internal

namespace CGAL::Intrinsic_triangulations {

/*!
\brief numbers the copies of vertices, as a `Tangent_field` does.

On a cover, several vertices are copies of one of the user's vertices and share its row. Data of a
neighbourhood, such as a tangent plane, have a number for each copy: its name; inserted vertices
follow in their order. Without copies these are rows.
\tparam Triangulation a model of `IndexedTriangulation`
*/
template <IndexedTriangulation Triangulation>
class Vertex_copies {
  using Vertex = typename Triangulation::vertex_descriptor;

public:
  /// numbers them. \param t the triangulation, which must outlive this object unchanged
  /// \complexity n log n in the number of inserted vertices
  explicit Vertex_copies(const Triangulation& t) : t_(t), size_(t.input().number_of_vertices()) {
    for (const Vertex v : vertices(t.mesh()))
      if (t.is_inserted(v)) inserted_.push_back(t.index(v));
    std::sort(inserted_.begin(), inserted_.end());
  }

  /// returns the number of a copy. \complexity logarithmic
  std::uint32_t operator()(Vertex v) const {
    const std::uint32_t i = t_.index(v);
    if (!t_.is_inserted(v)) return t_.input().names().vertices.user(i);
    const auto place = std::lower_bound(inserted_.begin(), inserted_.end(), i);
    return size_ + static_cast<std::uint32_t>(place - inserted_.begin());
  }
  /// returns how many there are.
  std::size_t size() const { return size_ + inserted_.size(); }

  /// returns the first copy of the vertex of each row: without a cover the row itself;
  /// `Gluing::none` for rows without a copy. \complexity linear
  std::vector<std::uint32_t> first_of_rows() const {
    return of_rows([](std::uint32_t i, std::uint32_t best) { return i < best; });
  }
  /// returns the first copy of the vertex of each row with a vector that is known, or the first
  /// one.
  /// \param field a vector per copy, `size()` of them
  /// \complexity linear
  std::vector<std::uint32_t> known_of_rows(const std::vector<std::complex<double>>& field) const {
    const auto is_known = [&field](std::uint32_t i) {
      return std::isfinite(field[i].real()) && std::isfinite(field[i].imag());
    };
    return of_rows([&](std::uint32_t i, std::uint32_t best) {
      return is_known(i) == is_known(best) ? i < best : is_known(i);
    });
  }
  /// returns the copy of the vertex of each row that has the shortest vector, such as the nearest
  /// one in a logarithmic map.
  /// \param field a vector per copy, `size()` of them; unknown ones count as infinite
  /// \complexity linear
  std::vector<std::uint32_t> nearest_of_rows(const std::vector<std::complex<double>>& field) const {
    return of_rows([&field](std::uint32_t i, std::uint32_t best) {
      return !std::isfinite(std::abs(field[best])) || std::abs(field[i]) < std::abs(field[best]);
    });
  }
  /// returns, for each copy, the first copy of the same vertex. \complexity linear
  std::vector<std::uint32_t> first_of_copies() const {
    const std::vector<std::uint32_t> of_row = first_of_rows();
    std::vector<std::uint32_t> result(size());
    for (const Vertex v : vertices(t_.mesh())) result[(*this)(v)] = of_row[t_.input_vertex(v)];
    return result;
  }

private:
  // \param is_better of a copy and the best one before
  template <class Is_better>
  std::vector<std::uint32_t> of_rows(const Is_better& is_better) const {
    std::vector<std::uint32_t> result(t_.number_of_vertices(), Gluing::none);
    for (const Vertex v : vertices(t_.mesh())) {
      std::uint32_t& best = result[t_.input_vertex(v)];
      const std::uint32_t i = (*this)(v);
      if (best == Gluing::none || is_better(i, best)) best = i;
    }
    return result;
  }

  const Triangulation& t_;
  std::uint32_t size_;
  std::vector<std::uint32_t> inserted_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_VERTEX_COPIES_H

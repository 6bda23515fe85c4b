// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_DEVELOPER_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_DEVELOPER_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <Eigen/Core>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <map>
#include <queue>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The point of a row.
inline std::complex<double> point_of_row(const Eigen::MatrixX2d& z, Eigen::Index v) {
  return {z(v, 0), z(v, 1)};
}

// Pieces laid out next to each other.
template <class Pieces>
struct Developed {
  std::vector<typename Pieces::Point> position; // of each vertex
  std::vector<typename Pieces::Frame> frame;    // of each piece
  std::vector<double> extent;                   // of each piece: its longest side
  double largest_error = 0;                     // of a side, relative to the extent of its piece

  // Positions as rows.
  Eigen::MatrixX2d rows() const {
    Eigen::MatrixX2d result(static_cast<Eigen::Index>(position.size()), 2);
    for (std::size_t v = 0; v < position.size(); ++v) {
      const std::complex<double> z(position[v]);
      result.row(static_cast<Eigen::Index>(v)) << z.real(), z.imag();
    }
    return result;
  }
};

// Develops pieces that form disks: frames follow from each other across sides, breadth first, and
// a vertex has the place that the first piece reached gives it.
// \tparam Pieces `Glued_pieces` of a geometry: `Plane_pieces` or `Disk_pieces`
template <class Pieces>
class Developer {
public:
  using Frame = typename Pieces::Frame;
  using Point = typename Pieces::Point;

  explicit Developer(const Pieces& pieces)
      : p_(pieces), piece_(pieces.piece_of_corner()), piece_round_(pieces.size(), 0),
        vertex_round_(pieces.number_of_vertices, 0) {
    result.position.resize(pieces.number_of_vertices);
    result.frame.resize(pieces.size());
    result.extent.resize(pieces.size(), 0);
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c)
        result.extent[i] = std::max(result.extent[i], p_.length(i, c));
    for (const double extent : result.extent) unit_ = std::max(unit_, extent);
  }

  // The longest side.
  double unit() const { return unit_; }
  bool is_placed(std::uint32_t piece) const { return piece_round_[piece] != 0; }

  // Lays out the component of a piece, whether or not it has been laid out before: breadth first
  // within classes of size, and small
  // classes first. Thus pieces between the corners of a needle follow from each other: if large
  // ones around led to them from all sides, they would have the errors of those.
  void spread_from(std::uint32_t first, const Frame& start) {
    ++round_;
    order_.clear();
    std::map<int, std::queue<std::uint32_t>> sides; // to cross, by the class of the piece beyond
    const auto reach = [&](std::uint32_t i, std::uint32_t corner, const Frame& frame) {
      piece_round_[i] = round_;
      order_.push_back(i);
      result.frame[i] = frame;
      place(i, corner);
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c)
        if (p_.glue[c] != Gluing::none)
          sides[Pieces::size_class(result.extent[piece_[p_.glue[c]]] / unit_)].push(c);
    };
    reach(first, p_.begin[first], start);
    while (!sides.empty()) {
      const auto least = sides.begin();
      const std::uint32_t c = least->second.front(), j = piece_[p_.glue[c]];
      least->second.pop();
      if (least->second.empty()) sides.erase(least);
      if (piece_round_[j] != round_) reach(j, p_.glue[c], p_.across(result.frame[piece_[c]], c));
    }
  }

  // Calls a function with each piece of the last component, and each of its corners.
  template <class Function>
  void for_each_corner(const Function& f) const {
    for (const std::uint32_t i : order_)
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1]; ++c) f(i, c);
  }

  // The largest error of a side at some places, relative to the extent of its piece.
  double largest_error(const std::vector<Point>& z) const {
    double largest = 0;
    for (std::uint32_t i = 0; i < p_.size(); ++i)
      for (std::uint32_t c = p_.begin[i]; c < p_.begin[i + 1] && result.extent[i] > 0; ++c)
        largest = std::max(
            largest, p_.error(result.frame[i], i, c, z[p_.vertex[c]], z[p_.vertex[p_.next(i, c)]]) /
                         result.extent[i]);
    return largest;
  }

  Developed<Pieces> result;

private:
  // Places the corners of a piece, of which corner `c` has a place unless it is the first piece.
  void place(std::uint32_t i, std::uint32_t c) {
    const Frame& frame = result.frame[i];
    const std::uint32_t first = p_.vertex[c];
    Point z = order_.size() == 1 ? p_.start(frame, c) : result.position[first];
    for (std::uint32_t n = p_.begin[i]; n < p_.begin[i + 1]; ++n, c = p_.next(i, c)) {
      const std::uint32_t v = p_.vertex[c];
      if (vertex_round_[v] != round_) result.position[v] = z;
      vertex_round_[v] = round_;
      z = p_.end(frame, i, c, z);
    }
  }

  const Pieces& p_;
  std::vector<std::uint32_t> piece_;            // of each corner
  std::vector<int> piece_round_, vertex_round_; // in which each was placed last
  int round_ = 0;
  std::vector<std::uint32_t> order_; // pieces of the last component
  double unit_ = 0;                  // the longest side
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_DEVELOPER_H

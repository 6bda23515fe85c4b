// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_MERGED_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_MERGED_EDGES_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Which of the two triangulations of a subdivision is meant.
enum class Subdivided : std::uint8_t { input, intrinsic };

// The corners of a subdivision whose sides lie along each halfedge of a triangulation, in order.
class Corners_along {
public:
  Corners_along(const Piece_gluer& pieces, Subdivided which, std::uint32_t halfedges);

  std::span<const std::uint32_t> operator[](std::uint32_t h) const {
    return {corners_.data() + begin_[h], begin_[h + 1] - begin_[h]};
  }

private:
  std::vector<std::size_t> begin_{0};
  std::vector<std::uint32_t> corners_;
};

// The crossings of two subdivisions along the edges of a triangulation that they have in common:
// intrinsic in the first one, the input in the second one. Each keeps its order; their places
// decide between them. A crossing of each that rounding cannot tell apart are one point: else
// edges that coincide would have slivers between them.
class Merged_edges {
public:
  Merged_edges(const Piece_gluer& first, const Piece_gluer& second, std::uint32_t halfedges);

  // How many points of crossings there are on an edge.
  std::uint32_t number_of_points(std::uint32_t h) const { return points_[h / 2]; }
  // The place of a crossing among those points on a halfedge, from 1.
  std::uint32_t rank_of_first(std::uint32_t crossing, std::uint32_t h) const {
    return along(of_first_[crossing].rank, h);
  }
  std::uint32_t rank_of_second(std::uint32_t crossing, std::uint32_t h) const {
    return along(of_second_[crossing].rank, h);
  }

  // The crossing of the other subdivision at the same point, or `none`.
  std::uint32_t second_at(std::uint32_t crossing) const { return of_first_[crossing].same; }
  std::uint32_t first_at(std::uint32_t crossing) const { return of_second_[crossing].same; }

  // The corner of the first subdivision at one of its crossings from which a side runs along `h`.
  std::uint32_t first_from(std::uint32_t crossing, std::uint32_t h) const {
    const std::uint32_t i = of_first_[crossing].index;
    return first_[h][h % 2 == 0 ? i : first_[h].size() - i];
  }
  // The corner of the first subdivision whose side along `h` a crossing of the second one lies on
  // or starts.
  std::uint32_t first_around(std::uint32_t crossing, std::uint32_t h) const {
    if (const std::uint32_t same = first_at(crossing); same != Common_subdivision::none)
      return first_from(same, h);
    const std::uint32_t before = of_second_[crossing].before;
    return first_[h][h % 2 == 0 ? before : first_[h].size() - 1 - before];
  }
  // How many crossings of the second subdivision are before one of the first one, along the edge.
  std::uint32_t second_before(std::uint32_t crossing) const { return of_first_[crossing].before; }

  const Corners_along& first() const { return first_; }
  const Corners_along& second() const { return second_; }

private:
  struct Mark {
    std::uint32_t index;  // among the crossings of the same subdivision on the edge, from 1
    std::uint32_t rank;   // among the points of all of them
    std::uint32_t before; // how many crossings of the other subdivision are before it
    std::uint32_t same = Common_subdivision::none;
  };

  void merge(const Piece_gluer& first, const Piece_gluer& second, std::uint32_t edge);
  std::uint32_t along(std::uint32_t rank, std::uint32_t h) const {
    return h % 2 == 0 ? rank : number_of_points(h) + 1 - rank;
  }

  Corners_along first_, second_;
  std::vector<Mark> of_first_, of_second_;
  std::vector<std::uint32_t> points_; // of each edge
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_MERGED_EDGES_H

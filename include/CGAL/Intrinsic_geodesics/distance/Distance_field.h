// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H
#define CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

struct Window;

/*!
\brief keeps the windows that look into faces, 32 bytes each, in a list per side.

The ends of intervals are rounded outwards, to 2^-30 of the geometric mean of the side and of the
distance to its nearer end; the ends of the side exactly. A path through the added part passes a
vertex on the wrong side by that much: it is too short by the square of it, divided by the distance
of the vertex, also next to the ends of the side.
*/
class Stored_windows {
public:
  /// A window, but for what all windows of its side share.
  struct Record {
    Plane_vector<double> image; ///< the source, in the frame of the side
    std::uint32_t begin;        ///< of the interval, see `place()`
    std::uint32_t end;          ///< of the interval
    std::uint32_t source;       ///< number of the source
    std::uint32_t next;         ///< another window of the side, or `Gluing::none`
  };

  /// forgets all windows, and makes room for those of a number of sides.
  void keep(std::size_t sides);
  /// returns whether windows are kept.
  bool are_kept() const { return !first_.empty(); }
  /// adds a window to a side with a length.
  void add(const Window& w, std::uint32_t side, double length);
  /// calls a function with a window after the other that look through a side.
  template <class Function>
  void for_each(std::uint32_t side, const Function& f) const {
    for (std::uint32_t i = first_[side]; i != Gluing::none; i = at(i).next) f(at(i));
  }
  /// returns where an interval begins or ends on a side with a length.
  static double place(std::uint32_t end, double length) {
    const double root = end / units, back = 1 - root; // finer towards both ends
    return root < 0.5 ? 2 * root * root * length : length - 2 * back * back * length;
  }
  /// returns the number of windows.
  std::size_t size() const { return size_; }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return blocks_.size() * block_size * sizeof(Record) + first_.size() * sizeof(std::uint32_t);
  }

private:
  // Blocks never move: growing copies nothing, and at most one, of 256 KiB, is in part empty.
  static constexpr std::uint32_t block_size = 1U << 13U;
  static constexpr std::uint32_t largest = 0xffffffffU;
  static constexpr double units = largest;

  Record& at(std::uint32_t i) const { return blocks_[i / block_size][i % block_size]; }

  std::vector<std::unique_ptr<Record[]>> blocks_;
  std::vector<std::uint32_t> first_; // per side
  std::uint32_t size_ = 0;
};

/// A source behind an edge of more than two faces: windows that cross the same ones belong
/// together.
struct Crossing {
  std::uint32_t source; ///< number of the source before
  std::uint32_t root;   ///< the vertex, or the source in a face
  std::uint32_t from;   ///< the side that is crossed
  std::uint32_t to;     ///< the side behind it

  /// Sources with numbers from here on are crossings.
  static constexpr std::uint32_t first = 0x80000000U;
  /// returns whether a source is a crossing.
  static bool is_one(std::uint32_t source) { return source >= first && source != Gluing::none; }
};

/// A point of a face.
struct Point_in_face {
  std::uint32_t side;            ///< a corner
  Plane_vector<double> point;    ///< in the frame of the side
  std::array<double, 3> weights; ///< of the source of the side, its target, and the apex
};

/// How the last piece of a shortest path comes to a point.
struct Arrival {
  enum class Kind : std::uint8_t {
    none,      ///< no path is found yet
    at_source, ///< the point is a source
    straight,  ///< straight from `image` through `side`, from an end of it, or from within the face
    copied     ///< the point is a copy of vertex `source` on a cover, where the path comes to
  };
  Plane_vector<double> image{0, 0};    ///< of the source, in the frame of `side`
  std::uint32_t side = Gluing::none;   ///< a corner
  std::uint32_t source = Gluing::none; ///< number of the source: a vertex, or one in a face
  Kind kind = Kind::none;
  std::uint32_t origin = Gluing::none; ///< index of the true source where the path begins

  /// returns the corner of a vertex to which a path comes straight: the apex seen from the side.
  std::uint32_t corner() const { return Corner_table::previous(side); }
};

/// A distance, and where it comes from.
struct Distance_and_arrival {
  double distance = std::numeric_limits<double>::infinity();
  Arrival arrival;
};

/*!
\brief is what window propagation finds: distances and last pieces of shortest paths at vertices,
  and the windows of all faces, from which the distances of all other points follow. In scaled
  units.
*/
struct Distance_field {
  Corner_table table;                         ///< the surface
  std::vector<Distance_and_arrival> vertices; ///< per vertex
  std::vector<Point_in_face>
      face_sources; ///< sources in faces: the i-th has the number of vertices plus i
  std::vector<std::uint32_t> origins; ///< the index of each source in a face among all sources
  std::vector<std::uint32_t>
      sources_by_face;             ///< the indices of sources in faces, in the order of their faces
  std::vector<Crossing> crossings; ///< of branches, by paths
  Stored_windows windows; ///< what looks into faces, if it is kept: points in faces need it
  double radius = 0;      ///< distances up to this one are final

  /// starts without sources.
  explicit Distance_field(Corner_table t);

  /// forgets what was found, and has sources no more.
  void clear();
  /// returns the vertex, or the source in a face, where the straight path begins.
  std::uint32_t root(std::uint32_t source) const {
    return Crossing::is_one(source) ? crossings[source - Crossing::first].root : source;
  }
  /// returns how far the source of a window is from the nearest true one.
  double offset(std::uint32_t source) const {
    source = root(source);
    return source < vertices.size() ? vertices[source].distance : 0;
  }
  /// returns the index of the true source where the shortest path to the source of a window begins.
  std::uint32_t origin(std::uint32_t source) const {
    source = root(source);
    return source < vertices.size() ? vertices[source].arrival.origin
                                    : origins[source - vertices.size()];
  }
  /// returns how many windows to look through at most; only very thin bodies have more.
  std::uint64_t default_cap() const { return 4000000 + 500 * std::uint64_t{table.corners.size()}; }
  /// returns the number of bytes held.
  std::size_t bytes() const {
    return table.corners.size() * sizeof(Face_corner) +
           vertices.size() * (sizeof(Distance_and_arrival) + sizeof(std::uint32_t)) +
           windows.bytes();
  }
  /// returns the sources in a face.
  std::span<const std::uint32_t> sources_in_face(std::uint32_t face) const;
  /// returns a point in the frame of a side in that of another side of the face.
  Plane_vector<double> turned_to(std::uint32_t side, Plane_vector<double> p,
                                 std::uint32_t from) const;
  /// returns the point of the face of a side with given weights of the source of the side, its
  /// target, and the apex.
  Point_in_face point(std::uint32_t side, const std::array<double, 3>& weights) const;
  /// finds the distance of a point of a face. \pre windows are kept
  Distance_and_arrival at(const Point_in_face& p) const;

private:
  // Through the windows of a side.
  void look_through(std::uint32_t side, Plane_vector<double> p, Distance_and_arrival& best) const;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_GEODESICS_DISTANCE_DISTANCE_FIELD_H

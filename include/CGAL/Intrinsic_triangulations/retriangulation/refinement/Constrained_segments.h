// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief keeps the edges that refinement splits but never flips, and the vertices that it puts on
them.

Such edges are those of the border and those that are constrained. Where two of them make an angle
of less than 60 degrees at a vertex, splitting one at its midpoint may require a split of the other,
and so on without end. Hence edges at such a vertex are split at distances from it that are powers
of two, so that both get vertices at the same distances (Ruppert, A Delaunay refinement algorithm
for quality 2-dimensional mesh generation, 1995, section 5), and a face whose shortest side joins
two such vertices is left alone (Shewchuk, Mesh generation for domains with small angles, 2000).
If the angle between two segments is below the bound, no face between them can meet it, whatever the
distances.

All elements are named by numbers, lengths are those of the complex.
*/
class Constrained_segments {
public:
  /// has none yet.
  Constrained_segments();
  /// copies.
  Constrained_segments(const Constrained_segments& other);
  /// moves.
  Constrained_segments(Constrained_segments&& other) noexcept;
  /// copies.
  Constrained_segments& operator=(const Constrained_segments& other);
  /// moves.
  Constrained_segments& operator=(Constrained_segments&& other) noexcept;
  /// destructs.
  ~Constrained_segments();

  /*!
  \brief adds an edge; all must be added before `find_small_angles()`.
  \tparam Complex a model of `NumberedComplex`
  \param complex the surface
  \param h a halfedge of the edge
  \param is_constrained false for a mere border edge
  \param is_seam whether the edge runs along a seam of a cover: it is split until it is locally
    Delaunay
  */
  template <NumberedComplex Complex>
  void add(const Complex& complex, std::uint32_t h, bool is_constrained, bool is_seam = false) {
    add({{complex.source(h), complex.target(h)},
         h,
         std::sqrt(complex.squared_length(h / 2)),
         is_constrained,
         is_seam});
  }

  /// finds where two segments make a small angle. \complexity linear in the degrees of their ends
  template <NumberedComplex Complex>
  void find_small_angles(const Complex& complex) {
    note_ends();
    for (const Segment& s : segments_)
      for (const std::uint32_t h : {s.halfedge, s.halfedge ^ 1U})
        if (!complex.is_border(h)) find_small_angle(complex, h);
  }

  /// tells whether an edge is one, or a part of one.
  bool is_segment(std::uint32_t edge) const {
    return edge < segment_.size() && segment_[edge] != Gluing::none;
  }
  /// tells whether an edge is constrained, or a part of one that is.
  bool is_constrained(std::uint32_t edge) const {
    return is_segment(edge) && segments_[segment_[edge]].is_constrained;
  }
  /// tells whether an edge, or the edge that it is a part of, runs along a seam.
  bool is_seam(std::uint32_t edge) const {
    return is_segment(edge) && segments_[segment_[edge]].is_seam;
  }
  /// makes a segment or a part of one an edge like others.
  void release(std::uint32_t edge) { segment_[edge] = Gluing::none; }
  /// returns the edge that a segment or a part of one was before any split.
  std::uint32_t whole(std::uint32_t edge) const { return segments_[segment_[edge]].halfedge / 2; }
  /// tells whether there are none.
  bool empty() const { return segments_.empty(); }

  /*!
  \brief returns where to split an edge: the weight of the target of `h`.
  \pre the edge is a segment or a part of one
  */
  template <NumberedComplex Complex>
  double split_parameter(const Complex& complex, std::uint32_t h) const {
    const bool at_source = has_small_angle(complex.source(h));
    const bool at_target = has_small_angle(complex.target(h));
    if (at_source == at_target) return 0.5;
    const double length = std::sqrt(complex.squared_length(h / 2));
    // the power of two that is closest to half the length, by ratio: between 1/3 and 2/3 of it
    const double shell = std::exp2(std::round(std::log2(length / 2)));
    const double t = std::clamp(shell / length, 0.25, 0.75);
    return at_source ? t : 1 - t;
  }

  /*!
  \brief records a split.
  \param whole the edge that was split
  \param parts its two parts
  \param ends its ends
  \param vertex the new vertex
  \param parameter weight of the second end
  */
  void split(std::uint32_t whole, const std::array<std::uint32_t, 2>& parts,
             const std::array<std::uint32_t, 2>& ends, std::uint32_t vertex, double parameter);

  /*!
  \brief tells whether two vertices are on the two sides of a small angle, neither at its corner:
  the small angle makes the line between them short.
  \param v a vertex
  \param w another
  \param bound for angles below it, in radians, it is enough that they are on both sides; for others
  both must be at the same distance from the corner
  \param may_be_one_segment whether the two sides may be one segment, which ends at a vertex whose
  total angle is small: not if the line is a part of it
  */
  bool are_across_small_angle(std::uint32_t v, std::uint32_t w, double bound,
                              bool may_be_one_segment = true) const;

  /*!
  \brief tells whether both vertices opposite a segment lie across a small angle, at the same
  distance from its corner as an end of the segment: then the opposite angles are acute, also where
  rounding spoils slivers.
  \param view the triangulation
  \param h a halfedge of the segment
  */
  template <NumberedComplex View>
  bool is_between_shells(const View& view, std::uint32_t h) const {
    const std::uint32_t a = view.source(h), b = view.target(h);
    for (const std::uint32_t side : {h, view.opposite(h)}) {
      const std::uint32_t k = view.target(view.next(side));
      if (!are_across_small_angle(a, k, 0) && !are_across_small_angle(b, k, 0)) return false;
    }
    return true;
  }

private:
  struct Segment {
    std::array<std::uint32_t, 2> ends;
    std::uint32_t halfedge; // before any split, from the first end
    double length;
    bool is_constrained, is_seam;
  };
  struct Place {
    std::uint32_t segment;
    std::array<double, 2> distance; // from the ends of the segment
  };

  void add(const Segment& segment);
  void set(std::uint32_t edge, std::uint32_t segment);

  // which segments end where
  void note_ends();
  bool has_small_angle(std::uint32_t vertex) const;
  // between two segments at a corner; the least of several angles is kept
  void note_small_angle(std::uint32_t corner, std::uint32_t s, std::uint32_t t, double angle);

  // of a vertex of a segment from one of its ends, along it; unknown on loops
  double distance(std::uint32_t s, std::size_t end, std::uint32_t vertex) const;

  // the segments that a vertex is on
  std::span<const std::uint32_t> segments_of(std::uint32_t vertex) const;

  // the angle to the next segment counterclockwise about the source, if it is below 60 degrees
  template <NumberedComplex Complex>
  void find_small_angle(const Complex& complex, std::uint32_t h) {
    double angle = 0;
    std::uint32_t g = h;
    do {
      if (complex.is_border(g)) return;
      angle += angle_at_source(complex, g);
      g = next_around_source(complex, g);
    } while (angle < limit && !is_segment(g / 2));
    if (!(angle < limit)) return;
    note_small_angle(complex.source(h), segment_[h / 2], segment_[g / 2], angle);
  }

  // between two segments at a corner, if it is small; between a segment and itself around its end,
  // if that has no other and a small total angle
  std::optional<double> small_angle(std::uint32_t corner, std::uint32_t s, std::uint32_t t) const;

  // Segments at smaller angles need shells (Ruppert 1995): splits of one encroach upon the other.
  static constexpr double limit = std::numbers::pi / 3;
  // Relative difference of distances taken for rounding. They are powers of two: others differ by a
  // half.
  static constexpr double same = 0x1p-20;

  std::vector<std::uint32_t> segment_; // of an edge, or none
  std::vector<Segment> segments_;
  std::unordered_map<std::uint32_t, Place> place_; // of vertices put on segments
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>>
      at_; // segments that end at a vertex
  std::unordered_set<std::uint32_t> has_small_angle_;
  std::map<std::array<std::uint32_t, 3>, double> small_angle_; // by corner and two segments
};

namespace internal {

// Stores which edges a property map constrains. If the map is writable, the parts of a split edge
// get its value.
template <class Triangulation, class Map>
class Constrained_parts {
  using Value = typename boost::property_traits<Map>::value_type;
  static constexpr bool is_writable =
      std::is_convertible_v<typename boost::property_traits<Map>::category,
                            boost::writable_property_map_tag>;

public:
  // keeps the values of all edges
  Constrained_parts(const Triangulation& t, const Map& map) : map_(map) {
    if constexpr (is_writable) {
      values_.resize(t.numbers().edge_capacity(t.mesh()));
      for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
        values_[t.index(e)] = get(map_, e);
    }
  }

  // for each edge, by number, whether it is constrained; empty: none is
  std::vector<char> marks(const Triangulation& t) const {
    using Edge = typename Triangulation::edge_descriptor;
    std::vector<char> result;
    if constexpr (!std::is_same_v<Map, Static_boolean_property_map<Edge, false>>) {
      result.resize(t.numbers().edge_capacity(t.mesh()), 0);
      for (const Edge e : edges(t.mesh())) result[t.index(e)] = get(map_, e) ? 1 : 0;
    }
    return result;
  }

  // `whole(e)` is the edge that edge e is a part of, or `Gluing::none`
  template <class Whole>
  void write(const Triangulation& t, const Whole& whole) const {
    if constexpr (is_writable)
      for (const typename Triangulation::edge_descriptor e : edges(t.mesh())) {
        const std::uint32_t w = whole(t.index(e));
        put(map_, e, w == Gluing::none ? Value() : static_cast<Value>(values_[w]));
      }
  }

private:
  Map map_;
  std::vector<Value> values_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_RETRIANGULATION_REFINEMENT_CONSTRAINED_SEGMENTS_H

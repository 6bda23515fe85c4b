// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_CROSSED_PIECES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_CROSSED_PIECES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Merged_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Piece_gluer.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The sides of the second of two subdivisions as edges, and where edges of the input, that of the
// first one, cross them.
class Crossed_pieces {
public:
  // \pre `expect_arrays()` has checked both
  // \throws Invalid_input as `expect_paths()`
  Crossed_pieces(const Common_subdivision& first, const Common_subdivision& second,
                 const Input& input, const Gluing_map& middle);

  const Piece_gluer& first() const { return first_; }
  const Piece_gluer& second() const { return second_; }
  const Merged_edges& edges() const { return edges_; }

  // the halfedge of the new edges at a corner of the second subdivision, and its inverse
  std::uint32_t halfedge(std::uint32_t corner) const { return halfedge_[corner]; }
  const std::vector<std::uint32_t>& corners() const { return corner_; }
  // row of a vertex of the second subdivision among all of them
  std::uint32_t row(std::uint32_t vertex) const;

  // The crossings on new edges, those on each together, along its first halfedge.
  const std::vector<Common_subdivision::Crossing>& crossings() const { return crossings_; }
  std::uint32_t crossings_begin(std::uint32_t edge) const { return begin_[edge]; }

  // The corner of the first subdivision whose side runs along the input edge from a crossing into
  // the face to the left of the side of a corner of the second one.
  std::uint32_t entering(std::uint32_t crossing, std::uint32_t corner) const;
  // The same for a crossing of both subdivisions at a corner of the second one; `none` if there is
  // none, or the edge does not run into the face of the corner.
  std::uint32_t entering_at(std::uint32_t corner) const { return entering_[corner]; }
  // The edge of the input that a new edge inside of a middle face is a part of, or `none`.
  std::uint32_t input_edge(std::uint32_t edge) const { return input_edge_[edge]; }
  // The same side, in the other direction.
  std::uint32_t partner(std::uint32_t first_corner) const { return glue_[first_corner]; }

  // \throws Invalid_input that the middle face of a corner of the second subdivision is another one
  [[noreturn]] void fail(std::uint32_t corner) const;

private:
  static constexpr std::uint32_t none = Common_subdivision::none;
  using Place = std::array<double, 3>; // in a face of the middle triangulation

  // An end of an input edge in a middle face.
  struct Chord_end {
    std::uint32_t at, other; // places of this end and of the other one along the border of the face
    std::uint32_t corner;    // of the first subdivision; its side runs from this end
  };

  std::uint32_t add_edge(std::uint32_t corner, std::uint32_t partner);
  void add_pieces(std::uint32_t edge);
  void enter_face(std::uint32_t f);
  std::uint32_t border_place(std::uint32_t h, std::uint32_t rank) const;
  std::uint32_t place_of_first(std::uint32_t corner) const;
  std::uint32_t place_of_second(std::uint32_t corner) const;
  Place point(std::uint32_t h, double along) const;
  Place point_of_first(std::uint32_t corner) const;
  Place point_of_second(std::uint32_t corner) const;
  void find_chords(std::uint32_t begin, std::uint32_t end);
  void cross(std::uint32_t corner);
  void meet(std::uint32_t corner);
  void add_crossing(std::uint32_t edge, std::uint32_t entering);
  Common_subdivision::Edge_point on_input(std::uint32_t corner, double along) const;

  const Common_subdivision &a_, &b_;
  const Input& input_;
  const Gluing_map& middle_;
  Piece_gluer first_, second_;
  std::vector<std::uint32_t> glue_;    // of the first subdivision
  std::vector<std::uint32_t> partner_; // of the second one
  Merged_edges edges_;
  std::vector<std::uint32_t> halfedge_, corner_, begin_;
  std::vector<Common_subdivision::Crossing> crossings_;
  // on an edge inside of a middle face, the result of `entering()` for its first halfedge; on
  // others the crossing of the first subdivision
  std::vector<std::uint32_t> source_;
  std::vector<std::uint32_t> entering_, input_edge_;
  // of the middle face at hand
  std::array<std::uint32_t, 3> sides_{}, base_{};
  std::uint32_t border_ = 0; // how many points its border has
  std::vector<Chord_end> ends_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_CROSSED_PIECES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows which version in the history of moves each face is, and records moves of faces.
*/
class Face_versions {
public:
  /// Version of a face and the edge in its slot 0, which must not be in another slot too. If slots 1
  /// and 2 have the same edge, they may be taken for each other: they have the same length.
  using Version = std::pair<std::uint32_t, std::uint32_t>;
  /// A slot of a version.
  using Side = Face_side;

  /// constructs an empty history.
  Face_versions() = default;

  /// takes the history of moves and the version of each face.
  Face_versions(Flip_history history, std::vector<Version> versions)
      : history_(std::move(history)), versions_(std::move(versions)) {}

  /// returns the moves so far.
  const Flip_history& history() const { return history_; }
  /// returns the version of a face.
  const Version& version(std::uint32_t f) const { return versions_[f]; }

  /// returns the first side of a face.
  Side side(const Indexed_face& f) const { return side(f.face, f.edges[0], f.edges[1]); }
  /// returns the side of a diamond on the left.
  Side left_side(const Diamond& d) const { return side(d.f, d.ij, d.jk); }
  /// returns the side of a diamond on the right.
  Side right_side(const Diamond& d) const { return side(d.g, d.ij, d.im); }
  /// returns the first side of each face.
  std::vector<Side> sides(std::span<const Indexed_face> faces) const {
    std::vector<Side> result;
    for (const Indexed_face& f : faces) result.push_back(side(f));
    return result;
  }

  /// records a flip.
  void flip(const Diamond& d) {
    const std::uint32_t version = history_.record_flip(left_side(d), right_side(d));
    versions_[d.f] = {version, d.ij};
    versions_[d.g] = {version + 1, d.ij};
  }

  /// records the insertion of a vertex in a face.
  void insert_in_face(const Vertex_star& s, const std::array<double, 3>& weights) {
    const std::uint32_t version = history_.record_vertex_move(
        Kind::insert_in_face, {side(Indexed_face{s.faces[0], s.sides})}, weights);
    for (std::uint32_t k = 0; k < 3; ++k) store(s.faces[k], {version + k, s.sides[k]});
  }

  /// records the removal of a vertex from a face.
  void remove_from_face(const Vertex_star& s) {
    const auto [ij, jk, ki] = s.sides;
    const std::uint32_t first = ij == jk ? 2 : ij == ki ? 1 : 0; // a side unlike the others
    std::array<Side, 3> parents;
    for (std::uint32_t i = 0; i < 3; ++i) { // the side opposite the vertex
      const std::uint32_t k = (first + i) % 3;
      parents[i] = side(s.faces[k], s.sides[k], s.spokes[(k + 1) % 3]);
    }
    const std::uint32_t version = history_.record_vertex_move(Kind::remove_from_face, parents);
    store(s.faces[0], {version, s.sides[first]});
  }

  /// records the insertion of a vertex on a border edge; `parameter` is the weight of `j`.
  void insert_in_border_edge(const Border_star& s, double parameter) {
    const std::uint32_t version = history_.record_vertex_move(
        Kind::insert_in_border_edge, {side(s.f, s.ip, s.jk)}, {1 - parameter, parameter, 0});
    store(s.f, {version, s.ip});
    store(s.g, {version + 1, s.pj});
  }

  /// records the removal of a vertex from a border edge; `d` is the diamond of pk.
  void remove_from_border_edge(const Border_star& s, const Diamond& d) {
    const std::uint32_t version =
        history_.record_vertex_move(Kind::remove_from_border_edge, {left_side(d), right_side(d)});
    store(s.f, {version, s.ip});
  }

private:
  using Kind = Flip_history::Vertex_move::Kind;

  Side side(std::uint32_t f, std::uint32_t edge, std::uint32_t next_edge) const {
    const auto& [version, first] = versions_[f];
    return {version, first == edge ? 0U : first == next_edge ? 2U : 1U};
  }

  void store(std::uint32_t f, const Version& version) {
    if (f >= versions_.size()) versions_.resize(f + 1);
    versions_[f] = version;
  }

  Flip_history history_;
  std::vector<Version> versions_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H

#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows which version in the history of flips each face is, and records flips.
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

  /// takes the history of flips and the version of each face.
  Face_versions(Flip_history history, std::vector<Version> versions)
      : history_(std::move(history)), versions_(std::move(versions)) {}

  /// returns the flips so far.
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

  /// forgets the last flip, which made the faces of a diamond of these versions.
  void forget_flip(const Diamond& d, const std::array<Version, 2>& before) {
    history_.forget_flip();
    versions_[d.f] = before[0];
    versions_[d.g] = before[1];
  }

private:
  Side side(std::uint32_t f, std::uint32_t edge, std::uint32_t next_edge) const {
    const auto& [version, first] = versions_[f];
    return {version, first == edge ? 0U : first == next_edge ? 2U : 1U};
  }

  Flip_history history_;
  std::vector<Version> versions_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FACE_VERSIONS_H

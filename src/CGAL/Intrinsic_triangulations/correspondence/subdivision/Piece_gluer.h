// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_PIECE_GLUER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_PIECE_GLUER_H

#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <array>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Finds which sides of the faces of a common subdivision are the same, in a Delta-complex.
class Piece_gluer {
public:
  explicit Piece_gluer(const Common_subdivision& s);

  // For each corner the side that the side from it is glued to, or `none`.
  std::vector<std::uint32_t> run() const;

  // the corner after `c` in its face
  std::uint32_t next(std::uint32_t c) const {
    return c + 1 == s_.face_begin[face_[c] + 1] ? s_.face_begin[face_[c]] : c + 1;
  }
  // the corner before `c` in its face
  std::uint32_t previous(std::uint32_t c) const {
    return c == s_.face_begin[face_[c]] ? s_.face_begin[face_[c] + 1] - 1 : c - 1;
  }
  const Common_subdivision& subdivision() const { return s_; }
  // the face of a corner
  std::uint32_t face(std::uint32_t c) const { return face_[c]; }

private:
  // What the two sides have in common: of an intrinsic edge the edge and the place along it; inside
  // of an intrinsic face that face, the input edge and both ends.
  using Key = std::array<std::uint32_t, 5>;

  Key key(std::uint32_t c) const;
  std::uint32_t place_along(std::uint32_t c) const;

  const Common_subdivision& s_;
  std::vector<std::uint32_t> face_;  // of each corner
  std::vector<std::uint32_t> first_; // crossing on each intrinsic edge, and one entry more
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_SUBDIVISION_PIECE_GLUER_H

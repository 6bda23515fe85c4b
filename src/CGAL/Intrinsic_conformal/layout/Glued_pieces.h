// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_LAYOUT_GLUED_PIECES_H
#define CGAL_INTRINSIC_CONFORMAL_LAYOUT_GLUED_PIECES_H

#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Polygons that are glued along sides. A side has the number of the corner where it starts.
struct Glued_pieces {
  std::uint32_t number_of_vertices = 0;
  std::vector<std::uint32_t> begin{0}; // for each piece its first corner, and one entry more
  std::vector<std::uint32_t> vertex;   // at each corner
  std::vector<std::uint32_t> glue;     // the side that each one is glued to, or `Gluing::none`

  std::uint32_t size() const { return static_cast<std::uint32_t>(begin.size() - 1); }
  // the next corner of piece `p`
  std::uint32_t next(std::uint32_t p, std::uint32_t c) const {
    return c + 1 == begin[p + 1] ? begin[p] : c + 1;
  }
  // the piece of each corner
  std::vector<std::uint32_t> piece_of_corner() const;
};

// Triangles as pieces.
Glued_pieces pieces_of(const Gluing& g);

// The two copies of a part of a cut: sides one after another, and their partners in the same order.
struct Border_seam {
  std::vector<std::uint32_t> sides, partners;
};

// Joins sides on the border whose partners are beside each other, too, and no cone is between.
// \param partner of each side that is cut, on the border; else `Gluing::none`
// \param is_cone nonzero for each vertex of the pieces that is a copy of a cone
std::vector<Border_seam> find_seams(const Glued_pieces& pieces,
                                    const std::vector<std::uint32_t>& partner,
                                    const std::vector<char>& is_cone);

// The same for a surface that was cut open.
std::vector<Border_seam> seams_of(const Opened_surface& s, const Glued_pieces& pieces,
                                  const std::vector<char>& is_cone);

// Marks the vertices of a surface that are copies of some vertices before the cut.
std::vector<char> copies_of(const Opened_surface& s, std::span<const std::uint32_t> vertices);

// \throws Invalid_input naming two faces that are not oriented alike
void expect_oriented(const Gluing& g);

// \param handles the genus that a surface must have
// \param name what such a surface is called
// \throws Invalid_input if it is not closed, connected, oriented and of this genus
void expect_closed(const Gluing& g, std::size_t handles, const std::string& name);

// The side on the border that starts at each vertex, or `Gluing::none`.
std::vector<std::uint32_t> border_from(const Glued_pieces& pieces);

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_CONFORMAL_LAYOUT_GLUED_PIECES_H

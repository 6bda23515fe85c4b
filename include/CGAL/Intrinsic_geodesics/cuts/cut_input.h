// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_INPUT_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_INPUT_H

#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief is the input of an intrinsic triangulation that was cut open along edges: the input of a
triangulation of the pieces.

Faces keep their numbers; pieces that become orientable are oriented. Lengths are those before,
exactly. A vertex with n cut edges has n copies, see `cut_open()`: the first one has its number,
others have the numbers after. So rows of matrices are those of copies.
*/
struct Opened_input {
  Intrinsic_input input; ///< the pieces
  /// The vertex before the cut that each vertex is a copy of.
  std::vector<std::uint32_t> original_vertex;
  /// The vertices of `input` at the corners of each face, counterclockwise, in the order of the
  /// sides of the face; for values per corner.
  std::vector<std::array<std::uint32_t, 3>> corners;
  /// Nonzero for each face that was turned around, whose side k is 2 - k now; empty: there is none.
  std::vector<char> reversed_faces;
};

/*!
\brief takes the triangles below a double cover: those from which `make_domain()` made it, glued
where two of them meet.

Edges where more triangles meet are borders of each of them. The surface need not be orientable:
cut it to disks, which are, before you build a triangulation. So it maps any triangles to the plane:

    const Intrinsic_input sheet = sheet_of_cover(make_domain(soup).input);
    const Opened_input disks = cut_open(sheet, cut_to_disk(sheet));

\param cover the result of `make_domain()`
\return the triangles, in their order, with a vertex for each of the user; the input itself if it is
  no cover
\throws Invalid_input if it has more than two sheets: there are no triangles below a cloud of points
\complexity linear
*/
Intrinsic_input sheet_of_cover(const Intrinsic_input& cover);

/*!
\brief finds a short cut along edges that makes a disk of each component of an input; see the
overload for arrays in `cut_to_disk.h`.

The user's polygons stay whole: diagonals are not cut.
\param in the input, with any numbers of handles and borders, orientable or not
\param through vertices that the cut passes through
\param roots how many roots are tried
\return nonzero for each edge to cut, by its number in `in.mesh`; `cut_open()` takes it
\throws Invalid_input as the overload for arrays does
\complexity n log n for each root
*/
std::vector<char> cut_to_disk(const Intrinsic_input& in,
                              std::span<const std::uint32_t> through = {}, std::size_t roots = 8);

/*!
\brief cuts the input of an intrinsic triangulation open along edges.

Parametrization, which needs a disk, then works for every surface:

    const Opened_input disk = cut_open(in, cut_to_disk(in));
    Intrinsic_triangulation<> t(disk.input);
    const Injective_map map = injective_harmonic_map(t);
    // corner k of face f is at map.uv.row(disk.corners[f][k])

The pieces are oriented, as most of the faces of each are, if they are orientable.
\param in the input
\param is_cut nonzero for each edge to cut, by its number in `in.mesh`; border edges are cut already
\return the pieces
\throws Invalid_input if there is not one mark for each edge, or the input is a cover
\complexity linear
*/
Opened_input cut_open(const Intrinsic_input& in, const std::vector<char>& is_cut);

/*!
\brief cuts the input of an intrinsic triangulation to disks, one for each component: along the
short cut of `cut_to_disk()`, or along given edges.
\param in the input; of a cover give `sheet_of_cover()`
\param is_cut nonzero for each edge to cut, by its number in `in.mesh`; empty: the short cut
\return the disks
\throws Invalid_input as `cut_to_disk()` and `cut_open()` do, or if given edges leave handles, more
  than one border or one side only
\complexity that of `cut_to_disk()`; linear with given edges
*/
Opened_input cut_to_disks(const Intrinsic_input& in, const std::vector<char>& is_cut = {});

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_INPUT_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_ELEMENT_NAMES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_ELEMENT_NAMES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief maps the numbers of the input's vertices, edges or faces to their numbers in the user's mesh
(its iteration order), and back.

They differ where elements were renumbered for locality or polygons were triangulated; diagonals
have no user's number.
*/
class Element_names {
public:
  /// maps every number to itself.
  Element_names() = default;
  /*!
  \brief takes both maps.
  \param user the user's number of each element; `Gluing::none` if it has none
  \param here the element by the user's number
  */
  Element_names(std::vector<std::uint32_t> user, std::vector<std::uint32_t> here)
      : user_(std::move(user)), here_(std::move(here)) {}

  /// takes the user's numbers and inverts them. \complexity linear
  explicit Element_names(std::vector<std::uint32_t> user)
      : user_(std::move(user)), here_(inverse_of(user_)) {}

  /// tells whether every number is mapped to itself.
  bool is_identity() const { return user_.empty(); }
  /// returns the user's number of an element, `Gluing::none` if it has none; elements that were
  /// inserted keep their number.
  std::uint32_t user(std::uint32_t here) const { return here < user_.size() ? user_[here] : here; }
  /// returns the element with the user's number; `Gluing::none` if there is none.
  std::uint32_t here(std::uint32_t user) const {
    if (user_.empty()) return user;
    return user < here_.size() ? here_[user] : Gluing::none;
  }
  /// returns the user's number of each element; empty: the same.
  const std::vector<std::uint32_t>& users() const { return user_; }

  /// returns the names after a renumbering, which maps the new numbers to those of these names.
  Element_names after(const Element_names& renumbered) const;

private:
  static std::vector<std::uint32_t> inverse_of(const std::vector<std::uint32_t>& user);

  std::vector<std::uint32_t> user_;
  std::vector<std::uint32_t> here_;
};

/*!
\brief names the vertices, edges and faces of the input as the user's mesh does.

On a cover (see `make_domain()`), names are those of the cover: its vertices are copies of the
user's vertices, its faces parts of the user's faces.
*/
struct Input_names {
  Element_names vertices; ///< rows of matrices
  Element_names edges;    ///< diagonals of polygons have no name
  Element_names faces;    ///< triangles, in the order of the user's faces that they were made of
  /// The user's face that each triangle, by its name, is a part of; empty: all faces are triangles.
  std::vector<std::uint32_t> polygon_of_triangle;

  /// The user's vertex that each vertex, by its name, is a copy of, ascending; empty: all are
  /// vertices of the user.
  std::vector<std::uint32_t> row_of_vertex;
  /// How many sheets of the surface lie over each face of the user: 2 if it is a double cover; more
  /// over the triangles of a cloud of points, which are in several stars.
  std::uint32_t sheets = 1;

  /// tells whether the surface is a cover.
  bool is_cover() const { return sheets > 1; }
  /// tells whether more than two sheets lie over a face, as over a cloud of points.
  bool is_cloud() const { return sheets > 2; }

  /// returns the user's vertex that an input vertex is, or is a copy of: its row in matrices.
  std::uint32_t row(std::uint32_t vertex) const {
    const std::uint32_t v = vertices.user(vertex);
    return row_of_vertex.empty() ? v : row_of_vertex[v];
  }
  /// returns an input vertex that is the user's vertex, or the first copy of it.
  std::uint32_t vertex(std::uint32_t row) const;
  /// returns the number of the user's vertices, given the number of input vertices.
  std::uint32_t number_of_rows(std::uint32_t vertices_of_input) const {
    return row_of_vertex.empty() ? vertices_of_input : row_of_vertex.back() + 1;
  }
  /// returns the user's face that an input face is, or is a part of.
  std::uint32_t polygon(std::uint32_t face) const {
    const std::uint32_t triangle = faces.user(face);
    return polygon_of_triangle.empty() ? triangle : polygon_of_triangle[triangle];
  }
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_ELEMENT_NAMES_H

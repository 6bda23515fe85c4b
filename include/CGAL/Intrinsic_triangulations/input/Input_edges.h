// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_EDGES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief finds edges of the user's mesh, to keep them or to cut along them: by their ends, or by how
sharp they are.

Diagonals of polygons are no edges of the user. Marks are numbers that are nonzero, one per edge of
the input by its number, as `constrained_input_edges()` and `cut_to_disks()` take them.
*/
class Input_edges {
public:
  /// reads the edges of an input, which must outlive it.
  explicit Input_edges(const Intrinsic_input& input);
  explicit Input_edges(const Intrinsic_input&& input) = delete; ///< it would not outlive it
  /// reads those of the input of a triangulation, which must outlive it.
  explicit Input_edges(const Input& input);
  explicit Input_edges(const Input&& input) = delete; ///< it would not outlive it

  /// returns marks of which none is set.
  std::vector<char> no_marks() const { return std::vector<char>(mesh_->number_of_edges(), 0); }
  /*!
  \brief marks the edges between two of the user's vertices.
  \param i the number of a vertex
  \param j that of another one, or the same
  \param marks get 1 at these edges
  \return whether there are any; false for a number that no vertex has
  \pre there is a mark for each edge, see `no_marks()`
  \complexity logarithmic, after the first call, which sorts the edges
  */
  bool mark(std::uint32_t i, std::uint32_t j, std::vector<char>& marks);
  /*!
  \brief marks the edges at which the faces are folded by more than an angle.
  \param degrees between the normals of the faces
  \param marks get 1 at these edges
  \pre the input has points, and there is a mark for each edge, see `no_marks()`
  \complexity linear
  */
  void mark_sharp(double degrees, std::vector<char>& marks) const;

private:
  using Ends = std::pair<std::uint32_t, std::uint32_t>;

  bool is_diagonal(std::uint32_t e) const;
  std::array<double, 3> normal(Gluing_map::Face f) const;

  const Gluing_map* mesh_;
  const std::vector<std::array<double, 3>>* points_;
  const Input_names* names_;
  std::vector<std::pair<Ends, std::uint32_t>> edges_{}; // sorted, or not yet found
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_INPUT_EDGES_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_LIST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_LIST_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief lists the halfedges that were flipped, the first flip first.

The list and the connectivity after the flips determine the connectivity before: flips are taken
back one by one. It also stores which edges were ever flipped: a face without a flipped side is a
face of the input.
*/
class Flip_list {
public:
  /// returns the number of flips.
  std::size_t size() const { return size_; }
  /// returns the halfedge that flip `n` turned clockwise.
  Gluing_map::Halfedge operator[](std::size_t n) const { return {halfedges_[n]}; }
  /// tells whether an edge was ever flipped.
  bool contains(std::uint32_t edge) const { return edge < is_flipped_.size() && is_flipped_[edge]; }
  /// makes room for a flip. \complexity constant, amortized
  void make_room(std::uint32_t halfedge) {
    if (size_ == halfedges_.size()) halfedges_.resize(2 * size_ + 64);
    const std::size_t edge = halfedge / 2;
    if (edge >= is_flipped_.size()) is_flipped_.resize(edge + edge / 2 + 1);
  }
  /// adds a flip. \pre there is room for it
  void add(std::uint32_t halfedge) noexcept {
    halfedges_[size_++] = halfedge;
    is_flipped_[halfedge / 2] = true;
  }
  /// forgets the last flip.
  void forget_last() noexcept { --size_; }
  /// forgets all flips.
  void clear() noexcept { *this = {}; }

  /*!
  \brief returns the connectivity before the flips.

  Halfedges of its faces and vertices may be others than those of the input.
  \param mesh that after the flips
  \param visit called with the number of each flip, the last one first, and the mesh after it
  \complexity linear in the number of flips and of elements
  */
  template <class Visit>
  Gluing_map undone(Gluing_map mesh, const Visit& visit) const {
    for (std::size_t n = size(); n-- > 0;) {
      visit(n, std::as_const(mesh));
      flip_edge_back((*this)[n], mesh);
    }
    return mesh;
  }
  /// returns the connectivity of the input, where each face has its first side.
  /// \param mesh that after the flips \param input the surface
  Gluing_map input_mesh(Gluing_map mesh, const Input_definition& input) const;

  /// returns the first side of a face of the input: the metric names it where the connectivity is
  /// not kept.
  static Gluing_map::Halfedge first_side(const Gluing_map& mesh, Gluing_map::Face f,
                                         const Input_definition& input);

private:
  std::vector<std::uint32_t> halfedges_; // and room for more
  std::size_t size_ = 0;
  std::vector<bool> is_flipped_; // by edge; of a flip that was taken back, too
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_FLIP_LIST_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/moves.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows the flips that have made some faces, and makes these flips again in any arithmetic.

Each flip is rational in the values that it finds, so that the values of faces lie in the field of the areas of the input.
This takes few steps where edges cross very many input edges: n flips can make 1.6^n crossings.
*/
class Replayed_faces {
public:
  /*!
  \brief finds the flips.
  \param input the surface
  \param mesh the connectivity after all flips
  \param flips all flips
  \param faces the faces, each from a side on
  \complexity linear in the number of flips and of elements
  */
  Replayed_faces(const Input_definition& input, const Gluing_map& mesh, const Flip_list& flips,
                 std::vector<Indexed_face> faces)
      : faces_(std::move(faces)) {
    Gluing_map before = mesh;
    std::vector<char> is_needed(mesh.number_of_faces(), 0);
    for (const Indexed_face& f : faces_) is_needed[f.face] = 1;
    for (std::size_t n = flips.size(); n-- > 0;) {
      const Gluing_map::Halfedge h = flips[n];
      const std::uint32_t f = before.face(h).index, g = before.face(Gluing_map::opposite(h)).index;
      flip_edge_back(h, before);
      if (!is_needed[f] && !is_needed[g]) continue;
      is_needed[f] = is_needed[g] = 1;
      flips_.push_back(diamond(h, before));
    }
    std::reverse(flips_.begin(), flips_.end());
    find_sides(Flip_list().undone(std::move(before), input));
  }

  /// returns the number of flips.
  std::size_t size() const { return flips_.size(); }

  /*!
  \brief evaluates the faces.
  \tparam FT a model of `Field`
  \tparam Input_values see `Unfolded_diamond::positions()`
  */
  template <class FT, class Input_values>
  std::vector<Face_values<FT>> values(const Input_values& input) const {
    std::unordered_map<std::uint32_t, FT> lengths, areas; // of edges and faces that flips have made
    const auto length = [&](std::uint32_t e) -> FT {
      if (const auto made = lengths.find(e); made != lengths.end()) return made->second;
      const Face_side s = sides_.at(e);
      return input(s.face).first[s.slot];
    };
    const auto area = [&](std::uint32_t f) -> FT {
      const auto made = areas.find(f);
      return made != areas.end() ? made->second : FT(input(f).second);
    };
    for (const Diamond& d : flips_) {
      const Flipped_values<FT> n =
          flipped(Diamond_values<FT>{length(d.ij), length(d.jk), length(d.ki), length(d.im),
                                     length(d.mj), area(d.f), area(d.g)});
      lengths.insert_or_assign(d.ij, n.km);
      areas.insert_or_assign(d.f, n.area_f);
      areas.insert_or_assign(d.g, n.area_g);
    }
    std::vector<Face_values<FT>> result;
    for (const auto& [f, e] : faces_)
      result.push_back({{length(e[0]), length(e[1]), length(e[2])}, area(f)});
    return result;
  }

private:
  static Diamond diamond(Gluing_map::Halfedge h, const Gluing_map& mesh) {
    const Gluing_map::Halfedge o = Gluing_map::opposite(h), jk = mesh.next(h), im = mesh.next(o);
    return {h.index / 2,
            jk.index / 2,
            mesh.next(jk).index / 2,
            im.index / 2,
            mesh.next(im).index / 2,
            mesh.face(h).index,
            mesh.face(o).index};
  }

  void find_sides(const Gluing_map& input) {
    const auto find = [&](std::uint32_t e) {
      Gluing_map::Halfedge h{2 * e};
      if (input.face(h).index == Gluing::none) h = Gluing_map::opposite(h);
      const auto sides = input.sides(input.face(h));
      const auto slot = std::find(sides.begin(), sides.end(), h) - sides.begin();
      sides_.insert({e, {input.face(h).index, static_cast<std::uint32_t>(slot)}});
    };
    for (const Diamond& d : flips_)
      for (const std::uint32_t e : {d.ij, d.jk, d.ki, d.im, d.mj}) find(e);
    for (const Indexed_face& f : faces_)
      for (const std::uint32_t e : f.edges) find(e);
  }

  std::vector<Indexed_face> faces_;
  std::vector<Diamond> flips_;
  std::unordered_map<std::uint32_t, Face_side> sides_; // of edges, in the input
};

/// Two faces, joined along the first side of each, as a diamond.
class Replayed_diamond {
public:
  /// takes the faces on the left and on the right.
  explicit Replayed_diamond(Replayed_faces faces) : faces_(std::move(faces)) {}
  /// returns the number of flips.
  std::size_t size() const { return faces_.size(); }
  /// evaluates the diamond; see `Replayed_faces::values()`.
  template <class FT, class Input_values>
  Diamond_values<FT> values(const Input_values& input) const {
    const auto v = faces_.values<FT>(input);
    return diamond_values(v[0], v[1]);
  }

private:
  Replayed_faces faces_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H

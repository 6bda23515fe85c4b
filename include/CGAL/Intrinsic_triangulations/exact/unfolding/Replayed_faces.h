// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief knows the flips that have made some faces, or all, and makes them again in any arithmetic.

Each flip is rational in the values that it finds, so that the values of faces lie in the field of the areas of the input.
This takes few steps where edges cross very many input edges: n flips can make 1.6^n crossings.
*/
class Replayed_faces {
public:
  /*!
  \brief finds the flips.
  \param input the surface
  \param mesh the connectivity after all flips
  \param flips all flips; must outlive this object
  \param faces the faces, each from a side on
  \complexity linear in the number of flips and of elements
  */
  Replayed_faces(const Input_definition& input, Gluing_map mesh, const Flip_list& flips,
                 std::vector<Indexed_face> faces)
      : flips_(&flips), is_needed_(flips.size()), faces_(std::move(faces)) {
    std::vector<char> is_needed(mesh.number_of_faces(), 0);
    for (const Indexed_face& f : faces_) is_needed[f.face] = 1;
    input_ = flips.undone(std::move(mesh), input, [&](std::size_t n, const Gluing_map& after) {
      char& f = is_needed[after.face(flips[n]).index];
      char& g = is_needed[after.face(Gluing_map::opposite(flips[n])).index];
      if (f == 0 && g == 0) return;
      f = g = 1;
      is_needed_[n] = true;
      ++size_;
    });
  }

  /// returns the number of flips.
  std::size_t size() const { return size_; }

  /*!
  \brief evaluates the faces.
  \tparam FT a model of `Field`
  \tparam Input_values see `Unfolded_diamond::positions()`
  \param visit called with the `Face_values<FT>` of each face, in order
  */
  template <class FT, class Input_values, class Visit>
  void for_each_face(const Input_values& input, const Visit& visit) const {
    Gluing_map mesh = input_;
    Known_values<FT> known(mesh);
    for (std::size_t n = 0; n < flips_->size(); ++n) {
      const Gluing_map::Halfedge h = (*flips_)[n];
      if (is_needed_[n]) {
        const Diamond d = diamond(h, mesh);
        known.find(d.f, mesh, input);
        known.find(d.g, mesh, input);
        known.flip(d);
      }
      CGAL::Euler::flip_edge(h, mesh);
    }
    for (const Indexed_face& f : faces_) {
      known.find(f.face, mesh, input);
      visit(known.values(f));
    }
  }

  /// returns the values of the faces; see above.
  template <class FT, class Input_values>
  std::vector<Face_values<FT>> values(const Input_values& input) const {
    std::vector<Face_values<FT>> result;
    result.reserve(faces_.size());
    for_each_face<FT>(input, [&](const Face_values<FT>& f) { result.push_back(f); });
    return result;
  }

private:
  // Values of the faces that flips have met. Before that, a face is one of the input, and its
  // halfedge is its first side.
  template <class FT>
  class Known_values {
  public:
    explicit Known_values(const Gluing_map& mesh)
        : length_place_(mesh.number_of_edges(), 0), area_place_(mesh.number_of_faces(), 0) {}

    template <class Input_values>
    void find(std::uint32_t f, const Gluing_map& mesh, const Input_values& input) {
      if (area_place_[f] != 0) return;
      const auto& [lengths, area] = input(f);
      add(area_place_[f], areas_, area);
      const auto sides = mesh.sides({f});
      for (std::size_t k = 0; k < 3; ++k)
        if (std::uint32_t& place = length_place_[sides[k].index / 2]; place == 0)
          add(place, lengths_, lengths[k]);
    }
    void flip(const Diamond& d) {
      const Flipped_values<FT> n =
          flipped(Diamond_values<FT>{length(d.ij), length(d.jk), length(d.ki), length(d.im),
                                     length(d.mj), area(d.f), area(d.g)});
      lengths_[length_place_[d.ij] - 1] = n.km;
      areas_[area_place_[d.f] - 1] = n.area_f;
      areas_[area_place_[d.g] - 1] = n.area_g;
    }
    Face_values<FT> values(const Indexed_face& f) const {
      return {{length(f.edges[0]), length(f.edges[1]), length(f.edges[2])}, area(f.face)};
    }

  private:
    const FT& length(std::uint32_t e) const { return lengths_[length_place_[e] - 1]; }
    const FT& area(std::uint32_t f) const { return areas_[area_place_[f] - 1]; }
    static void add(std::uint32_t& place, std::vector<FT>& values, const FT& value) {
      values.push_back(value);
      place = static_cast<std::uint32_t>(values.size());
    }

    std::vector<std::uint32_t> length_place_, area_place_; // number in `lengths_` and one, or zero
    std::vector<FT> lengths_, areas_;
  };

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

  Gluing_map input_;
  const Flip_list* flips_;
  std::vector<bool> is_needed_;
  std::size_t size_ = 0;
  std::vector<Indexed_face> faces_;
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

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_UNFOLDING_REPLAYED_FACES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes `flipped()` in 106 bits, with one radius per result instead of one per operation.

With m = L_mj - L_im and k = L_jk - L_ki, so that p_k - p_m = m - k, and n = a_f m + a_g k,

    L_km = ((m - k)^2 + (a_f + a_g)^2) / (4 L_ij),    areas (a_f + a_g) / 2 +- n / (2 L_ij).

With e = `Double_double::rounding()`, a sum of u and v has the radius r_u + r_v and e (|u| + |v|); a
product has |u| r_v + |v| r_u + r_u r_v and e |u v|; the quotient of s by L has
(r_s + |s / L| r_L) / (L - r_L), as that of two `Ball`s, and 2 e of itself, for the inverse and the
product. The terms with e^2 and the rounding of radii are left out below: they are smaller than the
excess of e over the errors of operations.

\param e four times as much allows any rounding: upwards doubles the error of each operation on
doubles, which makes those of double-doubles, products of two such errors, four times as large
(Boldo, Graillat, Muller, "On the robustness of the 2Sum and Fast2Sum algorithms", 2017).
*/
Flipped_values<Short_ball> flipped(const Diamond_values<Short_ball>& d,
                                   double e = Double_double::rounding());

/*!
\brief computes `cotangent_weight()` in 106 bits, with one radius; errors are as in `flipped()`.

With numerators p = L_jk + L_ki - L_ij and q = L_im + L_mj - L_ij, the weight is w = s / (2 a_f a_g)
where s = p a_g + q a_f. A sum of three numbers goes through two roundings of at most the sum of
their magnitudes.
\pre rounding is to the nearest
*/
Short_ball weight_in_106_bits(const Diamond_values<Short_ball>& d);

/*!
\brief holds the values of the faces that flips have met, and of those that were asked for; before
that, a face is one of the input.
\tparam FT a model of `Field`
*/
template <FieldNumber FT>
class Replayed_values {
public:
  /// knows nothing yet.
  /// \param mesh the connectivity of the input
  /// \param are_most whether it will know most faces: values then lie in their order
  Replayed_values(const Gluing_map& mesh, bool are_most)
      : length_place_(mesh.number_of_edges(), 0), area_place_(mesh.number_of_faces(), 0),
        are_most_(are_most) {
    if (!are_most) return;
    lengths_.resize(mesh.number_of_edges());
    areas_.resize(mesh.number_of_faces());
  }

  /// makes room for values of so many edges and faces. \pre they lie in their order
  void make_room(std::uint32_t edges, std::uint32_t faces) {
    if (edges > length_place_.size()) { // grows last, if memory is not exhausted
      lengths_.resize(edges);
      length_place_.resize(edges, 0);
    }
    if (faces > area_place_.size()) {
      areas_.resize(faces);
      area_place_.resize(faces, 0);
    }
  }
  /// tells whether all values are accurate, see `Ball::is_narrow()`. \pre it knows all faces, and
  /// they lie in their order
  bool are_narrow(double error) const requires requires(const FT& x) { x.is_narrow(error); }
  {
    const auto is_narrow = [error](const FT& x) { return x.is_narrow(error); };
    return std::all_of(lengths_.begin(), lengths_.end(), is_narrow) &&
           std::all_of(areas_.begin(), areas_.end(), is_narrow);
  }
  /// stores the squared length of an edge. \pre values lie in their order, and there is room
  void set_length(std::uint32_t e, const FT& value) { add(e, length_place_, lengths_, value); }
  /// stores the quadruple area of a face, whose lengths it knows. \pre see above
  void set_area(std::uint32_t f, const FT& value) { add(f, area_place_, areas_, value); }

  /// tells whether it knows a face.
  bool knows(std::uint32_t f) const { return area_place_[f] != 0; }
  /// adds a face of the input from its first side on.
  template <class Face>
  void add(std::uint32_t f, const Gluing_map& mesh, Gluing_map::Halfedge side, const Face& values) {
    add(f, area_place_, areas_, values.second);
    for (const FT& length : values.first) {
      const std::uint32_t e = side.index / 2;
      if (length_place_[e] == 0) add(e, length_place_, lengths_, length);
      side = mesh.next(side);
    }
  }
  /// follows a flip. \pre it knows both faces
  void flip(const Diamond& d) { store(d, flipped(values(d))); }
  /// stores the new values of a flip. \pre see above
  void store(const Diamond& d, const Flipped_values<FT>& n) {
    lengths_[length_place_[d.ij] - 1] = n.km;
    areas_[area_place_[d.f] - 1] = n.area_f;
    areas_[area_place_[d.g] - 1] = n.area_g;
  }

  /// forgets all other faces.
  void keep_only(const std::vector<Indexed_face>& faces) {
    std::vector<std::uint32_t> places(area_place_.size(), 0);
    for (const Indexed_face& f : faces) places[f.face] = area_place_[f.face];
    area_place_ = std::move(places);
  }

  /// returns the values of a diamond. \pre it knows both faces
  Diamond_values<FT> values(const Diamond& d) const {
    return {length(d.ij), length(d.jk), length(d.ki), length(d.im),
            length(d.mj), area(d.f),    area(d.g)};
  }
  /// returns the values of a face. \pre it knows it
  Face_values<FT> values(const Indexed_face& f) const {
    return {{length(f.edges[0]), length(f.edges[1]), length(f.edges[2])}, area(f.face)};
  }
  /// returns the squared length of an edge. \pre it knows a face of it
  const FT& length(std::uint32_t e) const { return lengths_[length_place_[e] - 1]; }
  /// returns the quadruple area of a face. \pre it knows it
  const FT& area(std::uint32_t f) const { return areas_[area_place_[f] - 1]; }

private:
  void add(std::uint32_t i, std::vector<std::uint32_t>& places, std::vector<FT>& values,
           const FT& value) {
    if (are_most_)
      values[i] = value;
    else
      values.push_back(value);
    places[i] = are_most_ ? i + 1 : static_cast<std::uint32_t>(values.size());
  }

  std::vector<std::uint32_t> length_place_, area_place_; // number in `lengths_` and one, or zero
  std::vector<FT> lengths_, areas_;
  bool are_most_;
};

/*!
\brief repeats the flips that made some faces, or all, in any arithmetic.

Each flip is rational in the values that it finds, so that the values of faces lie in the field of
the areas of the input. This is much shorter than unfolding if edges cross very many input edges: n
flips can make 1.6^n crossings.
*/
class Replayed_faces {
public:
  /*!
  \brief finds the flips.
  \param input the surface; must outlive this object, and so must `flips`
  \param mesh the connectivity after all flips
  \param flips all flips
  \param faces the faces, each from a side on
  \complexity linear in the number of flips and of elements
  */
  Replayed_faces(const Input_definition& input, Gluing_map mesh, const Flip_list& flips,
                 std::vector<Indexed_face> faces);
  /// takes all flips, since faces are most of those of a triangulation of a surface; see above.
  Replayed_faces(const Input& surface, const Flip_list& flips, std::vector<Indexed_face> faces)
      : input_(&surface), mesh_of_input_(&surface.mesh()), flips_(&flips),
        is_needed_(flips.size(), true), size_(flips.size()), faces_(std::move(faces)) {}

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
    const Replayed_values<FT> known = known_values<FT>(input);
    for (const Indexed_face& f : faces_) visit(known.values(f));
  }

  /// returns the values of the faces; if no flip is left out, also of others that flips have met.
  /// \see `for_each_face()`
  template <class FT, class Input_values>
  Replayed_values<FT> known_values(const Input_values& input) const& {
    return known_values<FT>(input, mesh_of_input_ != nullptr ? *mesh_of_input_ : mesh_);
  }
  /// returns the same, for the last time: it need not copy the mesh.
  template <class FT, class Input_values>
  Replayed_values<FT> known_values(const Input_values& input) && {
    if (mesh_of_input_ != nullptr) mesh_ = *mesh_of_input_;
    return known_values<FT>(input, std::move(mesh_));
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
  // \param mesh before the flips; in the end only of the faces that are needed
  template <class FT, class Input_values>
  Replayed_values<FT> known_values(const Input_values& input, Gluing_map mesh) const {
    Replayed_values<FT> known(mesh, 2 * faces_.size() >= mesh.number_of_faces());
    const auto find = [&](std::uint32_t f) {
      if (!known.knows(f)) known.add(f, mesh, Flip_list::first_side(mesh, {f}, *input_), input(f));
    };
    for (std::size_t n = 0; n < flips_->size(); ++n) {
      if (!is_needed_[n]) continue;
      const Gluing_map::Halfedge h = (*flips_)[n];
      const Diamond d = diamond(h, mesh);
      find(d.f);
      find(d.g);
      known.flip(d);
      CGAL::Euler::flip_edge(h, mesh);
    }
    for (const Indexed_face& f : faces_) find(f.face);
    if (size_ < flips_->size()) known.keep_only(faces_); // others are not up to date
    return known;
  }

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

  const Input_definition* input_;
  const Gluing_map* mesh_of_input_ = nullptr; // before all flips, if known, else in `mesh_`
  Gluing_map mesh_;                           // before the flips
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

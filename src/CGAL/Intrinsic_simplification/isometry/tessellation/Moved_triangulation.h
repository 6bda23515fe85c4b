// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_MOVED_TRIANGULATION_H
#define CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_MOVED_TRIANGULATION_H

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Chart_grid.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Developed_faces.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Value_recipes.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Repartition.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
A triangulation of which vertices of the input can be removed: connectivity, and names for the
values of its elements. It starts as a triangulation of the input and decides signs exactly: by
small integers where faces are on a grid, by enclosures of 106 bits, then in the field of the
square roots, then in more bits.
*/
class Moved_triangulation {
public:
  using Halfedge = Gluing_map::Halfedge;
  using Id = Value_recipes::Id;
  using Diamond_ids = Value_recipes::Diamond_ids;

  // \param t must outlive this object, and stay as it is
  explicit Moved_triangulation(const Corresponding_triangulation& t);

  const Gluing_map& mesh() const { return numbered_.mesh; }
  const Value_recipes& recipes() const { return recipes_; }
  const Developed_faces& developed() const { return developed_; }
  // all moves so far
  const std::vector<Repartition>& moves() const { return moves_; }
  Id length(std::uint32_t edge) const { return length_[edge]; }
  Id area(std::uint32_t face) const { return area_[face]; }
  // whether no move has changed the face
  bool is_original(std::uint32_t face) const { return area_[face] == recipes_.area_of_face(face); }
  // an enclosure that is narrow, unless moves are very many: below 2^-90 of the
  // value
  Short_ball narrow_enclosure(Id id) const;
  // a double near a value, with an error far below the mean edge
  double approximate(Id id) const {
    const Short_ball& quick = short_(id);
    const double x = quick.to_double();
    return quick.radius() <= 0x1p-60 * (1 + std::abs(x)) ? x : narrow_enclosure(id).to_double();
  }

  // the double nearest to a value, by exact arithmetic where enclosures leave
  // it open
  double nearest(Id id) const;

  // Gives faces at flat vertices that lie in planes common coordinates. \pre no move was made
  void lay_out_planes(const std::vector<char>& is_flat);
  // the face, with its first side on an axis, in doubles
  Plane_face lay_out(Halfedge h) const;
  // faces before or after a move, in doubles; the origin is the same for both
  std::vector<Plane_face> lay_out(const Repartition& move, const Repartition::Faces& faces) const;
  // whether both sides of the edge have faces, not the same one
  bool has_diamond(Halfedge h) const {
    const Gluing_map& m = mesh();
    const auto f = m.face(h), g = m.face(Gluing_map::opposite(h));
    return f.index != Gluing::none && g.index != Gluing::none && f.index != g.index;
  }
  bool is_in_one_frame(Halfedge h) const { return developed_.is_in_one_frame(h); }
  // A diamond: names of its values, and its corners if they are on a grid.
  struct Moved_diamond {
    Diamond_ids ids;
    const Chart_grid* grid; // or null
    Grid_diamond corners;
  };
  Moved_diamond diamond(Halfedge h) const;
  Diamond_values<double> approximate(Halfedge h) const;

  // \throws Undecidable
  template <class Expression>
  Sign sign(const Moved_diamond& d, const Expression& expression) const {
    if (d.grid != nullptr)
      if (const std::optional<Sign> s = d.grid->sign(d.corners, expression)) return *s;
    const Uncertain<Sign> quick = expression(short_(d.ids)).sign();
    return is_certain(quick) ? get_certain(quick) : exact_sign(d.ids, expression);
  }

  // \pre it has a diamond, whose new faces have areas; that of the source of
  // `h` may be zero
  void flip(Halfedge h);
  // \param h the halfedge ij of a face ijp, where p has three edges, none a
  // loop
  void remove_inner_vertex(Halfedge h);
  // \param h the halfedge ip of the border that has a face, where p has one
  // inner edge
  void remove_border_vertex(Halfedge h);

private:
  template <class Expression>
  Sign exact_sign(const Diamond_ids& d, const Expression& expression) const {
    const auto certain = [](const Long_ball& x) -> std::optional<Sign> {
      const Uncertain<Sign> s = x.sign();
      return is_certain(s) ? std::optional(get_certain(s)) : std::nullopt;
    };
    const auto in_bits = [&](unsigned bits) {
      const Mpfr_precision precision(bits);
      return certain(expression(long_values(bits)(d)));
    };
    const auto value = [&] { return expression((*exact_)(d)); };
    // most open signs are zero, in planes: then numbers of the field are short
    std::optional<Square_root_field::Number> x = in_field(few_words, value);
    // after many moves, enclosures of 106 bits are wide
    for (const unsigned bits : {256U, 1024U})
      if (const auto s = x ? std::nullopt : in_bits(bits)) return *s;
    if (!x) x = in_field(most_words, value);
    if (!x) { // once more, without the roots that others needed
      start_field();
      x = in_field(most_words, value);
    }
    if (x && x->is_zero()) return ZERO;
    if (x)
      if (const auto s = in_growing_precision([&] { return certain(enclosure_of(*x)); })) return *s;
    if (const auto s = in_bits(Mpfr_number::most_bits)) return *s;
    throw Undecidable("a sign that removing flat vertices depends on could not be proven");
  }
  // What a function returns that computes in the field; nothing if that takes too long.
  template <class Function>
  auto in_field(std::size_t most, const Function& f) const -> std::optional<decltype(f())> {
    most = std::min(most, words_left_);
    if (most == 0) return std::nullopt;
    field_->limit_products(most);
    std::optional<decltype(f())> result;
    try {
      result = f();
    } catch (const std::length_error&) {
    }
    words_left_ -= most - field_->words_left();
    return result;
  }
  // values in so many bits, each computed once
  Developed_faces::Evaluation<Long_ball>& long_values(unsigned bits) const {
    return long_.try_emplace(bits, developed_).first->second;
  }
  void start_field() const;
  Plane_vector<double> approximate_vector(Developed_faces::Point from,
                                          Developed_faces::Point to) const;
  // whether the area of three points is proven not to be zero
  bool has_area(const std::array<Developed_faces::Point, 3>& corners) const;
  Moved_face face_at(Halfedge h) const;
  // names the areas of faces that a move has made, and chooses their frames
  void name_areas(std::initializer_list<Halfedge> faces);

  static constexpr std::size_t few_words = std::size_t(1) << 12;
  // words of coefficients that one sign may cost: some tenths of a second; and
  // all of them
  static constexpr std::size_t most_words = std::size_t(1) << 22;
  mutable std::size_t words_left_ = std::size_t(1) << 26;

  Mesh_with_numbers<Gluing_map> numbered_;
  Value_recipes recipes_;
  Developed_faces developed_;
  std::vector<Id> length_, area_;
  std::vector<Repartition> moves_;
  mutable Developed_faces::Evaluation<Short_ball> short_;
  mutable std::map<unsigned, Developed_faces::Evaluation<Long_ball>> long_; // by precision
  mutable std::unique_ptr<Square_root_field> field_;
  mutable std::unique_ptr<Developed_faces::Evaluation<Square_root_field::Number>> exact_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_ISOMETRY_TESSELLATION_MOVED_TRIANGULATION_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRIANGULATION_UNFOLDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRIANGULATION_UNFOLDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Flat_parts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flat_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Input_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

// Unfolds the input under an intrinsic triangulation by its integer coordinates, which `Places` keeps.
template <class Triangulation, class Places>
class Triangulation_unfolder final : public Input_unfolder {
public:
  Triangulation_unfolder(const Triangulation& t, const Places& places) : t_(t), places_(places) {}

  std::optional<Flat_diamond> flat_diamond(const Diamond& d) override {
    if (!t_.input().metric().is_in_space() ||
        !can_unfold(std::array{d.ij, d.jk, d.ki, d.im, d.mj}, d.f == d.g))
      return std::nullopt;
    const std::uint32_t ij = halfedge(d.f, d.ij, d.jk), p = part(d, ij);
    if (p == Flat_parts::none) return std::nullopt;
    const View view(t_);
    return Flat_diamond{p,
                        {corner(view.source(ij)), corner(view.target(ij)),
                         corner(view.target(view.next(ij))),
                         corner(view.target(view.next(ij ^ 1U)))}};
  }
  const Unfolded_diamond* diamond(const Diamond& d) override {
    if (!can_unfold(std::array{d.ij, d.jk, d.ki, d.im, d.mj}, d.f == d.g)) return nullptr;
    return &unfolded(halfedge(d.f, d.ij, d.jk));
  }
  const Unfolded_diamond* face(const Indexed_face& f) override {
    if (!can_unfold(f.edges, false)) return nullptr;
    diamond_ = nullptr;
    return &unfolder_.face(View(t_), *places_.coordinates(t_),
                           halfedge(f.face, f.edges[0], f.edges[1]));
  }
  const Unfolded_diamond* first_side(const Indexed_face& f) override {
    if (!can_unfold(std::array{f.edges[0]}, false)) return nullptr;
    diamond_ = nullptr;
    return &unfolder_.strip(View(t_), *places_.coordinates(t_),
                            halfedge(f.face, f.edges[0], f.edges[1]));
  }

  // follows moves
  void after(const Flip& move) {
    diamond_ = nullptr;
    if (flat_parts_) flat_parts_->flip(move.diamond.f, move.diamond.g);
  }
  void after(const Star_of_vertex& move) {
    diamond_ = nullptr;
    if (flat_parts_)
      for (const std::uint32_t f : move.faces) flat_parts_->change(f);
  }
  void after(const Star_on_border& move) {
    diamond_ = nullptr;
    if (flat_parts_)
      for (const std::uint32_t f : {move.f, move.g}) flat_parts_->change(f);
  }

private:
  using View = Intrinsic_view<Triangulation>;

  // whether that is known, and the history, as long as there is one, is no better
  template <std::size_t n>
  bool can_unfold(const std::array<std::uint32_t, n>& edges, bool in_one_face) {
    const Integer_coordinates* c = places_.coordinates(t_);
    if (c == nullptr || places_.define_metric()) return c != nullptr;
    if (!are_lengths_positive_) are_lengths_positive_ = are_positive(t_.input().metric());
    return *are_lengths_positive_ && !in_one_face &&
           std::all_of(edges.begin(), edges.end(), [c](std::uint32_t e) {
             return c->normal_coordinate(e) <= Diamond_unfolder::maximal_crossings;
           });
  }

  const Unfolded_diamond& unfolded(std::uint32_t h) {
    if (diamond_ == nullptr || halfedge_ != h)
      diamond_ = &unfolder_(View(t_), *places_.coordinates(t_), h);
    halfedge_ = h;
    return *diamond_;
  }

  std::uint32_t part(const Diamond& d, std::uint32_t h) {
    const Input& input = places_.coordinates(t_)->input();
    if (!flat_parts_) flat_parts_.emplace(input);
    // where flips have gone on among faces that are not known, those that they made are not known either
    if (flat_parts_->number_of_searches() == input.number_of_faces() / 8) find_all_parts();
    return flat_parts_->part(
        input, d.f, d.g, [&]() -> auto& { return unfolded(h); });
  }

  void find_all_parts() {
    const View view(t_);
    diamond_ = nullptr;
    for (const auto x : faces(t_.mesh())) {
      const std::uint32_t f = t_.numbers().face(x), h = view.halfedge_of_face(f);
      flat_parts_->part(
          places_.coordinates(t_)->input(), f,
          f, [&]() -> auto& { return unfolder_.face(view, *places_.coordinates(t_), h); });
    }
  }

  Flat_diamond::Corner corner(std::uint32_t vertex) const {
    const Integer_coordinates& c = *places_.coordinates(t_);
    if (!c.is_inserted(vertex)) return {{vertex, vertex, vertex}, {1, 0, 0}};
    const Surface_point& p = c.location(vertex);
    const std::uint32_t next = c.input().next(p.halfedge);
    return {{c.input().source(p.halfedge), c.input().source(next), c.input().target(next)},
            p.weights};
  }

  // nothing can be unfolded across an edge without length
  static bool are_positive(const Input_metric& input) {
    for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
      for (unsigned k = 0; k < 3; ++k)
        if (input.squared_length<Interval_nt<false>>(f, k).sup() <= 0) return false;
    return true;
  }

  // the halfedge of an edge in a face, where the next one is on another given edge
  std::uint32_t halfedge(std::uint32_t face, std::uint32_t edge, std::uint32_t next) const {
    const View view(t_);
    return view.face(2 * edge) == face && view.next(2 * edge) / 2 == next ? 2 * edge : 2 * edge + 1;
  }

  const Triangulation& t_;
  const Places& places_;
  Diamond_unfolder unfolder_;
  const Unfolded_diamond* diamond_ = nullptr; // unfolded last, and since then no move was made
  std::uint32_t halfedge_ = 0;                // of that one
  std::optional<Flat_parts> flat_parts_;
  std::optional<bool> are_lengths_positive_; // of the input; not known yet
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_TRIANGULATION_UNFOLDER_H

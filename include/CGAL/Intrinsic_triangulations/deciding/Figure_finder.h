// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FIGURE_FINDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FIGURE_FINDER_H

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/deciding/Exact_memory.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Rung.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Finds the figure on which an `Exact_ladder` evaluates values of a triangulation, from where its
edges run on the input: usually the input under a diamond. It uses the list of flips instead if
flips are few and edges cross very many triangles, or if unfolding is impossible: over an edge
without length, around a face that is glued to itself, or if crossings are not counted.
*/
template <class Triangulation, class Places>
class Figure_finder {
public:
  using FT = Interval_nt<false>;

  Figure_finder(const Triangulation& t, const Places& places, Exact_memory& memory)
      : t_(t), places_(places), memory_(memory), view_(t) {}

  // The exact sign of an expression in the values of a diamond, or of faces. `better` are intervals
  // that contain the values, and may become narrower: proofs without numbers leave them.
  Sign exact_sign(const Diamond& d, const Recorded_diamond_expression& expression,
                  Diamond_values<FT>& better) const {
    const auto by_figure = [&](const auto& f) { return exact_sign_on(f, expression, better); };
    if (const std::optional<Input_diamond> input = untouched_diamond(d)) return by_figure(*input);
    if (expression.is_linear_in_areas() && can_unfold(d)) {
      if (const std::optional<Input_diamond> input = input_diamond(d)) return by_figure(*input);
      if (const std::optional<Flat_diamond> flat = flat_diamond(d)) return by_figure(*flat);
    }
    return with_figure(d, by_figure);
  }
  Sign exact_sign(std::span<const Indexed_face> faces, const Recorded_face_expression& expression,
                  std::vector<Face_values<FT>>& better) const {
    const auto* of_sides = expression.of_sides(); // edges in between have roots of their own
    if (of_sides != nullptr && Diamond_unfolder::is_wedge(view_, faces) &&
        can_unfold(std::array{faces.front().edges[0], faces.back().edges[2]})) {
      Diamond_values<FT> sides;
      return exact_sign_on(memory_.unfolder.wedge(view_, coordinates(), faces), *of_sides, sides);
    }
    return with_figure(faces, [&](const auto& f) { return exact_sign_on(f, expression, better); });
  }

  // on a figure that was found
  template <class Figure, class Expression, class Values>
  Sign exact_sign_on(const Figure& figure, const Expression& expression, Values& better) const {
    return memory_.ladder.sign(input_metric(), figure, expression, better,
                               t_.metric().statistics());
  }

  // intervals that contain the values of a diamond, and of faces, from the input alone
  Diamond_values<FT> values(const Diamond& d) const {
    if (const auto input = input_diamond(d)) return input->template values<FT>(intervals());
    return with_figure(d, [this](const auto& f) { return f.template values<FT>(intervals()); });
  }
  std::vector<Face_values<FT>> values(std::span<const Indexed_face> faces) const {
    return with_figure(faces, [this](const auto& f) { return f.template values<FT>(intervals()); });
  }
  // of faces of the input
  auto intervals() const { return memory_.input_faces.of(input_metric()); }
  // the input triangles through which the first side of a face runs
  const Unfolded_diamond& strip(const Indexed_face& face) const {
    return memory_.unfolder.strip(view_, coordinates(),
                                  view_.halfedge(face.face, face.edges[0], face.edges[1]));
  }

  // calls a function with the figure of a diamond
  template <class Function>
  auto with_figure(const Diamond& d, const Function& f) const {
    if (can_unfold(d)) return f(unfolded(d));
    return f(Replayed_diamond(replayed(faces_of(d))));
  }

  // calls a function with the figure of faces
  template <class Function>
  auto with_figure(std::span<const Indexed_face> faces, const Function& f) const {
    return can_unfold(faces) ? f(unfolded(faces)) : f(replayed(faces));
  }

protected:
  const Input_metric& input_metric() const { return t_.input().metric(); }

  static std::array<Indexed_face, 2> faces_of(const Diamond& d) {
    return {{{d.f, {d.ij, d.jk, d.ki}}, {d.g, {d.ij, d.im, d.mj}}}};
  }

  Replayed_faces replayed(std::span<const Indexed_face> faces) const {
    const Input* const surface = t_.input().surface();
    if (surface != nullptr && 2 * faces.size() >= surface->number_of_faces())
      return {*surface, *places_.flips(), {faces.begin(), faces.end()}};
    return {t_.input(), places_.connectivity(t_), *places_.flips(), {faces.begin(), faces.end()}};
  }

  // The double nearest to the weight of a diamond, or one within a relative error that is not zero,
  // if so many bits tell it.
  std::optional<double> weight_on_figure(const Diamond& d, double error, unsigned most_bits) const {
    return with_figure(d, [&](const auto& figure) {
      return memory_.ladder.weight(input_metric(), figure, t_.metric().statistics(), error,
                                   most_bits);
    });
  }
  // The nearest one, which is not zero and takes more than 106 bits, by repeating few of the flips:
  // to make coordinates would take all. Nothing if they are not few.
  std::optional<double> weight_by_few_flips(const Diamond& d) const {
    constexpr std::size_t short_flips = triangles_per_long_flip / triangles_per_short_flip;
    const Replayed_diamond figure(replayed(faces_of(d)));
    if (short_flips * figure.size() > places_.flips()->size()) return std::nullopt;
    return memory_.ladder.weight(input_metric(), figure, t_.metric().statistics(), 0,
                                 Mpfr_number::most_bits, 256);
  }

  // the values of faces in 106 bits, by repeating flips
  Replayed_values<Short_ball> replayed_values(std::span<const Indexed_face> faces) const {
    return Exact_ladder::values(input_metric(), replayed(faces));
  }
  std::vector<Indexed_face> all_faces() const {
    std::vector<Indexed_face> result;
    for (const auto f : faces(t_.mesh())) result.push_back(indexed_face(t_, f));
    return result;
  }

  // those whose stored values are wider than users allow
  std::vector<Indexed_face> wide_faces(double width = Enclosed_values::narrow) const {
    std::vector<Indexed_face> result;
    for (const auto f : faces(t_.mesh()))
      if (const Indexed_face face = indexed_face(t_, f); !t_.metric().is_narrow(face, width))
        result.push_back(face);
    return result;
  }

  Unfolded_faces unfolded(std::span<const Indexed_face> faces) const {
    Unfolded_faces result;
    for (const auto& [face, e] : faces)
      result.faces.push_back(
          memory_.unfolder.face(view_, coordinates(), view_.halfedge(face, e[0], e[1])));
    return result;
  }

  // whether a face crosses so many triangles that turns are usually long
  bool is_crossed_often(const Indexed_face& f) const {
    constexpr std::size_t many = 256;
    return number_of_crossings(*places_.coordinates(t_), f) >= many;
  }

  bool has_long_turns() const {
    const std::vector<Indexed_face> all = all_faces();
    return std::any_of(all.begin(), all.end(),
                       [this](const Indexed_face& f) { return is_crossed_often(f); });
  }

  // Intervals that contain the values of a face, in 53 or 106 bits, by turns about input vertices:
  // after insertions, where turns are long.
  std::optional<Face_values<FT>> turned_values(const Indexed_face& f, unsigned bits) const {
    if (bits > 106 || places_.flips() != nullptr || !is_crossed_often(f)) return std::nullopt;
    const Integer_coordinates& c = coordinates();
    const Face_values<FT> result =
        memory_.turned_faces.values(view_, c, view_.halfedge(f.face, f.edges[0], f.edges[1]), bits);
    const std::size_t steps = memory_.turned_faces.take_steps();
    memory_.steps += steps;
    if (steps > 0) c.count_steps(t_, steps);
    return result;
  }

  // The sign of an expression by these intervals, which the metric takes; nothing where it stays
  // open, or no face of the diamond has long turns.
  std::optional<Sign> turned_sign(const Diamond& d,
                                  const Recorded_diamond_expression& expression) const {
    bool are_turned = false;
    for (const Indexed_face& f : faces_of(d))
      if (const auto values = turned_values(f, 53)) {
        t_.metric().refine(f, *values);
        are_turned = true;
      }
    if (!are_turned) return std::nullopt;
    const std::optional<Sign> s = certain_sign(expression(t_.metric().enclosure(d)));
    Predicate_statistics& statistics = t_.metric().statistics();
    Rung_statistics& rung = statistics.rungs[static_cast<std::size_t>(Rung::doubles)];
    ++rung.asked;
    if (s) {
      ++rung.decided;
      ++statistics.escalations[53];
    }
    return s;
  }

  // Whether the input triangles under edges, or faces, can be unfolded, and it is worth it.
  template <class Elements>
  bool can_unfold(const Elements& elements,
                  std::size_t triangles_per_flip = triangles_per_short_flip) const {
    if (places_.flips() == nullptr) return true;
    const Integer_coordinates* c = places_.coordinates(t_);
    // nothing can be unfolded across an edge without length
    return c != nullptr && places_.are_input_lengths_positive(t_) &&
           are_worth_unfolding(*c, elements, *places_.flips(), triangles_per_flip);
  }

  bool can_unfold(const Diamond& d) const {
    return can_unfold(std::array{d.ij, d.jk, d.ki, d.im, d.mj}) &&
           (d.f != d.g || places_.flips() == nullptr);
  }

  const Triangulation& t_;
  const Places& places_;
  Exact_memory& memory_;
  Intrinsic_view<Triangulation> view_;

private:
  // two faces of the input, if the diamond consists of them
  std::optional<Input_diamond> input_diamond(const Diamond& d) const {
    const Integer_coordinates& c = coordinates();
    const std::uint32_t h = view_.halfedge(d.f, d.ij, d.jk);
    if (c.has_inserted_vertices() || !is_of_input(c, h) || !is_of_input(c, h ^ 1U))
      return std::nullopt;
    const std::uint32_t x = c.fans().halfedge(c.roundabout(h));
    return Input_diamond{input_side(c.input(), x), input_side(c.input(), x ^ 1U)};
  }

  // storing crossings if following them has taken as long
  const Integer_coordinates& coordinates() const {
    const Integer_coordinates& c = *places_.coordinates(t_);
    const std::size_t steps = memory_.unfolder.take_steps();
    memory_.steps += steps + 1;
    if (steps > 0) c.count_steps(t_, steps);
    return c;
  }

  const Unfolded_diamond& unfolded(const Diamond& d) const {
    return memory_.unfolder(view_, coordinates(), view_.halfedge(d.f, d.ij, d.jk));
  }

  // Two faces of the input, if all moves were flips and none flipped an edge of the diamond. This
  // needs no other data: on many meshes all ties are of this kind.
  std::optional<Input_diamond> untouched_diamond(const Diamond& d) const {
    const Flip_list* flips = places_.flips();
    if (flips == nullptr) return std::nullopt;
    for (const std::uint32_t e : {d.ij, d.jk, d.ki, d.im, d.mj})
      if (flips->contains(e)) return std::nullopt;
    const std::optional<Face_side> left = untouched_side(d.f, d.ij, d.jk),
                                   right = untouched_side(d.g, d.ij, d.im);
    return left && right ? std::optional(Input_diamond{*left, *right}) : std::nullopt;
  }
  // the side of an input face on an edge, where the next one is on another given edge
  std::optional<Face_side> untouched_side(std::uint32_t f, std::uint32_t edge,
                                          std::uint32_t next) const {
    const std::uint32_t h = view_.halfedge(f, edge, next), n = view_.next(h);
    const Input_metric& input = input_metric();
    const auto name = [&](std::uint32_t x) { return input.name(view_.source(x), x / 2); };
    const std::optional<unsigned> slot = input.slot(f, {name(h), name(n), name(view_.next(n))});
    return slot ? std::optional(Face_side{f, *slot}) : std::nullopt;
  }

  // whether the sides of a face run along input edges, between which there is no vertex
  bool is_of_input(const Integer_coordinates& c, std::uint32_t h) const {
    const std::uint32_t n = view_.next(h);
    return c.normal_coordinate(h / 2) < 0 && c.normal_coordinate(n / 2) < 0 &&
           c.normal_coordinate(view_.next(n) / 2) < 0;
  }

  // a plane in space that contains the diamond, if known
  std::optional<Flat_diamond> flat_diamond(const Diamond& d) const {
    if (!input_metric().is_in_space()) return std::nullopt;
    const std::uint32_t p = flat_part(d), h = view_.halfedge(d.f, d.ij, d.jk);
    if (p == Flat_parts::none) return std::nullopt;
    return Flat_diamond{p,
                        {corner(view_.source(h)), corner(view_.target(h)),
                         corner(view_.target(view_.next(h))),
                         corner(view_.target(view_.next(h ^ 1U)))}};
  }

  std::uint32_t flat_part(const Diamond& d) const {
    const Input& input = coordinates().input();
    std::optional<Flat_parts>& parts = memory_.flat_parts;
    if (!parts) parts.emplace(input);
    // Flips among unknown faces make unknown faces. Times on the data set are the same, within
    // noise, with a half and with a thirty-second of the faces.
    if (parts->number_of_searches() == input.number_of_faces() / 8) find_all_parts(input, *parts);
    return parts->part(input, d.f, d.g, [&]() -> const Unfolded_diamond& { return unfolded(d); });
  }

  void find_all_parts(const Input& input, Flat_parts& parts) const {
    for (const auto x : faces(t_.mesh())) {
      const std::uint32_t f = t_.numbers().face(x), h = view_.halfedge_of_face(f);
      parts.part(input, f, f, [&]() -> const Unfolded_diamond& {
        return memory_.unfolder.face(view_, coordinates(), h);
      });
    }
  }

  Flat_diamond::Corner corner(std::uint32_t vertex) const {
    const Integer_coordinates& c = coordinates();
    if (!c.is_inserted(vertex)) return {{vertex, vertex, vertex}, {1, 0, 0}};
    const Surface_point& p = c.location(vertex);
    const std::uint32_t next = c.input().next(p.halfedge);
    return {{c.input().source(p.halfedge), c.input().source(next), c.input().target(next)},
            p.weights};
  }
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FIGURE_FINDER_H

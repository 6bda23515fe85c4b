// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Flat_parts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/ladder.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides predicates on the diamonds of an intrinsic triangulation from integers and the input: no
length of an intrinsic edge is stored.

A diamond of two input faces is read from the input. Others are unfolded (see `Diamond_unfolder`) in
interval arithmetic; where that leaves a sign open, the triangles decide exactly (see
`Exact_ladder`).

All members but the constructors and accessors ask for a live `Protect_FPU_rounding<true>`.
*/
class Integer_geometry {
public:
  /// Number type of the filter.
  using FT = Interval_nt<false>;

private:
  using Input_face = std::pair<std::array<FT, 3>, FT>; // squared lengths, quadruple area

  // the values of a face of the input; before its uses, as clang wants a deduced type
  auto intervals() const {
    return [this](std::uint32_t f) -> const Input_face& { return faces_[f]; };
  }

public:
  /*!
  \brief evaluates the input in interval arithmetic.
  \throws Invalid_input if an edge has no length, across which nothing can be unfolded
  \complexity linear
  */
  explicit Integer_geometry(std::shared_ptr<const Input> input) : input_(std::move(input)) {
    const Input_metric& metric = input_->metric();
    const Protect_FPU_rounding<true> upward;
    const std::vector<FT> areas = quadruple_areas<FT>(metric);
    faces_.reserve(areas.size());
    for (std::uint32_t f = 0; f < areas.size(); ++f) {
      Input_face face{{}, areas[f]};
      for (unsigned k = 0; k < 3; ++k) {
        const FT l = metric.squared_length<FT>(f, k);
        if (l.sup() <= 0)
          throw Invalid_input(Element_kind::face, f,
                              "face " + std::to_string(f) +
                                  " has a side without length; build with mollification");
        face.first[k] = l;
      }
      faces_.push_back(face);
    }
  }

  /// returns the input.
  const Input& input() const { return *input_; }
  /// returns the input, to be shared.
  const std::shared_ptr<const Input>& shared_input() const { return input_; }

  /*!
  \brief returns the exact sign of an expression in the values of the diamond of an edge.
  \tparam View `Intrinsic_view`
  \tparam Expression a model of `DiamondExpression`
  \param view the triangulation
  \param coordinates its coordinates
  \param h a halfedge, see `Diamond_unfolder`
  \param expression the expression
  \param statistics counts how the sign was decided
  \complexity linear in the number of input triangles that are unfolded; if the filter fails, see
  `Diamond_zero_test`
  */
  template <class View, DiamondExpression Expression>
  Sign sign(const View& view, const Integer_coordinates& coordinates, std::uint32_t h,
            const Expression& expression, Predicate_statistics& statistics) {
    const Rebuilt d = rebuild(view, coordinates, h);
    const std::optional<Sign> s = certain_sign(expression(d.values));
    return s ? *s : exact_sign(d, recorded(expression), statistics);
  }

  /*!
  \brief returns the exact sign of an expression in the values of faces, each from a halfedge on.
  \tparam Expression a model of `FaceExpression`
  \complexity linear in the number of input triangles that are unfolded, if the filter decides
  */
  template <class View, FaceExpression Expression>
  Sign sign_of_faces(const View& view, const Integer_coordinates& coordinates,
                     std::span<const std::uint32_t> halfedges, const Expression& expression,
                     Predicate_statistics& statistics) {
    Unfolded_faces faces;
    for (const std::uint32_t h : halfedges)
      faces.faces.push_back(unfolder_.face(view, coordinates, h));
    auto values = faces.template values<FT>(intervals());
    const auto s = certain_sign(expression(std::span<const Face_values<FT>>(values)));
    if (s) return *s;
    ++statistics.filter_failures;
    return ladder_.sign(input_->metric(), faces,
                        Recorded_face_expression(expression, halfedges.size()), values, statistics);
  }

  /// returns intervals that contain the values of the face of a halfedge, from that on, in scaled units.
  template <class View>
  Face_values<FT> face_values(const View& view, const Integer_coordinates& coordinates,
                              std::uint32_t h) {
    return left_values(unfolder_.face(view, coordinates, h).template values<FT>(intervals()));
  }

  /// tells whether the angles opposite an edge sum to at most pi.
  /// \pre the edge has two faces
  template <class View>
  bool is_locally_delaunay(const View& view, const Integer_coordinates& coordinates,
                           std::uint32_t h, Predicate_statistics& statistics) {
    ++statistics.checks;
    const Rebuilt r = rebuild(view, coordinates, h);
    const FT q_f = left_cotangent_numerator(r.values), q_g = right_cotangent_numerator(r.values);
    if (q_f.inf() >= 0 && q_g.inf() >= 0) return true; // areas do not matter
    const FT value = q_f * r.values.area_g + q_g * r.values.area_f;
    if (value.inf() >= 0) return true;
    if (value.sup() < 0) return false;
    return exact_sign(r, recorded(Delaunay_expression()), statistics) !=
           NEGATIVE;
  }

  /// returns intervals that contain the values of the diamond of an edge, in scaled units.
  template <class View>
  Diamond_values<FT> values(const View& view, const Integer_coordinates& coordinates,
                            std::uint32_t h) {
    return rebuild(view, coordinates, h).values;
  }

  /*!
  \brief tells whether an edge runs straight: the ends of each curve that it crosses lie on its two sides, where its
  triangles are unfolded.

  Normal coordinates describe curves up to bending them; this tells that the straight one is among them.
  \param h a halfedge that has a face
  \complexity linear in the number of input triangles that are unfolded
  */
  template <class View>
  bool is_straight(const View& view, const Integer_coordinates& coordinates, std::uint32_t h,
                   Predicate_statistics& statistics) {
    if (coordinates.normal_coordinate(h / 2) <= 0) return true; // in one face, or along its side
    Unfolded_diamond strip = unfolder_.strip(view, coordinates, h);
    const auto z = strip.positions<FT>(intervals());
    const auto i = strip.position(0, z), ij = strip.position(1, z) - i;
    for (std::uint32_t t = 1; t < strip.triangles.size(); ++t) {
      const Unfolded_diamond::Triangle &triangle = strip.triangles[t],
                                       &last = strip.triangles[t - 1];
      for (const bool on_left : {true, false}) {
        const std::uint32_t point = on_left ? triangle.start() : triangle.end();
        if (t > 1 && point == (on_left ? last.start() : last.end())) continue;
        const std::optional<Sign> s = certain_sign(cross(ij, z[point] - i));
        const Sign side = on_left ? POSITIVE : NEGATIVE;
        strip.corners[2] = {t, on_left ? triangle.entry : (triangle.entry + 1) % 3};
        if ((s ? *s : exact_sign(strip, recorded(Left_area_expression()), statistics)) != side)
          return false;
      }
    }
    return true;
  }

private:
  static Face_values<FT> left_values(const Diamond_values<FT>& v) {
    return {{v.ij, v.jk, v.ki}, v.area_f};
  }

  Sign exact_sign(const Unfolded_diamond& d, const Recorded_diamond_expression& expression,
                  Predicate_statistics& statistics) {
    ++statistics.filter_failures;
    Diamond_values<FT> values;
    if (expression.is_linear_in_areas() && d.has_inserted_corners() && is_flat(d))
      return ladder_.sign(input_->metric(), flat_diamond(input_->metric(), d), expression, values,
                          statistics);
    return ladder_.sign(input_->metric(), d, expression, values, statistics);
  }

  // inserted vertices in flat parts of a surface are tied often
  bool is_flat(const Unfolded_diamond& d) {
    if (!input_->metric().is_in_space()) return false;
    if (!parts_) parts_.emplace(*input_);
    return parts_->part_of(*input_, d.triangles) != internal::Flat_parts::none;
  }

  // a diamond of two input faces has their sides, another one is in the unfolder
  struct Rebuilt {
    Diamond_values<FT> values;
    const Unfolded_diamond* diamond;
    Input_diamond of_input;
  };

  template <class View>
  Rebuilt rebuild(const View& view, const Integer_coordinates& coordinates, std::uint32_t h) {
    if (!coordinates.has_inserted_vertices() && is_of_input(view, coordinates, h) &&
        is_of_input(view, coordinates, h ^ 1U))
      return of_input(coordinates, h);
    const Unfolded_diamond& d = unfolder_(view, coordinates, h);
    return {d.values<FT>(intervals()), &d, {}};
  }

  // whether the three sides of a face run along input edges, between which there is no vertex
  template <class View>
  static bool is_of_input(const View& view, const Integer_coordinates& coordinates,
                          std::uint32_t h) {
    if (coordinates.normal_coordinate(h / 2) >= 0 || view.is_border(h)) return false;
    const std::uint32_t n = view.next(h);
    return coordinates.normal_coordinate(n / 2) < 0 &&
           coordinates.normal_coordinate(view.next(n) / 2) < 0;
  }

  Rebuilt of_input(const Integer_coordinates& coordinates, std::uint32_t h) const {
    const std::uint32_t x = coordinates.fans().halfedge(coordinates.roundabout(h));
    const Input_diamond d{input_side(coordinates.input(), x),
                          input_side(coordinates.input(), x ^ 1U)};
    return {d.values<FT>(intervals()), nullptr, d};
  }

  // Not inline: what the filter cannot decide is rare.
  Sign exact_sign(const Rebuilt& r, const Recorded_diamond_expression& expression,
                  Predicate_statistics& statistics) {
    if (r.diamond != nullptr) return exact_sign(*r.diamond, expression, statistics);
    ++statistics.filter_failures;
    Diamond_values<FT> values;
    return ladder_.sign(input_->metric(), r.of_input, expression, values, statistics);
  }

  std::shared_ptr<const Input> input_;
  std::vector<Input_face> faces_;
  Diamond_unfolder unfolder_;
  std::optional<internal::Flat_parts> parts_;
  Exact_ladder ladder_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H

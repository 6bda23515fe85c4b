// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Exact_values.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/formulas/nonnegative_intervals.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Finds where the edges of a triangulation run from integer coordinates alone.
template <class Triangulation>
struct Places_by_coordinates {
  static const Flip_list* flips() { return nullptr; }
  static const Integer_coordinates* coordinates(const Triangulation& t) {
    return &t.correspondence();
  }
  // called with flips only
  static Gluing_map connectivity(const Triangulation&) { return {}; }
  static bool are_input_lengths_positive(const Triangulation&) { return true; }
};

} // namespace internal

/*!
\brief decides predicates on an intrinsic triangulation from integers and the input; it stores no
intrinsic lengths.

Intervals of doubles on the figure of `Exact_values` decide nearly all signs; `Exact_values` decides
the others. All members require a live `Protect_FPU_rounding<true>`.
\tparam Triangulation has integer coordinates
*/
template <class Triangulation>
class Integer_geometry {
public:
  /// Number type of the filter.
  using FT = Interval_nt<false>;
  /// Working memory, which follows moves.
  struct Memory : internal::Exact_memory {
    Input_face_intervals<FT> input_faces; ///< what the filter evaluates
  };

  /// takes the triangulation, its working memory, and where to count how signs are decided.
  Integer_geometry(const Triangulation& t, Memory& memory, Predicate_statistics& statistics)
      : memory_(memory), statistics_(statistics), metric_(t.input().metric()),
        exact_(t, places_, memory) {}
  Integer_geometry(const Integer_geometry&) = delete;
  Integer_geometry& operator=(const Integer_geometry&) = delete;

  /// returns the exact sign of an expression in the values of a diamond.
  template <DiamondExpression Expression>
  Sign sign(const Diamond& d, const Expression& expression) {
    Diamond_values<FT> v = values(d);
    if (const std::optional<Sign> s = certain_sign(expression(v))) return *s;
    ++statistics_.filter_failures;
    return exact_.sign(d, recorded(expression), v, statistics_);
  }

  /// returns the exact sign of an expression in the values of faces, each from its first side on.
  template <FaceExpression Expression>
  Sign sign_of_faces(std::span<const Indexed_face> faces, const Expression& expression) {
    std::vector<Face_values<FT>> v = values(faces);
    const auto s = certain_sign(expression(std::span<const Face_values<FT>>(v)));
    if (s) return *s;
    ++statistics_.filter_failures;
    return exact_.sign(faces, Recorded_face_expression(expression, faces.size()), v, statistics_);
  }

  /// returns the sign of the area of a face.
  Sign orientation(const Indexed_face& face) {
    return sign_of_faces(std::span(&face, 1),
                         [](const auto& faces) { return faces.front().quadruple_area; });
  }

  /// tells whether the angles opposite an edge sum to at most pi.
  bool is_locally_delaunay(const Diamond& d) {
    ++statistics_.checks;
    Diamond_values<FT> v = values(d);
    const FT q_f = left_cotangent_numerator(v), q_g = right_cotangent_numerator(v);
    if (q_f.inf() >= 0 && q_g.inf() >= 0) return true; // areas do not matter
    const FT value = q_f * v.area_g + q_g * v.area_f;
    if (value.inf() >= 0) return true;
    if (value.sup() < 0) return false;
    ++statistics_.filter_failures;
    return exact_.sign(d, recorded(Delaunay_expression()), v, statistics_) != NEGATIVE;
  }

  /// returns intervals that contain the values of a diamond, in scaled units.
  Diamond_values<FT> values(const Diamond& d) {
    if (const auto input = exact_.input_diamond(d)) return input->template values<FT>(intervals());
    return exact_.with_figure(
        d, [this](const auto& figure) { return figure.template values<FT>(intervals()); });
  }
  /// returns intervals that contain the values of faces, in scaled units.
  std::vector<Face_values<FT>> values(std::span<const Indexed_face> faces) {
    return exact_.with_figure(
        faces, [this](const auto& figure) { return figure.template values<FT>(intervals()); });
  }

  /*!
  \brief tells whether the first side of a face runs straight: the ends of each curve that it
  crosses lie on its two sides, where its triangles are unfolded.

  Normal coordinates describe curves up to bending; this tests whether the straight one is among
  them.
  \complexity linear in the number of input triangles that are unfolded
  */
  bool is_straight(const Indexed_face& face) {
    Unfolded_diamond strip = exact_.strip(face);
    const auto z = strip.positions<FT>(intervals());
    const auto i = strip.position(0, z), ij = strip.position(1, z) - i;
    for (std::uint32_t t = 1; t < strip.size(); ++t) {
      const auto &ends = strip.triangles[t].point, &last = strip.triangles[t - 1].point;
      for (const std::uint32_t end : {0U, 1U}) { // on the left, and on the right
        if (t > 1 && ends[end] == last[end]) continue;
        std::optional<Sign> s = certain_sign(cross(ij, z[ends[end]] - i));
        strip.corners[2] = {t, end};
        if (!s) s = exact_area_sign(strip);
        if (*s != (end == 0 ? POSITIVE : NEGATIVE)) return false;
      }
    }
    return true;
  }

private:
  auto intervals() { return memory_.input_faces.of(metric_); }

  Sign exact_area_sign(const Unfolded_diamond& diamond) {
    ++statistics_.filter_failures;
    Diamond_values<FT> values;
    return memory_.ladder.sign(metric_, diamond, recorded(Left_area_expression()), values,
                               statistics_);
  }

  Memory& memory_;
  Predicate_statistics& statistics_;
  const Input_metric& metric_;
  internal::Places_by_coordinates<Triangulation> places_;
  internal::Exact_values<Triangulation, internal::Places_by_coordinates<Triangulation>> exact_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_MODELS_INTEGER_GEOMETRY_H

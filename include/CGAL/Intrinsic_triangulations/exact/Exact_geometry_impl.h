// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_geometry.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Face_versions.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flat_diamond.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Input_unfolder.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Unfolded_diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE
Exact_geometry::Exact_geometry(const std::shared_ptr<const Input>& input)
    : input_(input, &input->metric()) {
  std::vector<Face_versions::Version> versions;
  versions.reserve(input_->number_of_faces());
  for (std::uint32_t f = 0; f < input_->number_of_faces(); ++f)
    versions.push_back({f, input->halfedge_of_face(f) / 2});
  versions_ = {Flip_history(input_->number_of_faces()), std::move(versions)};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Exact_geometry::forget_flips() {
  versions_ = {};
  is_defined_by_places_ = true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::vector<Face_values<Exact_geometry::FT>>
Exact_geometry::enclosures(std::span<const Indexed_face> faces, unsigned bits) const {
  if (const auto u = unfolded(faces)) return evaluation_.enclosures(*input_, *u, bits);
  return evaluation_.enclosures(*input_, versions_.history(), versions_.sides(faces), bits);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Exact_geometry::FT
Exact_geometry::first_squared_length(const Indexed_face& face, unsigned bits) const {
  Input_unfolder* const u = unfolder();
  if (const Unfolded_diamond* const side = u != nullptr ? u->first_side(face) : nullptr)
    return evaluation_.squared_length(*input_, *side, bits);
  return enclosures(std::span(&face, 1), bits).front().squared_lengths.front();
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign
Exact_geometry::sign(const Diamond& d, const Recorded_diamond_expression& expression,
                     Diamond_values<FT>& better) const {
  if (const std::optional<Sign> s = sign_on_input(d, expression)) return *s;
  if (const std::optional<Sign> s = sign_by_flips(d, expression, better)) return *s;
  if (const std::optional<Sign> s = sign_in_plane(d, expression, better)) return *s;
  if (const Unfolded_diamond* u = unfolded(d))
    return evaluation_.sign(*input_, *u, expression, better, statistics_);
  return evaluation_.sign(*input_, versions_.history(), versions_.left_side(d),
                          versions_.right_side(d), expression, better, statistics_);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Sign Exact_geometry::sign(
    std::span<const Indexed_face> faces, const Recorded_face_expression& expression,
    std::vector<Face_values<FT>>& better) const {
  if (const auto u = unfolded(faces))
    return evaluation_.sign(*input_, *u, expression, better, statistics_);
  return evaluation_.sign(*input_, versions_.history(), versions_.sides(faces), expression, better,
                          statistics_);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<double>
Exact_geometry::weight_by_flips(const Diamond& d) const {
  if (is_defined_by_places_) return std::nullopt;
  ++statistics_.sharpenings[106];
  return evaluation_.weight_by_flips(*input_, versions_.history(), versions_.left_side(d),
                                     versions_.right_side(d));
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE double Exact_geometry::nonzero_weight(const Diamond& d) const {
  std::optional<double> weight;
  for (unsigned bits = 106; !weight; bits = bits == 106 ? 256 : 2 * bits) {
    ++statistics_.sharpenings[bits];
    const Unfolded_diamond* u = unfolded(d);
    weight = u != nullptr ? evaluation_.weight(*input_, *u, bits)
                          : evaluation_.weight(*input_, versions_.history(), versions_.left_side(d),
                                               versions_.right_side(d), bits);
  }
  return *weight;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Input_unfolder* Exact_geometry::unfolder() const {
  if (is_defined_by_places_ && unfolder_.pointer == nullptr)
    throw std::logic_error(
        "a metric of a refined triangulation decides only as long as it is in it");
  return unfolder_.pointer;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE const Unfolded_diamond*
Exact_geometry::unfolded(const Diamond& d) const {
  Input_unfolder* const u = unfolder();
  return u != nullptr ? u->diamond(d) : nullptr;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<std::vector<Unfolded_diamond>>
Exact_geometry::unfolded(std::span<const Indexed_face> faces) const {
  std::vector<Unfolded_diamond> result;
  for (const Indexed_face& f : faces) {
    Input_unfolder* const u = unfolder();
    const Unfolded_diamond* const face = u != nullptr ? u->face(f) : nullptr;
    if (face == nullptr) return std::nullopt;
    result.push_back(*face);
  }
  return result;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<Sign>
Exact_geometry::sign_on_input(const Diamond& d,
                              const Recorded_diamond_expression& expression) const {
  if (is_defined_by_places_) return std::nullopt;
  const Face_side left = versions_.left_side(d), right = versions_.right_side(d);
  if (!versions_.history().is_input(left.face) || !versions_.history().is_input(right.face))
    return std::nullopt;
  const std::optional<Sign> s = input_diamond_sign(*input_, left, right, expression);
  if (s) ++(*s == ZERO ? statistics_.certified_zero : statistics_.integer);
  return s;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<Sign>
Exact_geometry::sign_by_flips(const Diamond& d, const Recorded_diamond_expression& expression,
                              Diamond_values<FT>& better) const {
  if (is_defined_by_places_) return std::nullopt;
  const std::optional<Sign> s =
      evaluation_.sign_by_flips(*input_, versions_.history(), versions_.left_side(d),
                                versions_.right_side(d), expression, better);
  if (s) ++statistics_.escalations[106];
  return s;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE std::optional<Sign>
Exact_geometry::sign_in_plane(const Diamond& d, const Recorded_diamond_expression& expression,
                              Diamond_values<FT>& better) const {
  if (unfolder() != nullptr && expression.is_linear_in_areas())
    if (const std::optional<Flat_diamond> flat = unfolder()->flat_diamond(d))
      return flat_diamond_sign(*input_, *flat, expression, better, statistics_);
  return std::nullopt;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_GEOMETRY_IMPL_H

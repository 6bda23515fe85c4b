// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What decides exactly, and values of the input.

#include <CGAL/Intrinsic_triangulations/correspondence/models/Flat_parts_impl.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Replayed_flips_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_geometry_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign_impl.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Wedge_expression.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits_impl.h>

#include <CGAL/Interval_nt.h>

#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

#define DIAMOND_EXPRESSION(E)                                                                      \
  template Sign Exact_euclidean_metric::exact_sign(const Diamond&, const E&) const;                \
  template Sign flat_diamond_sign(const Input_metric&, const Flat_diamond&, const E&,              \
                                  Diamond_values<Interval_nt<false>>&, Predicate_statistics&);     \
  template Sign Exact_evaluation::sign(const Input_metric&, const Unfolded_diamond&, const E&,     \
                                       Predicate_statistics&)

DIAMOND_EXPRESSION(Delaunay_expression);
DIAMOND_EXPRESSION(Convexity_at_source_expression);
DIAMOND_EXPRESSION(Convexity_at_target_expression);
DIAMOND_EXPRESSION(Left_area_expression);

#define FACE_EXPRESSION(E)                                                                         \
  template Sign Exact_euclidean_metric::exact_sign(std::span<const Indexed_face>,                  \
                                                   std::vector<Face_values<Interval_nt<false>>>&,  \
                                                   const E&) const

FACE_EXPRESSION(Small_angle_expression);
FACE_EXPRESSION(Large_circumradius_expression);
FACE_EXPRESSION(Long_side_expression);
FACE_EXPRESSION(Wedge_sine_expression);
FACE_EXPRESSION(Wedge_cosine_expression);

#define UNFOLDED_FACE_EXPRESSION(E)                                                                \
  template Sign Exact_evaluation::sign(const Input_metric&, const std::vector<Unfolded_diamond>&,  \
                                       const E&, std::vector<Face_values<Interval_nt<false>>>&,    \
                                       Predicate_statistics&)

UNFOLDED_FACE_EXPRESSION(Wedge_sine_expression);
UNFOLDED_FACE_EXPRESSION(Wedge_cosine_expression);

template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
template std::vector<double> quadruple_areas(const Input_metric&);
template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);

} // namespace CGAL::Intrinsic_triangulations

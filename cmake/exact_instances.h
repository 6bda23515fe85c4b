// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What exact predicates do where their filter fails, and how polygons are triangulated, takes longer to compile
// than most programs that use it: tests, examples and the program of this project share one compilation, `exact_instances.cpp`.

#ifndef INTRINSIC_TRIANGULATIONS_EXACT_INSTANCES_H
#define INTRINSIC_TRIANGULATIONS_EXACT_INSTANCES_H

#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Polygon_triangulator.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#ifndef INTRINSIC_TRIANGULATIONS_INSTANCE
#define INTRINSIC_TRIANGULATIONS_INSTANCE extern template
#endif

namespace CGAL::Intrinsic_triangulations {

INTRINSIC_TRIANGULATIONS_INSTANCE Sign
Exact_euclidean_metric::exact_sign(const Diamond&, const Delaunay_expression&) const;
INTRINSIC_TRIANGULATIONS_INSTANCE Sign
Exact_euclidean_metric::exact_sign(const Diamond&, const Convexity_at_source_expression&) const;
INTRINSIC_TRIANGULATIONS_INSTANCE Sign
Exact_euclidean_metric::exact_sign(const Diamond&, const Convexity_at_target_expression&) const;

INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_euclidean_metric::exact_sign(
    std::span<const Indexed_face>, std::vector<Face_values<Interval_nt<false>>>&,
    const Small_angle_expression&) const;
INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_euclidean_metric::exact_sign(
    std::span<const Indexed_face>, std::vector<Face_values<Interval_nt<false>>>&,
    const Large_circumradius_expression&) const;
INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_euclidean_metric::exact_sign(
    std::span<const Indexed_face>, std::vector<Face_values<Interval_nt<false>>>&,
    const Long_side_expression&) const;

INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_evaluation::sign(const Input_metric&,
                                                              const Unfolded_diamond&,
                                                              const Delaunay_expression&,
                                                              Predicate_statistics&);
INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_evaluation::sign(const Input_metric&,
                                                              const Unfolded_diamond&,
                                                              const Convexity_at_source_expression&,
                                                              Predicate_statistics&);
INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_evaluation::sign(const Input_metric&,
                                                              const Unfolded_diamond&,
                                                              const Convexity_at_target_expression&,
                                                              Predicate_statistics&);
INTRINSIC_TRIANGULATIONS_INSTANCE Sign Exact_evaluation::sign(const Input_metric&,
                                                              const Unfolded_diamond&,
                                                              const Left_area_expression&,
                                                              Predicate_statistics&);

INTRINSIC_TRIANGULATIONS_INSTANCE bool internal::Polygon_triangulator<>::triangulate_delaunay(
    std::vector<std::array<std::uint32_t, 3>>&) const;

} // namespace CGAL::Intrinsic_triangulations

#endif // INTRINSIC_TRIANGULATIONS_EXACT_INSTANCES_H

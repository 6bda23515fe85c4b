// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What decides exactly, and values of the input; what knows where vertices are.

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/ladder.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <CGAL/Interval_nt.h>

#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

// of the figures on which it climbs
template Sign Exact_ladder::sign(const Input_metric&, const Input_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Flat_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Unfolded_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Replayed_diamond&,
                                 const Recorded_diamond_expression&,
                                 Diamond_values<Interval_nt<false>>&, Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Unfolded_faces&,
                                 const Recorded_face_expression&,
                                 std::vector<Face_values<Interval_nt<false>>>&,
                                 Predicate_statistics&);
template Sign Exact_ladder::sign(const Input_metric&, const Replayed_faces&,
                                 const Recorded_face_expression&,
                                 std::vector<Face_values<Interval_nt<false>>>&,
                                 Predicate_statistics&);
template std::optional<double> Exact_ladder::weight(const Input_metric&, const Unfolded_diamond&,
                                                    unsigned);
template std::optional<double> Exact_ladder::weight(const Input_metric&, const Replayed_diamond&,
                                                    unsigned);

template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
template std::vector<double> quadruple_areas(const Input_metric&);
template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);

} // namespace CGAL::Intrinsic_triangulations

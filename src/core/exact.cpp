// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What decides exactly, and values of the input; what knows where vertices are.

#include <CGAL/Intrinsic_triangulations/correspondence/Sheets_impl.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Flat_parts_impl.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates_impl.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Replayed_flips_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_evaluation_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/Exact_geometry_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/flat_diamond_sign_impl.h>
#include <CGAL/Intrinsic_triangulations/exact/input_diamond_sign_impl.h>
#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps_impl.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression_impl.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits_impl.h>

#include <CGAL/Interval_nt.h>

#include <vector>

namespace CGAL::Intrinsic_triangulations {

template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
template std::vector<double> quadruple_areas(const Input_metric&);
template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);

} // namespace CGAL::Intrinsic_triangulations

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Values of the input.

#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Interval_nt.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

template Interval_nt<false> quadruple_area(const Input_metric&, std::uint32_t);
template std::vector<double> quadruple_areas(const Input_metric&);
template std::vector<Interval_nt<false>> quadruple_areas(const Input_metric&);

} // namespace CGAL::Intrinsic_triangulations

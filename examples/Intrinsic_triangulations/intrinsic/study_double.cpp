// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_measure.h"

#include <CGAL/Intrinsic_triangulations/metric/Tolerant_traits.h>

#include <ratio>

namespace program {

namespace {

template <std::intmax_t denominator>
void study_tolerance(Study_run& run) {
  measure_and_compare<IT::Tolerant_traits<double, std::ratio<1, denominator>>>(run);
}

} // namespace

void study_double(Study_run& run) { measure_and_compare<IT::Euclidean_traits<double>>(run); }
void study_double_1e_12(Study_run& run) { study_tolerance<1000000000000>(run); }
void study_double_1e_6(Study_run& run) { study_tolerance<1000000>(run); }
void study_double_1e_5(Study_run& run) { study_tolerance<100000>(run); }
void study_long_double(Study_run& run) {
  measure_and_compare<IT::Euclidean_traits<long double>>(run);
}

} // namespace program

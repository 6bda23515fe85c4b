// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arithmetics.h"
#include "measure.h"

#include <CGAL/Intrinsic_triangulations/metric/Tolerant_traits.h>

#include <cstdint>
#include <ratio>

namespace program {

namespace {

template <std::intmax_t denominator>
using Tolerant = IT::Tolerant_traits<double, std::ratio<1, denominator>>;

} // namespace

std::vector<Arithmetic> hardware_arithmetics() {
  return {{"double", measure_and_compare<IT::Euclidean_traits<double>>},
          {"double-1e-12", measure_and_compare<Tolerant<1000000000000>>},
          {"double-1e-6", measure_and_compare<Tolerant<1000000>>},
          {"double-1e-5", measure_and_compare<Tolerant<100000>>},
          {"long-double", measure_and_compare<IT::Euclidean_traits<long double>>}};
}

} // namespace program

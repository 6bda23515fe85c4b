// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <CGAL/Intrinsic_triangulations/metric/boost_float_traits.h>

#include "arithmetics.h"
#include "measure.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>

namespace program {

namespace {

template <unsigned bits>
using Float = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

} // namespace

std::vector<Arithmetic> number_types() {
  return {{"boost-100", measure_and_compare<IT::Euclidean_traits<Float<100>>>},
          {"boost-200", measure_and_compare<IT::Euclidean_traits<Float<200>>>},
          {"gmpq", measure_and_compare<IT::Euclidean_traits<CGAL::Gmpq>>},
          {"core-expr", measure_and_compare<IT::Euclidean_traits<CORE::Expr>>},
          {"lazy-core-expr",
           measure_and_compare<IT::Euclidean_traits<CGAL::Lazy_exact_nt<CORE::Expr>>>}};
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arithmetics.h"
#include "measure.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>

namespace program {

std::vector<Arithmetic> exact_number_types() {
  return {{"gmpq", measure_and_compare<IT::Euclidean_traits<CGAL::Gmpq>>},
          {"core-expr", measure_and_compare<IT::Euclidean_traits<CORE::Expr>>},
          {"lazy-core-expr",
           measure_and_compare<IT::Euclidean_traits<CGAL::Lazy_exact_nt<CORE::Expr>>>}};
}

} // namespace program

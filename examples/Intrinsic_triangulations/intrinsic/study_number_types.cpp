// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_measure.h"

#include <CGAL/CORE_Expr.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Lazy_exact_nt.h>

namespace program {

void study_gmpq(Study_run& run) { measure_and_compare<IT::Euclidean_traits<CGAL::Gmpq>>(run); }
void study_core_expr(Study_run& run) { measure_and_compare<IT::Euclidean_traits<CORE::Expr>>(run); }
void study_lazy_core_expr(Study_run& run) {
  measure_and_compare<IT::Euclidean_traits<CGAL::Lazy_exact_nt<CORE::Expr>>>(run);
}

} // namespace program

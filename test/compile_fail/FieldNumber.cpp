// expect: satisfaction of .FieldNumber<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Degrees of polynomials have no quotient.

#include <CGAL/Intrinsic_triangulations/formulas/Expression_steps.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  const Expression_degree length = Expression_degree::length();
  apex(length, length, length, Expression_degree::area());
}

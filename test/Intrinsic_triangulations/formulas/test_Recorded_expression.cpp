// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>

#include <gtest/gtest.h>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;

double changing_bound = 0;

TEST(Recorded_expression, is_recorded_anew_if_what_it_reads_may_have_changed) {
  const auto e = [](const auto& d) { return d.ij - changing_bound; }; // an empty type
  const IT::Diamond_values<double> d{1.5, 1, 1, 1, 1, 1, 1};
  for (const double bound : {1., 2., -4.}) {
    changing_bound = bound;
    EXPECT_EQ(IT::recorded(e)(d), 1.5 - bound);
  }
}

} // namespace

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sizes.h"

namespace program {

std::vector<double> read_sizes(const Options& options, std::size_t vertices) {
  if (options.sizes.empty()) return {};
  const Number_table table = read_numbers(options.sizes, vertices, "vertices of " + options.input);
  if (table.columns != 1) table.refuse(0, "give one number on each line");
  table.expect_rows(vertices, "vertices of " + options.input);
  for (std::size_t v = 0; v < vertices; ++v)
    if (!(table.values[v] > 0)) table.refuse(v, "a length must be positive; correct it");
  return table.values;
}

} // namespace program

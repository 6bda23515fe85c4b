// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "constraints.h"
#include "support/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace program {

namespace {

// \param vertices how many the user has
// \pre options ask for constraints
void constrain(IT::Input_edges edges, std::uint32_t vertices, const Options& options,
               Constraints& c) {
  c.is_asked_for = true;
  c.is_constrained = edges.no_marks();
  if (options.sharp_angle) edges.mark_sharp(*options.sharp_angle, c.is_constrained);
  if (!options.constraints.empty()) {
    Text_lines lines(options.constraints);
    while (lines.next()) {
      lines.expect_words(2, "the numbers of two vertices");
      const std::uint32_t i = lines.element(0, "vertex", vertices),
                          j = lines.element(1, "vertex", vertices);
      if (!edges.mark(i, j, c.is_constrained))
        lines.refuse("no edge of " + options.input + " joins vertices " + std::to_string(i) +
                     " and " + std::to_string(j) + "; constrain a path of edges");
    }
  }
  c.count =
      static_cast<std::size_t>(std::count(c.is_constrained.begin(), c.is_constrained.end(), 1));
}

} // namespace

Constraints constraints_of(const IT::Intrinsic_input& in, const Options& options) {
  Constraints c;
  if (!has_constraints(options)) return c;
  constrain(IT::Input_edges(in), in.names.number_of_rows(in.mesh.number_of_vertices()), options, c);
  if (c.count > 0) c.mesh = in.mesh;
  return c;
}

Constraints constraints_of(const IT::Input& input, const Options& options) {
  Constraints c;
  c.is_stored = true;
  if (!has_constraints(options)) return c;
  if (options.sharp_angle && !input.metric().is_embedded())
    throw std::runtime_error(options.input +
                             ": the stored triangulation has lengths and no points, so that no "
                             "edge is sharp; name edges with --keep");
  constrain(IT::Input_edges(input), input.number_of_rows(), options, c);
  return c;
}

} // namespace program

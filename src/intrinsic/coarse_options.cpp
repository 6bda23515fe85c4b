// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "coarse_options.h"
#include "support/file_formats.h"

#include <string>

namespace program {

namespace {

// A number of vertices, or a percentage.
CLI::Validator vertex_count() {
  return CLI::Validator(
      [](std::string& word) -> std::string {
        const bool is_part = word.ends_with('%');
        const std::string number = is_part ? word.substr(0, word.size() - 1) : word;
        double x = 0;
        const bool is_whole = number.find_first_not_of("0123456789") == std::string::npos;
        if (number.empty() || !CLI::detail::lexical_cast(number, x) || !(x > 0) ||
            (is_part ? x > 100 : !is_whole || x > 1e9))
          return word + ": give a number of vertices, or a percentage such as 10%";
        return {};
      },
      "N|P%");
}

} // namespace

void add_simplify_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  Simplify_command& s = options.simplify;
  CLI::Option* const vertices =
      add("--vertices", s.vertices, {vertex_count()},
          "how many vertices are wanted: a number, or a percentage; by default 10%, or with "
          "another bound as few as it allows");
  add("--stretch", s.stretch, {in_range(ranges::stretch)},
      "no length on the surface is multiplied by more than this, or by less than its inverse; a "
      "vertex whose removal would break this stays");
  CLI::Option* const flat = add(
      "--flat", s.flat, {in_range(ranges::within), Type{"RADIANS"}},
      "remove only vertices where the angles sum to a full turn, or half a turn on the border, up "
      "to this; 0: exactly");
  flat->excludes(vertices);
  const Words costs({{"stretch", "those that stretch the surface least"},
                     {"curvature", "those whose curvature moves least"},
                     {"area", "those whose area moves least"},
                     {"balanced", "those that functions on the surface need least, for operators"}},
                    defaults::removal_cost);
  add("--cost", s.cost, {costs.check()}, "which vertices go first: " + costs.help())
      ->excludes(flat);
  add("--keep-vertices", s.kept_vertices, {file_name},
      "text file: the number of a vertex that stays on each line");
  add_output_option(command, options, "-o", options.output,
                    {Contents::triangulation, Contents::coarse_surface});
  add_plain_flag(command, options);
  add("--prolongation", s.prolongation, {file_of({Contents::matrix})},
      "write the matrix that takes functions from the coarse vertices to the fine ones");
  add("--vector-prolongation", s.vector_prolongation, {file_of({Contents::matrix})},
      "the same for tangent vectors, in polar coordinates: complex numbers");
  add("--places", s.places, {file_of({Contents::values})},
      "write where each vertex is on the coarse surface, a face and the weights of its corners, or "
      "a vertex, to .txt");
  add_view_option(command, options, "the fine and the coarse surface side by side");
}

void add_embed_options(CLI::App& command, Options& options) {
  const Option_adder add(command);
  add("--flat-within", options.flat_within, {in_range(ranges::flat_within), Type{"RADIANS"}},
      "vertices whose angles sum to a full turn up to this are put on faces; by default 1e-10");
}

} // namespace program

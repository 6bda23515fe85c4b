// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "load.h"
#include "support/file_formats.h"
#include "support/text_lines.h"

#include <optional>
#include <string>

namespace program {

template Loaded<Exact_triangulation> load_mesh(const Options&, Progress&, const Cutter&);
template Loaded<Double_triangulation> load_mesh(const Options&, Progress&, const Cutter&);
template Loaded<Exact_triangulation> load_triangulation(const Options&, Progress&);
template Loaded<Double_triangulation> load_triangulation(const Options&, Progress&);

std::vector<double> read_sizes(const Options& options, std::size_t vertices) {
  if (options.sizes.empty()) return {};
  const Number_table table = read_numbers(options.sizes, vertices, "vertices of " + options.input);
  if (table.columns != 1) table.refuse(0, "give one number on each line");
  table.expect_rows(vertices, "vertices of " + options.input);
  for (std::size_t v = 0; v < vertices; ++v)
    if (!(table.values[v] > 0)) table.refuse(v, "a length must be positive; correct it");
  return table.values;
}

bool is_triangulation_file(const std::string& path) {
  return is_file_of(Contents::triangulation, path);
}

IT::Surface_options surface_of(const Options& options) {
  IT::Surface_options surface =
      IT::surface_options(options.domain, options.mollification, options.polygons);
  surface.neighbors = options.neighbors;
  return surface;
}

std::string arithmetic_of(const Options& options) {
  if (!is_triangulation_file(options.input)) return options.arithmetic;
  std::optional<std::string> given;
  if (options.is_arithmetic_given) given = options.arithmetic;
  std::string stored = IT::stored_arithmetic(options.input, given, options.is_mollification_given,
                                             surface_of(options));
  const auto fail = [&](const std::string& what) {
    throw IT::Invalid_input(IT::Element_kind::none, 0, options.input + ": " + what);
  };
  if (options.correspondence == "crossings" || options.correspondence == "signposts")
    fail("a stored triangulation has its correspondence, integer coordinates; start from the mesh");
  if (!options.metric.empty())
    fail("a stored triangulation has its metric; leave --metric out, or start from the mesh");
  return stored;
}

} // namespace program

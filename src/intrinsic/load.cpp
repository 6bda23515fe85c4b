// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "load.h"
#include "support/file_formats.h"
#include "support/text_lines.h"

#include <stdexcept>
#include <string>

namespace program {

namespace {

IT::Mollification mollification_of(const Options& options) {
  if (options.mollification == "none") return IT::Mollification::none;
  if (options.mollification == "lengths") return IT::Mollification::lengths;
  if (options.mollification == "squared") return IT::Mollification::squared_lengths;
  return IT::Mollification::automatic;
}

} // namespace

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

Surface_choice surface_of(const Options& options) {
  Surface_choice choice = surface_named(options.domain);
  choice.mollification = mollification_of(options);
  choice.neighbors = options.neighbors;
  if (options.polygons == "planar") choice.polygons = IT::Nonplanar_polygons::planar;
  return choice;
}

bool is_triangulation_file(const std::string& path) {
  return is_file_of(Contents::triangulation, path);
}

std::size_t number_of_polygons(const IT::Input_definition& input) {
  const std::vector<std::uint32_t>& polygon = input.names().polygon_of_triangle;
  return polygon.empty() ? input.metric().number_of_faces() : std::size_t{polygon.back()} + 1;
}

std::string arithmetic_of(const Options& options) {
  if (!is_triangulation_file(options.input)) return options.arithmetic;
  std::string arithmetic = IT::read_intrinsic_triangulation_arithmetic(options.input);
  const auto fail = [&](const std::string& what) {
    throw IT::Invalid_input(IT::Element_kind::none, 0, options.input + ": " + what);
  };
  if (options.is_arithmetic_given && options.arithmetic != arithmetic)
    fail("the triangulation is stored in " + arithmetic +
         " arithmetic; leave --arithmetic out, or start from the mesh");
  if (options.correspondence == "crossings" || options.correspondence == "signposts")
    fail("a stored triangulation has its correspondence, integer coordinates; start from the mesh");
  if (options.is_mollification_given)
    fail("a stored triangulation cannot be mollified; leave --mollification out, or start from the "
         "mesh");
  if (options.domain != "auto")
    fail("a stored triangulation has its surface; leave --domain out, or start from the mesh");
  if (!options.metric.empty())
    fail("a stored triangulation has its metric; leave --metric out, or start from the mesh");
  if (options.neighbors)
    fail("a stored triangulation has its surface; leave --neighbors out, or start from the points");
  if (options.polygons != "fan")
    fail("a stored triangulation has its surface; leave --polygons out, or start from the mesh");
  return arithmetic;
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"
#include "support/file_formats.h"

#include <string>
#include <vector>

namespace program {

namespace {

// What `-o` writes.
std::string contents_of_output(const Options& o) {
  const bool is_curve_command = o.command == "geodesic" && !o.geodesic.writes_subdivision;
  if (o.command == "simplify")
    return is_mesh_output(o) ? "the coarse triangles in space" : "the coarse surface";
  if (is_file_of(Contents::triangulation, o.output)) return "the intrinsic triangulation";
  if (is_curve_command) return "the curves";
  if (o.command == "cut") return "the surface cut open";
  if (!o.application.pairs.empty()) return "distances, a line for each pair";
  if (!o.application.source_sets.empty() && o.application.voronoi.empty())
    return "distances, a row for each set of sources";
  if (is_file_of(Contents::values, o.output)) return "values, a line for each row";
  if (o.command == "embed") return "a polyhedron";
  if (!is_mesh_output(o)) return "a matrix";
  const std::string surface = o.application.on == "input" ? "the mesh" : "the common subdivision";
  const bool has_values = o.command != "delaunay" && o.command != "refine" &&
                          is_file_of(Contents::valued_subdivision, o.output);
  const bool is_map = o.command == "parametrize" || o.command == "uniformize";
  return surface + (is_map ? " with its map" : has_values ? " with values" : "");
}

} // namespace

std::vector<Output> outputs(const Options& o) {
  std::vector<Output> all{{o.output, contents_of_output(o)},
                          {o.laplacian, "the Laplacian"},
                          {o.mass, "the mass matrix"},
                          {o.interpolation, "the interpolation from the triangulation"},
                          {o.input_interpolation, "the interpolation from the input"},
                          {o.cut.labels, "labels of faces"},
                          {o.simplify.prolongation, "the prolongation from the coarse vertices"},
                          {o.simplify.vector_prolongation, "the prolongation of vectors"},
                          {o.simplify.places, "places on the coarse surface"},
                          {o.application.isolines, "isolines"},
                          {o.application.voronoi, "lines between cells"},
                          {o.application.singularities, "singularities"},
                          {o.view, "a page for the browser"},
                          {o.records, "all records of statistics"},
                          {o.stats, "statistics"}};
  std::erase_if(all, [](const Output& output) { return output.path.empty(); });
  return all;
}

bool is_standard_output(const std::string& path) { return path == "-" || path.starts_with("-."); }

bool is_mesh_output(const Options& options) {
  return options.command != "embed" && is_file_of(Contents::subdivision, options.output);
}

bool writes_plain_meshes(const Options& options) {
  return options.is_plain || options.application.on == "input";
}

bool has_constraints(const Options& options) {
  return options.sharp_angle || !options.constraints.empty();
}

bool needs_subdivision(const Options& options) {
  return is_mesh_output(options) || !options.view.empty() || !options.interpolation.empty() ||
         !options.input_interpolation.empty();
}

bool needs_correspondence(const Options& options) {
  return needs_subdivision(options) || !options.sizes.empty() || options.is_adaptive;
}

} // namespace program

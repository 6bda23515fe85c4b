// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Drawn_results.h"
#include "../support/Number_rows.h"
#include "../view.h"

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace program {

namespace {

// The first two functions.
std::vector<std::array<double, 2>>
drawn_texture(const std::vector<IT::Subdivision_field>& functions) {
  std::vector<std::array<double, 2>> texture;
  for (std::size_t v = 0; v < functions[0].values.size(); ++v)
    texture.push_back({functions[0].values[v], functions[1].values[v]});
  return texture;
}

} // namespace

bool stays_open(const Options& options) {
  constexpr std::array<std::string_view, 1> without_corners{"vtp"};
  return options.is_plain || IT::has_extension(options.output, without_corners);
}

void expect_writable_results(const Options& options) {
  if (is_mesh_output(options) && options.application.on == "intrinsic")
    throw std::runtime_error(
        options.output +
        ": faces of the intrinsic triangulation bend over edges of the mesh; write "
        "the common subdivision with --on subdivision, or values to a file .txt");
}

void write_functions(std::ostream& out, const Computed& computed,
                     const std::vector<std::vector<Point>>& axes, Eigen::Index rows,
                     const Cut& cut) {
  Number_rows numbers(out);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (const Function& f : computed.functions) numbers.put(f.values[i]);
    for (Eigen::Index c = 0; c < computed.displacements.cols(); ++c)
      numbers.put(computed.displacements(i, c));
    if (computed.directions) {
      const std::uint32_t copy = computed.directions->of_row[static_cast<std::size_t>(i)];
      const bool is_vertex = copy != IT::Gluing::none;
      const std::complex<double> z = is_vertex ? computed.directions->vectors[copy] : 0;
      numbers.put(z.real());
      numbers.put(z.imag());
      for (const std::vector<Point>& axis : axes)
        for (const double x : is_vertex ? axis[copy] : Point{0, 0, 0}) numbers.put(x);
    }
    if (cut.is_cut()) { // inserted vertices are no copies of any
      const auto v = static_cast<std::size_t>(i);
      numbers.put(v < cut.original_vertex.size() ? cut.original_vertex[v] : -1.);
    }
    numbers.end_row();
  }
}

Drawn_results draw(Drawn_subdivision drawn, const Computed& computed,
                   const IT::Interpolation_matrix& interpolation) {
  Drawn_results results{std::move(drawn), {}};
  for (const Function& f : computed.functions)
    results.fields.push_back(
        IT::interpolated_field(f.name, interpolation, f.values, f.has_classes));
  if (computed.is_map) results.texture = drawn_texture(results.fields);
  if (computed.displacements.size() == 0) return results;
  const Eigen::MatrixXd d = interpolation * computed.displacements.topRows(interpolation.cols());
  for (std::size_t v = 0; v < results.drawn.points.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      results.drawn.points[v][c] += d(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c));
  return results;
}

void write_results_view(std::ostream& out, const Drawn_results& results, const Computed& computed,
                        const Cut& cut, const Options& options, const Json& json) {
  IT::Html_view view;
  view.curves = cut.is_cut() ? cut.seams : results.lines;
  const std::vector<IT::Placed_vector> vectors = placed_vectors(results.directions, results.drawn);
  view.vectors = vectors;
  view.are_arrows = results.directions.at_vertices.size() == 1;
  view.marks = computed.marks.points;
  view.marks_name = computed.marks.name;
  view.isolines = computed.isolines;
  view.has_edges = view.has_face_colors =
      computed.isolines == 0 && !computed.is_map && !computed.directions;
  view.fields = results.fields;
  view.shown_field = computed.is_map ? results.fields.size() : computed.shown;
  view.texture = results.texture;
  view.is_logarithm = computed.is_logarithm;
  write_view(out, results.drawn.s, results.drawn.points, options, json, view);
}

void write_laid_out(const Laid_out& laid_out, const Marks& marks, const Options& options,
                    const Json& json, Output_files& files) {
  const Surface_with_fields& opened = laid_out.opened;
  if (!options.view.empty()) {
    IT::Html_view view;
    view.has_edges = view.has_face_colors = false;
    view.curves = laid_out.seams;
    view.marks = marks.points;
    view.marks_name = marks.name;
    std::vector<IT::Subdivision_field> shown;
    for (const IT::Subdivision_field& field : opened.fields)
      if (field.is_function()) shown.push_back(field);
    const std::vector<std::array<double, 2>> texture = drawn_texture(shown);
    view.fields = shown;
    view.shown_field = shown.size(); // none
    view.texture = texture;
    view.is_disk = laid_out.is_disk;
    files.write(options.view, [&](std::ostream& out) {
      write_view(out, opened.s, opened.points, options, json, view);
    });
  }
  if (!is_mesh_output(options)) return;
  const Surface_with_fields& written = stays_open(options) ? opened : laid_out.closed;
  files.write(options.output, [&](std::ostream& out, const std::string& extension) {
    write_mesh(out, extension, written.s, written.points, written.fields, options);
  });
}

} // namespace program

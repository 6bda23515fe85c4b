// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "metric.h"
#include "support/text_lines.h"

#include <CGAL/Intrinsic_triangulations/input/metric_scaling/scale_metric.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// Entries xx xy xz yy yz zz of a symmetric matrix.
using Tensor = std::span<const double>;

// |v|^2 = v^T M v
double squared_norm(const Tensor& m, const std::array<double, 3>& v) {
  return m[0] * v[0] * v[0] + m[3] * v[1] * v[1] + m[5] * v[2] * v[2] +
         2 * (m[1] * v[0] * v[1] + m[2] * v[0] * v[2] + m[4] * v[1] * v[2]);
}

// By Cholesky's pivots.
bool is_positive_definite(const Tensor& m) {
  const double a = m[0], b = m[3] - m[1] * m[1] / a, l = m[4] - m[1] * m[2] / a;
  return a > 0 && b > 0 && m[5] - m[2] * m[2] / a - l * l / b > 0;
}

IT::Scaled_metric scaled_by_factors(const IT::Read_surface& file, const Number_table& table,
                                    const Options& options) {
  table.expect_rows(file.input.names.number_of_rows(file.input.mesh.number_of_vertices()),
                    "vertices of " + options.input);
  for (std::size_t v = 0; v < table.rows(); ++v)
    if (!(table.values[v] > 0)) table.refuse(v, "a factor must be positive; correct it");
  return IT::scale_conformally(
      file.input,
      [&](IT::Gluing_map::Vertex v) {
        return std::log(table.values[file.input.names.row(v.index)]);
      },
      IT::parameters::triangle_inequality(IT::Triangle_inequality::repair));
}

IT::Scaled_metric scaled_by_tensors(const IT::Read_surface& file, const Number_table& table,
                                    const Options& options) {
  table.expect_rows(file.facts.polygons, "faces of " + options.input);
  const auto tensor = [&](std::size_t face) { return Tensor(&table.values[6 * face], 6); };
  for (std::size_t f = 0; f < table.rows(); ++f)
    if (!is_positive_definite(tensor(f)))
      table.refuse(f, "the tensor xx xy xz yy yz zz is not positive definite; correct it");
  return IT::scale_by_norm_in_space(
      file.input,
      [&](IT::Gluing_map::Face f, const std::array<double, 3>& v) {
        const std::vector<std::uint32_t>& polygon = file.input.names.polygon_of_triangle;
        return std::sqrt(squared_norm(tensor(polygon.empty() ? f.index : polygon[f.index]), v));
      },
      IT::parameters::triangle_inequality(IT::Triangle_inequality::repair));
}

} // namespace

Metric_report change_metric(IT::Read_surface& file, const Options& options) {
  if (options.metric.empty()) return {};
  const std::size_t rows = file.input.names.number_of_rows(file.input.mesh.number_of_vertices());
  const Number_table table = read_numbers(options.metric, std::max(rows, file.facts.polygons),
                                          "vertices or faces of " + options.input);
  if (table.columns != 1 && table.columns != 6)
    table.refuse(0,
                 "there are " + std::to_string(table.columns) +
                     " numbers; give a factor per vertex, or the six entries xx xy xz yy yz zz of "
                     "a tensor per face");
  IT::Scaled_metric scaled = table.columns == 1 ? scaled_by_factors(file, table, options)
                                                : scaled_by_tensors(file, table, options);
  file.input = std::move(scaled.input);
  return {scaled.violating_faces.size(), scaled.changed_edges, scaled.largest_relative_change};
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "delaunay.h"
#include "support/Number_rows.h"
#include "support/text_lines.h"

#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <Eigen/Core>

namespace program {

namespace {

using Functions = Eigen::MatrixXd; // a row per vertex, a column per function

/// Functions on both triangulations, and on their common subdivision.
struct Transferred {
  Functions input, intrinsic;
  Functions input_on_subdivision, intrinsic_on_subdivision;
};

Functions functions_of(const Number_table& table) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Eigen::Map<const Rows>(table.values.data(), static_cast<Eigen::Index>(table.rows()),
                                static_cast<Eigen::Index>(table.columns));
}

template <class Triangulation>
Transferred transfer(const Triangulation& t, const IT::Common_subdivision& s,
                     const Functions& given, const Options& options) {
  const bool from_input = options.from == "input", is_l2 = options.method == "l2";
  Transferred result{given, given, {}, {}};
  if (from_input)
    result.intrinsic = is_l2 ? IT::L2_transfer(t, s, IT::Transfer_direction::to_intrinsic)(given)
                             : IT::copy_to_intrinsic(t, given);
  else
    result.input = is_l2 ? IT::L2_transfer(t, s)(given) : IT::copy_to_input(t, given);
  result.input_on_subdivision = IT::interpolation_from_input(s) * result.input;
  result.intrinsic_on_subdivision = IT::interpolation_from_intrinsic(s) * result.intrinsic;
  return result;
}

// The norm by a mass matrix. Squares of small numbers would vanish.
double norm(const Eigen::VectorXd& f, const Eigen::SparseMatrix<double>& mass) {
  const double largest = f.size() > 0 ? f.lpNorm<Eigen::Infinity>() : 0;
  if (!(largest > 0)) return largest;
  const Eigen::VectorXd unit = f / largest;
  return largest * std::sqrt(std::max(0., unit.dot(mass * unit)));
}

// Integrals and distances, one per function, by the mass matrix of the common subdivision.
Json transfer_json(const Transferred& r, const Eigen::SparseMatrix<double>& mass,
                   const Options& options) {
  Json input = Json::array(), intrinsic = Json::array(), distance = Json::array();
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(mass.rows());
  for (Eigen::Index k = 0; k < r.input.cols(); ++k) {
    const Eigen::VectorXd f = r.input_on_subdivision.col(k), g = r.intrinsic_on_subdivision.col(k);
    input.push_back(ones.dot(mass * f));
    intrinsic.push_back(ones.dot(mass * g));
    distance.push_back(norm(f - g, mass));
  }
  return {{"from", options.from},
          {"method", options.method},
          {"functions", r.input.cols()},
          {"integral_on_input", input},
          {"integral_on_intrinsic", intrinsic},
          {"L2_distance", distance}};
}

void write_values(std::ostream& out, const Functions& values) {
  Number_rows numbers(out);
  for (Eigen::Index i = 0; i < values.rows(); ++i) {
    for (Eigen::Index k = 0; k < values.cols(); ++k) numbers.put(values(i, k));
    numbers.end_row();
  }
}

// The functions on both triangulations, at the vertices of their common subdivision.
std::vector<IT::Subdivision_field> fields_of(const Transferred& r) {
  std::vector<IT::Subdivision_field> fields;
  const auto add = [&](const std::string& name, const Functions& values) {
    for (Eigen::Index k = 0; k < values.cols(); ++k)
      fields.push_back({values.cols() == 1 ? name : name + "_" + std::to_string(k), values.col(k)});
  };
  add("field_on_input", r.input_on_subdivision);
  add("field_on_intrinsic", r.intrinsic_on_subdivision);
  return fields;
}

void write_on_subdivision(const std::vector<IT::Subdivision_field>& fields,
                          const IT::Common_subdivision& s, const std::vector<Point>& points,
                          const Options& options, const Json& json, Output_files& files) {
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      write_mesh(out, extension, s, points, fields, options);
    });
  if (options.view.empty()) return;
  IT::Html_view view;
  view.fields = fields;
  view.shown_field = options.from == "input" ? fields.size() / 2 : 0; // what was computed
  view.isolines = 20;
  view.has_edges = view.has_face_colors = false;
  files.write(options.view,
              [&](std::ostream& out) { write_view(out, s, points, options, json, view); });
}

template <class Triangulation>
void transfer(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  const Triangulation& t = loaded.triangulation;
  const bool from_input = options.from == "input";
  const auto read = [&](std::size_t rows, const std::string& what) {
    Number_table table = read_numbers(options.field, rows, what);
    table.expect_rows(rows, what);
    return table;
  };
  Number_table table;
  if (from_input) table = read(t.input().number_of_rows(), "vertices of " + options.input);
  Json json = improve_and_measure(loaded, options, progress, {});
  if (!from_input) table = read(t.number_of_vertices(), "vertices of the intrinsic triangulation");
  IT::Stopwatch watch;
  progress.show("subdividing");
  IT::Common_subdivision s = subdivide(loaded, options, json);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("transferring");
  const Transferred result = transfer(t, s, functions_of(table), options);
  json["transfer"] = transfer_json(result, IT::subdivision_mass_matrix(t, s), options);
  json["seconds"]["transfer"] = watch.lap();
  progress.show("writing");
  Output_files files;
  IT::label_with_polygons(s, loaded.triangulation.input().names().polygon_of_triangle);
  if (is_mesh_output(options) || !options.view.empty()) {
    expect_points(loaded, options);
    write_on_subdivision(fields_of(result), s,
                         IT::positions(s, input_points(loaded), loaded.triangulation.input()),
                         options, json, files);
  }
  if (!options.output.empty() && !is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out) {
      write_values(out, from_input ? result.intrinsic : result.input);
    });
  finish(json, options, files, watch);
}

} // namespace

void run_transfer(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress,
                                       [&](auto& loaded) { transfer(loaded, options, progress); });
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands.h"
#include "delaunay.h"
#include "support/file_formats.h"
#include "support/text_lines.h"

#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/read_polylines.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

extern char** environ;

// The command `view`.

namespace program {

namespace {

// What files have: values at vertices of the mesh or of the triangulation or on faces of the mesh,
// and curves.
struct Shown {
  std::vector<IT::Subdivision_field> fields;
  std::vector<IT::Polyline> curves;
};

// Whether values name classes: few whole numbers.
bool are_classes(const Eigen::VectorXd& values) {
  constexpr std::size_t most = 64;
  std::set<double> different;
  for (const double x : values) {
    if (x != std::floor(x) || std::isinf(x)) return false;
    different.insert(x);
    if (different.size() > most) return false;
  }
  return true;
}

Eigen::VectorXd column_of(const Number_table& table, std::size_t k, Eigen::Index rows) {
  Eigen::VectorXd values(rows);
  for (Eigen::Index i = 0; i < rows; ++i)
    values[i] = table.values[table.columns * static_cast<std::size_t>(i) + k];
  return values;
}

// Values of faces of the mesh.
IT::Subdivision_field on_faces(const std::string& name, const Eigen::VectorXd& values,
                               const IT::Common_subdivision& s) {
  std::vector<double> there;
  for (const std::uint32_t f : s.input_face) there.push_back(values[static_cast<Eigen::Index>(f)]);
  IT::Subdivision_field field(name, std::move(there), IT::Subdivision_field::Place::faces);
  field.has_classes = are_classes(values);
  return field;
}

// \param faces how many faces the mesh has
template <class Triangulation>
void add_values(const std::string& path, const Triangulation& t, std::size_t faces,
                const IT::Common_subdivision& s, const Options& options, Shown& shown) {
  const std::size_t mine = t.number_of_vertices(), rows = t.input().number_of_rows();
  const std::string what = "vertices or faces of " + options.input;
  const Number_table table = read_numbers(path, std::max(mine, faces), what, Infinity::taken);
  const std::size_t n = table.rows();
  const bool is_on_faces = n == faces && n != mine && n != rows;
  if (n != mine && !is_on_faces) table.expect_rows(rows, "vertices of " + options.input);
  const std::string stem = as_utf8(std::filesystem::path(path).stem().string());
  for (std::size_t k = 0; k < table.columns; ++k) {
    const std::string name = table.columns == 1 ? stem : stem + "_" + std::to_string(k);
    const Eigen::VectorXd values = column_of(table, k, static_cast<Eigen::Index>(n));
    shown.fields.push_back(is_on_faces
                               ? on_faces(name, values, s)
                               : IT::interpolated_field(name, s, values, are_classes(values)));
  }
}

void add_curves(const std::string& path, Shown& shown) {
  std::vector<IT::Polyline> curves = IT::read_polylines(path);
  for (IT::Polyline& curve : curves) shown.curves.push_back(std::move(curve));
}

// The file of the page that is to be opened.
std::string temporary_page(const Options& options) {
  const std::string stem = std::filesystem::path(options.input).stem().string();
  std::string path =
      (std::filesystem::temp_directory_path() / ("intrinsic-" + stem + "-XXXXXX.html")).string();
  const int file = mkstemps(path.data(), 5);
  if (file < 0) throw std::runtime_error(path + ": the file cannot be made; name one with -o");
  close(file);
  return path;
}

// Asks the desktop for a browser; nothing happens where there is none.
void open_in_browser(std::string path) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string opener = "xdg-open";
  const std::array<char*, 3> words{opener.data(), path.data(), nullptr};
  posix_spawn_file_actions_t quiet; // else a pipe from here would stay open as long as the browser
  posix_spawn_file_actions_init(&quiet);
  posix_spawn_file_actions_addopen(&quiet, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&quiet, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  posix_spawnp(&child, opener.c_str(), &quiet, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&quiet);
}

template <class Triangulation>
void view(Loaded<Triangulation>& loaded, Options options, Progress& progress) {
  const bool is_temporary = options.view.empty();
  options.no_flip = true;
  Json json = improve_and_measure(loaded, options, progress, {});
  IT::Stopwatch watch;
  progress.show("subdividing");
  const auto [s, points, triangles] = drawn_subdivision(loaded, options, json);
  Shown shown;
  for (const std::string& path : options.shown)
    if (is_file_of(Contents::values, path))
      add_values(path, loaded.triangulation, loaded.facts.polygons, s, options, shown);
    else
      add_curves(path, shown);
  if (is_temporary) options.view = temporary_page(options);
  progress.show("writing");
  IT::Html_view page;
  page.fields = shown.fields;
  page.curves = shown.curves;
  page.isolines = 20;
  page.has_edges = page.has_face_colors = options.shown.empty();
  Output_files files;
  files.write(options.view,
              [&](std::ostream& out) { write_view(out, s, points, options, json, page); });
  finish(json, options, files, watch);
  if (is_temporary) open_in_browser(options.view);
}

} // namespace

void run_view(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress,
                                       [&](auto& loaded) { view(loaded, options, progress); });
}

} // namespace program

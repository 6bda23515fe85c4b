// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_DELAUNAY_H
#define INTRINSIC_DELAUNAY_H

#include "improve.h"
#include "load.h"
#include "options.h"
#include "output_files.h"
#include "statistics.h"
#include "support/naming_file.h"
#include "support/progress.h"
#include "view.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/matrix_market.h>
#include <CGAL/Intrinsic_operators/operators/subdivision_matrices.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

/// extracts the common subdivision, and reports it. \throws std::runtime_error
template <class Triangulation>
IT::Common_subdivision subdivide(const Loaded<Triangulation>& loaded, const Options& options,
                                 Json& json) {
  try {
    IT::Common_subdivision s = IT::common_subdivision(loaded.triangulation);
    json["subdivision"] = {{"vertices", s.number_of_vertices()},
                           {"edges", s.number_of_edges()},
                           {"faces", s.number_of_faces()}};
    return s;
  } catch (const std::exception& e) {
    throw std::runtime_error(options.input + ": " + e.what());
  }
}

/// returns the area of a common subdivision.
inline double area(const IT::Common_subdivision& s, const std::vector<Point>& points) {
  long double sum = 0;
  for (std::size_t f = 0; f < s.number_of_faces(); ++f) {
    const auto corners = s.face(f);
    for (std::size_t k = 2; k < corners.size(); ++k)
      sum += IT::area_in_space(points[corners[0]], points[corners[k - 1]], points[corners[k]]);
  }
  return static_cast<double>(sum);
}

/// The common subdivision and where its vertices are.
struct Drawn_subdivision {
  IT::Common_subdivision s; ///< labelled with the polygons of the file
  std::vector<Point> points;
  std::vector<std::uint32_t> input_triangle; ///< the triangle of the input that each face is in
};

/// throws std::runtime_error if nothing can be drawn, as the input has no points.
template <class Triangulation>
void expect_points(const Loaded<Triangulation>& loaded, const Options& options) {
  if (loaded.points.empty())
    throw std::runtime_error(
        options.input + ": the stored triangulation has lengths and no points, so that nothing "
                        "can be drawn; write values to a file .txt, or start from the mesh (of a "
                        "coarse surface, simplify -o coarse.ply writes the triangles in space)");
}

/// extracts the common subdivision to be drawn, and reports it. \throws std::runtime_error
template <class Triangulation>
Drawn_subdivision drawn_subdivision(const Loaded<Triangulation>& loaded, const Options& options,
                                    Json& json) {
  if (is_mesh_output(options) || !options.view.empty()) expect_points(loaded, options);
  IT::Common_subdivision s = subdivide(loaded, options, json);
  std::vector<std::uint32_t> triangles = s.input_face;
  IT::label_with_polygons(s, loaded.triangulation.input().names().polygon_of_triangle);
  std::vector<Point> points = IT::positions(s, input_points(loaded), loaded.triangulation.input());
  json["subdivision"]["area"] = area(s, points) / loaded.triangulation.input().names().sheets;
  return {std::move(s), std::move(points), std::move(triangles)};
}

/// writes a common subdivision with fields in the format of an extension.
inline void write_mesh(std::ostream& out, const std::string& extension,
                       const IT::Common_subdivision& s, const std::vector<Point>& points,
                       std::span<const IT::Subdivision_field> fields, const Options& options) {
  if (writes_plain_meshes(options))
    IT::write_plain_subdivision(out, extension, s, points, fields);
  else
    IT::write_common_subdivision(out, extension, s, points, fields);
}

/// writes a matrix. \param what what it is, for the comment in the file
template <class Matrix>
void write_matrix(const std::string& path, const Matrix& matrix, const std::string& what,
                  Output_files& files) {
  const Eigen::SparseMatrix<typename Matrix::Scalar>& in_columns = matrix; // made of one in rows
  files.write(path, [&](std::ostream& out) {
    IT::write_matrix_market(out, in_columns,
                            what + ",\nby intrinsic " + INTRINSIC_TRIANGULATIONS_VERSION);
  });
}

/// writes the Laplacian and the mass matrix, if options name files for them.
/// \throws Invalid_input naming the file
template <class Triangulation>
void write_matrices(Triangulation& t, const Options& options, Output_files& files) {
  const std::string rows = "; rows of the input's vertices in their order, then of those inserted";
  naming_file(options.input, [&] {
    if (!options.laplacian.empty())
      write_matrix(options.laplacian, IT::cotangent_laplacian(t),
                   "cotangent Laplacian, positive semidefinite" + rows, files);
    if (!options.mass.empty())
      write_matrix(options.mass,
                   options.mass_kind == "lumped"     ? IT::lumped_mass_matrix(t)
                   : options.mass_kind == "galerkin" ? IT::galerkin_mass_matrix(t)
                                                     : IT::voronoi_mass_matrix(t),
                   options.mass_kind + " mass matrix" + rows, files);
  });
}

/// writes the common subdivision, what interpolates there, and the page that shows it.
template <class Triangulation>
void write_subdivision(const Loaded<Triangulation>& loaded, const Options& options, Json& json,
                       Output_files& files, Progress& progress, IT::Stopwatch& watch) {
  progress.show("subdividing");
  const auto [s, points, triangles] = drawn_subdivision(loaded, options, json);
  if constexpr (!Triangulation::Metric::is_exact)
    if (loaded.triangulation.input().planar_polygons().empty()) // which are not planar in space
      expect_covered(json["area"]["input"], json["subdivision"]["area"], options);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      write_mesh(out, extension, s, points, {}, options);
    });
  if (!options.interpolation.empty())
    write_matrix(options.interpolation, IT::interpolation_from_intrinsic(s),
                 "interpolation from the vertices of the intrinsic triangulation to those of the "
                 "common subdivision",
                 files);
  if (!options.input_interpolation.empty())
    write_matrix(options.input_interpolation, IT::interpolation_from_input(s),
                 "interpolation from the vertices of the input to those of the common subdivision",
                 files);
  if (!options.view.empty())
    files.write(options.view,
                [&](std::ostream& out) { write_view(out, s, points, options, json, {}); });
}

/// flips to Delaunay, refines and writes files, as options say.
template <class Triangulation>
void delaunay(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  Json json = improve_and_measure(loaded, options, progress, {});
  IT::Stopwatch watch;
  Output_files files;
  if constexpr (Triangulation::has_correspondence)
    if (needs_subdivision(options))
      write_subdivision(loaded, options, json, files, progress, watch);
  if (!options.output.empty() && !is_mesh_output(options)) {
    progress.show("writing");
    files.write(options.output, [&](std::ostream& out) {
      IT::write_intrinsic_triangulation(out, loaded.triangulation);
    });
  }
  write_matrices(loaded.triangulation, options, files);
  finish(json, options, files, watch);
}

/// runs the command with a correspondence
template <class Correspondence>
void run_delaunay_with(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<Correspondence>(options, progress,
                              [&](auto& loaded) { delaunay(loaded, options, progress); });
}

} // namespace program

#endif // INTRINSIC_DELAUNAY_H

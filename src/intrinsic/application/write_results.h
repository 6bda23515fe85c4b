// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_WRITE_RESULTS_H
#define INTRINSIC_APPLICATION_WRITE_RESULTS_H

#include "../delaunay.h"
#include "../load.h"
#include "../options.h"
#include "../output_files.h"
#include "../support/progress.h"
#include "Computed.h"
#include "Drawn_results.h"
#include "cut.h"
#include "direction_lines.h"

#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/support/Stopwatch.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace program {

/// returns the mesh of the file, or the input that was stored, before the first move.
template <class Triangulation>
Loaded<Triangulation> input_alone(const Loaded<Triangulation>& loaded, const Options& options) {
  expect_points(loaded, options);
  const IT::Input& input = loaded.triangulation.input();
  const std::vector<Point>& rows = loaded.points;
  std::vector<Point> points;
  for (std::uint32_t v = 0; v < input.number_of_vertices(); ++v)
    points.push_back(rows[input.names().row(v)]);
  IT::Intrinsic_input in(input.mesh(), std::move(points), IT::Mollification::none);
  in.names = input.names();
  in.may_renumber = false;
  return {{Triangulation(std::move(in)), rows}};
}

/// returns the index of each face that is drawn: of its intrinsic face, or on the input the sum of
/// those about points in its face.
template <class Triangulation>
std::vector<int> drawn_index(const Triangulation& t, const std::vector<int>& index,
                             const Drawn_subdivision& drawn, bool is_on_input) {
  std::vector<int> of_triangle(is_on_input ? drawn.s.number_of_faces() : 0, 0), result;
  if (is_on_input)
    for (const auto f : faces(t.mesh())) {
      const IT::Surface_point centre{t.numbers().halfedge(halfedge(f, t.mesh())),
                                     {1. / 3, 1. / 3, 1. / 3}};
      if (index[t.index(f)] == 0) continue;
      if (const auto p = IT::locate_on_input(t, centre))
        of_triangle[t.input().names().faces.user(t.input().face(p->halfedge))] += index[t.index(f)];
    }
  for (std::size_t f = 0; f < drawn.s.number_of_faces(); ++f)
    result.push_back(is_on_input ? of_triangle[drawn.input_triangle[f]]
                                 : index[drawn.s.intrinsic_face[f]]);
  return result;
}

/// returns the vectors that are known, and zero elsewhere.
inline IT::Tangent_field known_vectors(IT::Tangent_field vectors) {
  for (std::complex<double>& z : vectors)
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag())) z = 0;
  return vectors;
}

/// returns directions at the points of a cloud: their planes are not those of faces.
template <class Triangulation>
Drawn_directions drawn_at_points(const Triangulation& t, const Direction_field& d,
                                 const Drawn_subdivision& drawn) {
  const IT::Tangent_field vectors = known_vectors(d.vectors);
  Drawn_directions result;
  for (unsigned k = 0; k < d.degree; ++k) {
    result.at_vertices.emplace_back(drawn.s.number_of_vertices(), Point{0, 0, 0});
    for (std::size_t v = 0; v < drawn.s.vertices.size(); ++v) {
      const std::uint32_t row =
          t.input_vertex(t.numbers().vertex_at(drawn.s.vertices[v].intrinsic));
      const std::complex<double> z =
          vectors[row] * std::polar(1., 2 * std::numbers::pi * k / d.degree);
      const auto& [x, y] = d.axes[row];
      for (std::size_t c = 0; c < 3; ++c)
        result.at_vertices[k][v][c] = z.real() * x[c] + z.imag() * y[c];
    }
  }
  return result;
}

/// returns the directions of a field on the surface that is drawn; none if there is no field.
template <class Triangulation>
Drawn_directions drawn_directions(const Loaded<Triangulation>& loaded,
                                  const Loaded<Triangulation>& surface, const Computed& computed,
                                  const Drawn_subdivision& drawn) {
  if (!computed.directions) return {};
  const Direction_field& d = *computed.directions;
  if (!d.axes.empty()) return drawn_at_points(surface.triangulation, d, drawn);
  const bool is_on_input = &surface != &loaded;
  const IT::Tangent_field vectors = known_vectors(d.vectors);
  Drawn_directions result =
      is_on_input
          ? directions_in_space(surface,
                                IT::tangent_field_to_intrinsic(
                                    surface.triangulation,
                                    IT::tangent_field_to_input(loaded.triangulation, vectors)),
                                d.degree, drawn)
          : directions_in_space(loaded, vectors, d.degree, drawn);
  if (!d.index.empty())
    result.index = drawn_index(loaded.triangulation, d.index, drawn, is_on_input);
  return result;
}

/// returns the unit vectors in space along the real axes of tangent planes, on a cloud along both;
/// none if there are no points.
template <class Triangulation>
std::vector<std::vector<Point>> axes_in_space(const Loaded<Triangulation>& loaded,
                                              const Computed& computed) {
  if (!computed.directions || loaded.points.empty()) return {};
  if (const auto& axes = computed.directions->axes; !axes.empty()) {
    std::vector<std::vector<Point>> result(2);
    for (const IT::Point_cloud_vectors::Axes& a : axes)
      for (const std::size_t k : {0U, 1U}) result[k].push_back(a[k]);
    return result;
  }
  return {IT::vectors_in_space(loaded.triangulation,
                               IT::Tangent_field(computed.directions->vectors.size(), 1),
                               input_points(loaded))};
}

/// writes what was computed to files that show it on a surface: that of a triangulation, or the
/// input.
template <class Triangulation>
void write_on_surface(const Loaded<Triangulation>& loaded, const Loaded<Triangulation>& surface,
                      const Computed& computed, const Options& options, Json& json,
                      Output_files& files, Progress& progress, IT::Stopwatch& watch) {
  Json unread;
  const bool is_on_input = &surface != &loaded;
  Drawn_subdivision drawn = drawn_subdivision(surface, options, is_on_input ? unread : json);
  Drawn_directions directions = drawn_directions(loaded, surface, computed, drawn);
  const IT::Interpolation_matrix interpolation = is_on_input
                                                     ? IT::interpolation_from_input(drawn.s)
                                                     : IT::interpolation_from_intrinsic(drawn.s);
  Drawn_results results = draw(std::move(drawn), computed, interpolation);
  results.directions = std::move(directions);
  if (computed.cell_boundaries && !options.view.empty())
    for (IT::Polyline& line : results.lines = computed.cell_boundaries(input_points(loaded)))
      line.label = -1; // dark
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  if (!options.view.empty())
    files.write(options.view, [&](std::ostream& out) {
      write_results_view(out, results, computed, loaded.cut, options, json);
    });
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      std::vector<IT::Subdivision_field> fields = results.fields;
      if (computed.directions) append_fields(fields, computed.directions->name, results.directions);
      if (loaded.cut.is_cut() && !stays_open(options))
        close_seams(results.drawn, fields, loaded.cut);
      write_mesh(out, extension, results.drawn.s, results.drawn.points, fields, options);
    });
}

/// writes isolines of the first function as polylines in space, and counts them.
template <class Triangulation>
void write_isolines(std::ostream& out, const std::string& extension,
                    const Loaded<Triangulation>& loaded, const Computed& computed,
                    const Options& options, Json& json) {
  expect_points(loaded, options);
  const Triangulation& t = loaded.triangulation;
  const Eigen::VectorXd& values = computed.functions.front().values;
  const std::vector<IT::Polyline> lines = IT::polylines(
      t,
      IT::isolines(t, std::span(values.data(), static_cast<std::size_t>(values.size())),
                   computed.levels),
      input_points(loaded));
  json[computed.command]["isolines"] = lines.size();
  IT::write_polylines(out, extension, lines, "level");
}

/// writes points and lines in space that were computed: singularities, isolines, cells.
template <class Triangulation>
void write_lines(const Loaded<Triangulation>& loaded, const Computed& computed,
                 const Options& options, Json& json, Output_files& files) {
  if (!options.application.singularities.empty()) {
    expect_points(loaded, options);
    files.write(options.application.singularities,
                [&](std::ostream& out, const std::string& extension) {
                  IT::write_polylines(out, extension, computed.marks.points, "index");
                });
  }
  if (!options.application.isolines.empty())
    files.write(options.application.isolines, [&](std::ostream& out, const std::string& extension) {
      write_isolines(out, extension, loaded, computed, options, json);
    });
  if (computed.cell_boundaries) {
    expect_points(loaded, options);
    files.write(options.application.voronoi, [&](std::ostream& out, const std::string& extension) {
      IT::write_polylines(out, extension, computed.cell_boundaries(input_points(loaded)),
                          "boundary");
    });
  }
}

/// writes what was computed.
template <class Triangulation>
void write_results(const Loaded<Triangulation>& loaded, const Computed& computed,
                   const Options& options, Json& json, Output_files& files, Progress& progress,
                   IT::Stopwatch& watch) {
  const bool is_on_input = options.application.on == "input" || computed.is_of_input;
  if (computed.laid_out) {
    expect_points(loaded, options);
    progress.show("writing");
    write_laid_out(*computed.laid_out, computed.marks, options, json, files);
  } else if (computed.write_page) {
    if (!options.view.empty())
      files.write(options.view, [&](std::ostream& out) { computed.write_page(out, json); });
  } else if (needs_subdivision(options)) {
    progress.show("subdividing");
    if (is_on_input)
      write_on_surface(loaded, input_alone(loaded, options), computed, options, json, files,
                       progress, watch);
    else
      write_on_surface(loaded, loaded, computed, options, json, files, progress, watch);
  }
  write_lines(loaded, computed, options, json, files);
  if (computed.write && !options.output.empty()) {
    watch.lap();
    files.write(options.output,
                [&](std::ostream& out) { computed.write(out, json[computed.command]); });
    json["seconds"]["solve"] = watch.lap();
  } else if (!options.output.empty() && !is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out) {
      write_functions(out, computed, axes_in_space(loaded, computed),
                      is_on_input ? loaded.triangulation.input().number_of_rows()
                                  : loaded.triangulation.number_of_vertices(),
                      loaded.cut);
    });
}

} // namespace program

#endif // INTRINSIC_APPLICATION_WRITE_RESULTS_H

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.h"
#include "../delaunay.h"
#include "../geodesic/asked_curves.h"
#include "../support/Number_rows.h"
#include "../support/naming_file.h"
#include "../view.h"
#include "cut.h"
#include "direction_lines.h"

#include <CGAL/Intrinsic_geodesics/compiled.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/insert_places.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/tangent_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <numbers>
#include <ostream>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace program {

namespace {

/// The surface on which results are drawn: the common subdivision, or the mesh of the file.
struct Drawn_results {
  Drawn_subdivision drawn;
  std::vector<IT::Subdivision_field> fields; ///< first the functions
  Drawn_directions directions{};
  /// where a checkerboard is shown; not numbers: none
  std::vector<std::array<double, 2>> texture{};
};

void expect_writable_results(const Options& options) {
  if (is_mesh_output(options) && options.application.on == "intrinsic")
    throw std::runtime_error(
        options.output +
        ": faces of the intrinsic triangulation bend over edges of the mesh; write "
        "the common subdivision with --on subdivision, or values to a file .txt");
}

// The values of each row; of directions one of them in polar coordinates, and the unit vectors in
// space along the axes there: along the real one, on a cloud along both. On a surface that was cut
// open, the vertex of the file is last.
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

// The first two functions, without vertices at which the map is torn.
std::vector<std::array<double, 2>> drawn_texture(const Computed& computed,
                                                 const Eigen::SparseMatrix<double>& interpolation) {
  std::vector<std::array<double, 2>> texture(static_cast<std::size_t>(interpolation.rows()));
  for (std::size_t c = 0; c < 2; ++c) {
    Eigen::VectorXd values = computed.functions[c].values.head(interpolation.cols());
    for (Eigen::Index i = 0; i < values.size() && !computed.is_torn.empty(); ++i)
      if (computed.is_torn[static_cast<std::size_t>(i)] != 0)
        values[i] = std::numeric_limits<double>::quiet_NaN();
    const Eigen::VectorXd places = interpolation * values;
    for (std::size_t v = 0; v < texture.size(); ++v)
      texture[v][c] = places[static_cast<Eigen::Index>(v)];
  }
  return texture;
}

Drawn_results draw(Drawn_subdivision drawn, const Computed& computed,
                   const Eigen::SparseMatrix<double>& interpolation) {
  Drawn_results results{std::move(drawn), {}};
  if (computed.is_map) results.texture = drawn_texture(computed, interpolation);
  for (const Function& f : computed.functions)
    results.fields.push_back(
        {f.name, Eigen::VectorXd(interpolation * f.values.head(interpolation.cols()))});
  if (computed.displacements.size() == 0) return results;
  const Eigen::MatrixXd d = interpolation * computed.displacements.topRows(interpolation.cols());
  for (std::size_t v = 0; v < results.drawn.points.size(); ++v)
    for (std::size_t c = 0; c < 3; ++c)
      results.drawn.points[v][c] += d(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c));
  return results;
}

void write_results_view(std::ostream& out, const Drawn_results& results, const Computed& computed,
                        const Cut& cut, const Options& options, const Json& json) {
  Viewed viewed;
  const std::vector<IT::Polyline> lines =
      cut.is_cut() ? cut.seams : direction_lines(results.directions, results.drawn);
  viewed.curves = lines;
  viewed.marks = computed.marks.points;
  viewed.marks_name = computed.marks.name;
  viewed.isolines = computed.isolines;
  viewed.is_plain = computed.isolines > 0 || computed.is_map || computed.directions;
  if (computed.directions) viewed.curve_width = 1.5;
  viewed.fields = results.fields;
  viewed.shown_field = computed.is_map ? results.fields.size() : computed.shown;
  viewed.texture = results.texture;
  write_view(out, results.drawn.s, results.drawn.points, options, json, viewed);
}

/// returns the mesh of the file, or the input that was stored, before the first move.
template <class Triangulation>
Loaded<Triangulation> input_alone(const Loaded<Triangulation>& loaded, const Options& options) {
  expect_points(loaded, options);
  const IT::Input& input = loaded.triangulation.input();
  IT::Intrinsic_input in(input.mesh(), loaded.scaled_points(), IT::Mollification::none);
  for (Point& p : in.points)
    for (double& x : p) x = std::ldexp(x, -input.scale_exponent());
  in.names = input.names();
  in.may_renumber = false;
  Loaded<Triangulation> alone{Triangulation(std::move(in)), {}, {}, {}, {}};
  if (!Triangulation::Metric::is_exact)
    alone.points = alone.triangulation.input().metric().points();
  return alone;
}

// The index of each face that is drawn: of its intrinsic face, or on the input the sum of those
// about points in its face.
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

// The vectors that are known, and zero elsewhere.
IT::Tangent_field known_vectors(IT::Tangent_field vectors) {
  for (std::complex<double>& z : vectors)
    if (!std::isfinite(z.real()) || !std::isfinite(z.imag())) z = 0;
  return vectors;
}

// At the points of a cloud: their planes are not those of faces.
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

// The unit vectors in space along the real axes of tangent planes, on a cloud along both; none if
// there are no points.
template <class Triangulation>
std::vector<std::vector<Point>> axes_in_space(const Loaded<Triangulation>& loaded,
                                              const Computed& computed) {
  if (!computed.directions || loaded.scaled_points().empty()) return {};
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
                      Output_files& files, Progress& progress, Stopwatch& watch) {
  Json unread;
  const bool is_on_input = &surface != &loaded;
  Drawn_subdivision drawn = drawn_subdivision(surface, options, is_on_input ? unread : json);
  Drawn_directions directions = drawn_directions(loaded, surface, computed, drawn);
  const Eigen::SparseMatrix<double> interpolation = is_on_input
                                                        ? IT::interpolation_from_input(drawn.s)
                                                        : IT::interpolation_from_intrinsic(drawn.s);
  Drawn_results results = draw(std::move(drawn), computed, interpolation);
  results.directions = std::move(directions);
  json["seconds"]["subdivide"] = watch.lap();
  progress.show("writing");
  if (!options.view.empty())
    files.write(options.view, [&](std::ostream& out) {
      write_results_view(out, results, computed, loaded.cut, options, json);
    });
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out) {
      constexpr std::array<std::string_view, 1> without_corners{"vtp"};
      std::vector<IT::Subdivision_field> fields = results.fields;
      if (computed.directions) append_fields(fields, computed.directions->name, results.directions);
      if (loaded.cut.is_cut() && !IT::has_extension(options.output, without_corners))
        close_seams(results.drawn, fields, loaded.cut);
      IT::write_common_subdivision(out, std::filesystem::path(options.output).extension().string(),
                                   results.drawn.s, results.drawn.points, fields);
    });
}

// Writes a surface that was laid out in the plane; formats without numbers at corners get it cut.
void write_laid_out(const Laid_out& laid_out, const Marks& marks, const Options& options,
                    const Json& json, Output_files& files) {
  constexpr std::array<std::string_view, 1> without_corners{"vtp"};
  const Surface_with_fields& opened = laid_out.opened;
  if (!options.view.empty()) {
    Viewed viewed;
    viewed.is_plain = true;
    viewed.curves = laid_out.seams;
    viewed.marks = marks.points;
    viewed.marks_name = marks.name;
    std::vector<IT::Subdivision_field> shown;
    for (const IT::Subdivision_field& field : opened.fields)
      if (field.is_function()) shown.push_back(field);
    std::vector<std::array<double, 2>> texture;
    for (std::size_t v = 0; v < opened.points.size(); ++v)
      texture.push_back({shown[0].values[v], shown[1].values[v]});
    viewed.fields = shown;
    viewed.shown_field = shown.size(); // none
    viewed.texture = texture;
    viewed.is_disk = laid_out.is_disk;
    files.write(options.view, [&](std::ostream& out) {
      write_view(out, opened.s, opened.points, options, json, viewed);
    });
  }
  if (!is_mesh_output(options)) return;
  const Surface_with_fields& written =
      IT::has_extension(options.output, without_corners) ? opened : laid_out.closed;
  files.write(options.output, [&](std::ostream& out) {
    IT::write_common_subdivision(out, std::filesystem::path(options.output).extension().string(),
                                 written.s, written.points, written.fields);
  });
}

/// writes isolines of the first function as polylines in space, and counts them.
template <class Triangulation>
void write_isolines(std::ostream& out, const Loaded<Triangulation>& loaded,
                    const Computed& computed, const Options& options, Json& json) {
  expect_points(loaded, options);
  const Triangulation& t = loaded.triangulation;
  const Eigen::VectorXd& values = computed.functions.front().values;
  const std::vector<IT::Polyline> lines = IT::polylines(
      t,
      IT::isolines(t, std::span(values.data(), static_cast<std::size_t>(values.size())),
                   computed.levels),
      input_points(loaded));
  json[computed.command]["isolines"] = lines.size();
  IT::write_polylines(out, std::filesystem::path(options.application.isolines).extension().string(),
                      lines, "level");
}

/// writes what was computed.
template <class Triangulation>
void write_results(const Loaded<Triangulation>& loaded, const Computed& computed,
                   const Options& options, Json& json, Output_files& files, Progress& progress,
                   Stopwatch& watch) {
  const bool is_on_input = options.application.on == "input" || computed.is_of_input;
  if (computed.laid_out) {
    expect_points(loaded, options);
    progress.show("writing");
    write_laid_out(*computed.laid_out, computed.marks, options, json, files);
  } else if (needs_subdivision(options)) {
    progress.show("subdividing");
    if (is_on_input)
      write_on_surface(loaded, input_alone(loaded, options), computed, options, json, files,
                       progress, watch);
    else
      write_on_surface(loaded, loaded, computed, options, json, files, progress, watch);
  }
  if (!options.application.singularities.empty()) {
    expect_points(loaded, options);
    files.write(options.application.singularities, [&](std::ostream& out) {
      IT::write_polylines(
          out, std::filesystem::path(options.application.singularities).extension().string(),
          computed.marks.points, "index");
    });
  }
  if (!options.application.isolines.empty())
    files.write(options.application.isolines,
                [&](std::ostream& out) { write_isolines(out, loaded, computed, options, json); });
  if (computed.cell_boundaries) {
    expect_points(loaded, options);
    const std::string& name = options.application.voronoi;
    files.write(name, [&](std::ostream& out) {
      IT::write_polylines(out, std::filesystem::path(name).extension().string(),
                          computed.cell_boundaries(input_points(loaded)), "boundary");
    });
  }
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

// Where sources are.
template <class Triangulation>
Marks source_marks(const Loaded<Triangulation>& loaded, const Sources& sources,
                   std::size_t lists_of_points) {
  Marks marks{"sources"};
  const Triangulation& t = loaded.triangulation;
  const std::vector<Point> points = input_points(loaded);
  for (const auto& list : std::span(sources).first(lists_of_points))
    for (const IT::Place& p : list)
      marks.points.push_back(
          {{IT::point_in_space(t, point_on_input(t.input(), p), points)}, false, 0});
  return marks;
}

// Reads points before long work begins: each has an element of the mesh that is good for it.
template <class Triangulation>
Sources sources_of(const Triangulation& t, const std::vector<Asked_curve>& asked,
                   const Options& options) {
  IT::Place_finder<Triangulation> find(t);
  Sources sources;
  for (const Asked_curve& list : asked)
    naming_file(list.source + ": " + options.input, [&] {
      std::vector<IT::Place>& places = sources.emplace_back();
      for (const IT::Place& p : list.points) {
        places.push_back(normalized(t.input(), p));
        if (places.back().is_vertex()) (void)find.vertex(places.back().vertex);
      }
    });
  return sources;
}

// Vertices at the points of curves. They need a triangulation that is not refined any more.
template <class Triangulation>
bool insert_curves(Triangulation& t, const std::vector<Asked_curve>& asked,
                   const Options& options) {
  const std::size_t before = num_vertices(t.mesh());
  for (const Asked_curve& list : asked)
    if (list.kind == Curve_kind::joined)
      naming_file(list.source + ": " + options.input,
                  [&] { return IT::insert_places(t, list.points); });
  return num_vertices(t.mesh()) != before;
}

// Adaptive refinement is about the first vertex from which something is computed.
Options about_source(Options options, const std::vector<Asked_curve>& asked,
                     const Sources& sources) {
  if (!options.adaptive.is_asked_for || asked.empty()) return options;
  const IT::Place& first = sources.front().front();
  if (!first.is_vertex())
    throw std::runtime_error(
        asked.front().source +
        ": --adaptive refines about a vertex; give one first, or another criterion");
  options.adaptive.source = first.vertex;
  return options;
}

template <class Traits>
Computed solved(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
                const Solver<Traits>& solve, const Sources& sources, Progress& progress) {
  return naming_file(options.input, [&] {
    return solve(loaded.triangulation, sources, input_points(loaded), progress);
  });
}

template <class Traits>
void run(Loaded<Solved_triangulation<Traits>>& loaded, const Options& options,
         const Solver<Traits>& solve, Progress& progress) {
  const std::vector<Asked_curve> asked =
      asked_points(options, loaded.triangulation.input().number_of_rows(), loaded.facts.polygons);
  const Sources sources = sources_of(loaded.triangulation, asked, options);
  if (options.application.alignment && loaded.scaled_points().empty())
    throw std::runtime_error(options.input +
                             ": the stored triangulation has lengths and no points, so that it has "
                             "no directions of curvature; leave --align out, or start from the "
                             "mesh");
  Json json = improve_and_measure(loaded, about_source(options, asked, sources), progress, [&] {
    return insert_curves(loaded.triangulation, asked, options);
  });
  Stopwatch watch;
  progress.show("solving");
  Computed computed = solved(loaded, options, solve, sources, progress);
  if (computed.marks.points.empty() && !sources.empty())
    computed.marks = source_marks(loaded, sources, options.application.sources.size());
  json[computed.command] = computed.json;
  if (loaded.cut.is_cut())
    json["cut"] = {{"edges", loaded.cut.edges},
                   {"length", loaded.cut.length},
                   {"vertices", loaded.cut.original_vertex.size()}};
  json["seconds"][computed.timed] = watch.lap();
  Output_files files;
  write_results(loaded, computed, options, json, files, progress, watch);
  finish(json, options, files, watch);
  print_summary_on_terminal(json);
}

} // namespace

namespace {

// A line from a point along a vector, or an arrow, the tip of which has another colour.
void append_direction(std::vector<IT::Polyline>& lines, const Point& from, const Point& vector,
                      double scale, bool is_arrow) {
  Point middle, to;
  for (std::size_t c = 0; c < 3; ++c) {
    middle[c] = from[c] + 0.7 * scale * vector[c];
    to[c] = from[c] + scale * vector[c];
  }
  lines.push_back({{from, is_arrow ? middle : to}, false, 1});
  if (is_arrow) lines.push_back({{middle, to}, false, 0});
}

double length(const Point& p) { return std::hypot(p[0], p[1], p[2]); }

// The factor by which to draw vectors.
double scale_of_lines(const Drawn_directions& directions, const Drawn_subdivision& drawn) {
  double longest = 0, sum = 0;
  for (const Point& p : directions.at_vertices.front()) longest = std::max(longest, length(p));
  std::size_t count = 0;
  const std::vector<Point>& x = drawn.points;
  IT::for_each_subdivision_edge(
      drawn.s, [&](std::uint32_t a, std::uint32_t b, const IT::Common_subdivision::Side& side) {
        if (side.intrinsic_edge == IT::Common_subdivision::none) return;
        ++count;
        sum += length({x[a][0] - x[b][0], x[a][1] - x[b][1], x[a][2] - x[b][2]});
      });
  return longest > 0 && count > 0 ? sum / static_cast<double>(count) / 2 / longest : 0;
}

} // namespace

std::vector<IT::Polyline> direction_lines(const Drawn_directions& directions,
                                          const Drawn_subdivision& drawn) {
  std::vector<IT::Polyline> lines;
  if (directions.at_vertices.empty()) return lines;
  const double scale = scale_of_lines(directions, drawn);
  const bool are_arrows = directions.at_vertices.size() == 1;
  for (const std::vector<Point>& vectors : directions.at_vertices)
    for (std::size_t v = 0; v < drawn.s.vertices.size(); ++v)
      append_direction(lines, drawn.points[v], vectors[v], scale, are_arrows);
  return lines;
}

void append_fields(std::vector<IT::Subdivision_field>& fields, const std::string& name,
                   const Drawn_directions& directions) {
  using Place = IT::Subdivision_field::Place;
  const std::size_t degree = directions.at_vertices.size();
  for (std::size_t k = 0; k < degree; ++k) {
    const std::string numbered = degree == 1 ? name : name + "_" + std::to_string(k);
    fields.push_back({numbered, directions.at_vertices[k]});
    if (!directions.at_faces.empty())
      fields.push_back({numbered, directions.at_faces[k], Place::faces});
  }
  if (!directions.index.empty()) fields.push_back({"index", directions.index, Place::faces});
}

void run_application(const Options& options, const Solver<IT::Exact_euclidean_traits>& exact,
                     const Solver<IT::Euclidean_traits<double>>& approximate) {
  expect_writable_results(options);
  Progress_line progress(options.logs_progress);
  with_loaded<IT::Integer_coordinates>(
      options, progress,
      [&](auto& loaded) {
        if constexpr (std::decay_t<decltype(loaded.triangulation)>::Metric::is_exact)
          run(loaded, options, exact, progress);
        else
          run(loaded, options, approximate, progress);
      },
      options.application.cut.empty() ? Cutter() : Cutter{take_sheet, cut_to_disk});
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../delaunay.h"
#include "../support/file_formats.h"
#include "../support/text_lines.h"
#include "Computed.h"
#include "side_by_side.h"

#include <CGAL/Intrinsic_simplification/simplification/prolongation.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_simplification/simplification/vector_prolongation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

// ---- What is asked for -------------------------------------------------------------------------

// A number of vertices, or a percentage of all.
void ask_for_vertices(const std::string& word, IT::Simplify_options& asked) {
  if (word.empty()) return;
  if (word.back() == '%')
    asked.part = std::stod(word) / 100;
  else
    asked.vertices = std::stoul(word);
}

std::vector<std::uint32_t> listed_vertices(const Options& options, std::uint32_t vertices) {
  std::vector<std::uint32_t> result;
  if (options.simplify.kept_vertices.empty()) return result;
  Text_lines lines(options.simplify.kept_vertices);
  while (lines.next()) {
    lines.expect_words(1, "the number of a vertex");
    result.push_back(lines.element(0, "vertex", vertices));
  }
  return result;
}

template <class Triangulation>
IT::Simplify_options asked_options(const Loaded<Triangulation>& loaded, const Options& options,
                                   Progress& progress) {
  const Triangulation& t = loaded.triangulation;
  IT::Simplify_options asked;
  const Simplify_command& given = options.simplify;
  ask_for_vertices(given.vertices, asked);
  if (given.stretch) asked.stretch = *given.stretch;
  asked.kept_vertices = listed_vertices(options, t.input().number_of_rows());
  const auto kept = constrained_edges(t, loaded.constraints);
  for (const auto e : edges(t.mesh()))
    if (get(kept, e)) asked.kept_edges.push_back(t.index(e));
  asked.progress = [&progress](const IT::Simplify_progress& p) {
    return progress.show("simplifying", std::to_string(p.left) + " vertices left");
  };
  return asked;
}

template <class Triangulation>
IT::Simplification simplified(const Triangulation& t, const Simplify_command& given,
                              const IT::Simplify_options& asked) {
  if (given.flat) return IT::remove_flat_vertices(t, *given.flat, asked);
  return IT::with_named_cost(given.cost, t,
                             [&](auto&& cost) { return IT::simplify(t, asked, std::move(cost)); });
}

Json json_of(const IT::Simplification& s, std::size_t kept) {
  return {{"status", IT::name_of(s.status)},
          {"vertices", s.kept.size()},
          {"faces", s.surface.mesh.number_of_faces()},
          {"removed", s.removed},
          {"stretch",
           {{"lower", s.stretch.lower},
            {"upper", s.stretch.upper},
            {"mean_lower", s.stretch.mean_lower},
            {"mean_upper", s.stretch.mean_upper}}},
          {"newton", s.newton_steps},
          {"most_newton", s.most_newton_steps},
          {"ptolemy_flips", s.ptolemy_flips},
          {"flips", s.flips},
          {"kept", kept},
          {"blocked_by_border", s.blocked_by_border},
          {"not_flattened", s.not_flattened},
          {"kept_by_bound", s.kept_by_bound}};
}

// ---- What is written ---------------------------------------------------------------------------

// The bounds of the stretch where each vertex of the fine surface is, and at each coarse one: the
// worst of the faces there.
class Stretch_at_vertices {
public:
  explicit Stretch_at_vertices(const IT::Simplification& s) : s_(s), at_coarse_(s.kept.size()) {
    const IT::Gluing_map& mesh = s.surface.mesh;
    for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
      for (const auto h : mesh.sides(IT::Gluing_map::Face{f}))
        at_coarse_[mesh.source(h).index] =
            worse(at_coarse_[mesh.source(h).index], s.face_stretch[f]);
  }

  const IT::Face_stretch& at_coarse(std::size_t vertex) const { return at_coarse_[vertex]; }
  IT::Face_stretch at_fine(std::size_t row) const {
    const IT::Place& p = s_.places[row];
    if (p.is_vertex()) return at_coarse_[p.vertex];
    return p.has_face() ? s_.face_stretch[p.face] : IT::Face_stretch{};
  }

private:
  static IT::Face_stretch worse(const IT::Face_stretch& a, const IT::Face_stretch& b) {
    return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
  }

  const IT::Simplification& s_;
  std::vector<IT::Face_stretch> at_coarse_;
};

// Adds the bounds at the vertices of a triangulation; at crossings those of an end of their edge.
template <class Bounds_of_row>
void add_stretch(Surface_with_fields& surface, const Bounds_of_row& bounds) {
  std::vector<double> lower, upper;
  for (std::size_t v = 0; v < surface.s.number_of_vertices(); ++v) {
    const IT::Face_stretch b = bounds(surface.s.on_intrinsic(v).vertices[0]);
    lower.push_back(b.lower);
    upper.push_back(b.upper);
  }
  surface.fields.emplace_back("stretch_upper", std::move(upper));
  surface.fields.emplace_back("stretch_lower", std::move(lower));
}

std::vector<Point> points_of_kept(const IT::Simplification& s, const Surface_with_fields& fine) {
  std::vector<Point> of_row(s.places.size());
  for (std::size_t v = 0; v < fine.s.vertices.size(); ++v)
    of_row[fine.s.vertices[v].intrinsic] = fine.points[v];
  std::vector<Point> result;
  for (const std::uint32_t row : s.kept) result.push_back(of_row[row]);
  return result;
}

// The coarse triangles, drawn between the places of their vertices on the fine surface.
Surface_with_fields coarse_in_space(const Exact_triangulation& coarse, std::vector<Point> points) {
  Surface_with_fields result{IT::common_subdivision(coarse), {}, {}};
  result.points = IT::positions(result.s, points, coarse.input());
  return result;
}

void write_in_space(const Surface_with_fields& fine, const IT::Simplification& s,
                    const Exact_triangulation& coarse, const Options& options, const Json& json,
                    Output_files& files) {
  Surface_with_fields drawn = coarse_in_space(coarse, points_of_kept(s, fine));
  const Stretch_at_vertices bounds(s);
  add_stretch(drawn, [&](std::size_t v) { return bounds.at_coarse(v); });
  if (is_mesh_output(options))
    files.write(options.output, [&](std::ostream& out, const std::string& extension) {
      write_mesh(out, extension, drawn.s, drawn.points, drawn.fields, options);
    });
  if (options.view.empty()) return;
  Surface_with_fields left = fine;
  add_stretch(left, [&](std::size_t row) { return bounds.at_fine(row); });
  const Surface_with_fields both = side_by_side(std::move(left), drawn);
  IT::Html_view page;
  page.fields = both.fields;
  page.isolines = 0;
  files.write(options.view, [&](std::ostream& out) {
    write_view(out, both.s, both.points, options, json, page);
  });
}

void write_places(std::ostream& out, const IT::Simplification& s) {
  out.precision(17);
  out << "# for each vertex: a face of the coarse surface, and the weights of its corners; or the "
         "number of a vertex\n";
  for (const IT::Place& p : s.places)
    if (p.is_vertex())
      out << p.vertex << '\n';
    else if (p.has_face())
      out << p.face << ' ' << p.weights[0] << ' ' << p.weights[1] << ' ' << p.weights[2] << '\n';
    else
      out << "-1\n";
}

template <class Triangulation>
void write(const Loaded<Triangulation>& loaded, IT::Simplification& s, const Options& options,
           Json& json, Output_files& files) {
  const bool draws = is_mesh_output(options) || !options.view.empty();
  const IT::Intrinsic_input surface = s.surface;
  Exact_triangulation coarse(std::move(s.surface));
  s.surface = surface;
  IT::flip_to_delaunay(coarse);
  if (draws) {
    Drawn_subdivision fine = drawn_subdivision(loaded, options, json);
    write_in_space({std::move(fine.s), std::move(fine.points), {}}, s, coarse, options, json,
                   files);
  }
  if (!options.output.empty() && !is_mesh_output(options))
    files.write(options.output,
                [&](std::ostream& out) { IT::write_intrinsic_triangulation(out, coarse); });
  if (!options.simplify.prolongation.empty())
    write_matrix(options.simplify.prolongation, IT::prolongation(s),
                 "prolongation from the coarse vertices to the fine ones", files);
  if (!options.simplify.vector_prolongation.empty())
    write_matrix(options.simplify.vector_prolongation,
                 IT::vector_prolongation(loaded.triangulation, coarse, s),
                 "prolongation of tangent vectors from the coarse vertices to the fine ones",
                 files);
  if (!options.simplify.places.empty())
    files.write(options.simplify.places, [&](std::ostream& out) { write_places(out, s); });
}

template <class Triangulation>
void simplify(Loaded<Triangulation>& loaded, const Options& options, Progress& progress) {
  const Triangulation& t = loaded.triangulation;
  Json json = improve_and_measure(loaded, options, progress, {});
  IT::Stopwatch watch;
  progress.show("simplifying");
  const IT::Simplify_options asked = asked_options(loaded, options, progress);
  IT::Simplification s =
      naming_file(options.input, [&] { return simplified(t, options.simplify, asked); });
  json["simplify"] = json_of(s, asked.kept_vertices.size());
  json["seconds"]["simplify"] = watch.lap();
  progress.show("writing");
  Output_files files;
  write(loaded, s, options, json, files);
  finish(json, options, files, watch);
}

} // namespace

void run_simplify(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress,
                                       [&](auto& loaded) { simplify(loaded, options, progress); });
}

} // namespace program

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"

#include "../../src/intrinsic/improve.h"
#include "../../src/intrinsic/view.h"

#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace python {

namespace {

using program::Json;
using program::Options;
using Surface_ptr = std::shared_ptr<Surface>;

// Edges of the user's mesh that are kept: pairs of vertices, and those with a sharp angle.
struct Kept {
  std::vector<std::uint32_t> ends;
  std::optional<double> sharp_angle;
};

Kept kept(Surface& s, const std::optional<Integers>& ends, std::optional<double> sharp_angle) {
  Kept k{{}, sharp_angle};
  const std::size_t rows =
      with_triangulation(s, [](auto& t) -> std::size_t { return t.input().number_of_rows(); });
  if (ends) k.ends = numbers_of(*ends, rows, "vertex");
  return k;
}

program::Constraints constraints_of(const IT::Input& input, const Kept& keep) {
  program::Constraints c;
  c.is_stored = true;
  c.is_asked_for = !keep.ends.empty() || keep.sharp_angle;
  if (!c.is_asked_for) return c;
  const program::Surface_with_edges s{input.mesh(), input.metric().points(), input.names()};
  c.is_constrained.assign(input.number_of_edges(), 0);
  if (keep.sharp_angle && s.points.empty())
    refuse("the surface has lengths and no points, so that no edge is sharp; give keep the edges");
  if (keep.sharp_angle) program::mark_sharp_edges(s, *keep.sharp_angle, c.is_constrained);
  if (!keep.ends.empty()) {
    const program::Edge_finder edges(s);
    for (std::size_t i = 0; i < keep.ends.size(); i += 2)
      if (!edges.mark(keep.ends[i], keep.ends[i + 1], c.is_constrained))
        refuse("keep[" + std::to_string(i / 2) + "]: no edge joins vertices " +
               std::to_string(keep.ends[i]) + " and " + std::to_string(keep.ends[i + 1]) +
               "; give a path of edges");
  }
  c.count =
      static_cast<std::size_t>(std::count(c.is_constrained.begin(), c.is_constrained.end(), 1));
  return c;
}

// Improves a triangulation and measures it, as all commands of the program do: measuring checks
// rounding, and sharpens what is stored, so that values that are computed later are those of the
// program to the last bit.
template <class Triangulation>
const Json& improve(Surface& s, program::Loaded<Triangulation>& loaded, const Options& options,
                    Watch& watch) {
  return s.cached<Json>("statistics", [&] {
    return new Json(program::improve_and_measure(loaded, options, watch, {}));
  });
}

// The lock is held.
template <class Triangulation>
const Json& statistics(Surface& s, program::Loaded<Triangulation>& loaded, Watch& watch) {
  Options options;
  options.input = s.name;
  options.no_flip = true;
  return improve(s, loaded, options, watch); // has been done if edges were flipped
}

// \param is_improved whether the copy will be, so that other statistics hold
Surface_ptr copy(Surface& s, bool is_improved) {
  Watch watch;
  return with_loaded(s, watch, [&](auto& loaded) {
    auto result = std::make_shared<Surface>(loaded);
    result->points = s.points;
    result->name = s.name;
    result->is_flipped = s.is_flipped;
    if (const auto known = s.cache.find("statistics"); known != s.cache.end() && !is_improved)
      result->cache.insert(*known);
    return result;
  });
}

Surface_ptr improved_copy(Surface& s, Options options, const Kept& keep, std::vector<double> sizes,
                          const py::object& progress) {
  Watch watch(progress);
  const Surface_ptr result = copy(s, true);
  options.input = s.name;
  with_loaded(*result, watch, [&](auto& loaded) {
    loaded.constraints = constraints_of(loaded.triangulation.input(), keep);
    if (loaded.constraints.count > 0) program::restore_constrained_edges(loaded, options);
    loaded.sizes = std::move(sizes);
    improve(*result, loaded, options, watch);
  });
  result->is_flipped = true;
  return result;
}

Surface_ptr delaunay(Surface& s, const std::optional<Integers>& keep,
                     std::optional<double> sharp_angle, const py::object& progress) {
  return improved_copy(s, {}, kept(s, keep, sharp_angle), {}, progress);
}

IT::Refinement_order order_of(const std::string& name) {
  if (name == "largest-first") return IT::Refinement_order::largest_first;
  if (name == "worst-first") return IT::Refinement_order::worst_first;
  return IT::Refinement_order::first_come;
}

Surface_ptr refine(Surface& s, double min_angle, const std::optional<Doubles>& sizes,
                   std::optional<double> max_edge_length, std::optional<double> max_circumradius,
                   std::optional<std::uint64_t> max_insertions, const std::string& order,
                   bool conforming, const std::optional<Integers>& keep,
                   std::optional<double> sharp_angle, double odt_length,
                   const py::object& progress) {
  Options options;
  options.refines = true;
  IT::Refine_criteria& criteria = options.refinement;
  criteria.minimum_angle = min_angle;
  if (max_edge_length) criteria.maximum_edge_length = *max_edge_length;
  if (max_circumradius) criteria.maximum_circumradius = *max_circumradius;
  criteria.maximum_insertions = max_insertions;
  criteria.order = order_of(order);
  criteria.is_conforming = conforming;
  criteria.odt_length = odt_length;
  std::vector<double> values;
  if (sizes) values.assign(sizes->data(), sizes->data() + sizes->size());
  return improved_copy(s, options, kept(s, keep, sharp_angle), std::move(values), progress);
}

Surface_ptr adapt(Surface& s, std::uint32_t source, double heat_time, double tolerance,
                  std::size_t max_vertices, double min_angle, const std::optional<Integers>& keep,
                  std::optional<double> sharp_angle, const py::object& progress) {
  Options options;
  options.is_adaptive = true;
  options.adaptive = {source, heat_time, tolerance, max_vertices, min_angle};
  options.refinement.minimum_angle = min_angle;
  return improved_copy(s, options, kept(s, keep, sharp_angle), {}, progress);
}

// ---- Measuring ---------------------------------------------------------------------------------

std::string statistics_text(Surface& s) {
  Watch watch;
  return with_loaded(s, watch, [&](auto& loaded) { return statistics(s, loaded, watch).dump(); });
}

std::string report_text(Surface& s) {
  Watch watch;
  return with_loaded(s, watch, [&](auto& loaded) {
    Options options;
    options.input = s.name;
    return program::loaded_json(loaded, options).dump();
  });
}

// A page that shows the triangulation.
std::string page(Surface& s, double megabytes) {
  Watch watch;
  return with_loaded(s, watch, [&](auto& loaded) {
    if (s.points.empty())
      refuse("the surface has lengths and no points, so that nothing can be drawn");
    const auto& input = loaded.triangulation.input();
    IT::Common_subdivision d = IT::common_subdivision(loaded.triangulation);
    IT::label_with_polygons(d, input.names().polygon_of_triangle);
    Options options;
    options.input = s.name;
    options.view = "the page";
    options.view_limit = megabytes;
    std::ostringstream out;
    const IT::Html_view_report report = program::write_page(
        out, d, IT::positions(d, s.points, input), options, statistics(s, loaded, watch), {});
    if (!report.is_complete())
      watch.warn(report.description() + "; megabytes allows a larger page");
    return out.str();
  });
}

} // namespace

void bind_improve(py::module_& m) {
  m.def("copy", [](Surface& s) { return copy(s, false); });
  m.def("delaunay", &delaunay);
  m.def("refine", &refine);
  m.def("adapt", &adapt);
  m.def("statistics", &statistics_text);
  m.def("report", &report_text);
  m.def("page", &page);
}

} // namespace python

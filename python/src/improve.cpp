// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface.h"
#include "kept_edges.h"

#include <CGAL/Intrinsic_operators/improvement/describe_delaunay.h>
#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_operators/improvement/reports.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/has_accurate_values.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace python {

namespace {

using Surface_ptr = std::shared_ptr<Surface>;

// ---- Reports as dictionaries -------------------------------------------------------------------

// Numbers that are not finite are `None`, as in JSON.
py::object object_of(const IT::Report& report) {
  return std::visit(
      []<class Value>(const Value& x) -> py::object {
        if constexpr (std::is_same_v<Value, std::monostate>) {
          return py::none();
        } else if constexpr (std::is_same_v<Value, IT::Report::Figures>) {
          py::dict dict;
          for (const IT::Report::Figure& f : x) dict[f.name.c_str()] = object_of(f.value);
          return dict;
        } else if constexpr (std::is_same_v<Value, IT::Report::List>) {
          py::list list;
          for (const IT::Report& r : x) list.append(object_of(r));
          return list;
        } else if constexpr (std::is_same_v<Value, std::string>) { // which need not be UTF-8
          return py::reinterpret_steal<py::object>(PyUnicode_DecodeUTF8(
              x.data(), static_cast<py::ssize_t>(x.size()), "backslashreplace"));
        } else if constexpr (std::is_same_v<Value, double>) {
          return std::isfinite(x) ? py::object(py::float_(x)) : py::object(py::none());
        } else {
          return py::cast(x);
        }
      },
      report.value());
}

template <class T>
IT::Report report_of(const Surface& s, const T& t) {
  IT::Report report = {{"version", INTRINSIC_TRIANGULATIONS_VERSION}};
  const IT::Report known = IT::surface_report(s.name, t, s.facts);
  for (const IT::Report::Figure& f : known.get<IT::Report::Figures>()) report[f.name] = f.value;
  return report;
}

// ---- Improving ---------------------------------------------------------------------------------

// What was done to a triangulation. What it is since then, statistics find when they are asked for,
// unless measuring changes stored values.
struct Improved {
  IT::Improve_options options;
  std::vector<char> marks; // nonzero for each edge of the input that is kept; empty: none is
  IT::Improved_surface surface;
};

const std::vector<Point>& points_in_space(const Surface& s) {
  static const std::vector<Point> none;
  return s.is_in_space ? s.points : none;
}

// Calls a function; what rounding has spoilt gets the name of the surface.
template <class Function>
auto naming_spoilt(const Surface& s, const Function& function) {
  try {
    return naming(s.name, function);
  } catch (const IT::Rounding_error& e) {
    throw std::runtime_error(s.name + ": " + e.what());
  }
}

template <class T>
const Improved& improve(Surface& s, T& t, const IT::Improve_options& options,
                        const std::vector<char>& marks, Watch& watch) {
  return s.cached<Improved>("improvement", [&] {
    IT::Improve_options watched = options;
    watched.progress = [&watch](IT::Improve_step step, std::uint64_t count) {
      static constexpr std::array stages{"flipping to Delaunay", "refining", "moving vertices",
                                         "refining adaptively"};
      return watch(stages[static_cast<std::size_t>(step)], count);
    };
    auto result = std::make_unique<Improved>(Improved{options, marks, {}});
    naming_spoilt(s, [&] {
      result->surface =
          IT::improve_soundly(t, points_in_space(s), watched, IT::labelled_input_edges(t, marks));
      IT::expect_area_kept(t, false, result->surface);
    });
    if (const std::string what = result->surface.shortcoming(); !what.empty())
      watch.warn(s.name + ": " + what);
    return result;
  });
}

// What the program reports of a triangulation, which was improved or is as it was read. The lock is
// held.
template <class T>
const IT::Report& statistics(Surface& s, T& t, Watch& watch) {
  return s.cached<IT::Report>("statistics", [&] {
    IT::Improve_options as_it_is;
    as_it_is.flips = false;
    const Improved& done = improve(s, t, as_it_is, {}, watch);
    watch.begin("verifying");
    IT::Improved_surface found = done.surface;
    naming_spoilt(s, [&] {
      IT::measure_improved(t, points_in_space(s), IT::labelled_input_edges(t, done.marks), false,
                           found);
    });
    std::optional<std::size_t> count;
    if (!done.marks.empty())
      count = static_cast<std::size_t>(std::count(done.marks.begin(), done.marks.end(), char{1}));
    auto report = std::make_unique<IT::Report>(report_of(s, t));
    IT::report_improvement(*report, found, done.options, count);
    return report;
  });
}

// \param is_improved whether the copy will be, so that other statistics hold
Surface_ptr copy(Surface& s, bool is_improved) {
  Watch watch;
  return with_triangulation(s, watch, [&]<class T>(const T& t) {
    auto result = std::make_shared<Surface>(IT::Built_surface<T>{t, s.points, s.facts}, s.name);
    result->is_in_space = s.is_in_space;
    result->is_flipped = s.is_flipped;
    if (is_improved) return result;
    for (const char* const key : {"improvement", "statistics"})
      if (const auto known = s.cache.find(key); known != s.cache.end())
        result->cache.insert(*known);
    return result;
  });
}

Surface_ptr improved_copy(Surface& s, const IT::Improve_options& options, const Kept& keep,
                          Watch& watch) {
  const Surface_ptr result = copy(s, true);
  with_triangulation(*result, watch, [&](auto& t) {
    const std::vector<char> marks = marks_of(t.input(), keep);
    if (const std::string missing = IT::restore_kept_edges(t, marks); !missing.empty())
      throw std::runtime_error(s.name + ": " + missing);
    improve(*result, t, options, marks, watch);
    // else now, as the program does before it computes anything: values are the same, bit for bit
    if (!IT::has_accurate_values(t)) statistics(*result, t, watch);
  });
  result->is_flipped = true;
  return result;
}

Surface_ptr delaunay(Surface& s, const std::optional<Integers>& keep,
                     std::optional<double> sharp_angle, Watch& watch) {
  return improved_copy(s, {}, kept(s, keep, sharp_angle), watch);
}

Surface_ptr refine(Surface& s, double min_angle, const std::optional<Doubles>& sizes,
                   std::optional<double> max_edge_length, std::optional<double> max_circumradius,
                   std::optional<std::uint64_t> max_insertions, const std::string& order,
                   bool conforming, const std::optional<Integers>& keep,
                   std::optional<double> sharp_angle, double odt_length, Watch& watch) {
  IT::Improve_options options;
  IT::Refine_criteria& criteria = options.refine.emplace();
  criteria.minimum_angle = min_angle;
  if (max_edge_length) criteria.maximum_edge_length = *max_edge_length;
  if (max_circumradius) criteria.maximum_circumradius = *max_circumradius;
  criteria.maximum_insertions = max_insertions;
  criteria.order = IT::refinement_order(order);
  criteria.is_conforming = conforming;
  criteria.odt_length = odt_length;
  if (sizes) criteria.lengths.assign(sizes->data(), sizes->data() + sizes->size());
  return improved_copy(s, options, kept(s, keep, sharp_angle), watch);
}

Surface_ptr adapt(Surface& s, std::uint32_t source, double heat_time, double tolerance,
                  std::size_t max_vertices, double min_angle, const std::optional<Integers>& keep,
                  std::optional<double> sharp_angle, Watch& watch) {
  IT::Improve_options options;
  options.adapt = {source, heat_time, tolerance, max_vertices, min_angle};
  return improved_copy(s, options, kept(s, keep, sharp_angle), watch);
}

// ---- Measuring ---------------------------------------------------------------------------------

py::object statistics_of(Surface& s) {
  Watch watch;
  return object_of(with_triangulation(s, watch, [&](auto& t) { return statistics(s, t, watch); }));
}

py::object report_of_input(Surface& s) {
  return object_of(with_triangulation(s, [&](auto& t) { return report_of(s, t); }));
}

// The title of pages, and what they say of the surface.
py::tuple description(Surface& s) {
  Watch watch;
  // as Python has it, which is UTF-8 whatever bytes the file's name has
  const py::object title = object_of(IT::Report(std::filesystem::path(s.name).filename().string()));
  return py::make_tuple(title, with_triangulation(s, watch, [&](auto& t) {
                          const IT::Element_counts& n = s.facts.counts;
                          return std::to_string(n.vertices) + " vertices, " +
                                 std::to_string(n.faces) + " faces; " +
                                 IT::describe_delaunay(statistics(s, t, watch));
                        }));
}

} // namespace

void bind_improve(py::module_& m) {
  m.def("copy", [](Surface& s) { return copy(s, false); });
  m.def("delaunay", &delaunay);
  m.def("refine", &refine);
  m.def("adapt", &adapt);
  m.attr("defaults") = object_of(IT::report_of_defaults());
  m.attr("ranges") = object_of(IT::report_of_ranges());
  m.def("statistics", &statistics_of);
  m.def("report", &report_of_input);
  m.def("description", &description);
}

} // namespace python

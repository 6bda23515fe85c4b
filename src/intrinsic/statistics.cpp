// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "statistics.h"
#include "support/messages.h"

#include <CGAL/Gmpq.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <iterator>
#include <numbers>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include <sys/resource.h>

namespace program {

namespace {

// twice the area of a triangle; `scale` is set to the sum of all products, without signs
template <class FT>
double cross_product(const Point& p, const Point& q, const Point& r, double& scale) {
  std::array<FT, 3> u{}, v{};
  for (unsigned k = 0; k < 3; ++k) {
    u[k] = FT(q[k]) - FT(p[k]);
    v[k] = FT(r[k]) - FT(p[k]);
  }
  std::array<double, 3> normal{};
  scale = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const FT x = u[(k + 1) % 3] * v[(k + 2) % 3], y = u[(k + 2) % 3] * v[(k + 1) % 3];
    normal[k] = CGAL::to_double(FT(x - y));
    scale += std::abs(CGAL::to_double(x)) + std::abs(CGAL::to_double(y));
  }
  return std::hypot(normal[0], normal[1], normal[2]);
}

} // namespace

double area(const Point& p, const Point& q, const Point& r) {
  double scale = 0;
  const double twice = cross_product<double>(p, q, r, scale);
  // rounding is below 2^-49 of the products: where they cancel, as on needles, rationals are right
  if (twice > 0x1p-7 * scale) return twice / 2;
  return cross_product<CGAL::Gmpq>(p, q, r, scale) / 2;
}

namespace {

const char* name(IT::Mollification kind) {
  switch (kind) {
  case IT::Mollification::lengths:
    return "lengths";
  case IT::Mollification::squared_lengths:
    return "squared";
  default:
    return "none";
  }
}

} // namespace

Json input_json(const Options& options, const std::string& arithmetic,
                const std::string& correspondence, const Input_facts& facts,
                const IT::Input_report& report) {
  Json json;
  json["version"] = INTRINSIC_TRIANGULATIONS_VERSION;
  Json& input = json["input"];
  input["file"] = as_utf8(options.input);
  input["vertices"] = facts.vertices;
  input["edges"] = facts.edges;
  input["faces"] = facts.faces;
  input["boundary_edges"] = facts.boundary_edges;
  input["boundary_loops"] = facts.boundary_loops;
  input["components"] = facts.components;
  input["genus"] = facts.genus ? Json(*facts.genus) : Json(nullptr);
  input["degenerate_faces"] = report.degenerate_faces;
  input["isolated_vertices"] = facts.isolated_vertices;
  input["nonmanifold_vertices"] = facts.nonmanifold_vertices;
  if (facts.polygons > 0) input["polygons"] = facts.polygons;
  input["triangulated_polygons"] = facts.triangulated_polygons;
  input["faces_with_repeated_vertices"] = facts.faces_with_repeated_vertices;
  input["renumbered"] = report.renumbered;
  input["reversed_faces"] = report.reversed_faces;
  json["arithmetic"] = arithmetic;
  json["correspondence"] = correspondence;
  json["mollification"] = {{"kind", name(report.mollification.kind)},
                           {"delta", report.mollification.delta}};
  return json;
}

namespace {

const char* name(IT::Domain_kind kind) {
  switch (kind) {
  case IT::Domain_kind::tufted_cover:
    return "tufted";
  case IT::Domain_kind::orientation_cover:
    return "orientation-cover";
  default:
    return "manifold";
  }
}

} // namespace

Json domain_json(const IT::Domain_report& report,
                 const std::optional<IT::Point_cloud_report>& cloud, std::size_t vertices) {
  const bool is_sheet = report.kind != IT::Domain_kind::manifold && report.sheets == 1;
  Json json = {{"kind", cloud      ? "points"
                        : is_sheet ? "sheet"
                                   : name(report.kind)},
               {"reason", report.reason},
               {"sheets", report.sheets},
               {"vertices", vertices},
               {"nonmanifold_edges", report.nonmanifold_edges},
               {"unoriented_edges", report.unoriented_edges}};
  if (!cloud) return json;
  json["neighbors"] = cloud->neighbours;
  json["triangles"] = cloud->triangles;
  json["duplicated_points"] = cloud->duplicated_points;
  json["points_without_triangles"] = cloud->points_without_triangles;
  json["border_points"] = std::count(cloud->is_on_border.begin(), cloud->is_on_border.end(), 1);
  return json;
}

Json polygons_json(const IT::Polygon_report& report) {
  return {{"planar", report.planar},
          {"flattened", report.flattened},
          {"kept", report.kept},
          {"max_angle_change_deg", report.largest_angle_change * 180 / std::numbers::pi}};
}

Json metric_json(const Metric_report& report) {
  return {{"violating_faces", report.violating_faces},
          {"changed_edges", report.changed_edges},
          {"largest_relative_change", report.largest_relative_change}};
}

Json constraints_json(const Constraints& constraints, const Delaunay_check& check) {
  return {{"input_edges", constraints.count},
          {"edges", check.constrained_edges},
          {"non_delaunay_edges", check.constrained_non_delaunay_edges}};
}

Json delaunay_json(const IT::Flip_to_delaunay_result& flips,
                   const IT::Predicate_statistics& statistics, const Delaunay_check& check) {
  Json json;
  json["checks"] = flips.checks;
  json["flips"] = flips.flips;
  json["refused_flips"] = flips.refused_flips;
  json["filter_failures"] = statistics.filter_failures;
  json["integer"] = statistics.integer;
  json["escalations"] = Json::object();
  for (const auto& [bits, count] : statistics.escalations)
    json["escalations"][std::to_string(bits)] = count;
  json["sharpenings"] = Json::object();
  for (const auto& [bits, count] : statistics.sharpenings)
    json["sharpenings"][std::to_string(bits)] = count;
  json["rungs"] = Json::object();
  for (std::size_t r = 0; r < IT::number_of_rungs; ++r)
    if (const IT::Rung_statistics& rung = statistics.rungs[r]; rung.asked > 0)
      json["rungs"][IT::name_of(static_cast<IT::Rung>(r))] = {{"asked", rung.asked},
                                                              {"decided", rung.decided},
                                                              {"zeros", rung.zeros},
                                                              {"seconds", rung.seconds}};
  json["certified_zero"] = statistics.certified_zero;
  json["probable_zero"] = statistics.probable_zero + check.probable_zero;
  json["non_delaunay_edges"] = check.non_delaunay_edges;
  json["cocircular_edges"] = check.cocircular_edges;
  return json;
}

std::string certificate(bool is_exact, std::uint64_t probable_zero, const Delaunay_check& check) {
  if (!is_exact || check.non_delaunay_edges > 0) return "none";
  return probable_zero + check.probable_zero > 0 ? "interval" : "exact";
}

Json quality_json(const IT::Quality& quality) {
  return {{"min_angle_deg", quality.minimum_angle},
          {"max_angle_deg", quality.maximum_angle},
          {"angle_histogram", quality.angles},
          {"mean_aspect_ratio", quality.mean_aspect_ratio},
          {"max_aspect_ratio", quality.maximum_aspect_ratio},
          {"min_cotan_weight", quality.minimum_weight},
          {"max_cotan_weight", quality.maximum_weight},
          {"cotan_weight_histogram", quality.weights}};
}

void add_integrals(Json& json, const Integrals& integrals, double input_area, bool has_points) {
  json["laplacian"]["trace"] = integrals.trace;
  if (has_points)
    json["dirichlet"] = {{"x", integrals.dirichlet[0]},
                         {"y", integrals.dirichlet[1]},
                         {"z", integrals.dirichlet[2]}};
  json["area"] = {{"input", input_area}, {"intrinsic", integrals.area}};
}

double peak_rss_mib() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

namespace {

// Calls a function with the lists of records, and the long lists of numbers, and their names.
template <class Any_json, class Function>
void for_each_list(Any_json& json, const std::string& name, const Function& function) {
  for (auto& [key, value] : json.items()) {
    const std::string full = name.empty() ? key : name + "." + key;
    if (value.is_object()) for_each_list(value, full, function);
    if (value.is_array() && !value.empty() &&
        (value.front().is_object() || value.size() > most_records))
      function(full, value);
  }
}

// Writes each record as a line, with its list and its number there.
void write_records(std::ostream& out, const std::string& list, const Json& records) {
  for (std::size_t i = 0; i < records.size(); ++i) {
    Json line = {{"list", list}, {"number", i}};
    if (records[i].is_object())
      line.update(records[i]);
    else
      line["value"] = records[i];
    out << line.dump() << '\n';
  }
}

// Writes all records to a file if options name one. Returns the statistics with the first records
// of long lists, and how many there are.
Json with_short_lists(const Json& json, const Options& options, Output_files& files) {
  Json result = json;
  Json sizes = Json::object();
  for_each_list(result, "", [&](const std::string& name, Json& records) {
    if (records.size() <= most_records) return;
    sizes[name] = records.size();
    records.erase(std::next(records.begin(), most_records), records.end());
  });
  if (!sizes.empty()) result["records"] = std::move(sizes);
  if (options.records.empty()) return result;
  files.write(options.records, [&](std::ostream& out) {
    for_each_list(json, "", [&](const std::string& name, const Json& records) {
      write_records(out, name, records);
    });
  });
  return result;
}

} // namespace

void finish(Json& json, const Options& options, Output_files& files, Stopwatch& watch) {
  json["seconds"]["write"] = watch.lap();
  json["peak_rss_mib"] = peak_rss_mib();
  const bool to_standard_output = options.stats == "-";
  const Json shown = with_short_lists(json, options, files);
  if (!options.stats.empty() && !to_standard_output)
    files.open(options.stats) << shown.dump(2) << '\n';
  files.commit();
  if (to_standard_output && !(std::cout << shown.dump(2) << std::endl))
    throw std::runtime_error("standard output cannot be written; is the disk full?");
}

} // namespace program

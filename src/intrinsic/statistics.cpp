// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "statistics.h"
#include "support/messages.h"

#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
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

namespace {

Json delaunay_json(const IT::Improvement& done, const IT::Tested_edges& tested) {
  const IT::Flip_to_delaunay_result& flips = done.flips;
  const IT::Predicate_statistics& statistics = done.statistics;
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
  json["probable_zero"] = statistics.probable_zero + tested.probable_zero;
  json["non_delaunay_edges"] = tested.non_delaunay;
  json["cocircular_edges"] = tested.cocircular;
  return json;
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

Json refine_json(const IT::Refined_faces& r, const Options& options) {
  const IT::Refinement_counts& counts = r.counts;
  Json json = {{"status", IT::name_of(r.status)},
               {"asked_angle_deg", options.refinement.minimum_angle},
               // negative if more vertices of an earlier refinement, or of curves, were removed
               {"insertions", static_cast<std::int64_t>(counts.inserted_vertices())},
               {"points", r.points},
               {"circumcenters", counts.circumcenters},
               {"segment_splits", counts.segment_splits},
               {"removals", counts.removals},
               {"flips", counts.flips},
               {"refused", counts.refused},
               {"without_copies", counts.without_copies},
               {"min_angle_deg", r.minimum_angle},
               {"satisfied_min_angle_deg", r.satisfied_minimum_angle},
               {"unsatisfied_faces", r.unsatisfied_faces()},
               {"unsatisfied",
                {{"needle", r.unsatisfied[0]},
                 {"small_angle", r.unsatisfied[1]},
                 {"refused", r.unsatisfied[2]},
                 {"stopped", r.unsatisfied[3]}}}};
  if (r.longest_side) json["max_relative_edge_length"] = *r.longest_side;
  return json;
}

Json odt_json(const IT::Odt_result& result, const Options& options) {
  return {{"status", result.status == IT::Status::done ? "converged" : "cap"},
          {"target_length", options.refinement.odt_length},
          {"iterations", result.iterations},
          {"splits", result.splits},
          {"moves", result.moves},
          {"refused", result.refused},
          {"energy_before", result.energy_before},
          {"energy_after", result.energy_after},
          {"insertions", result.insertions},
          {"min_angle_deg", result.minimum_angle},
          {"unsatisfied_faces", result.unsatisfied_faces}};
}

Json adaptive_json(const IT::Adapted_faces& adapted, const IT::Adapt_criteria& criteria) {
  Json rounds = Json::array();
  for (const IT::Adaptive_refinement_round& r : adapted.result.rounds)
    rounds.push_back({{"vertices", r.vertices},
                      {"estimated_error", r.estimated_error / adapted.unit},
                      {"marked_faces", r.marked_faces}});
  Json json = {{"status", IT::name_of(adapted.result.status)},
               {"source", criteria.source},
               {"tolerance", criteria.tolerance},
               {"rounds", rounds}};
  if (criteria.heat_time > 0) json["heat_time"] = criteria.heat_time;
  return json;
}

} // namespace

void add_improvement(Json& json, const IT::Improvement& done, const Options& options) {
  json["seconds"]["delaunay"] = done.seconds_of_flips;
  if (const auto& r = done.refined) {
    json["quality_before"] = quality_json(r->quality_before);
    json["seconds"]["refine"] = r->seconds;
    json["refine"] = refine_json(*r, options);
    if (r->odt) {
      json["seconds"]["odt"] = r->seconds_of_odt;
      json["odt"] = odt_json(*r->odt, options);
    }
  }
  if (!done.adapted) return;
  json["adaptive"] = adaptive_json(*done.adapted, options.adaptive);
  json["seconds"]["refine"] = done.adapted->seconds;
}

void add_measurements(Json& json, const IT::Measurements& measured, const IT::Improvement& done,
                      const Constraints& constraints, double input_area, bool is_exact) {
  const IT::Tested_edges& tested = measured.edges;
  if (constraints.is_asked_for)
    json["constraints"] = {{"input_edges", constraints.count},
                           {"edges", tested.constrained},
                           {"non_delaunay_edges", tested.constrained_non_delaunay}};
  json["delaunay"] = delaunay_json(done, tested);
  const bool is_probable = done.statistics.probable_zero + tested.probable_zero > 0;
  json["certificate"] = !is_exact || tested.non_delaunay > 0 ? "none"
                        : is_probable                        ? "interval"
                                                             : "exact";
  json["quality"] = quality_json(measured.quality);
  json["laplacian"]["trace"] = measured.laplacian_trace;
  if (const auto& d = measured.dirichlet)
    json["dirichlet"] = {{"x", (*d)[0]}, {"y", (*d)[1]}, {"z", (*d)[2]}};
  json["area"] = {{"input", input_area}, {"intrinsic", measured.area}};
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

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/improvement/Improve_options.h>
#include <CGAL/Intrinsic_operators/improvement/Improvement.h>
#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_operators/improvement/reports.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

const char* name_of(Mollification kind) {
  return kind == Mollification::lengths           ? "lengths"
         : kind == Mollification::squared_lengths ? "squared"
                                                  : "none";
}

static const char* name_of(Domain_kind kind) {
  return kind == Domain_kind::tufted_cover        ? "tufted"
         : kind == Domain_kind::orientation_cover ? "orientation-cover"
                                                  : "manifold";
}

Report report_of_input(const std::string& name, const Surface_facts& facts,
                       const Input_report& report) {
  const Element_counts& n = facts.counts;
  Report input = {{"file", name},
                  {"vertices", n.vertices},
                  {"edges", n.edges},
                  {"faces", n.faces},
                  {"boundary_edges", n.boundary_edges},
                  {"boundary_loops", n.boundary_loops},
                  {"components", n.components},
                  {"genus", n.genus},
                  {"degenerate_faces", report.degenerate_faces},
                  {"isolated_vertices", n.isolated_vertices},
                  {"nonmanifold_vertices", n.nonmanifold_vertices}};
  if (facts.polygons > 0) input["polygons"] = facts.polygons;
  input["triangulated_polygons"] = facts.triangulated_polygons;
  input["faces_with_repeated_vertices"] = facts.faces_with_repeated_vertices;
  input["renumbered"] = report.renumbered;
  input["reversed_faces"] = report.reversed_faces;
  return input;
}

Report report_of_domain(const Surface_facts& facts, std::size_t vertices) {
  const Domain_report& d = facts.domain;
  const bool is_sheet = d.kind != Domain_kind::manifold && d.sheets == 1;
  Report report = {{"kind", facts.cloud ? "points"
                            : is_sheet  ? "sheet"
                                        : name_of(d.kind)},
                   {"reason", d.reason},
                   {"sheets", d.sheets},
                   {"vertices", vertices},
                   {"nonmanifold_edges", d.nonmanifold_edges},
                   {"unoriented_edges", d.unoriented_edges}};
  if (!facts.cloud) return report;
  const Point_cloud_report& cloud = *facts.cloud;
  report["neighbors"] = cloud.neighbours;
  report["triangles"] = cloud.triangles;
  report["duplicated_points"] = cloud.duplicated_points;
  report["points_without_triangles"] = cloud.points_without_triangles;
  report["border_points"] =
      std::count(cloud.is_on_border.begin(), cloud.is_on_border.end(), char{1});
  return report;
}

static Report report_of_predicates(const Improvement& done, const Tested_edges& tested) {
  const Predicate_statistics& s = done.statistics;
  Report report = {{"checks", done.flips.checks},
                   {"flips", done.flips.flips},
                   {"refused_flips", done.flips.refused_flips},
                   {"filter_failures", s.filter_failures},
                   {"integer", s.integer}};
  for (const auto& [name, counts] :
       {std::pair("escalations", &s.escalations), std::pair("sharpenings", &s.sharpenings)}) {
    report[name] = Report::Figures();
    for (const auto& [bits, count] : *counts) report[name][std::to_string(bits)] = count;
  }
  report["rungs"] = Report::Figures();
  for (std::size_t r = 0; r < number_of_rungs; ++r)
    if (const Rung_statistics& rung = s.rungs[r]; rung.asked > 0)
      report["rungs"][Intrinsic_triangulations::name_of(static_cast<Rung>(r))] = {
          {"asked", rung.asked},
          {"decided", rung.decided},
          {"zeros", rung.zeros},
          {"seconds", rung.seconds}};
  report["certified_zero"] = s.certified_zero;
  report["probable_zero"] = s.probable_zero + tested.probable_zero;
  report["non_delaunay_edges"] = tested.non_delaunay;
  report["cocircular_edges"] = tested.cocircular;
  return report;
}

static Report report_of_quality(const Quality& quality) {
  return {{"min_angle_deg", quality.minimum_angle},
          {"max_angle_deg", quality.maximum_angle},
          {"angle_histogram", quality.angles},
          {"mean_aspect_ratio", quality.mean_aspect_ratio},
          {"max_aspect_ratio", quality.maximum_aspect_ratio},
          {"min_cotan_weight", quality.minimum_weight},
          {"max_cotan_weight", quality.maximum_weight},
          {"cotan_weight_histogram", quality.weights}};
}

static Report report_of_refinement(const Refined_faces& r, const Refine_criteria& asked) {
  const Refinement_counts& counts = r.counts;
  Report report = {{"status", Intrinsic_triangulations::name_of(r.status)},
                   {"asked_angle_deg", asked.minimum_angle},
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
  if (r.longest_side) report["max_relative_edge_length"] = *r.longest_side;
  return report;
}

static Report report_of_odt(const Odt_result& result, const Refine_criteria& asked) {
  return {{"status", result.status == Status::done ? "converged" : "cap"},
          {"target_length", asked.odt_length},
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

static Report report_of_adaptation(const Adapted_faces& adapted, const Adapt_criteria& asked) {
  Report::List rounds;
  for (const Adaptive_refinement_round& r : adapted.result.rounds)
    rounds.push_back({{"vertices", r.vertices},
                      {"estimated_error", r.estimated_error / adapted.unit},
                      {"marked_faces", r.marked_faces}});
  Report report = {{"status", Intrinsic_triangulations::name_of(adapted.result.status)},
                   {"source", asked.source},
                   {"tolerance", asked.tolerance},
                   {"rounds", std::move(rounds)}};
  if (asked.heat_time > 0) report["heat_time"] = asked.heat_time;
  return report;
}

} // namespace internal

Report polygon_report(const Polygon_report& report) {
  return {{"planar", report.planar},
          {"flattened", report.flattened},
          {"kept", report.kept},
          {"max_angle_change_deg", report.largest_angle_change * 180 / std::numbers::pi}};
}

void report_improvement(Report& report, const Improved_surface& improved,
                        const Improve_options& options,
                        std::optional<std::size_t> kept_input_edges) {
  const Improvement& done = improved.done;
  const Measurements& measured = improved.measured;
  const Tested_edges& tested = measured.edges;
  Report& seconds = report["seconds"];
  seconds["delaunay"] = done.seconds_of_flips;
  if (const auto& r = done.refined) seconds["refine"] = r->seconds;
  if (done.refined && done.refined->odt) seconds["odt"] = done.refined->seconds_of_odt;
  if (done.adapted) seconds["refine"] = done.adapted->seconds;
  seconds["verify"] = improved.seconds_of_measuring;
  if (const auto& r = done.refined) {
    report["quality_before"] = internal::report_of_quality(r->quality_before);
    report["refine"] = internal::report_of_refinement(*r, *options.refine);
    if (r->odt) report["odt"] = internal::report_of_odt(*r->odt, *options.refine);
  }
  if (done.adapted)
    report["adaptive"] = internal::report_of_adaptation(*done.adapted, *options.adapt);
  if (kept_input_edges)
    report["constraints"] = {{"input_edges", *kept_input_edges},
                             {"edges", tested.constrained},
                             {"non_delaunay_edges", tested.constrained_non_delaunay}};
  report["delaunay"] = internal::report_of_predicates(done, tested);
  report["certificate"] = improved.certificate();
  report["quality"] = internal::report_of_quality(measured.quality);
  report["laplacian"]["trace"] = measured.laplacian_trace;
  if (const auto& d = measured.dirichlet)
    report["dirichlet"] = {{"x", (*d)[0]}, {"y", (*d)[1]}, {"z", (*d)[2]}};
  report["area"] = {{"input", improved.input_area}, {"intrinsic", measured.area}};
}

} // namespace CGAL::Intrinsic_triangulations

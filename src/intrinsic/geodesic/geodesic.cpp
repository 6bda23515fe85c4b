// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geodesic.h"
#include "../commands.h"

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <string>
#include <string_view>

namespace program {

bool Curve_progress::operator()(IT::Curve_stage stage, std::uint64_t count) {
  using IT::Curve_stage;
  const bool is_path = stage == Curve_stage::paths || stage == Curve_stage::paths_on_faces;
  const bool is_shortening = stage == Curve_stage::shortening;
  const char* const timed = is_path ? "paths" : is_shortening ? "shorten" : "certify";
  if (std::string_view(timed) != timed_) end();
  timed_ = timed;
  const char* const unit = stage == Curve_stage::paths_on_faces ? " windows" : " flips";
  return progress_.show(is_path         ? "finding paths"
                        : is_shortening ? "shortening"
                                        : "verifying",
                        count == 0 ? std::string() : std::to_string(count) + unit);
}

void Curve_progress::end() { json_["seconds"][timed_] = watch_.lap(); }

static const char* word_for(IT::Status status) {
  return status == IT::Status::done      ? "geodesic"
         : status == IT::Status::stalled ? "cap"
                                         : IT::name_of(status);
}

static Json curve_json(const IT::Found_curve& curve) {
  Json json = {{"status", word_for(curve.way.status)},
               {"length", curve.way.length},
               {"initial_length", curve.initial_length},
               {"is_loop", curve.is_loop}};
  if (const CGAL::Interval_nt<>& bounds = curve.way.length_enclosure; CGAL::is_finite(bounds))
    json["length_bounds"] = {bounds.inf(), bounds.sup()};
  if (curve.contracted_to != IT::Gluing::none) json["vertex"] = curve.contracted_to;
  return json;
}

Json curves_json(const IT::Found_curves& found) {
  Json curves = Json::array();
  for (const IT::Found_curve& c : found.curves) curves.push_back(curve_json(c));
  const IT::Shortening_result& s = found.shortening;
  Json json = {{"status", word_for(found.status)},
               {"length", found.length},
               {"initial_length", found.initial_length},
               {"joints", found.joints},
               {"flips", s.flips},
               {"shortenings", s.shortenings},
               {"wedge_checks", s.wedge_checks},
               {"exact_ties", s.exact_ties},
               {"refused_flips", s.refused_flips},
               {"certified", found.is_certified},
               {"curves", curves}};
  if (!found.obstacle.empty()) json["obstacle"] = found.obstacle;
  return json;
}

void run_geodesic(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress,
                                       [&](auto& loaded) { geodesic(loaded, options, progress); });
}

} // namespace program

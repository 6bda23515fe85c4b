// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "adaptive.h"

#include <CGAL/Intrinsic_triangulations/connectivity/status_name.h>

namespace program {

Json adaptive_json(const IT::Adaptive_refinement_result& result, const Adaptive_criteria& criteria,
                   double unit) {
  Json rounds = Json::array();
  for (const IT::Adaptive_refinement_round& r : result.rounds)
    rounds.push_back({{"vertices", r.vertices},
                      {"estimated_error", r.estimated_error / unit},
                      {"marked_faces", r.marked_faces}});
  Json json = {{"status", IT::name_of(result.status)},
               {"source", criteria.source},
               {"tolerance", criteria.tolerance},
               {"rounds", rounds}};
  if (criteria.heat_time > 0) json["heat_time"] = criteria.heat_time;
  return json;
}

} // namespace program

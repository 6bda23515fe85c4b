// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "statistics.h"

#include <iostream>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include <unistd.h>

namespace program {

namespace {

// Begins a line of the summary.
std::ostream& row(std::ostream& out, const std::string& title) {
  return out << title << std::string(title.size() < 16 ? 16 - title.size() : 1, ' ');
}

void print_input(std::ostream& out, const Json& json) {
  const Json& input = json["input"];
  row(out, "file") << input["file"].get<std::string>() << '\n';
  row(out, "elements") << input["vertices"] << " vertices, " << input["edges"] << " edges, "
                       << input["faces"] << " faces\n";
  row(out, "topology") << "components " << input["components"] << ", genus ";
  (input["genus"].is_null() ? out << "none: not orientable" : out << input["genus"])
      << ", boundary loops " << input["boundary_loops"] << " (" << input["boundary_edges"]
      << " edges)\n";
}

// What was found out about the faces, and what was done about it.
void print_repairs(std::ostream& out, const Json& json) {
  const Json& input = json["input"];
  if (json.contains("domain") && json["domain"]["kind"] != "manifold")
    row(out, "surface") << json["domain"]["kind"].get<std::string>() << ", of "
                        << json["domain"]["vertices"]
                        << " vertices: " << json["domain"]["reason"].get<std::string>() << '\n';
  if (json.contains("domain"))
    for (const auto& [key, what] :
         {std::pair("duplicated_points", "points are at the place of another"),
          std::pair("points_without_triangles", "points have no triangles of their own"),
          std::pair("border_points", "points are on the border")})
      if (const Json& domain = json["domain"]; domain.value(key, 0) != 0)
        row(out, "") << domain[key] << ' ' << what << '\n';
  if (json.contains("polygons"))
    row(out, "polygons") << json["polygons"]["planar"] << " planar, "
                         << json["polygons"]["flattened"] << " made planar, "
                         << json["polygons"]["kept"] << " kept\n";
  for (const auto& [key, what] : {std::pair("triangulated_polygons", "polygons were triangulated"),
                                  std::pair("faces_with_repeated_vertices",
                                            "faces listed a vertex twice: lines were left out"),
                                  std::pair("reversed_faces", "faces were turned around"),
                                  std::pair("degenerate_faces", "faces have no area"),
                                  std::pair("isolated_vertices", "vertices have no face"),
                                  std::pair("nonmanifold_vertices", "vertices are not manifold")})
    if (input[key] != 0) row(out, "") << input[key] << ' ' << what << '\n';
}

void print_delaunay(std::ostream& out, const Json& json) {
  if (json["mollification"]["kind"] != "none")
    row(out, "mollification") << json["mollification"]["kind"].get<std::string>() << ", delta "
                              << json["mollification"]["delta"] << '\n';
  const Json& delaunay = json["delaunay"];
  row(out, "Delaunay") << delaunay["non_delaunay_edges"] << " edges are not, "
                       << delaunay["cocircular_edges"] << " are ties; " << delaunay["flips"]
                       << " flips; " << json["arithmetic"].get<std::string>() << " arithmetic";
  if (delaunay["non_delaunay_edges"] == 0) // else there is nothing to certify
    out << ", certificate: " << json["certificate"].get<std::string>();
  out << '\n';
}

void print_refinement(std::ostream& out, const Json& json) {
  if (json.contains("refine")) {
    const Json& refine = json["refine"];
    row(out, "refinement") << refine["insertions"] << " vertices more, angles from "
                           << refine["satisfied_min_angle_deg"] << " degrees except in "
                           << refine["unsatisfied_faces"] << " faces; "
                           << refine["status"].get<std::string>() << '\n';
  }
  if (json.contains("odt"))
    row(out, "optimal Delaunay") << json["odt"]["splits"] << " splits, " << json["odt"]["moves"]
                                 << " moves, energy from " << json["odt"]["energy_before"] << " to "
                                 << json["odt"]["energy_after"] << ", least angle "
                                 << json["odt"]["min_angle_deg"] << " degrees; "
                                 << json["odt"]["status"].get<std::string>() << '\n';
  if (json.contains("constraints"))
    row(out, "kept edges") << json["constraints"]["input_edges"] << '\n';
}

} // namespace

void print_summary(std::ostream& stream, const Json& json) {
  std::ostringstream out; // the caller's stream keeps its format
  print_input(out, json);
  print_repairs(out, json);
  print_delaunay(out, json);
  print_refinement(out, json);
  const Json& quality = json["quality"];
  row(out, "angles") << quality["min_angle_deg"] << " to " << quality["max_angle_deg"]
                     << " degrees\n";
  row(out, "cotan weights") << "from " << quality["min_cotan_weight"] << ", trace of the Laplacian "
                            << json["laplacian"]["trace"] << '\n';
  row(out, "area") << json["area"]["intrinsic"] << '\n';
  stream << out.str();
}

void print_summary_on_terminal(const Json& json) {
  if (isatty(STDERR_FILENO) != 0) print_summary(std::cerr, json);
}

} // namespace program

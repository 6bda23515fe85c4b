// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "answers.h"

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace program {

namespace {

struct Warning {
  bool (*is_due)(const Figures&, const Options&);
  std::string_view text; // see `Figures::fill()`
};

constexpr double thin = 1; // degrees: the weights of such a face are beyond 57
// Degrees. The error of heat, as root mean square in percent of the greatest distance, has the
// median 3.0 on 11 meshes of CGAL's data set with smaller angles, and 1.7 on 35 others.
constexpr double uneven = 5;

bool is_at_command(const Options& o, std::initializer_list<std::string_view> commands) {
  for (const std::string_view c : commands)
    if (o.command == c) return true;
  return false;
}

bool is_heat_on_thin_faces(const Figures& f) {
  return f.word("/distance/method") == "heat" && f.number("/quality/min_angle_deg") < uneven;
}

bool leaves_parts_out(const Figures& f, const Options&) {
  return f.at("/distance/reached").is_null() && f.at("/distance/targets").empty() &&
         f.has("/distance/unreached_vertices");
}

const std::array warnings{
    Warning{leaves_parts_out,
            "{/distance/unreached_vertices} of {/input/vertices vertex vertices} not reached: no "
            "path leads there from a source; the surface has {/input/components component}"},
    Warning{[](const Figures& f, const Options&) { return f.has("/distance/unreached"); },
            "{/distance/unreached distance} infinite: no path leads there; the surface has "
            "{/input/components component}"},
    Warning{[](const Figures& f, const Options&) { return f.word("/distance/status") == "cap"; },
            "the surface is so thin that a search met its cap; distances beyond the part that it "
            "searched are infinite"},
    Warning{[](const Figures& f, const Options& o) {
              return is_heat_on_thin_faces(f) && o.application.curves.empty();
            },
            "heat on thin faces, with angles from {/quality/min_angle_deg} degrees: the error may "
            "be large; use --method exact or --refine"},
    Warning{[](const Figures& f, const Options& o) {
              return is_heat_on_thin_faces(f) && !o.application.curves.empty();
            },
            "heat on thin faces, with angles from {/quality/min_angle_deg} degrees: the error may "
            "be large; use --refine"},
    Warning{[](const Figures& f, const Options& o) {
              return is_at_command(o, {"delaunay", "laplacian"}) &&
                     f.number("/quality/min_angle_deg") < thin;
            },
            "thin faces, with angles from {/quality/min_angle_deg} degrees, have large weights; "
            "the command refine makes them well shaped"},
    Warning{[](const Figures& f, const Options& o) {
              return is_at_command(o, {"transport", "field", "eigen", "edit"}) &&
                     f.number("/quality/min_angle_deg") < thin;
            },
            "thin faces, with angles from {/quality/min_angle_deg} degrees: the error may be "
            "large; use --refine"},
    Warning{[](const Figures& f, const Options&) { return f.has("/transport/unknown_vertices"); },
            "{/transport/unknown_vertices vertex vertices} without a vector: no path leads there"},
    Warning{[](const Figures& f, const Options&) { return f.has("/logmap/unknown_vertices"); },
            "{/logmap/unknown_vertices vertex vertices} not reached: no path leads there"},
    Warning{[](const Figures& f, const Options& o) {
              return is_at_command(o, {"delaunay", "refine", "laplacian"}) && !o.no_flip &&
                     f.word("/arithmetic") == "exact" && f.has("/delaunay/non_delaunay_edges");
            },
            "{/delaunay/non_delaunay_edges edge} not Delaunay: their flips were refused; "
            "--correspondence none refuses none"},
    Warning{[](const Figures& f, const Options& o) {
              return is_at_command(o, {"delaunay", "refine", "laplacian"}) && !o.no_flip &&
                     f.word("/arithmetic") == "double" && f.has("/delaunay/non_delaunay_edges");
            },
            "{/delaunay/non_delaunay_edges edge} not Delaunay as far as double arithmetic can "
            "tell; --arithmetic exact decides them"},
    Warning{[](const Figures& f, const Options& o) {
              return o.application.on == "input" && f.has("/parametrize/injective") &&
                     f.at("/parametrize/injective_on_input").is_boolean() &&
                     !f.has("/parametrize/injective_on_input");
            },
            "on the faces of the mesh, as it is written, the map is not injective; without --on "
            "input it is"},
    Warning{[](const Figures& f, const Options&) {
              return f.word("/refine/status") == "cap" &&
                     f.number("/refine/asked_angle_deg") > greatest_safe_angle;
            },
            "refinement stopped at its cap of insertions; above 30 degrees there is no guarantee "
            "that it ends; ask for --min-angle 30 or less"},
    Warning{[](const Figures& f, const Options&) {
              return f.word("/refine/status") == "cap" &&
                     f.number("/refine/asked_angle_deg") <= greatest_safe_angle;
            },
            "refinement stopped at its cap of insertions; allow more with --max-insertions"},
    Warning{[](const Figures& f, const Options& o) {
              return is_at_command(o, {"simplify"}) && f.number("/domain/sheets") > 1;
            },
            "the surface is a cover: bounds hold on it, where copies of a vertex are different "
            "points, and not for distances on the mesh"},
    Warning{[](const Figures& f, const Options&) { return f.word("/geodesic/status") == "cap"; },
            "shortening did not end after {/geodesic/flips flip} in double arithmetic; use "
            "--arithmetic exact"}};

} // namespace

std::vector<std::string> warnings_of(const Figures& figures, const Options& options) {
  std::vector<std::string> due;
  for (const Warning& w : warnings)
    if (w.is_due(figures, options))
      if (const auto text = figures.fill(w.text)) due.push_back(*text);
  return due;
}

} // namespace program

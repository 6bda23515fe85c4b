// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view.h"
#include "support/input_name.h"
#include "support/messages.h"
#include "support/warnings.h"

#include <CGAL/Intrinsic_operators/improvement/describe_delaunay.h>

#include <three_js.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

namespace program {

namespace {

void describe_curves(std::ostream& text, const Json& geodesic) {
  const std::size_t n = geodesic["curves"].size();
  text << n << (n == 1 ? " curve: " : " curves: ") << geodesic["status"].get<std::string>()
       << (geodesic["certified"] ? ", certified" : "") << "\nlength "
       << geodesic["length"].get<double>() << ", before "
       << geodesic["initial_length"].get<double>() << "; " << geodesic["flips"] << " flips\n";
}

void describe_cut(std::ostream& text, const Json& cut) {
  const std::size_t pieces = cut["components"].size(), loops = cut["border_loops"];
  text << pieces << (pieces == 1 ? " piece" : " pieces") << " with " << loops
       << (loops == 1 ? " border" : " borders") << "\n";
}

void describe_map(std::ostream& text, const Json& conformal) {
  const auto is_known = [&](const char* key) {
    return conformal[key].is_number() && std::isfinite(conformal[key].get<double>());
  };
  const bool is_proven = is_known("proven_residual");
  const char* const residual = is_proven ? "proven_residual" : "residual";
  if (is_known(residual))
    text << "\n"
         << conformal["cones"] << " cones; angles are right up to "
         << conformal[residual].get<double>() << " radians" << (is_proven ? ", proven" : "");
}

std::string description(const Json& json) {
  std::ostringstream text;
  text.precision(4);
  const Json& input = json["input"];
  text << input["vertices"] << " vertices, " << input["faces"] << " faces; ";
  if (json.contains("geodesic")) describe_curves(text, json["geodesic"]);
  // of the command cut; a map is cut open, too, and has other facts
  if (json.contains(Json::json_pointer("/cut/components"))) describe_cut(text, json["cut"]);
  if (!json.contains("delaunay")) return text.str();
  text << IT::describe_delaunay(json);
  if (json.contains("conformal")) describe_map(text, json["conformal"]);
  return text.str();
}

} // namespace

void write_view(std::ostream& out, const IT::Common_subdivision& s,
                const std::vector<Point>& points, const Options& options, const Json& json,
                IT::Html_view view) {
  if (embedded::three_js().empty())
    throw std::runtime_error(options.view +
                             ": the program was built without three.js, which the page needs; "
                             "install libjs-three and build it again");
  const std::string title =
      as_utf8(std::filesystem::path(with_input_named(options.input)).filename().string());
  const std::string text = description(json);
  view.title = title;
  view.description = text;
  view.three = embedded::three_js();
  view.trackball_controls = embedded::trackball_controls_js();
  if (view.marks.empty()) view.marks_name = {};
  constexpr std::size_t many = 1000; // curves, which would cover the surface
  if (view.curves.size() > many) view.curve_width = 1;
  view.maximum_size = static_cast<std::size_t>(1e6 * options.view_limit);
  const IT::Html_view_report report = IT::write_html_view(out, s, points, view);
  if (!report.is_complete())
    warn(options.view + ": " + report.description() + "; --view-limit allows a larger page" +
         (options.command == "view" ? "" : ", and -o writes all to a file"));
}

} // namespace program

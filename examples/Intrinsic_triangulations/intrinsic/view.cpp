// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "view.h"
#include "three_js.h"

#include <CGAL/Intrinsic_triangulations/IO/write_html_view.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>

namespace program {

namespace {

std::string description(const Json& json) {
  std::ostringstream text;
  text.precision(4);
  const Json& input = json["input"];
  const Json& delaunay = json["delaunay"];
  text << input["vertices"] << " vertices, " << input["faces"] << " faces; " << delaunay["flips"]
       << " flips\nangles from " << json["quality"]["min_angle_deg"].get<double>() << " to "
       << json["quality"]["max_angle_deg"].get<double>() << " degrees\n"
       << json["arithmetic"].get<std::string>()
       << " arithmetic, certificate: " << json["certificate"].get<std::string>();
  return text.str();
}

} // namespace

void write_view(std::ostream& out, const IT::Common_subdivision& s,
                const std::vector<Point>& points, const Options& options, const Json& json) {
  if (three_js().empty())
    throw std::runtime_error(options.view +
                             ": the program was built without three.js, which the page needs; "
                             "install libjs-three and build it again");
  const std::string title = std::filesystem::path(options.input).filename().string();
  const std::string text = description(json);
  IT::Html_view view;
  view.title = title;
  view.description = text;
  view.three = three_js();
  view.trackball_controls = trackball_controls_js();
  IT::write_html_view(out, s, points, view);
}

} // namespace program

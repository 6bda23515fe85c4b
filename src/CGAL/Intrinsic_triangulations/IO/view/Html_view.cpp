// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <sstream>
#include <string>

namespace CGAL::Intrinsic_triangulations {

Three_js find_three_js(const std::filesystem::path& directory) {
  const auto text = [&](const std::filesystem::path& folder, const std::filesystem::path& name) {
    std::ifstream file(directory / name, std::ios::binary);
    if (!file) file = std::ifstream(directory / folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  return {text("build", "three.min.js"), text("examples/js/controls", "TrackballControls.js")};
}

std::string Html_view_report::description() const {
  std::ostringstream text;
  text.precision(2);
  std::string separator = "thinned out: ";
  const auto add = [&]() -> std::ostream& {
    text << separator;
    separator = "; ";
    return text;
  };
  if (shown_pieces < pieces)
    add() << shown_pieces << " of " << pieces << " pieces of the surface, vertices nearer than "
          << cell << " are one";
  if (shown_curves < curves) add() << shown_curves << " of " << curves << " curves";
  if (curve_tolerance > 0) add() << "points of curves, up to " << curve_tolerance << " from others";
  if (shown_fields < fields) add() << shown_fields << " of " << fields << " fields";
  if (shown_marks < marks) add() << shown_marks << " of " << marks << " marked points";
  if (shown_vectors < vectors) add() << shown_vectors << " of " << vectors << " vectors";
  return text.str();
}

} // namespace CGAL::Intrinsic_triangulations

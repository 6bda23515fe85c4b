// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/stored_surface.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <optional>
#include <string>

namespace CGAL::Intrinsic_triangulations {

std::string stored_arithmetic(const std::string& path, const std::optional<std::string>& arithmetic,
                              bool is_mollified, const Surface_options& options) {
  std::string stored = read_intrinsic_triangulation_arithmetic(path);
  const auto refuse_if = [&](bool is_given, const std::string& fact, const std::string& option,
                             const char* start = "mesh") {
    if (is_given)
      throw Invalid_input(Element_kind::none, 0,
                          path + ": " + fact + "; leave --" + option + " out, or start from the " +
                              start);
  };
  const std::string surface = "a stored triangulation has its surface";
  refuse_if(arithmetic && *arithmetic != stored,
            "the triangulation is stored in " + stored + " arithmetic", "arithmetic");
  refuse_if(is_mollified, "a stored triangulation cannot be mollified", "mollification");
  refuse_if(options.is_points || options.kind != Domain_kind::automatic, surface, "domain");
  refuse_if(options.neighbors.has_value(), surface, "neighbors", "points");
  refuse_if(options.polygons != Nonplanar_polygons::fan, surface, "polygons");
  return stored;
}

} // namespace CGAL::Intrinsic_triangulations

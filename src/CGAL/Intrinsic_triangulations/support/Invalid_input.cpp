// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstddef>
#include <string>

namespace CGAL::Intrinsic_triangulations {

Invalid_input Invalid_input::about(Element_kind kind, std::size_t index, const std::string& what) {
  constexpr const char* names[] = {"element ", "vertex ", "halfedge ", "edge ", "face "};
  return Invalid_input(kind, index, names[static_cast<int>(kind)] + std::to_string(index) + what);
}

} // namespace CGAL::Intrinsic_triangulations

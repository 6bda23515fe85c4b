// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INVALID_INPUT_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INVALID_INPUT_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL::Intrinsic_triangulations {

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Invalid_input Invalid_input::about(Element_kind kind,
                                                                        std::size_t index,
                                                                        const std::string& what) {
  constexpr const char* names[] = {"element ", "vertex ", "halfedge ", "edge ", "face "};
  return Invalid_input(kind, index, names[static_cast<int>(kind)] + std::to_string(index) + what);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CONNECTIVITY_INVALID_INPUT_IMPL_H

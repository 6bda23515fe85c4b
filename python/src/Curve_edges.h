// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_CURVE_EDGES_H
#define INTRINSIC_PYTHON_CURVE_EDGES_H

#include "Surface.h"

#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace python {

/// A triangulation of a surface with curves along its edges.
struct Curve_edges {
  std::variant<std::unique_ptr<Exact>, std::unique_ptr<Double>> triangulation;
  /// Per edge of it the number of the first curve along it, plus one; 0: there is none.
  std::vector<std::uint32_t> labels;
  /// A curve that has shrunk to a point, if there is one.
  std::optional<std::uint32_t> contracted;
};

/// Asks during shortening whether to go on.
struct Shortening_watch {
  Watch* watch; ///< what is asked
  /// is called now and then.
  bool progress(const IT::Shortening_result& r) { return (*watch)("flips", r.flips); }
};

} // namespace python

#endif // INTRINSIC_PYTHON_CURVE_EDGES_H

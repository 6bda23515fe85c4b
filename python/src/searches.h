// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_SEARCHES_H
#define INTRINSIC_PYTHON_SEARCHES_H

#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_operators/distance/Distances.h>

#include <cstdint>
#include <memory>
#include <vector>

// What searches for exact distances have in common.

namespace python {

/// Asks during a search whether to go on.
struct Search_visitor {
  Watch* watch; ///< what is asked
  /// is called now and then.
  bool progress(std::uint64_t windows, double) { return (*watch)("windows", windows); }
};

/// returns what finds distances on the triangulation of a surface, which keeps it.
template <class T>
IT::Distances<T>& distances_on(Surface& s, const T& t) {
  return s.cached<IT::Distances<T>>("distances",
                                    [&] { return std::make_unique<IT::Distances<T>>(t); });
}

/// \throws ValueError if there is no source
inline void expect_sources(const std::vector<Place>& sources) {
  if (sources.empty()) throw py::value_error("distances need a source; give one at least");
}

/// adds the functions on cells and samples.
void bind_cells(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_SEARCHES_H

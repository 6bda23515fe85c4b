// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_PYTHON_SEARCHES_H
#define INTRINSIC_PYTHON_SEARCHES_H

#include "Surface.h"
#include "places.h"

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

// What searches for exact distances have in common.

namespace python {

/// The distance of what is not reached.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Asks during a search whether to go on.
struct Search_visitor {
  Watch* watch; ///< what is asked
  /// is called now and then.
  bool progress(std::uint64_t windows, double) { return (*watch)("windows", windows); }
};

/// Where a surface keeps the tables of exact distances, without windows.
inline constexpr const char* exact_tables = "exact distances";

/// returns the search on the triangulation of a surface, which keeps its tables.
template <class T>
IT::Polyhedral_distance<T>& search_of(Surface& s, const T& t) {
  return s.cached<IT::Polyhedral_distance<T>>(exact_tables, [&] {
    return std::make_unique<IT::Polyhedral_distance<T>>(IT::Polyhedral_distance<T>::on_faces(t));
  });
}

/// \throws ValueError if there is no source
inline void expect_sources(const std::vector<Place>& sources) {
  if (sources.empty()) throw py::value_error("distances need a source; give one at least");
}

/// adds the functions on cells and samples.
void bind_cells(py::module_& m);

} // namespace python

#endif // INTRINSIC_PYTHON_SEARCHES_H

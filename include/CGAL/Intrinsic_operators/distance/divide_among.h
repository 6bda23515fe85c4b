// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_DIVIDE_AMONG_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_DIVIDE_AMONG_H

#include <CGAL/Intrinsic_geodesics/distance/Polyhedral_distance.h>
#include <CGAL/Intrinsic_geodesics/voronoi/voronoi_cells.h>
#include <CGAL/Intrinsic_operators/distance/Distance_options.h>
#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place_finder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// A surface divided among sets of sources, and the distances from them.
struct Found_cells : Found_distances {
  std::vector<std::int64_t> nearest{}; ///< number of the nearest set of each row; -1: none
  std::vector<std::size_t> vertices{}; ///< number of vertices of the triangulation in each cell
  /// Areas of cells, and the lines between them; none if the search or the division was cancelled.
  Voronoi_cells cells{};
};

/*!
\brief divides a surface among sets of sources, by exact distances: each point belongs to the
nearest set.
\tparam Triangulation see `Distances`
\param find finds the distances; it keeps the search
\param sets the sets of sources; a set may be empty: its cell is
\param tolerance of the lines between cells, in the units of the input; by default see
  `voronoi_cells()`
\param options how; all distances are exact, and searched for everywhere
\return the cells; the status of both parts is `cancelled` if `options.progress` has ended the work
\throws Invalid_input as `Distances::from()` does
\throws std::invalid_argument if the search met its cap, see `voronoi_cells()`
\complexity that of `Distances::from()` and `voronoi_cells()`
*/
template <QueriedTriangulation Triangulation>
Found_cells divide_among(Distances<Triangulation>& find,
                         const std::vector<std::vector<Place>>& sets,
                         std::optional<double> tolerance = {}, Distance_options options = {}) {
  const Polyhedral_distance<Triangulation>& search = find.exact_search();
  const Triangulation& t = search.triangulation();
  Place_finder<Triangulation> places(t);
  std::vector<Place> all;
  std::vector<std::uint32_t> cell_of_source; // places have copies on a cover
  for (std::uint32_t i = 0; i < sets.size(); ++i) {
    all.insert(all.end(), sets[i].begin(), sets[i].end());
    cell_of_source.resize(cell_of_source.size() + places.points(sets[i]).size(), i);
  }
  options.method = Distance_method::exact;
  options.maximum_distance = std::numeric_limits<double>::infinity();
  Found_cells found{find.from(all, options)};
  found.nearest.assign(found.by_row.size(), -1);
  if (found.status != Status::cancelled && options.progress &&
      !options.progress(Distance_step::cells, 0, 0))
    found.status = Status::cancelled;
  if (found.status == Status::cancelled) {
    found.cells.status = Status::cancelled;
    return found;
  }
  found.cells = tolerance ? voronoi_cells(search, cell_of_source, parameters::tolerance(*tolerance))
                          : voronoi_cells(search, cell_of_source);
  found.cells.areas.resize(sets.size()); // the last sets may be empty
  found.vertices.resize(sets.size());
  for (const auto v : vertices(t.mesh()))
    if (const std::uint32_t i = search.nearest_source(v); i != Gluing::none) {
      found.nearest[t.input_vertex(v)] = cell_of_source[i];
      ++found.vertices[cell_of_source[i]];
    }
  Twin_points(t).copy(found.nearest);
  return found;
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_DIVIDE_AMONG_H

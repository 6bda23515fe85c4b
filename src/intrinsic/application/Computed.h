// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_COMPUTED_H
#define INTRINSIC_APPLICATION_COMPUTED_H

#include "../statistics.h"

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Vertex_frames.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

namespace program {

/// A value per vertex of the intrinsic triangulation, at its row.
struct Function {
  std::string name;
  Eigen::VectorXd values;
  bool has_classes = false; ///< whether values are whole numbers that name classes
};

/// Tangent vectors at the vertices of the intrinsic triangulation.
struct Direction_field {
  std::string name; ///< of one of the vectors, in files
  IT::Tangent_field vectors;
  unsigned degree = 1; ///< vectors that differ by a turn by 2 pi / degree are alike
  /// Number of the vector of each row, on a cover that of one copy of the vertex; `Gluing::none` if
  /// the row has no vector.
  std::vector<std::uint32_t> of_row;
  std::vector<int> index{}; ///< of each face of the intrinsic triangulation, at its number; or none
  /// On a cloud of points, the axes of the tangent plane of each row; else none.
  std::vector<IT::Point_cloud_vectors::Axes> axes{};
};

/// Points that a page and files show with a number each: sources, or singularities with their
/// indices.
struct Marks {
  std::string name;
  std::vector<IT::Polyline> points{}; ///< of one point each
};

/// A surface of polygons in space, with numbers and vectors on it.
struct Surface_with_fields {
  IT::Common_subdivision s; ///< labelled with the polygons of the file
  std::vector<std::array<double, 3>> points;
  std::vector<IT::Subdivision_field> fields;
};

/// A surface that was laid out in the plane.
struct Laid_out {
  Surface_with_fields opened;        ///< cut open; its first two fields are places in the plane
  Surface_with_fields closed;        ///< not cut, with places at corners
  std::vector<IT::Polyline> seams{}; ///< the edges that were cut
  bool is_disk = false;              ///< whether the plane is Poincaré's disk
};

/// What a command has computed.
struct Computed {
  std::string command; ///< key of `json` among the statistics
  Json json;
  std::vector<Function> functions;
  std::size_t shown = 0; ///< which of the functions a page shows, if there is one
  unsigned isolines = 0; ///< number of steps between lines of equal values of it
  /// Whether the first two functions are places in the plane, shown by a checkerboard.
  bool is_map = false;
  /// Whether functions have values at vertices of the file alone, not at inserted ones.
  bool is_of_input = false;
  bool is_logarithm = false; ///< whether these places are logarithms of a point
  std::optional<Direction_field> directions{};
  Marks marks{};
  /// Values of the first function at which isolines are written.
  std::vector<double> levels{};
  /// Makes the lines between cells from the places of the vertices of the mesh; none: no cells.
  std::function<std::vector<IT::Polyline>(const std::vector<std::array<double, 3>>&)>
      cell_boundaries{};
  /// Computes and writes what has no value per vertex, and reports it; none: all has.
  std::function<void(std::ostream&, Json&)> write{};
  /// Writes the page that shows the results; none: it shows the functions on the surface.
  std::function<void(std::ostream&, const Json&)> write_page{};
  /// Displacement of each vertex, a row each; empty: the surface stays as it is.
  Eigen::MatrixXd displacements{};
  /// What files and pages show in place of the functions on the triangulation; or none.
  std::optional<Laid_out> laid_out{};
  std::string timed = "solve"; ///< key of the seconds that it took
};

} // namespace program

#endif // INTRINSIC_APPLICATION_COMPUTED_H

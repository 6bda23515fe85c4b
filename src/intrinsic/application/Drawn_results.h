// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_DRAWN_RESULTS_H
#define INTRINSIC_APPLICATION_DRAWN_RESULTS_H

#include "../delaunay.h"
#include "../options.h"
#include "Computed.h"
#include "direction_lines.h"

#include <CGAL/Intrinsic_triangulations/IO/curves/write_polylines.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <array>
#include <ostream>
#include <vector>

// What is written and shown of the results of a command, once they are on a surface.

namespace program {

/// The surface on which results are drawn: the common subdivision, or the mesh of the file.
struct Drawn_results {
  Drawn_subdivision drawn;
  std::vector<IT::Subdivision_field> fields; ///< first the functions
  Drawn_directions directions{};
  std::vector<IT::Polyline> lines{}; ///< between cells
  /// where a checkerboard is shown; not numbers: none
  std::vector<std::array<double, 2>> texture{};
};

/// tells whether a file of a surface that was cut open has it open: formats without numbers at
/// corners, and plain files, whose readers take one place per vertex.
bool stays_open(const Options& options);
/// refuses a file of results that cannot be. \throws std::runtime_error
void expect_writable_results(const Options& options);
/// writes the values of each row; of directions one of them in polar coordinates, and the unit
/// vectors in space along the axes there: along the real one, on a cloud along both. On a surface
/// that was cut open, the vertex of the file is last.
void write_functions(std::ostream& out, const Computed& computed,
                     const std::vector<std::vector<Point>>& axes, Eigen::Index rows,
                     const Cut& cut);
/// returns the functions, and the places of displaced points, at the vertices of a surface.
/// \param interpolation from the vertices of the triangulation, or of the input, to these
Drawn_results draw(Drawn_subdivision drawn, const Computed& computed,
                   const IT::Interpolation_matrix& interpolation);
/// writes a page that shows results on a surface.
void write_results_view(std::ostream& out, const Drawn_results& results, const Computed& computed,
                        const Cut& cut, const Options& options, const Json& json);
/// writes a surface that was laid out in the plane; formats without numbers at corners get it cut.
void write_laid_out(const Laid_out& laid_out, const Marks& marks, const Options& options,
                    const Json& json, Output_files& files);

} // namespace program

#endif // INTRINSIC_APPLICATION_DRAWN_RESULTS_H

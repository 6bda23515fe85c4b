// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_MATRICES_H
#define INTRINSIC_MATRICES_H

#include "options.h"
#include "output_files.h"
#include "support/naming_file.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/matrix_market.h>

#include <Eigen/SparseCore>

#include <ostream>
#include <string>

namespace program {

/// writes a matrix. \param what what it is, for the comment in the file
inline void write_matrix(const std::string& path, const Eigen::SparseMatrix<double>& matrix,
                         const std::string& what, Output_files& files) {
  files.write(path, [&](std::ostream& out) {
    CGAL::Intrinsic_triangulations::write_matrix_market(
        out, matrix, what + ",\nby intrinsic " + INTRINSIC_TRIANGULATIONS_VERSION);
  });
}

/// writes the Laplacian and the mass matrix, if options name files for them.
/// \throws Invalid_input naming the file
template <class Triangulation>
void write_matrices(Triangulation& t, const Options& options, Output_files& files) {
  namespace IT = CGAL::Intrinsic_triangulations;
  const std::string rows = "; rows of the input's vertices in their order, then of those inserted";
  naming_file(options.input, [&] {
    if (!options.laplacian.empty())
      write_matrix(options.laplacian, IT::cotangent_laplacian(t),
                   "cotangent Laplacian, positive semidefinite" + rows, files);
    if (!options.mass.empty())
      write_matrix(options.mass,
                   options.mass_kind == "lumped" ? IT::lumped_mass_matrix(t)
                                                 : IT::galerkin_mass_matrix(t),
                   options.mass_kind + " mass matrix" + rows, files);
  });
}

} // namespace program

#endif // INTRINSIC_MATRICES_H

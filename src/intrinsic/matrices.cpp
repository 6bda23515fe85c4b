// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "matrices.h"

#include <CGAL/Intrinsic_operators/operators/matrix_market.h>

namespace program {

void write_matrix(const std::string& path, const Eigen::SparseMatrix<double>& matrix,
                  const std::string& what, Output_files& files) {
  files.write(path, [&](std::ostream& out) {
    CGAL::Intrinsic_triangulations::write_matrix_market(
        out, matrix, what + ",\nby intrinsic " + INTRINSIC_TRIANGULATIONS_VERSION);
  });
}

} // namespace program

// expect: satisfaction of .Factorization<
// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A matrix is not factored yet.

#include <CGAL/Intrinsic_operators/solvers/Diffusion.h>

#include <Eigen/SparseCore>

int main() {
  using namespace CGAL::Intrinsic_triangulations;
  internal::Diffusion<Eigen::SparseMatrix<double>>* flow = nullptr;
  return flow != nullptr;
}

// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/editing/Heat_flow.h>

#include <Eigen/Core>

#include <stdexcept>

namespace CGAL::Intrinsic_triangulations {

Eigen::MatrixXd Heat_flow::step(const Eigen::MatrixXd& values) const {
  if (values.rows() != mass_.size()) throw std::invalid_argument("there must be a row per vertex");
  return solver_.solve(Eigen::MatrixXd(mass_.asDiagonal() * values));
}

} // namespace CGAL::Intrinsic_triangulations

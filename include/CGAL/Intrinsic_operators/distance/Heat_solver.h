// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_SOLVER_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_SOLVER_H

#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/// How heat behaves at the border, for `Heat_distance`.
enum class Heat_border {
  insulated, ///< no flux: the gradient runs along the border (Neumann)
  average    ///< the mean of that and of a border that is kept cold (Dirichlet)
};

/// The last step of `Heat_distance`, or of `Signed_heat_distance`, in which normals spread.
enum class Heat_step {
  /// a matrix of the heat flow is factored; a cold border needs two
  heat_factored,
  heat_found ///< heat has spread from the sources
};

namespace internal {

template <class Scalar>
struct Heat;
class Function_flow;

// Called after each step; returns whether to go on.
using Heat_progress = std::function<bool(Heat_step)>;

// The options of `Heat_distance`.
struct Heat_options {
  double time_factor = 1;
  Heat_border border = Heat_border::average;
};

// The heat method on a table of faces, in scaled units.
class Heat_solver {
public:
  Heat_solver(const Eigen::SparseMatrix<double>& laplacian, Face_table table,
              const Heat_options& options, std::uint32_t sheets, Heat_progress progress);

  const Face_table& table() const { return table_; }
  double time() const { return table_.unscaled(table_.unscaled(time_)); }

  // whether the caller stopped the last step
  bool is_cancelled() const { return is_cancelled_; }

  // \param positions where the vertices of rows are in space, for the bound by chords
  // \return by rows, in the units of the input; empty if cancelled
  Eigen::VectorXd distances(const Source_places& sources,
                            const std::vector<std::array<double, 3>>& positions);

  // From several sets of sources, a column each, without calls of `progress`. The results are those
  // of single calls, bit by bit. Several threads may call it at once, each with what it keeps.
  Eigen::MatrixXd columns(std::span<const Source_places> sets,
                          const std::vector<std::array<double, 3>>& positions,
                          Pinned_laplacian::Kept& kept) const;

private:
  using Pins = Pinned_laplacian::Pins;

  void make_cold_border(const Eigen::VectorXd& masses);

  // the pins of each set
  std::vector<Pins> pins_of(std::span<const Source_places> sets) const;

  // from each set
  std::vector<Heat<double>> heat(std::span<const Source_places> sets,
                                 std::span<const Pins> pins) const;
  std::vector<char> reached(const Pins& pins) const;

  // the distances whose gradients fit the flow of heat best, not less than chords
  Eigen::MatrixXd fitted(const std::vector<Heat<double>>& heat, std::span<const Source_places> sets,
                         std::span<const Pins> pins,
                         const std::vector<std::array<double, 3>>& positions,
                         Pinned_laplacian::Kept& kept) const;

  // Curves count by their length in mean edges, points once.
  Eigen::VectorXd initial_heat(const Source_places& sources) const;

  // of the field of unit vectors along which heat decreases
  Eigen::VectorXd divergence(const Heat<double>& heat) const;

  // the unit vector against the gradient of a function, zero if that is constant
  static std::complex<double> descent(const std::array<std::complex<double>, 3>& corners,
                                      const std::array<double, 3>& u);

  Face_table table_;
  double mean_edge_;
  double time_;
  std::vector<std::uint32_t> component_;
  Pinned_laplacian poisson_;
  Pinned_laplacian::Kept kept_;
  std::shared_ptr<const Function_flow> insulated_, cold_;
  std::vector<char> is_on_border_; // of rows
  std::uint32_t sheets_;
  Heat_progress progress_;
  bool is_cancelled_ = false;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_HEAT_SOLVER_H

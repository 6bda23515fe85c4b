// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_SOLVER_H
#define CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_SOLVER_H

#include <CGAL/Intrinsic_operators/distance/Pinned_laplacian.h>
#include <CGAL/Intrinsic_operators/distance/distance_sources.h>
#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/solvers/Diffusion.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// The signed heat method on a table of faces, in scaled units.
class Signed_heat_solver {
  using Complex = std::complex<double>;

public:
  Signed_heat_solver(Face_table table, const Eigen::SparseMatrix<double>& laplacian,
                     double time_factor)
      : table_(std::move(table)),
        time_(flow_time(time_factor, squared_spacing(table_), table_.area())),
        component_(table_.components()), poisson_(laplacian, component_),
        flow_(flow_matrix(), edge_masses()) {}

  const Face_table& table() const { return table_; }
  double time() const { return table_.unscaled(table_.unscaled(time_)); }

  // \return by rows, in the units of the input
  Eigen::VectorXd distances(const Source_places& curves);

private:
  // The mean of the squared distances of neighbouring nodes, which are the midpoints of edges.
  static double squared_spacing(const Face_table& table) {
    return table.mean_of_edges(
        [](const Table_face& f, std::size_t k) { return f.squared_lengths[k] / 4; });
  }
  Eigen::SparseMatrix<Complex> flow_matrix() const;
  Eigen::VectorXd edge_masses() const;

  // The normals on the right of the curves, diffused.
  Heat<Complex> normals(const Source_places& curves, const Pinned_laplacian::Pins& pins) const;

  // of the field of unit vectors that have the directions of the diffused normals in the middle of the faces
  Eigen::VectorXd divergence(const Heat<Complex>& field) const;

  // Zero at vertices of the curves. At the corners of a face that a curve goes through, the distance from its line there, which is
  // linear in the face: it is zero where the curve is.
  Pinned_laplacian::Pins signed_distances_near(const Source_places& curves) const;

  Face_table table_;
  double time_;
  std::vector<std::uint32_t> component_;
  Pinned_laplacian poisson_;
  Diffusion<Complex> flow_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_COMPILED
#include <CGAL/Intrinsic_operators/distance/Signed_heat_solver_impl.h>
#endif

#endif // CGAL_INTRINSIC_OPERATORS_DISTANCE_SIGNED_HEAT_SOLVER_H
